// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "rtcore/cycle/executor.hpp"

namespace psicarve::cycle {

Executor::Progress Executor::begin_path(std::uint64_t tick) noexcept {
    if (!can_end(block().path)) {
        in_motion_ = false;
        return kStarved;
    }
    starts_again_ = false;
    iterations_.start_segment(block());
    pace_.cap(feed_.goes_on() && !feed_.has_next_group());
    if (wanted_marks_ != 0) look_at_rest();
    bound_segment();
    if (feed_.carries_on() || is_stop_at_hand()) {
        pace_.start_again(block().path, iterations_.left());
    } else {
        pace_.start(block().path, iterations_.left());
    }
    turn_for_segment(tick);
    return kGroupStarted;
}

// At most one iteration a tick, and at most one segment of which is emitted: what else is due is late by a
// tick, while time goes on.
Executor::Progress Executor::advance_path(std::uint64_t tick) noexcept {
    if (pace_.is_capped() && feed_.has_next_group()) pace_.cap(false);
    if (wanted_marks_ != 0 && !starts_again_) look_for_line_end();
    if (block().way == WayKind::to_feed && !is_near_feed_ && pace_.way() >= double{block().path.feed_from}) {
        is_near_feed_ = true;
        aim();
    }
    pace_.tick();
    if (!iterations_.is_held() && pace_.is_due(iterations_.left())) iterations_.make();
    bool has_stepped = false;
    Progress progress = kNothing;
    for (std::uint32_t i = 0; i < kSegmentsPerTick; ++i) {
        if (iterations_.is_held()) {
            if (!iterations_.emit(*pulses_, tick, still_axes_)) {
                progress_.note_wait();
                return progress;
            }
            has_stepped = true;
            pace_.take();
        }
        if (!pace_.is_at_end() || !iterations_.are_done()) return progress;
        progress |= reached();
        if (rests_at_line_end()) {
            rest_at_line_end();
            return progress;
        }
        if (feed_.is_last_of_group()) {
            // Capped, it has slowed down for a rest here.
            if (pace_.is_capped() || !feed_.take_next_group()) {
                in_motion_ = false;
                return progress;
            }
            pace_.cap(feed_.goes_on() && !feed_.has_next_group());
        } else if (!feed_.take_next_of_group()) {
            in_motion_ = false;
            return progress | kStarved;
        }
        if (!can_end(block().path)) {
            in_motion_ = false;
            return progress | kStarved;
        }
        enter_segment(tick);
        if (take_up_.is_on()) return progress;
        if (!has_stepped && pace_.is_due(iterations_.left())) iterations_.make();
    }
    return progress;
}

void Executor::enter_segment(std::uint64_t tick) noexcept {
    iterations_.start_segment(block());
    enter_way();
    if (starts_again_ && wanted_marks_ != 0) look_at_rest();
    bound_segment();
    if (std::exchange(starts_again_, false)) {
        pace_.start_again(block().path, iterations_.left());
    } else {
        pace_.next(block().path, iterations_.left());
    }
    turn_for_segment(tick);
}

void Executor::turn_for_segment(std::uint64_t tick) noexcept {
    turn_axes(tick);
    if (!take_up_.is_on()) turn_idle_axes(tick);
}

// An axis without a pulse in this segment may already turn for the next one: its pins then need not be waited
// for.
void Executor::turn_idle_axes(std::uint64_t tick) noexcept {
    const MotionBlock* const next = feed_.next_of_group();
    if (next == nullptr) return;
    std::array<std::int64_t, kAxisCount> way = block().delta_pulses;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        if (way[k] == 0) way[k] = next->delta_pulses[k];
    }
    if (way != block().delta_pulses) pulses_->want_directions(way, tick);
}

}  // namespace psicarve::cycle
