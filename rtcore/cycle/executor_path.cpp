// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/executor.hpp"

#include <algorithm>
#include <cstdlib>

namespace psicarve::cycle {
namespace {

// An iteration that is due at the very instant of a tick must not fall behind it by rounding.
constexpr double kEarlyIterations = 1e-9;
// Segments may be shorter than a tick; so many of them end in one, the rest in the next.
constexpr int kSegmentsPerTick = 8;

/// Whether time passes in it at all. What does not end would hold the machine for good, without a word.
bool can_end(const PathTiming& timing) noexcept {
    return timing.length > 0.0 && timing.start_speed2[0] >= 0.0 && timing.end_speed2[0] >= 0.0 &&
           timing.start_speed2[0] + timing.end_speed2[0] > 0.0;
}

}  // namespace

// At most one iteration a tick, and at most one segment of which is emitted: what else is due is late by a
// tick, while time goes on.
Executor::Progress Executor::advance_path(std::uint64_t tick) noexcept {
    if (law_.way() < due_way_ + iteration_way_) law_.tick();
    if (next_axes_ == 0 && is_iteration_due()) next_axes_ = dda_.iterate();
    bool has_stepped = false;
    Progress progress = kNothing;
    for (int i = 0; i < kSegmentsPerTick; ++i) {
        if (next_axes_ != 0) {
            if (!pulses_->may_step(next_axes_, tick)) {
                ++waited_ticks_;
                return progress;
            }
            pulses_->step(next_axes_ & ~still_axes_, tick);
            next_axes_ = 0;
            has_stepped = true;
            expect_iteration(iteration_ + 1.0);
        }
        if (!is_segment_done()) return progress;
        progress |= reached();
        if (group_blocks_left_ == 0) {
            in_motion_ = false;
            return progress;
        }
        if (!take_next_of_group() || !can_end(block_.path)) {
            in_motion_ = false;
            return progress | kStarved;
        }
        law_.next(block_.path);
        begin_segment(tick);
        if (is_taking_up_) return progress;
        if (!has_stepped && is_iteration_due()) next_axes_ = dda_.iterate();
    }
    return progress;
}

// The last one is due with the segment's end, so that way and pulses end together.
bool Executor::is_iteration_due() const noexcept {
    const std::int64_t left = dda_.iterations_left();
    return left > 0 && (law_.is_at_end() || (left > 1 && law_.way() >= due_way_));
}

bool Executor::is_segment_done() const noexcept {
    return law_.is_at_end() && dda_.iterations_left() == 0 && next_axes_ == 0;
}

Executor::Progress Executor::begin_path(std::uint64_t tick) noexcept {
    if (!can_end(block_.path)) {
        in_motion_ = false;
        return kStarved;
    }
    law_.start(block_.path);
    begin_segment(tick);
    return kGroupStarted;
}

void Executor::begin_segment(std::uint64_t tick) noexcept {
    start_dda();
    const std::int64_t iterations = dda_.iterations_left();
    iteration_way_ =
        iterations > 0 ? block_.path.length / static_cast<double>(iterations) : block_.path.length;
    expect_iteration(1.0);
    turn_axes(tick);
    if (!is_taking_up_) turn_idle_axes(tick);
}

void Executor::start_dda() noexcept {
    std::array<std::int64_t, kAxisCount> line{};
    std::int64_t longest = 0;
    std::int64_t count = 0;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        line[k] = block_.line_pulses[k];
        longest = std::max(longest, std::abs(line[k]));
        count = std::max(count, std::abs(block_.delta_pulses[k]));
    }
    if (block_.line_done >= 0 && longest > 0 && block_.line_done + count <= longest) {
        dda_.start_within(line, block_.line_done, count);
    } else {
        dda_.start(block_.delta_pulses);
    }
}

// An axis without a pulse in this segment may already turn for the next one: its pins then need not be waited
// for.
void Executor::turn_idle_axes(std::uint64_t tick) noexcept {
    const MotionBlock* next = group_blocks_left_ > 0 ? blocks_->front() : nullptr;
    if (next == nullptr || next->epoch != epoch_ || next->kind != BlockKind::path) return;
    std::array<std::int64_t, kAxisCount> way = block_.delta_pulses;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        if (way[k] == 0) way[k] = next->delta_pulses[k];
    }
    if (way != block_.delta_pulses) pulses_->want_directions(way, tick);
}

void Executor::expect_iteration(double number) noexcept {
    iteration_ = number;
    due_way_ = (number - kEarlyIterations) * iteration_way_;
}

}  // namespace psicarve::cycle
