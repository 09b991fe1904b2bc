// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/motion.hpp"

namespace psicarve::cycle {

Motion::Progress Motion::step_lift(std::uint64_t tick) noexcept {
    switch (lift_.step(tick)) {
        case HeadLift::Progress::going_on:
            break;
        case HeadLift::Progress::lifted:
            return kLifted;
        case HeadLift::Progress::back:
            executor_.go_on_after_lift(tick);
            break;
        case HeadLift::Progress::halted:
            lift_.forget();
            return Executor::kAtRest;
    }
    return Executor::kNothing;
}

bool Motion::ask(PlanRequest request, double feed_ratio, std::uint32_t still_axes) noexcept {
    drop();
    executor_.set_feed_ratio(feed_ratio);
    executor_.set_still_axes(still_axes);
    request.epoch = epoch_;
    request.position_pulses = pulses_->positions();
    return io_->plan_requests.push(request);
}

void Motion::drop() noexcept {
    ++epoch_;
    executor_.reset(epoch_);
    lift_.forget();
}

void Motion::hold() noexcept {
    if (lift_.is_active()) {
        lift_.lift();
    } else {
        executor_.slow_down();
    }
}

void Motion::resume() noexcept {
    if (lift_.is_active()) {
        lift_.lower();
    } else {
        executor_.go_on();
    }
}

void Motion::slow_down() noexcept {
    executor_.slow_down();
    if (lift_.is_active()) lift_.halt();
}

}  // namespace psicarve::cycle
