// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "rtcore/cycle/cycle_config.hpp"
#include "shared/job/outside.hpp"
#include "shared/machine/signal.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::plan {

using Pulses4 = std::array<std::int64_t, kAxisCount>;

/// Speed of the long axis over one acceleration group: DDA iterations per second.
struct GroupLimits {
    double start_per_s;
    double max_per_s;
    double accel_per_s2;
};

/// Seconds after which a motor that stopped with a jump may jump off again.
inline constexpr double kRest_s = 0.01;

/// A profile as the planners need it: pulses and seconds, and what the ticks allow.
struct MachineLimits {
    std::array<AxisMotion, kAxisCount> axes;
    psicarve::Planner planner = psicarve::Planner::lookahead;
    cycle::CycleConfig tick;
    double max_iterations_per_s = 0.0;  ///< one axis' step high and low over whole ticks
    double pace = 1.0;  ///< at which a carving goes that was planned for all that the axes have
    double feed_mm_s = 0.0;
    double plunge_mm_s = 0.0;
    double path_tolerance_mm = 0.0;
    double blank_radius_mm = 0.0;  ///< 0: the job's largest
    std::int64_t pulses_per_rev = 6400;
    double sin_corner = 0.0;  ///< of corner_deg
    double cos_corner = 1.0;
    std::array<double, 2> tip_offset_mm{};           ///< by head: the tip stands this much further out
    std::array<std::int64_t, 2> clearance_pulses{};  ///< by head
    std::array<std::int64_t, 2> retract_pulses{};
    std::array<double, 2> least_radius_pulses{};  ///< by head, as counted: the core, or the travel's end
    OutsideRule outside_rule;
    HeadsOutside outside;  ///< of a job that is carved: where a head keeps to no feed
    bool is_program =
        false;  ///< what is planned is a program: Y is an axis as the heads are, not a table's rows
    std::int64_t spinup_ticks = 0;
    std::int64_t rest_ticks = 0;  ///< after which a motor that stopped with a jump may jump off again

    double tick_seconds() const noexcept { return 1e-9 * static_cast<double>(tick.interpolation_ns()); }
};
MachineLimits machine_limits(const Profile& profile);

/// What every axis' own limits make of a straight line: the least of limit_k * S / |delta_k|, and what the
/// ticks allow. `speed_cap_pps` lowers an axis' top speed (0: as it is).
GroupLimits line_limits(const MachineLimits& limits, const Pulses4& delta_pulses,
                        const std::array<double, kAxisCount>& speed_cap_pps = {});

/// Seconds that so many iterations take from start speed to start speed.
double group_seconds(const GroupLimits& limits, std::uint64_t iterations);

}  // namespace psicarve::plan
