// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/pulse_train.hpp"

#include <algorithm>
#include <cstdlib>

#include "shared/units.hpp"

namespace psicarve::verify {

namespace {
constexpr int kLeastPatience = 4;
constexpr int kMostPatience = 256;
}  // namespace

TrainFollower::TrainFollower(const MotorLimits& limits, std::int64_t begin_ns)
    : reach_(limits), reached_ns_(begin_ns), witness_(reach_.limits()) {
    start_anew(begin_ns);
}

void TrainFollower::start_anew(std::int64_t time_ns) {
    reached_ns_ = time_ns;
    count_ = 0;  // positions stay small, whatever the axis counts
    patience_ = kLeastPatience;
    late_count_ = 0;
    earlier_count_ = 0;
    has_witness_ = false;
    open_window();
    reach_.start_anywhere(room_at(count_));
}

/// Everything that is possible after an event.
void TrainFollower::step(const TrainEvent& event) {
    if (event.time_ns > reached_ns_)
        reach_.run(seconds_from_ns(event.time_ns - reached_ns_), room_at(count_));
    reached_ns_ = event.time_ns;
    if (event.kind == TrainEvent::Kind::joint) {
        reach_.jump();
        return;
    }
    if (!event.is_pulse()) return;
    reach_.cut(room_between(count_, event.count_after(count_)));
    count_ = event.count_after(count_);
}

bool TrainFollower::take(const TrainEvent& event) {
    if (has_witness_) {
        if (witness_.take(event)) {
            keep_late(event);
            return true;
        }
        patience_ = std::min(2 * patience_, kMostPatience);
        catch_up();
    }
    step(event);
    if (reach_.is_empty()) {
        start_anew(event.time_ns);
        return false;
    }
    if (event.is_pulse()) choose_witness();
    return true;
}

/// Tries the witness that suits the way of the last pulses.
void TrainFollower::choose_witness() {
    if (++window_pulses_ < patience_) return;
    const double slow_way = reach_.limits().jump_pps * seconds_from_ns(reached_ns_ - window_ns_);
    const bool is_slow = static_cast<double>(std::abs(count_ - window_count_)) <= slow_way;
    open_window();
    if (is_slow) {
        if (reach_.slow().is_empty()) return;
        witness_.start_slow(reach_.slow(), reached_ns_, count_);
    } else {
        const bool is_upward = !reach_.running(true).is_empty();
        const StateSet& states = reach_.running(is_upward);
        if (states.is_empty()) return;
        witness_.start_running(states, reach_.is_running_only(), is_upward, reached_ns_, count_);
    }
    has_witness_ = true;
}

void TrainFollower::open_window() {
    window_pulses_ = 0;
    window_ns_ = reached_ns_;
    window_count_ = count_;
}

void TrainFollower::keep_late(const TrainEvent& event) {
    // An axis that stands passes many joints: the first and the last of them will do.
    const auto is_joint = [this](std::size_t back) {
        return late_[late_count_ - back].kind == TrainEvent::Kind::joint;
    };
    if (late_count_ >= earlier_count_ + 2 && event.kind == TrainEvent::Kind::joint && is_joint(1) &&
        is_joint(2)) {
        late_[late_count_ - 1] = event;
        return;
    }
    if (late_count_ == kMostLate) forget_earlier();
    late_[late_count_++] = event;
    if (earlier_count_ == 0 && late_count_ >= (witness_.is_whole() ? kFewLate : kMostLate / 2)) {
        earlier_ = witness_;
        earlier_count_ = late_count_;
    }
    // A witness that left nothing out is as good as everything.
    if (earlier_count_ > 0 && earlier_.is_whole()) forget_earlier();
}

/// What lies so far back has no bearing any more: the witness of then stands for it.
void TrainFollower::forget_earlier() {
    earlier_.hand_to(reach_);
    reached_ns_ = earlier_.time_ns();
    count_ = earlier_.count();
    std::copy(late_.begin() + static_cast<std::ptrdiff_t>(earlier_count_),
              late_.begin() + static_cast<std::ptrdiff_t>(late_count_), late_.begin());
    late_count_ -= earlier_count_;
    earlier_count_ = 0;
    patience_ = kLeastPatience;
}

void TrainFollower::catch_up() {
    has_witness_ = false;
    for (std::size_t i = 0; i < late_count_; ++i) step(late_[i]);
    late_count_ = 0;
    earlier_count_ = 0;
    open_window();
}

bool TrainFollower::wait(std::int64_t time_ns) {
    if (has_witness_) catch_up();
    if (time_ns > reached_ns_) reach_.run(seconds_from_ns(time_ns - reached_ns_), room_at(count_));
    reached_ns_ = time_ns;
    if (!reach_.is_empty()) return true;
    start_anew(time_ns);
    return false;
}

}  // namespace psicarve::verify
