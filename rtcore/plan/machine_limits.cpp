// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/machine_limits.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "rtcore/plan/cycle_config_from_profile.hpp"
#include "shared/base/units.hpp"

namespace psicarve::plan {
namespace {

struct SineCosine {
    double sine;
    double cosine;
};

// The power series: libm's last bit differs between machines, plain arithmetic does not.
SineCosine sine_cosine(double angle_rad) {
    constexpr int kTerms = 40;  // far beyond double precision for angles up to a half turn
    double sine = 0.0;
    double cosine = 0.0;
    double term = 1.0;
    for (int n = 0; n < kTerms; ++n) {
        const double signed_term = n % 4 < 2 ? term : -term;
        (n % 2 == 0 ? cosine : sine) += signed_term;
        term *= angle_rad / static_cast<double>(n + 1);
    }
    return {sine, cosine};
}

// Pulses leave up to a whole io period late: what the motors' limits grant a pulse that is late at their top
// speed is used up, and what makes good for it is kept back.
constexpr double kTwoTimerPace = 0.96;

}  // namespace

MachineLimits machine_limits(const Profile& profile) {
    MachineLimits limits;
    for (const Axis axis : kAllAxes) limits.axes[index_of(axis)] = axis_motion(profile, axis);
    limits.tick = cycle_config_from_profile(profile);
    if (limits.tick.has_two_timers()) limits.pace = kTwoTimerPace;
    const double tick_s = seconds_from_ns(limits.tick.interpolation_ns());
    limits.max_iterations_per_s =
        limits.tick.has_two_timers()
            ? 1.0 / seconds_from_ns(pulse_period_ns(profile))
            : 1.0 / (tick_s * static_cast<double>(limits.tick.step_high_ticks + limits.tick.step_low_ticks));
    limits.planner = profile.job.planner;
    limits.feed_mm_s = profile.job.feed_mm_s;
    limits.plunge_mm_s = profile.job.plunge_mm_s;
    limits.path_tolerance_mm = profile.job.path_tolerance_mm;
    limits.blank_radius_mm = profile.blank.reach_mm();
    limits.outside_rule = outside_rule(profile);
    limits.pulses_per_rev = profile.psi.pulses_per_rev;
    const SineCosine corner = sine_cosine(rad_from_deg(profile.job.corner_deg));
    limits.sin_corner = corner.sine;
    limits.cos_corner = corner.cosine;
    limits.tip_offset_mm = {profile.r1.tip_mm(), profile.r2.tip_mm()};
    for (std::size_t head = 0; head < 2; ++head) {
        const double scale = limits.axes[head].pulses_per_unit;
        limits.clearance_pulses[head] = pulses_from_mm(profile.job.clearance_mm, scale);
        limits.retract_pulses[head] = pulses_from_mm(profile.job.retract_mm, scale);
        limits.least_radius_pulses[head] =
            std::max((profile.core_radius_mm - limits.tip_offset_mm[head]) * scale,
                     static_cast<double>(limits.axes[head].travel_min_pulses));
    }
    limits.rest_ticks = round_to_pulse(kRest_s / tick_s);
    limits.spinup_ticks = round_to_pulse(profile.job.spindle_spinup_s / tick_s);
    return limits;
}

GroupLimits line_limits(const MachineLimits& limits, const Pulses4& delta_pulses,
                        const std::array<double, kAxisCount>& speed_cap_pps) {
    std::int64_t capacity = 0;
    for (const std::int64_t delta : delta_pulses) capacity = std::max(capacity, std::abs(delta));
    GroupLimits result{limits.max_iterations_per_s, limits.max_iterations_per_s, 0.0};
    bool is_first = true;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        if (delta_pulses[k] == 0) continue;
        const AxisMotion& axis = limits.axes[k];
        const double ratio = static_cast<double>(capacity) / static_cast<double>(std::abs(delta_pulses[k]));
        const double speed_pps =
            speed_cap_pps[k] > 0.0 ? std::min(axis.speed_pps, speed_cap_pps[k]) : axis.speed_pps;
        result.max_per_s = std::min(result.max_per_s, speed_pps * ratio);
        result.start_per_s = std::min(result.start_per_s, axis.start_stop_pps * ratio);
        const double accel = axis.accel_pps2 * ratio;
        result.accel_per_s2 = is_first ? accel : std::min(result.accel_per_s2, accel);
        is_first = false;
    }
    result.start_per_s = std::min(result.start_per_s, result.max_per_s);
    return result;
}

double group_seconds(const GroupLimits& limits, std::uint64_t iterations) {
    const double way = static_cast<double>(iterations);
    const double start = limits.start_per_s;
    if (way <= 0.0) return 0.0;
    const double ramps = (limits.max_per_s * limits.max_per_s - start * start) / limits.accel_per_s2;
    if (ramps <= way) {
        return 2.0 * (limits.max_per_s - start) / limits.accel_per_s2 + (way - ramps) / limits.max_per_s;
    }
    const double top = std::sqrt(start * start + limits.accel_per_s2 * way);
    return 2.0 * (top - start) / limits.accel_per_s2;
}

}  // namespace psicarve::plan
