// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/cycle_config_from_profile.hpp"

#include <algorithm>

#include "rtcore/cycle/motion_order.hpp"
#include "rtcore/plan/machine_limits.hpp"
#include "shared/base/units.hpp"

namespace psicarve::plan {
namespace {

// What does not fit into a tick is of whole ones.
std::int64_t ticks_for(std::int64_t time_ns, std::int64_t period_ns) {
    return std::max<std::int64_t>(1, ticks_covering_ns(time_ns, period_ns));
}

std::int64_t ns_from_us(double time_us) {
    return round_to_pulse(time_us * static_cast<double>(kNsPerUs));
}

cycle::SensorEnd sensor_end(HomeSensor home) {
    switch (home) {
        case HomeSensor::none:
            break;
        case HomeSensor::min:
            return cycle::SensorEnd::low;
        case HomeSensor::max:
            return cycle::SensorEnd::high;
        case HomeSensor::index:
            return cycle::SensorEnd::index;
    }
    return cycle::SensorEnd::none;
}

constexpr std::int64_t kSamplePeriodNs = kNsPerMs;

void set_speeds(cycle::CycleConfig& config, const Profile& profile) {
    const double tick_s = seconds_from_ns(config.interpolation_ns());
    const double most_per_tick =
        config.has_two_timers()
            ? static_cast<double>(config.interpolation_ticks) / static_cast<double>(config.io_ticks)
            : 1.0 / static_cast<double>(config.step_high_ticks + config.step_low_ticks);
    for (const Axis axis : kAllAxes) {
        const AxisMotion motion = axis_motion(profile, axis);
        cycle::AxisConfig& to = config.axes[index_of(axis)];
        to.speed_per_tick = std::min(motion.speed_pps * tick_s, most_per_tick);
        to.start_stop_per_tick = std::min(motion.start_stop_pps * tick_s, to.speed_per_tick);
        to.accel_per_tick2 = motion.accel_pps2 * tick_s * tick_s;
    }
}

void set_lift(cycle::CycleConfig& config, const Profile& profile) {
    const double tick_s = seconds_from_ns(config.interpolation_ns());
    config.rest_ticks = round_to_pulse(kRest_s / tick_s);
    for (const Axis head : {Axis::r1, Axis::r2}) {
        const std::size_t k = index_of(head);
        const double scale = axis_motion(profile, head).pulses_per_unit;
        if (profile.job.lifts_on_hold) config.lift_pulses[k] = pulses_from_mm(profile.job.retract_mm, scale);
        config.lower_speed_per_tick[k] = profile.job.plunge_mm_s * scale * tick_s;
    }
}

cycle::SoftLimits soft_limits(const Profile& profile) {
    cycle::SoftLimits limits;
    for (const Axis axis : kAllAxes) {
        const AxisMotion motion = axis_motion(profile, axis);
        const std::size_t k = index_of(axis);
        limits.least_pulses[k] = motion.has_travel ? motion.travel_min_pulses : -cycle::kFurthestPulses;
        limits.most_pulses[k] = motion.has_travel ? motion.travel_max_pulses : cycle::kFurthestPulses;
    }
    limits.least_sum_mm = profile.head_clearance_mm - profile.r1.tip_mm() - profile.r2.tip_mm();
    for (const Axis head : {Axis::r1, Axis::r2}) {
        const std::size_t k = index_of(head);
        limits.core_pulses[k] = core_radius_pulses(profile, head);
        limits.mm_per_pulse[k] = 1.0 / axis_motion(profile, head).pulses_per_unit;
        // As in a table: a radius stands at its nearest pulse.
        limits.least_sum_mm -= 0.5 * limits.mm_per_pulse[k] * (1.0 + 1e-9);
    }
    return limits;
}

}  // namespace

cycle::CycleConfig cycle_config_from_profile(const Profile& profile) {
    cycle::CycleConfig config;
    const std::int64_t period_ns = tick_period_ns(profile);
    config.period_ns = period_ns;
    if (profile.tick.schedule == Schedule::two_timer) {
        config.io_ticks = ticks_for(ns_from_us(profile.tick.io_us), period_ns);
        config.interpolation_ticks = ticks_for(ns_from_us(profile.tick.interpolation_us), period_ns);
    }
    for (const Axis axis : kAllAxes) {
        const AxisMotion motion = axis_motion(profile, axis);
        cycle::AxisConfig& to = config.axes[index_of(axis)];
        to.sensor_end = sensor_end(motion.home);
        to.has_sensor = to.sensor_end != cycle::SensorEnd::none;
        to.coast_ticks =
            static_cast<std::int64_t>(1.0 / (motion.start_stop_pps * seconds_from_ns(period_ns)));
        to.travel_min_pulses = motion.travel_min_pulses;
        to.travel_max_pulses = motion.travel_max_pulses;
        to.backlash_pulses = motion.backlash_pulses;
    }
    config.soft_limits = soft_limits(profile);
    if (profile.port.pulses == PulseForm::within_tick) {
        config.pulse_ns = profile.port.step_high_ns;
        config.step_high_ticks = 0;
        config.step_low_ticks = 1;
    } else {
        config.step_high_ticks = ticks_between_edges(profile.port.step_high_ns, period_ns);
        config.step_low_ticks = ticks_between_edges(profile.port.step_low_ns, period_ns);
    }
    config.dir_setup_ticks = ticks_between_edges(profile.port.dir_setup_ns, period_ns);
    config.dir_hold_ticks = ticks_between_edges(profile.port.dir_hold_ns, period_ns);
    set_speeds(config, profile);
    set_lift(config, profile);
    config.filter_ticks = ticks_covering_ns(ns_from_us(profile.port.input_filter_us), period_ns);
    for (std::size_t signal = kFirstInput; signal < kFirstSwitchedOutput; ++signal) {
        if (profile.port.pins[signal] != 0) config.input_mask |= SignalWord{1} << signal;
    }
    for (const Axis axis : kAllAxes) {
        if (profile.port.pins[index_of(enable_of(axis))] != 0)
            config.switched_axes = static_cast<std::uint8_t>(config.switched_axes | 1U << index_of(axis));
    }
    config.has_charge_pump = profile.port.charge_pump_pin != 0;
    config.has_index = profile.psi.home == HomeSensor::index;
    config.pulses_per_rev = profile.psi.pulses_per_rev;
    config.index_position_pulses = config.axes[index_of(Axis::psi)].has_sensor
                                       ? axis_motion(profile, Axis::psi).home_position_pulses
                                       : 0;
    config.index_tolerance_pulses = profile.psi.index_tolerance_pulses;
    config.sample_ticks = static_cast<std::uint64_t>(std::max<std::int64_t>(1, kSamplePeriodNs / period_ns));
    return config;
}

}  // namespace psicarve::plan
