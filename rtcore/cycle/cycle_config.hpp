// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "rtcore/cycle/soft_limits.hpp"
#include "shared/machine/signal.hpp"

namespace psicarve::cycle {

enum class SensorEnd : std::uint8_t { none, low, high, index };

/// One axis as the tick needs it.
struct AxisConfig {
    SensorEnd sensor_end = SensorEnd::none;
    bool has_sensor = false;       ///< wired, and used for homing
    std::int64_t coast_ticks = 0;  ///< 1/j_k: a longer gap in ticks loses a moving rotor's steps
    std::int64_t travel_min_pulses = 0;
    std::int64_t travel_max_pulses = 0;
    std::int64_t backlash_pulses = 0;  ///< what a reversal turns before the tip moves
    /// j_k, v_k, a_k in pulses and steps of the interpolation, as far as the pins keep up.
    double start_stop_per_tick = 0.0;
    double speed_per_tick = 0.0;
    double accel_per_tick2 = 0.0;
};

/// A machine profile in ticks and pulses: all that the tick knows of it. Long, and without a word of its own:
/// each part of the tick takes from it what it needs, once.
struct CycleConfig {
    std::int64_t period_ns = 50'000;
    /// Schedule two-timer: inputs are read and pulses leave every so many ticks. 0: schedule single.
    std::int64_t io_ticks = 0;
    std::int64_t interpolation_ticks = 1;  ///< from one step of the interpolation to the next
    std::array<AxisConfig, kAxisCount> axes;
    SoftLimits soft_limits;
    std::array<std::int64_t, 2> lift_pulses{};     ///< on hold, by head; 0: it stays in the cut
    std::array<double, 2> lower_speed_per_tick{};  ///< of the way back
    std::int64_t rest_ticks = 0;  ///< after which a motor that stopped with a jump may jump off again
    /// Not 0: a pulse ends so long after its begin, in the same tick, and step_high_ticks is 0.
    std::int64_t pulse_ns = 0;
    std::int64_t step_high_ticks = 1;  ///< this and the next three otherwise at least 1
    std::int64_t step_low_ticks = 1;
    std::int64_t dir_setup_ticks = 1;
    std::int64_t dir_hold_ticks = 1;
    std::int64_t filter_ticks = 0;   ///< a limit counts when its level stood for so long
    SignalWord input_mask = 0;       ///< inputs that are wired
    bool has_charge_pump = false;    ///< an output that toggles with every tick
    std::uint8_t switched_axes = 0;  ///< whose drives the safe state switches off: enable is wired
    bool has_index = false;
    std::int64_t pulses_per_rev = 6400;
    std::int64_t index_position_pulses = 0;
    std::int64_t index_tolerance_pulses = 2;
    std::uint64_t sample_ticks = 20;  ///< the sample is renewed this often, and on every change of state

    bool has_two_timers() const noexcept { return io_ticks > 0; }
    /// From one step of inputs and pulses to the next.
    std::int64_t step_ticks() const noexcept { return has_two_timers() ? io_ticks : 1; }
    std::int64_t interpolation_ns() const noexcept { return interpolation_ticks * period_ns; }
};

}  // namespace psicarve::cycle
