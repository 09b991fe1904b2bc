// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>

#include "rtcore/cycle/motion_block.hpp"
#include "rtcore/plan/machine_limits.hpp"

namespace psicarve::plan {

/// How long the tick takes for the blocks of a table at 100 %: their motion in whole steps of the
/// interpolation, the step in which it begins each group, with two timers the wait for the last pulse, and
/// the fine moves by which axes with backlash cross their gaps. Begins with what an approach from home
/// leaves: heads came inwards, psi and Y stand as homing left them.
class TickTimes {
public:
    explicit TickTimes(const MachineLimits& limits);

    /// Of the next blocks that the tick gets, whole groups [s].
    double seconds_of(std::span<const cycle::MotionBlock> blocks);

private:
    void pass(std::span<const cycle::MotionBlock> group);
    void pass(std::int64_t steps, std::int64_t steps_to_last_pulse);
    std::int64_t steps_in(double seconds, std::int64_t period_steps = 1) const;
    std::int64_t steps_in_gaps_before(const cycle::MotionBlock& block);
    std::int64_t steps_across(const Pulses4& way_pulses);

    cycle::CycleConfig tick_;
    bool has_gaps_ = false;
    std::int64_t now_ = 0;                   ///< ticks since a tick of inputs and pulses
    std::array<bool, kAxisCount> is_up_{};   ///< the way that each went last
    std::map<Pulses4, std::int64_t> known_;  ///< steps across these gaps at once
};

}  // namespace psicarve::plan
