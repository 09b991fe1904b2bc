// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "shared/machine/signal.hpp"

namespace psicarve::sim {

/// What happened to one axis since the machine was built. Every step edge ends in exactly one of: taken,
/// ignored, lost to timing, lost in a stall, lost at a stop.
struct AxisReport {
    std::int64_t position_pulses = 0;       ///< where the carriage or table really is
    std::int64_t motor_pulses = 0;          ///< where the motor is: differs by the backlash at most
    std::uint64_t pulses_taken = 0;         ///< moved the motor
    std::uint64_t pulses_ignored = 0;       ///< drive disabled
    std::uint64_t lost_dir_setup = 0;       ///< step edge too soon after the direction changed
    std::uint64_t lost_dir_hold = 0;        ///< direction changed too soon after the step edge
    std::uint64_t lost_step_high = 0;       ///< step pulse too short
    std::uint64_t lost_step_low = 0;        ///< gap before the step pulse too short
    std::uint64_t stalls = 0;               ///< times the motor fell out of step
    std::uint64_t pulses_lost_stalled = 0;  ///< pulses that a stalled motor did not follow
    std::uint64_t slipped_pulses = 0;       ///< distance between count and rotor when it fell out of step
    std::uint64_t crashes = 0;              ///< times it ran into a mechanical stop
    std::uint64_t pulses_lost_at_stop = 0;  ///< pulses into a stop
    std::uint64_t sensor_changes = 0;       ///< of the axis' own sensor, as the pin shows it

    std::uint64_t timing_lost() const noexcept {
        return lost_dir_setup + lost_dir_hold + lost_step_high + lost_step_low;
    }
};

struct SimReport {
    std::array<AxisReport, kAxisCount> axes;  ///< by Axis
    std::int64_t spindle_on_ns = 0;           ///< sum over the spindle's runs that have ended
    std::uint64_t spindle_starts = 0;

    const AxisReport& axis(Axis which) const noexcept { return axes[index_of(which)]; }
};

}  // namespace psicarve::sim
