// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/executor.hpp"

#include <algorithm>

namespace psicarve::cycle {

void Executor::reset(std::uint32_t epoch) noexcept {
    feed_.reset(epoch);
    search_.end_homing();
    take_up_.end();
    in_motion_ = false;
    has_line_ended_ = false;
    starts_again_ = false;
    forget_stops();
    go_on();
    still_axes_ = 0;
    pulses_->forget_waiting();
}

void Executor::go_on_after_lift(std::uint64_t tick) noexcept {
    if (take_up_.is_on()) {
        take_up_.want_directions(tick);
    } else if (in_motion_) {
        pulses_->want_directions(block().delta_pulses, tick);
        if (block().kind == BlockKind::path) turn_idle_axes(tick);
    }
    go_on();
}

void Executor::set_feed_ratio(double feed_ratio) noexcept {
    feed_ratio_ = feed_ratio;
    const double up_to_plan = std::min(feed_ratio, 1.0);
    profile_.set_ratio(up_to_plan);
    fine_.set_ratio(up_to_plan);
    aim();
}

void Executor::set_rapid_ratio(double rapid_ratio) noexcept {
    rapid_ratio_ = rapid_ratio;
    aim();
}

// As fast as the overrides allow for the block at hand. A feed above 100 % is that of rapid ways, too: their
// plan for it is no faster but at their ends, and so there is no step where one kind follows the other.
void Executor::aim() noexcept {
    if (block().way == WayKind::feed) {
        if (!slowing_) pace_.aim(feed_ratio_);
        take_up_.set_ratio(std::min(feed_ratio_, 1.0));
    } else {
        if (!slowing_) pace_.aim(std::max(feed_ratio_, 1.0), rapid_part());
        take_up_.set_ratio(rapid_part());
    }
}

// Before the block at hand begins.
void Executor::enter_way() noexcept {
    is_near_feed_ = block().way == WayKind::to_feed && block().path.feed_from <= 0.0F;
    aim();
}

double Executor::rapid_part() const noexcept {
    return is_near_feed_ ? std::min(rapid_ratio_, feed_ratio_) : rapid_ratio_;
}

std::uint32_t Executor::axes_in_motion() const noexcept {
    if (!in_motion_) return 0;
    std::uint32_t axes = 0;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        axes |= static_cast<std::uint32_t>(block().delta_pulses[k] != 0) << k;
    }
    return axes;
}

Executor::Progress Executor::begin(std::uint64_t tick) noexcept {
    switch (block().kind) {
        case BlockKind::line:
        case BlockKind::path:
        case BlockKind::move:
            return begin_motion(tick);
        case BlockKind::define:
            return define(block().position_pulses - pulses_->positions()[block().axis], kDefined);
        case BlockKind::outputs:
            pulses_->set_enables(block().enable_mask, tick);
            if (block().spindle != Spindle::keep) pulses_->set_spindle(block().spindle == Spindle::on);
            pulses_->switch_outputs(block().switched_on, block().switched_off);
            return kNothing;
        case BlockKind::dwell:
            feed_.pause(block().ticks);
            return kNothing;
        case BlockKind::halt:
            return is_halt_wanted() ? kHalted : kNothing;
        case BlockKind::program_end:
            break;
    }
    search_.end_homing();
    return kProgramEnd;
}

Executor::Progress Executor::begin_motion(std::uint64_t tick) noexcept {
    search_.begin(block());
    in_motion_ = true;
    enter_way();
    if (block().kind == BlockKind::path) return begin_path(tick);
    const std::uint8_t homing_axis = search_.homing_axis();
    if (block().kind == BlockKind::move && homing_axis != kNoAxis) {
        feed_.lengthen(homing_axis, take_up_.extra_pulses(homing_axis, block().delta_pulses[homing_axis]));
    }
    const bool has_way = block().kind == BlockKind::move ? start_move() : start_line();
    if (!has_way) return kGroupStarted | end_of_line(tick);
    turn_axes(tick);
    return kGroupStarted;
}

Executor::Progress Executor::advance(std::uint64_t tick) noexcept {
    if (take_up_.is_on()) return advance_take_up(tick);
    if (has_line_ended_) {
        if (pulses_->is_gate_shut()) return kNothing;
        has_line_ended_ = false;
        return kLineDone;
    }
    Progress progress = kNothing;
    bool must_slow = slowing_;
    if (search_.is_on()) {
        progress = watch_sensor();
        must_slow = must_slow || search_.has_answered() || search_.may_answer();
    }
    if (must_slow && is_slowest() && !pulses_->is_gate_shut()) {
        rest();
        if (search_.has_answered()) return progress | end_of_line(tick);
        return slowing_ ? progress | kAtRest : progress;
    }
    if (block().kind == BlockKind::path) return progress | advance_path(tick);
    if (block().kind == BlockKind::move) return progress | advance_move(tick, must_slow);
    return progress | advance_line(tick, must_slow);
}

Executor::Progress Executor::advance_take_up(std::uint64_t tick) noexcept {
    if (slowing_ && take_up_.is_slowest() && !pulses_->is_gate_shut()) {
        take_up_.rest();
        if (block().kind == BlockKind::path) pace_.rest();
        return kAtRest;
    }
    if (!take_up_.step(tick, slowing_)) return kNothing;
    // The planned speed may have been changed meanwhile.
    if (block().kind == BlockKind::move) start_move();
    pulses_->want_directions(block().delta_pulses, tick);
    return kNothing;
}

// What homing has to take up is part of its moves.
void Executor::turn_axes(std::uint64_t tick) noexcept {
    if (search_.homing_axis() == kNoAxis && take_up_.begin(block(), still_axes_, tick)) return;
    pulses_->want_directions(block().delta_pulses, tick);
}

bool Executor::is_slowest() const noexcept {
    if (block().kind == BlockKind::path) return pace_.is_slowest();
    return block().kind == BlockKind::move ? fine_.is_slowest() : profile_.is_slowest();
}

void Executor::rest() noexcept {
    if (block().kind == BlockKind::path) {
        pace_.rest();
    } else if (block().kind == BlockKind::move) {
        fine_.rest();
    } else {
        profile_.rest();
    }
}

Executor::Progress Executor::reached() noexcept {
    const std::uint32_t points = feed_.take_points();
    if (points == 0) return kNothing;
    progress_.reach(block().layer, block().point, points);
    return kPoint;
}

Executor::Progress Executor::watch_sensor() noexcept {
    if (!search_.watch() || block().latch == Latch::none) return kNothing;
    return define(block().position_pulses - search_.edge_position(), kLatched);
}

Executor::Progress Executor::define(std::int64_t correction, Progress what) noexcept {
    latch_correction_ = correction;
    pulses_->set_position(block().axis, pulses_->positions()[block().axis] + correction);
    return what;
}

}  // namespace psicarve::cycle
