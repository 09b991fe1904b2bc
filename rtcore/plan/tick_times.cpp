// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/tick_times.hpp"

#include <algorithm>
#include <cmath>

#include "rtcore/cycle/fine_move.hpp"
#include "rtcore/cycle/straight_way.hpp"
#include "rtcore/plan/speed_up.hpp"
#include "shared/base/units.hpp"

namespace psicarve::plan {
namespace {

using cycle::BlockKind;
using cycle::MotionBlock;

// What ends with a step ends in it, though sums are rounded.
constexpr double kLateSteps = 1e-6;

bool moves_axes(const MotionBlock& block) {
    return block.kind == BlockKind::line || block.kind == BlockKind::path || block.kind == BlockKind::move;
}

double line_seconds(const MotionBlock& first_of_group) {
    return group_seconds(
        {first_of_group.start_speed_per_s, first_of_group.max_speed_per_s, first_of_group.accel_per_s2},
        first_of_group.group_iterations);
}

}  // namespace

TickTimes::TickTimes(const MachineLimits& limits) : tick_(limits.tick) {
    for (const cycle::AxisConfig& axis : tick_.axes) has_gaps_ = has_gaps_ || axis.backlash_pulses > 0;
    is_up_[kPsi] = true;
    // Homing leaves its sensor, and the approach goes on that way.
    is_up_[kY] = tick_.axes[kY].sensor_end != cycle::SensorEnd::high;
}

double TickTimes::seconds_of(std::span<const MotionBlock> blocks) {
    const std::int64_t begin = now_;
    for (auto first = blocks.begin(); first != blocks.end();) {
        const auto is_next = [](const MotionBlock& block) {
            return block.group_blocks > 0 || !moves_axes(block);
        };
        const auto end = std::find_if(first + 1, blocks.end(), is_next);
        if (moves_axes(*first)) {
            pass({first, end});
        } else {
            now_ += ((first->kind == BlockKind::dwell ? first->ticks : 0) + 1) * tick_.interpolation_ticks;
        }
        first = end;
    }
    return static_cast<double>(now_ - begin) * seconds_from_ns(tick_.period_ns);
}

void TickTimes::pass(std::span<const MotionBlock> group) {
    std::int64_t steps = 0;
    if (has_gaps_) {
        for (const MotionBlock& block : group) steps += steps_in_gaps_before(block);
    }
    const MotionBlock& first = group.front();
    if (first.kind != BlockKind::path) {
        steps +=
            steps_in(line_seconds(first), first.kind == BlockKind::move ? cycle::FineMove::kCoarseTicks : 1);
        return pass(steps, steps);
    }
    double seconds = 0.0;
    double to_last_pulse_s = 0.0;
    for (const MotionBlock& block : group) {
        seconds += path_seconds(block.path);
        if (block.delta_pulses != Pulses4{}) to_last_pulse_s = seconds;
    }
    pass(steps + steps_in(seconds), steps + steps_in(to_last_pulse_s));
}

// What comes next begins in the first step behind these, once the last pulse is out: with two timers it waits
// for the next tick of inputs and pulses.
void TickTimes::pass(std::int64_t steps, std::int64_t steps_to_last_pulse) {
    const std::int64_t step_ticks = tick_.interpolation_ticks;
    const std::int64_t out_ticks = std::max<std::int64_t>(tick_.io_ticks, 1);
    const std::int64_t last_pulse = now_ + steps_to_last_pulse * step_ticks;
    const std::int64_t out = last_pulse + out_ticks - last_pulse % out_ticks;
    const std::int64_t out_step = (out + step_ticks - 1) / step_ticks * step_ticks;
    now_ = std::max(now_ + (steps + 1) * step_ticks, out_step);
}

std::int64_t TickTimes::steps_in(double seconds, std::int64_t period_steps) const {
    const double step_s = seconds_from_ns(tick_.interpolation_ns());
    const double periods = seconds / (step_s * static_cast<double>(period_steps));
    return period_steps * static_cast<std::int64_t>(std::ceil(periods - kLateSteps));
}

// As TakeUp::begin().
std::int64_t TickTimes::steps_in_gaps_before(const MotionBlock& block) {
    Pulses4 way_pulses{};
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        const bool up = block.delta_pulses[k] > 0 || (block.up_axes >> k & 1U) != 0;
        const bool down = block.delta_pulses[k] < 0 || (block.down_axes >> k & 1U) != 0;
        if (up == down || up == is_up_[k]) continue;
        is_up_[k] = up;
        way_pulses[k] = tick_.axes[k].backlash_pulses;
    }
    return way_pulses == Pulses4{} ? 0 : steps_across(way_pulses);
}

std::int64_t TickTimes::steps_across(const Pulses4& way_pulses) {
    const auto [known, is_new] = known_.try_emplace(way_pulses, 0);
    if (!is_new) return known->second;
    cycle::SpeedLimits4 most_per_tick{};
    for (std::size_t k = 0; k < kAxisCount; ++k) most_per_tick[k] = tick_.axes[k].speed_per_tick;
    cycle::FineMove move;
    cycle::start_straight(move, tick_, way_pulses, most_per_tick);
    for (; !move.is_finished(); ++known->second) {
        move.tick(false);
        const std::uint32_t due = move.due();
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            if ((due >> k & 1U) != 0) move.take(k);
        }
    }
    return known->second;
}

}  // namespace psicarve::plan
