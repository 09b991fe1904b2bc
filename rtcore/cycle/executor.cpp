// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/executor.hpp"

#include <algorithm>

#include "rtcore/cycle/straight_way.hpp"
#include "shared/machine/status.hpp"

namespace psicarve::cycle {
namespace {

// Dropping a whole queue of another epoch in one tick would take too long.
constexpr int kDropsPerTick = 64;
// Lines without any pulse end at once; so many of them in one tick, the rest in the next.
constexpr int kEmptyLinesPerTick = 8;

}  // namespace

void Executor::reset(std::uint32_t epoch) noexcept {
    epoch_ = epoch;
    in_motion_ = false;
    is_taking_up_ = false;
    go_on();
    next_axes_ = 0;
    dwell_left_ = 0;
    homing_axis_ = kNoAxis;
    still_axes_ = 0;
    pulses_->forget_waiting();
}

void Executor::go_on_after_lift(std::uint64_t tick) noexcept {
    if (is_taking_up_) {
        pulses_->want_directions(take_up_way_, tick);
    } else if (in_motion_) {
        pulses_->want_directions(block_.delta_pulses, tick);
        if (block_.kind == BlockKind::path) turn_idle_axes(tick);
    }
    go_on();
}

void Executor::set_feed_ratio(double feed_ratio) noexcept {
    feed_ratio_ = feed_ratio;
    if (!slowing_) law_.aim(feed_ratio);
    const double up_to_plan = std::min(feed_ratio, 1.0);
    profile_.set_ratio(up_to_plan);
    fine_.set_ratio(up_to_plan);
}

void Executor::clear_points(std::uint64_t points_before) noexcept {
    waited_ticks_ = 0;
    layer_ = 0;
    point_ = 0;
    points_reached_ = points_before;
}

std::uint32_t Executor::axes_in_motion() const noexcept {
    if (!in_motion_) return 0;
    std::uint32_t axes = 0;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        axes |= static_cast<std::uint32_t>(block_.delta_pulses[k] != 0) << k;
    }
    return axes;
}

Executor::Progress Executor::advance(std::uint64_t tick) noexcept {
    if (is_taking_up_) return advance_take_up(tick);
    Progress progress = kNothing;
    bool must_slow = slowing_;
    if (block_.until != Until::none) {
        progress = watch_sensor();
        must_slow = must_slow || sensor_done_ || must_wait_for_sensor();
    }
    if (must_slow && is_slowest() && !pulses_->is_gate_shut()) {
        rest();
        if (sensor_done_) return progress | end_of_line(tick);
        return slowing_ ? progress | kAtRest : progress;
    }
    if (block_.kind == BlockKind::path) return progress | advance_path(tick);
    if (block_.kind == BlockKind::move) return progress | advance_move(tick, must_slow);
    if (dda_.iterations_left() == 0) return progress | end_of_way(tick);
    if (!profile_.is_due()) profile_.advance(must_slow);
    return profile_.is_due() ? progress | emit(tick) : progress;
}

Executor::Progress Executor::advance_move(std::uint64_t tick, bool must_slow) noexcept {
    if (fine_.is_finished()) return end_of_way(tick);
    step_fine(tick, must_slow);
    return fine_.is_finished() ? end_of_way(tick) : kNothing;
}

void Executor::step_fine(std::uint64_t tick, bool must_slow) noexcept {
    step_along(fine_, *pulses_, tick, must_slow, still_axes_);
}

void Executor::start_fine() noexcept {
    fine_.start(block_.delta_pulses, block_.start_speed_per_s * period_s_, block_.max_speed_per_s * period_s_,
                block_.accel_per_s2 * period_s_ * period_s_);
}

bool Executor::is_slowest() const noexcept {
    if (block_.kind == BlockKind::path) return law_.is_slowest();
    return block_.kind == BlockKind::move ? fine_.is_slowest() : profile_.is_slowest();
}

void Executor::rest() noexcept {
    if (block_.kind == BlockKind::path) {
        law_.rest();
    } else if (block_.kind == BlockKind::move) {
        fine_.rest();
    } else {
        profile_.rest();
    }
}

Executor::Progress Executor::emit(std::uint64_t tick) noexcept {
    if (next_axes_ == 0) next_axes_ = dda_.iterate();
    if (!pulses_->may_step(next_axes_, tick)) {
        ++waited_ticks_;
        return kNothing;
    }
    pulses_->step(next_axes_ & ~still_axes_, tick);
    next_axes_ = 0;
    profile_.take();
    return dda_.iterations_left() == 0 ? end_of_way(tick) : kNothing;
}

// A move that looks for a sensor has not found it by the end of its way, unless the filter still thinks.
Executor::Progress Executor::end_of_way(std::uint64_t tick) noexcept {
    if (block_.until == Until::none || sensor_done_) return end_of_line(tick);
    if (must_wait_for_sensor()) return kNothing;
    in_motion_ = false;
    return kNotFound;
}

Executor::Progress Executor::end_of_line(std::uint64_t tick) noexcept {
    Progress progress = reached();
    for (int i = 0; group_blocks_left_ > 0 && i < kEmptyLinesPerTick; ++i) {
        if (!take_next_of_group()) return progress | kStarved;
        dda_.start(block_.delta_pulses);
        if (dda_.iterations_left() > 0) {
            turn_axes(tick);
            return progress;
        }
        progress |= reached();
    }
    in_motion_ = group_blocks_left_ > 0;
    return progress;
}

bool Executor::take_next_of_group() noexcept {
    const MotionBlock* next = blocks_->front();
    if (next == nullptr || next->epoch != epoch_ || next->kind != block_.kind) {
        in_motion_ = false;
        return false;
    }
    block_ = *next;
    blocks_->pop();
    --group_blocks_left_;
    return true;
}

Executor::Progress Executor::reached() noexcept {
    if (block_.reaches_points == 0) return kNothing;
    layer_ = block_.layer;
    point_ = block_.point;
    points_reached_ += block_.reaches_points;
    block_.reaches_points = 0;
    return kPoint;
}

bool Executor::drop_foreign_blocks() noexcept {
    for (int i = 0; i < kDropsPerTick; ++i) {
        const MotionBlock* front = blocks_->front();
        if (front == nullptr) return false;
        if (front->epoch == epoch_) return true;
        blocks_->pop();
    }
    return false;
}

Executor::Progress Executor::next_block(std::uint64_t tick) noexcept {
    if (dwell_left_ > 0) {
        --dwell_left_;
        return kNothing;
    }
    if (!drop_foreign_blocks()) return kNothing;
    const MotionBlock& front = *blocks_->front();
    if ((front.kind == BlockKind::line || front.kind == BlockKind::path) &&
        blocks_->size() < std::min<std::size_t>(front.group_blocks, kGroupStartBlocks)) {
        return kNothing;
    }
    block_ = front;
    blocks_->pop();
    return begin(tick);
}

Executor::Progress Executor::begin(std::uint64_t tick) noexcept {
    switch (block_.kind) {
        case BlockKind::line:
        case BlockKind::path:
        case BlockKind::move:
            return begin_motion(tick);
        case BlockKind::define:
            return define(block_.position_pulses - pulses_->positions()[block_.axis], kDefined);
        case BlockKind::outputs:
            pulses_->set_enables(block_.enable_mask, tick);
            if (block_.spindle != Spindle::keep) pulses_->set_spindle(block_.spindle == Spindle::on);
            return kNothing;
        case BlockKind::dwell:
            dwell_left_ = block_.ticks;
            return kNothing;
        case BlockKind::program_end:
            break;
    }
    homing_axis_ = kNoAxis;
    return kProgramEnd;
}

Executor::Progress Executor::begin_motion(std::uint64_t tick) noexcept {
    group_blocks_left_ = block_.group_blocks > 0 ? block_.group_blocks - 1 : 0;
    homing_axis_ = block_.is_homing != 0 ? block_.axis : kNoAxis;
    sensor_done_ = false;
    index_before_ = inputs_->is_tripped(block_.axis);
    next_axes_ = 0;
    in_motion_ = true;
    if (block_.kind == BlockKind::path) return begin_path(tick);
    bool has_way = false;
    if (block_.kind == BlockKind::move) {
        if (homing_axis_ != kNoAxis) lengthen_by_take_up();
        start_fine();
        has_way = !fine_.is_finished();
    } else {
        dda_.start(block_.delta_pulses);
        profile_.start(block_.start_speed_per_s * period_s_, block_.max_speed_per_s * period_s_,
                       block_.accel_per_s2 * period_s_ * period_s_, block_.group_iterations);
        has_way = dda_.iterations_left() > 0;
    }
    if (!has_way) return kGroupStarted | end_of_line(tick);
    turn_axes(tick);
    return kGroupStarted;
}

Executor::Progress Executor::define(std::int64_t correction, Progress what) noexcept {
    latch_correction_ = correction;
    pulses_->set_position(block_.axis, pulses_->positions()[block_.axis] + correction);
    return what;
}

bool Executor::must_wait_for_sensor() const noexcept {
    return block_.until == Until::sensor_tripped && inputs_->is_raw_tripped(block_.axis);
}

Executor::Progress Executor::watch_sensor() noexcept {
    const bool is_tripped = inputs_->is_tripped(block_.axis);
    const bool was_tripped = index_before_;
    index_before_ = is_tripped;
    if (sensor_done_) return kNothing;
    switch (block_.until) {
        case Until::none:
            return kNothing;
        case Until::sensor_tripped:
            sensor_done_ = is_tripped;
            break;
        case Until::sensor_clear:
            sensor_done_ = !is_tripped && !inputs_->is_raw_tripped(block_.axis);
            break;
        case Until::index_edge:
            sensor_done_ = is_tripped && !was_tripped;
            break;
    }
    if (!sensor_done_ || block_.latch == Latch::none) return kNothing;
    return define(block_.position_pulses - inputs_->edge_position(block_.axis), kLatched);
}

}  // namespace psicarve::cycle
