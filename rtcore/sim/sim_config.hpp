// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "shared/machine/signal.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::sim {

// The simulated machine's configuration: where things are, what its motors can do, how it is wired, its
// faults. Positions are pulses in the profile's coordinates (zero and positive direction as in a file).

enum class SensorKind : std::uint8_t { none, low_end, high_end, index };
enum class SensorFault : std::uint8_t { none, never_trips, always_trips };

struct SensorConfig {
    SensorKind kind = SensorKind::none;
    /// low_end: tripped at and below it; high_end: at and above it; index: from it on, once a turn.
    std::int64_t edge_pulses = 0;
    std::int64_t width_pulses = 1;  ///< index: how far the table turns while it is tripped
    SensorFault fault = SensorFault::none;
    std::int64_t bounce_ns = 0;                    ///< after each change the contact chatters for this time
                                                   ///< ...
    std::int64_t bounce_half_period_ns = 100'000;  ///< ... and toggles at this interval
};

/// What the axis' motor can really do. motor.hpp explains the values.
struct MotorConfig {
    double speed_pps = 0.0;
    double accel_pps2 = 0.0;
    double start_stop_pps = 0.0;
    double slip_pulses = 16.0;  ///< lag at which it falls out of step: two full steps at 1/8 step
};

struct AxisConfig {
    std::int64_t start_pulses = 0;
    bool has_ends = false;  ///< mechanical stops; psi has none
    std::int64_t low_end_pulses = 0;
    std::int64_t high_end_pulses = 0;
    std::int64_t pulses_per_turn = 0;  ///< psi; 0 for a linear axis
    double pulses_per_mm = 0.0;        ///< of a linear axis
    std::int64_t backlash_pulses = 0;
    SensorConfig sensor;
    MotorConfig motor;
};

/// How a head truly stands, whatever the core's profile says.
struct HeadConfig {
    double tip_mm = 0.0;         ///< the tip is this much further out than the carriage
    double direction_deg = 0.0;  ///< the workpiece direction that it faces at table angle 0
    double height_mm = 0.0;      ///< the tip is this much above the heads' height
};

/// A cylinder that stands on the table, round its axis; 0: nothing stands there.
struct BlankConfig {
    double diameter_mm = 0.0;
    double height_mm = 0.0;
};

/// What the drivers ask of their inputs; a pulse that breaks it is lost.
struct DriverTiming {
    std::int64_t dir_setup_ns = 0;
    std::int64_t dir_hold_ns = 0;
    std::int64_t step_high_ns = 0;
    std::int64_t step_low_ns = 0;
};

/// Which pin of the connector goes to which signal of the machine. Pins as in a profile: 1..17, negative:
/// active low, 0: not wired.
struct WiringConfig {
    std::array<int, kSignalCount> pins{};
    std::array<bool, kAxisCount> positive_is_high{true, true, true, true};
};

inline constexpr std::int64_t kForeverNs = std::numeric_limits<std::int64_t>::max() / 2;

/// An input that shows a wrong level for a while: a pressed switch, a glitch, a chattering contact.
struct InputFault {
    Signal signal = Signal::estop;
    std::int64_t start_ns = 0;  ///< since the start of time, or after the trigger
    /// When set, time counts from the moment this axis first stands at `trigger_pulses` or past it, seen
    /// from its start.
    std::optional<Axis> trigger_axis;
    std::int64_t trigger_pulses = 0;
    std::int64_t duration_ns = kForeverNs;
    bool level = true;                ///< the level it shows: tripped, or not
    std::int64_t half_period_ns = 0;  ///< > 0: it shows `level` and the truth in turns of this length
};

/// The axis moves without a pulse, or a pulse without the axis: after the axis has taken `after_pulses`
/// pulses its position changes by `slip_pulses`.
struct SlipFault {
    Axis axis = Axis::psi;
    std::uint64_t after_pulses = 0;
    std::int64_t slip_pulses = 0;
};

struct SimConfig {
    std::array<AxisConfig, kAxisCount> axes;  ///< by Axis
    std::array<HeadConfig, 2> heads;          ///< r1, r2
    BlankConfig blank;
    DriverTiming timing;
    WiringConfig wiring;
    std::vector<InputFault> input_faults;
    std::vector<SlipFault> slip_faults;

    AxisConfig& axis(Axis which) noexcept { return axes[index_of(which)]; }
    const AxisConfig& axis(Axis which) const noexcept { return axes[index_of(which)]; }
};

// What the usual machine has to spare over its profile: a motor that gets no more than the profile's demands
// must never stall, however the ticks fall.
inline constexpr double kSpeedReserve_ratio = 1.3;
inline constexpr double kAccelReserve_ratio = 1.5;
inline constexpr double kStartStopReserve_ratio = 1.3;

/// The index is tripped over a four-hundredth of a turn (0.9 degrees), from its position on.
inline constexpr std::int64_t kIndexWidths_per_rev = 400;
inline constexpr double kYStartOffSensor_mm = 5.0;

/// The usual machine for a profile: heads, with their errors, and sensors where the profile says, mechanical
/// stops an overtravel beyond, motors with the reserves above, drivers with exactly the profile's timing,
/// wired as in [port.pins]. It starts with the heads in the middle of their travel, y a little off its
/// sensor, psi a quarter turn before its index; all of it within its coordinates, so that homing has nothing
/// to correct.
SimConfig sim_config_from_profile(const Profile& profile);

}  // namespace psicarve::sim
