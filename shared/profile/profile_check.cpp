// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <initializer_list>

#include "shared/base/units.hpp"
#include "shared/profile/profile_table.hpp"

namespace psicarve::profile_detail {
namespace {

/// The numbers of an axis that must fit each other, whatever their unit.
struct AxisKeys {
    std::string table;       ///< "axis.r1."
    std::string unit;        ///< "mm" or "deg"
    std::string speed_unit;  ///< as in key names: "mm_s" or "deg_s"
};

AxisKeys keys_of(Axis axis) {
    const bool rotary = axis == Axis::psi;
    return {"axis." + std::string(name_of(axis)) + ".", rotary ? "deg" : "mm", rotary ? "deg_s" : "mm_s"};
}

struct AxisSpeeds {
    double speed;
    double start_stop;
    double home_speed;
};

AxisSpeeds speeds_of(const Profile& profile, Axis axis) {
    const auto linear = [](const LinearAxisProfile& a) {
        return AxisSpeeds{a.speed_mm_s, a.start_stop_mm_s, a.home_speed_mm_s};
    };
    switch (axis) {
        case Axis::r1:
            return linear(profile.r1);
        case Axis::r2:
            return linear(profile.r2);
        case Axis::psi:
            break;
        case Axis::y:
            return linear(profile.y);
    }
    return {profile.psi.speed_deg_s, profile.psi.start_stop_deg_s, profile.psi.home_speed_deg_s};
}

std::optional<Problem> check_speeds(const Profile& profile, Axis axis) {
    const AxisKeys keys = keys_of(axis);
    const AxisSpeeds speeds = speeds_of(profile, axis);
    const std::string speed_key = keys.table + "speed_" + keys.speed_unit;
    const auto above = [&](const std::string& leaf, double value) -> std::optional<Problem> {
        const std::string key = keys.table + leaf + "_" + keys.speed_unit;
        if (value <= speeds.speed) return std::nullopt;
        return Problem{key,
                       {speed_key},
                       number_text(value) + " " + keys.unit + "/s is above the axis' top speed of " +
                           number_text(speeds.speed) + " " + keys.unit + "/s; lower it, or raise " +
                           speed_key};
    };
    if (auto problem = above("start_stop", speeds.start_stop)) return problem;
    return above("home_speed", speeds.home_speed);
}

std::optional<Problem> check_travel(const LinearAxisProfile& axis, const AxisMotion& motion,
                                    const std::string& table) {
    const std::string low = number_text(axis.travel_mm[0]);
    const std::string high = number_text(axis.travel_mm[1]);
    if (!(axis.travel_mm[0] < axis.travel_mm[1])) {
        return Problem{table + "travel_mm",
                       {},
                       "the travel from " + low + " to " + high +
                           " mm is empty or reversed; give the lowest position first"};
    }
    const std::string home_key = table + "home_position_mm";
    const std::vector<std::string> also{table + "travel_mm", table + "home", table + "overtravel_mm"};
    const std::string at = number_text(axis.home_position_mm) + " mm ";
    if (axis.home_position_mm < axis.travel_mm[0] - axis.overtravel_mm ||
        axis.home_position_mm > axis.travel_mm[1] + axis.overtravel_mm) {
        return Problem{home_key, also,
                       at + "lies outside the travel of " + low + " to " + high + " mm by more than the " +
                           number_text(axis.overtravel_mm) +
                           " mm of overtravel; give a position that the axis can reach"};
    }
    if (motion.travel_min_pulses >= motion.travel_max_pulses) {
        const bool at_max = axis.home == HomeSensor::max;
        return Problem{home_key, also,
                       at + "as the " + (at_max ? "max" : "min") +
                           " sensor's edge leaves nothing of the travel of " + low + " to " + high +
                           " mm; put it at the travel's " + (at_max ? "upper" : "lower") +
                           " end, or correct " + table + "home"};
    }
    return std::nullopt;
}

std::optional<Problem> check_heads(const Profile& profile) {
    for (const Axis axis : {Axis::r1, Axis::r2}) {
        if (core_radius_pulses(profile, axis) < axis_motion(profile, axis).travel_max_pulses) continue;
        const std::string table = keys_of(axis).table;
        return Problem{"core_radius_mm",
                       {table + "travel_mm", table + "tip_offset_mm", table + "home_position_mm"},
                       number_text(profile.core_radius_mm) + " mm is out of the reach of head " +
                           std::string(name_of(axis)) + "; lower it, or widen " + table + "travel_mm"};
    }
    return std::nullopt;
}

/// With both heads out to the end of their travel the tips are as far apart as possible.
std::optional<Problem> check_head_clearance(const Profile& profile) {
    double most_mm = 0.0;
    for (const Axis axis : {Axis::r1, Axis::r2}) {
        const AxisMotion motion = axis_motion(profile, axis);
        most_mm += mm_from_pulses(motion.travel_max_pulses, motion.pulses_per_unit);
    }
    most_mm += profile.r1.tip_mm() + profile.r2.tip_mm();
    if (profile.head_clearance_mm < most_mm) return std::nullopt;
    return Problem{"head_clearance_mm",
                   {"axis.r1.travel_mm", "axis.r2.travel_mm", "axis.r1.tip_offset_mm",
                    "axis.r2.tip_offset_mm", "axis.r1.tool_wear_mm", "axis.r2.tool_wear_mm"},
                   number_text(profile.head_clearance_mm) +
                       " mm is more than the tips are apart with both heads out, " + number_text(most_mm) +
                       " mm; lower it"};
}

std::optional<Problem> check_psi(const RotaryAxisProfile& psi) {
    if (psi.pulses_per_rev % 2 != 0) {
        return Problem{"axis.psi.pulses_per_rev",
                       {},
                       std::to_string(psi.pulses_per_rev) +
                           " is odd, so half a revolution is no whole number of pulses; give an even number"};
    }
    if (2 * psi.index_tolerance_pulses >= psi.pulses_per_rev) {
        return Problem{"axis.psi.index_tolerance_pulses",
                       {"axis.psi.pulses_per_rev"},
                       std::to_string(psi.index_tolerance_pulses) + " is half a revolution of " +
                           std::to_string(psi.pulses_per_rev) +
                           " pulses or more, so lost steps would never be noticed; lower it"};
    }
    return std::nullopt;
}

std::optional<Problem> check_schedule(const Profile& profile) {
    if (profile.tick.schedule != Schedule::two_timer) return std::nullopt;
    const std::int64_t period_ns = tick_period_ns(profile);
    const auto check = [&](const char* key, double time_us, const char* of) -> std::optional<Problem> {
        if (round_to_pulse(time_us * static_cast<double>(kNsPerUs)) % period_ns == 0) return std::nullopt;
        return Problem{key,
                       {of, "tick.schedule"},
                       number_text(time_us) + " us is no whole number of periods of " +
                           number_text(profile.tick.period_us) + " us; give a multiple of tick.period_us"};
    };
    if (auto problem = check("tick.interpolation_us", profile.tick.interpolation_us, "tick.period_us")) {
        return problem;
    }
    if (auto problem = check("tick.io_us", profile.tick.io_us, "tick.period_us")) return problem;
    if (profile.tick.interpolation_us <= profile.tick.io_us) return std::nullopt;
    return Problem{"tick.interpolation_us",
                   {"tick.io_us", "tick.schedule"},
                   number_text(profile.tick.interpolation_us) + " us is longer than the " +
                       number_text(profile.tick.io_us) +
                       " us from pulse to pulse; shorten it, or lengthen tick.io_us"};
}

std::string rate_text(double rate_pps) {
    return number_text(std::floor(rate_pps * 10.0 + 0.5) / 10.0) + " pulses/s";
}

std::optional<Problem> check_rate(const Profile& profile, Axis axis, const char* leaf, double wanted_pps) {
    const double possible_pps = static_cast<double>(kNsPerS) / static_cast<double>(pulse_period_ns(profile));
    constexpr double kRounding = 1.0 + 1e-9;  // a speed given as exactly the limit is no fault
    if (wanted_pps <= possible_pps * kRounding) return std::nullopt;
    const AxisKeys keys = keys_of(axis);
    const double scale = axis_motion(profile, axis).pulses_per_unit;
    const bool two_timer = profile.tick.schedule == Schedule::two_timer;
    const std::string most =
        number_text(std::floor(possible_pps / scale * 1000.0) / 1000.0) + " " + keys.unit + "/s";
    return Problem{keys.table + leaf + "_" + keys.speed_unit,
                   {keys.table + (axis == Axis::psi ? "pulses_per_rev" : "pulses_per_mm"),
                    two_timer ? "tick.io_us" : "tick.period_us", "tick.schedule", "port.step_high_ns",
                    "port.step_low_ns"},
                   "axis " + std::string(name_of(axis)) + " would need " + rate_text(wanted_pps) +
                       ", but the " +
                       (two_timer ? "two-timer schedule allows " : "tick and the pulse times allow ") +
                       rate_text(possible_pps) + "; lower it to " + most + ", or shorten " +
                       (two_timer ? "tick.io_us" : "tick.period_us, port.step_high_ns or port.step_low_ns")};
}

std::optional<Problem> check_pulse_within_tick(const Profile& profile) {
    const std::int64_t needed_ns = pulse_within_tick_ns(profile);
    if (profile.port.pulses == PulseForm::over_ticks || needed_ns <= tick_period_ns(profile)) {
        return std::nullopt;
    }
    return Problem{"port.pulses",
                   {"tick.period_us", "port.step_high_ns", "port.step_low_ns"},
                   "a pulse, its gap and the writes take " +
                       number_text(static_cast<double>(needed_ns) / static_cast<double>(kNsPerUs)) +
                       " us, more than a tick of " + number_text(profile.tick.period_us) +
                       " us; lengthen tick.period_us, shorten port.step_high_ns or port.step_low_ns, or set "
                       "port.pulses = \"over-ticks\""};
}

}  // namespace

std::optional<Problem> check_pulse_rates(const Profile& profile) {
    if (auto problem = check_pulse_within_tick(profile)) return problem;
    Profile single = profile;
    single.tick.schedule = Schedule::single;
    const std::int64_t pulse_ns = pulse_period_ns(single);
    if (pulse_period_ns(profile) < pulse_ns) {
        return Problem{"tick.io_us",
                       {"port.step_high_ns", "port.step_low_ns", "tick.period_us", "tick.schedule"},
                       number_text(profile.tick.io_us) +
                           " us are too short for a pulse and its gap, which "
                           "take " +
                           number_text(static_cast<double>(pulse_ns) / static_cast<double>(kNsPerUs)) +
                           " us in ticks; lengthen it, or shorten tick.period_us"};
    }
    for (const Axis axis : kAllAxes) {
        const AxisMotion motion = axis_motion(profile, axis);
        if (auto problem = check_rate(profile, axis, "speed", motion.speed_pps)) return problem;
        if (auto problem = check_rate(profile, axis, "home_speed", motion.home_speed_pps)) return problem;
    }
    return std::nullopt;
}

std::optional<Problem> check_blank(const BlankProfile& blank) {
    const double off_mm = std::hypot(blank.offset_x_mm, blank.offset_z_mm);
    if (off_mm > 0.0 && !(off_mm < blank.radius_mm)) {
        return Problem{blank.offset_x_mm != 0.0 ? "blank.offset_x_mm" : "blank.offset_z_mm",
                       {"blank.offset_z_mm", "blank.radius_mm"},
                       "the table's axis would be outside a blank of radius " + number_text(blank.radius_mm) +
                           " mm; set blank.radius_mm, or a lesser offset"};
    }
    if (blank.depth_limit_mm > 0.0 && !(blank.radius_mm > 0.0)) {
        return Problem{"blank.depth_limit_mm",
                       {"blank.radius_mm"},
                       "is counted from the blank's surface, and nobody knows where that is; set "
                       "blank.radius_mm"};
    }
    return std::nullopt;
}

std::optional<Problem> check_roughing(const Profile& profile) {
    const double stepover_mm = profile.roughing.stepover_mm;
    if (profile.tool.shape == ToolShape::point || stepover_mm <= profile.tool.diameter_mm)
        return std::nullopt;
    return Problem{"roughing.stepover_mm",
                   {"tool.diameter_mm", "tool.shape"},
                   number_text(stepover_mm) + " mm is more than the tool is wide, " +
                       number_text(profile.tool.diameter_mm) + " mm; set it lower, or to 0"};
}

std::optional<Problem> check_profile(const Profile& profile) {
    for (const Axis axis : kAllAxes) {
        if (auto problem = check_speeds(profile, axis)) return problem;
    }
    for (const auto& [axis, part] : {std::pair{Axis::r1, &profile.r1}, std::pair{Axis::r2, &profile.r2},
                                     std::pair{Axis::y, &profile.y}}) {
        if (auto problem = check_travel(*part, axis_motion(profile, axis), keys_of(axis).table)) {
            return problem;
        }
    }
    if (auto problem = check_psi(profile.psi)) return problem;
    if (auto problem = check_heads(profile)) return problem;
    if (auto problem = check_head_clearance(profile)) return problem;
    if (auto problem = check_schedule(profile)) return problem;
    if (auto problem = check_pulse_rates(profile)) return problem;
    if (auto problem = check_blank(profile.blank)) return problem;
    if (auto problem = check_roughing(profile)) return problem;
    return check_pins(profile);
}

}  // namespace psicarve::profile_detail
