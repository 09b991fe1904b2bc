// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/executor.hpp"
#include "rtcore/cycle/straight_way.hpp"

namespace psicarve::cycle {
namespace {

// Lines without any pulse end at once; so many of them in one tick, the rest in the next.
constexpr int kEmptyLinesPerTick = 8;

}  // namespace

// Each false when there is no way to go.
bool Executor::start_line() noexcept {
    iterations_.start(block());
    profile_.start(block().start_speed_per_s * period_s_, block().max_speed_per_s * period_s_,
                   block().accel_per_s2 * period_s_ * period_s_, block().group_iterations);
    return iterations_.left() > 0;
}

bool Executor::start_move() noexcept {
    fine_.start(block().delta_pulses, block().start_speed_per_s * period_s_,
                block().max_speed_per_s * period_s_, block().accel_per_s2 * period_s_ * period_s_);
    return !fine_.is_finished();
}

Executor::Progress Executor::advance_line(std::uint64_t tick, bool must_slow) noexcept {
    if (iterations_.are_done()) return end_of_way(tick);
    if (!profile_.is_due()) profile_.advance(must_slow);
    if (!profile_.is_due()) return kNothing;
    if (!iterations_.is_held()) iterations_.make();
    if (!iterations_.emit(*pulses_, tick, still_axes_)) {
        progress_.note_wait();
        return kNothing;
    }
    profile_.take();
    return iterations_.left() == 0 ? end_of_way(tick) : kNothing;
}

Executor::Progress Executor::advance_move(std::uint64_t tick, bool must_slow) noexcept {
    if (fine_.is_finished()) return end_of_way(tick);
    step_along(fine_, *pulses_, tick, must_slow, still_axes_);
    return fine_.is_finished() ? end_of_way(tick) : kNothing;
}

// A move that looks for a sensor has not found it by the end of its way, unless the filter still thinks.
Executor::Progress Executor::end_of_way(std::uint64_t tick) noexcept {
    if (!search_.is_on() || search_.has_answered()) return end_of_line(tick);
    if (search_.may_answer()) return kNothing;
    in_motion_ = false;
    return kNotFound;
}

Executor::Progress Executor::end_of_line(std::uint64_t tick) noexcept {
    Progress progress = reached();
    for (int i = 0; !feed_.is_last_of_group() && i < kEmptyLinesPerTick; ++i) {
        if (!feed_.take_next_of_group()) {
            in_motion_ = false;
            return progress | kStarved;
        }
        iterations_.start(block());
        if (iterations_.left() > 0) {
            turn_axes(tick);
            return progress;
        }
        progress |= reached();
    }
    in_motion_ = !feed_.is_last_of_group();
    return progress;
}

}  // namespace psicarve::cycle
