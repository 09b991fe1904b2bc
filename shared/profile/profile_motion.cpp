// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "shared/base/units.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve {
namespace {

AxisMotion linear_motion(const LinearAxisProfile& axis) {
    const double scale = axis.pulses_per_mm;
    AxisMotion motion{.pulses_per_unit = scale,
                      .speed_pps = axis.speed_mm_s * scale,
                      .accel_pps2 = axis.accel_mm_s2 * scale,
                      .start_stop_pps = axis.start_stop_mm_s * scale,
                      .home_speed_pps = axis.home_speed_mm_s * scale,
                      .travel_min_pulses = pulses_from_mm(axis.travel_mm[0], scale),
                      .travel_max_pulses = pulses_from_mm(axis.travel_mm[1], scale),
                      .home_position_pulses = pulses_from_mm(axis.home_position_mm, scale),
                      .overtravel_pulses = pulses_from_mm(axis.overtravel_mm, scale),
                      .backlash_pulses = pulses_from_mm(axis.backlash_mm, scale),
                      .home = axis.home,
                      .has_travel = true,
                      .positive_is_high = axis.positive_is_high};
    // Where the sensor ends the travel: at its home position it is clear, one pulse further it trips.
    if (axis.home == HomeSensor::max) {
        motion.travel_max_pulses = std::min(motion.travel_max_pulses, motion.home_position_pulses);
    }
    if (axis.home == HomeSensor::min) {
        motion.travel_min_pulses = std::max(motion.travel_min_pulses, motion.home_position_pulses);
    }
    return motion;
}

AxisMotion rotary_motion(const RotaryAxisProfile& axis) {
    const double scale = static_cast<double>(axis.pulses_per_rev) / kDegPerRev;
    return {.pulses_per_unit = scale,
            .speed_pps = axis.speed_deg_s * scale,
            .accel_pps2 = axis.accel_deg_s2 * scale,
            .start_stop_pps = axis.start_stop_deg_s * scale,
            .home_speed_pps = axis.home_speed_deg_s * scale,
            .home_position_pulses = pulses_from_deg(axis.home_position_deg, axis.pulses_per_rev),
            .backlash_pulses = pulses_from_deg(axis.backlash_deg, axis.pulses_per_rev),
            .home = axis.home,
            .has_travel = false,
            .positive_is_high = axis.positive_is_high};
}

}  // namespace

AxisMotion axis_motion(const Profile& profile, Axis axis) {
    switch (axis) {
        case Axis::r1:
            return linear_motion(profile.r1);
        case Axis::r2:
            return linear_motion(profile.r2);
        case Axis::psi:
            return rotary_motion(profile.psi);
        case Axis::y:
            break;
    }
    return linear_motion(profile.y);
}

std::int64_t tick_period_ns(const Profile& profile) noexcept {
    return round_to_pulse(profile.tick.period_us * static_cast<double>(kNsPerUs));
}

// Counted from the end of a write to the begin of the next one: without room for the writes each tick would
// end later than the one before, until one is missed.
std::int64_t ticks_between_edges(std::int64_t time_ns, std::int64_t period_ns) noexcept {
    constexpr std::int64_t kWrite_ns = 2'500;  // two registers, and two looks at the clock
    return std::max<std::int64_t>(1, ticks_covering_ns(time_ns + kWrite_ns, period_ns));
}

std::int64_t pulse_within_tick_ns(const Profile& profile) noexcept {
    constexpr std::int64_t kWrites_ns = 5'000;  // two registers, twice, and some lateness
    return profile.port.step_high_ns + profile.port.step_low_ns + kWrites_ns;
}

std::int64_t pulse_period_ns(const Profile& profile) noexcept {
    const std::int64_t period_ns = tick_period_ns(profile);
    if (profile.tick.schedule == Schedule::two_timer) {
        return round_to_pulse(profile.tick.io_us * static_cast<double>(kNsPerUs));
    }
    if (profile.port.pulses == PulseForm::within_tick) return period_ns;
    return period_ns * (ticks_between_edges(profile.port.step_high_ns, period_ns) +
                        ticks_between_edges(profile.port.step_low_ns, period_ns));
}

std::int64_t core_radius_pulses(const Profile& profile, Axis head) noexcept {
    const LinearAxisProfile& axis = head == Axis::r2 ? profile.r2 : profile.r1;
    return pulses_from_mm(profile.core_radius_mm - axis.tip_mm(), axis.pulses_per_mm);
}

}  // namespace psicarve
