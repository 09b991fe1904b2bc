// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/permission_rule.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "shared/base/units.hpp"

namespace psicarve::verify {

namespace {
constexpr SignalWord kAlarmInputs = kInputMask & ~bit_of(Signal::psi_index);
}  // namespace

PermissionRule::PermissionRule(const Profile& profile, OffenceLog& log) : log_(log) {
    for (const Axis axis : kAllAxes) {
        const AxisMotion motion = axis_motion(profile, axis);
        Guard& guard = guards_[index_of(axis)];
        guard.limit_sign = motion.home == HomeSensor::max ? 1 : motion.home == HomeSensor::min ? -1 : 0;
        const double braking =
            motion.accel_pps2 > 0.0
                ? motion.home_speed_pps * motion.home_speed_pps / (2.0 * motion.accel_pps2) + 1.0
                : 1.0;
        guard.homing_pulses =
            std::min(static_cast<std::int64_t>(std::floor(braking)), motion.overtravel_pulses);
    }
    two_timer_ = profile.tick.schedule == Schedule::two_timer;
    const double period_us = two_timer_ ? profile.tick.io_us : profile.tick.period_us;
    period_ns_ = round_to_pulse(period_us * static_cast<double>(kNsPerUs));
    filter_ns_ = round_to_pulse(profile.port.input_filter_us * static_cast<double>(kNsPerUs));
}

void PermissionRule::begin(SignalWord initial_levels, SignalWord present, std::int64_t period_ns) {
    levels_ = initial_levels;
    present_ = present;
    is_calm_ = (initial_levels & kAlarmInputs) == 0;
    reaction_ns_ = period_ns > 0 && !two_timer_ ? period_ns : period_ns_;
    for (const Axis axis : kAllAxes) {
        const bool tripped = (initial_levels & bit_of(sensor_of(axis))) != 0;
        if (tripped) limit_changed(guards_[index_of(axis)], true, kNever);
    }
}

void PermissionRule::limit_changed(Guard& guard, bool tripped, std::int64_t time_ns) {
    guard.tripped = tripped;
    if (tripped) {
        guard.tripped_ns = time_ns;
        guard.beyond_pulses = 0;
        guard.is_leaving = false;
        guard.tripped_while_carving = (levels_ & bit_of(Signal::spindle)) != 0;
        return;
    }
    if (guard.tripped_while_carving && time_ns - guard.tripped_ns >= filter_ns_)
        guard.crash_ns = guard.tripped_ns;
    // Waiting pulses were all within homing's bound, with the drive on and the spindle off since.
    if (guard.is_leaving) guard.waiting = 0;
    guard.tripped_while_carving = false;
}

void PermissionRule::levels_changed(SignalWord before, SignalWord now, std::int64_t time_ns) {
    const SignalWord changed = before ^ now;
    levels_ = now;
    if ((changed & now & bit_of(Signal::estop)) != 0) estop_ns_ = time_ns;
    if (((before | now) & kAlarmInputs) != 0) is_calm_ = false;
    for (const Axis axis : kAllAxes) {
        Guard& guard = guards_[index_of(axis)];
        if ((changed & bit_of(sensor_of(axis))) != 0 && guard.limit_sign != 0) {
            // The spindle's level before counts: the alarm itself may have switched it off in this instant.
            levels_ = before;
            limit_changed(guard, (now & bit_of(sensor_of(axis))) != 0, time_ns);
            levels_ = now;
        }
        const bool disabled = (changed & before & bit_of(enable_of(axis))) != 0;
        if (disabled) guard.disabled_ns = time_ns;
        if (disabled || (changed & now & bit_of(Signal::spindle)) != 0) judge_waiting(axis);
    }
}

void PermissionRule::report(Axis axis, std::int64_t time_ns, const Finding& finding,
                            const CarvePlace& place) {
    Offence offence;
    offence.rule = 4;
    offence.fault = finding.fault;
    offence.axis = axis;
    offence.time_ns = time_ns;
    offence.measured = finding.measured;
    offence.allowed = finding.allowed;
    offence.unit = finding.unit;
    offence.sentence = shown_name(axis) + finding.text;
    log_.describe(std::move(offence), place);
}

void PermissionRule::rising(Axis axis, bool positive, std::int64_t time_ns, const CarvePlace& place) {
    if (has(enable_of(axis)) && (levels_ & bit_of(enable_of(axis))) == 0 && log_.count(4, time_ns))
        report(axis, time_ns, {"disabled", " steps while its drive is disabled", 1.0, 0.0, "pulses"}, place);
    if (is_calm_) return;
    judge_alarm(axis, time_ns, place);
    judge_limit(axis, positive, time_ns, place);
}

void PermissionRule::judge_alarm(Axis axis, std::int64_t time_ns, const CarvePlace& place) {
    const Guard& own = guards_[index_of(axis)];
    const bool knows_enable = has(enable_of(axis));
    const auto in_alarm_since = [&](std::int64_t since_ns, bool still_tripped) {
        const bool never_off = knows_enable && own.disabled_ns < since_ns;
        return since_ns != kNever && (still_tripped || never_off);
    };
    const bool estop_now = (levels_ & bit_of(Signal::estop)) != 0;
    if (in_alarm_since(estop_ns_, estop_now) && time_ns - estop_ns_ >= reaction_ns_ && log_.count(4, time_ns))
        report(axis, time_ns,
               {"emergency-stop", " steps after the emergency stop", static_cast<double>(time_ns - estop_ns_),
                static_cast<double>(reaction_ns_), "ns"},
               place);
    for (const Axis other : kAllAxes) {
        const Guard& guard = guards_[index_of(other)];
        const bool crashed = guard.tripped && guard.tripped_while_carving;
        const std::int64_t since_ns = crashed ? guard.tripped_ns : guard.crash_ns;
        // judge_limit judges the axis at the limit as long as the limit is tripped.
        if (other == axis && guard.tripped) continue;
        if (!in_alarm_since(since_ns, false)) continue;
        if (time_ns - since_ns < filter_ns_ + reaction_ns_ || !log_.count(4, time_ns)) continue;
        report(
            axis, time_ns,
            {"limit-alarm", " steps after " + shown_name(other) + "'s limit tripped",
             static_cast<double>(time_ns - since_ns), static_cast<double>(filter_ns_ + reaction_ns_), "ns"},
            place);
    }
}

void PermissionRule::judge_limit(Axis axis, bool positive, std::int64_t time_ns, const CarvePlace& place) {
    Guard& guard = guards_[index_of(axis)];
    if (guard.limit_sign == 0 || !guard.tripped) return;
    if ((guard.limit_sign > 0) != positive) {
        --guard.beyond_pulses;
        guard.is_leaving = true;
        return;
    }
    ++guard.beyond_pulses;
    guard.is_leaving = false;
    if (time_ns - guard.tripped_ns < filter_ns_ + reaction_ns_) return;
    const bool is_crash = guard.tripped_while_carving;
    const std::int64_t allowed = is_crash ? 0 : guard.homing_pulses;
    if (!is_crash && guard.beyond_pulses <= allowed) {
        if (guard.waiting++ == 0) {
            guard.first_waiting_ns = time_ns;
            guard.first_waiting_place = place;
        }
        return;
    }
    if (!log_.count(4, time_ns)) return;
    report(axis, time_ns,
           {"limit", " steps on past its tripped limit",
            static_cast<double>(std::max<std::int64_t>(guard.beyond_pulses, 1)), static_cast<double>(allowed),
            "pulses"},
           place);
}

void PermissionRule::judge_waiting(Axis axis) {
    Guard& guard = guards_[index_of(axis)];
    for (std::uint64_t n = std::exchange(guard.waiting, 0); n > 0; --n) {
        if (!log_.count(4, guard.first_waiting_ns)) continue;
        report(axis, guard.first_waiting_ns,
               {"limit", " steps on past its tripped limit without being homed",
                static_cast<double>(guard.beyond_pulses), 0.0, "pulses"},
               guard.first_waiting_place);
    }
}

void PermissionRule::positions_redefined() {
    for (Guard& guard : guards_) guard.waiting = 0;
}

void PermissionRule::finish() {
    for (const Axis axis : kAllAxes) judge_waiting(axis);
}

}  // namespace psicarve::verify
