// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/sim/sim_config.hpp"

#include <algorithm>
#include <cmath>

#include "shared/base/units.hpp"

namespace psicarve::sim {
namespace {

constexpr double kLeastSlipPulses = 16.0;

/// How far a motor may lag before it slips: two full steps at 1/8 step; with finer steps (a machine with
/// many pulses per mm) twice the lag that its own start-stop jump costs it.
double slip_pulses(const MotorConfig& motor) {
    return std::max(kLeastSlipPulses,
                    std::ceil(motor.start_stop_pps * motor.start_stop_pps / motor.accel_pps2));
}

MotorConfig motor_for(const AxisMotion& motion) {
    MotorConfig motor{.speed_pps = motion.speed_pps * kSpeedReserve_ratio,
                      .accel_pps2 = motion.accel_pps2 * kAccelReserve_ratio,
                      .start_stop_pps = motion.start_stop_pps * kStartStopReserve_ratio};
    motor.slip_pulses = slip_pulses(motor);
    return motor;
}

SensorConfig sensor_for(const AxisMotion& motion) {
    SensorConfig sensor{.edge_pulses = motion.home_position_pulses};
    switch (motion.home) {
        case HomeSensor::none:
            sensor.kind = SensorKind::none;
            break;
        case HomeSensor::min:
            sensor.kind = SensorKind::low_end;
            sensor.edge_pulses -= 1;  // at the home position it is still clear
            break;
        case HomeSensor::max:
            sensor.kind = SensorKind::high_end;
            sensor.edge_pulses += 1;
            break;
        case HomeSensor::index:
            sensor.kind = SensorKind::index;
            break;
    }
    return sensor;
}

AxisConfig rotary_axis(const Profile& profile) {
    const AxisMotion motion = axis_motion(profile, Axis::psi);
    AxisConfig axis{.start_pulses = motion.home_position_pulses - profile.psi.pulses_per_rev / 4,
                    .pulses_per_turn = profile.psi.pulses_per_rev,
                    .backlash_pulses = motion.backlash_pulses,
                    .sensor = sensor_for(motion),
                    .motor = motor_for(motion)};
    axis.sensor.width_pulses = std::max<std::int64_t>(1, profile.psi.pulses_per_rev / kIndexWidths_per_rev);
    return axis;
}

AxisConfig linear_axis(const Profile& profile, Axis which) {
    const AxisMotion motion = axis_motion(profile, which);
    const LinearAxisProfile& keys = which == Axis::r1   ? profile.r1
                                    : which == Axis::r2 ? profile.r2
                                                        : profile.y;
    const auto pulses = [&](double mm) { return std::llround(mm * keys.pulses_per_mm); };
    AxisConfig axis{.start_pulses = pulses((keys.travel_mm[0] + keys.travel_mm[1]) / 2.0),
                    .has_ends = true,
                    .low_end_pulses = pulses(keys.travel_mm[0]) - motion.overtravel_pulses,
                    .high_end_pulses = pulses(keys.travel_mm[1]) + motion.overtravel_pulses,
                    .pulses_per_mm = keys.pulses_per_mm,
                    .backlash_pulses = motion.backlash_pulses,
                    .sensor = sensor_for(motion),
                    .motor = motor_for(motion)};
    if (motion.home == HomeSensor::min) {
        axis.low_end_pulses = motion.home_position_pulses - motion.overtravel_pulses;
    } else if (motion.home == HomeSensor::max) {
        axis.high_end_pulses = motion.home_position_pulses + motion.overtravel_pulses;
    }
    if (which == Axis::y) {
        const std::int64_t off =
            std::min(pulses(kYStartOffSensor_mm), axis.start_pulses - pulses(keys.travel_mm[0]));
        if (motion.home == HomeSensor::min) axis.start_pulses = motion.home_position_pulses + off;
        if (motion.home == HomeSensor::max) axis.start_pulses = motion.home_position_pulses - off;
    }
    return axis;
}

}  // namespace

SimConfig sim_config_from_profile(const Profile& profile) {
    SimConfig config{
        .axes = {linear_axis(profile, Axis::r1), linear_axis(profile, Axis::r2), rotary_axis(profile),
                 linear_axis(profile, Axis::y)},
        .heads = {HeadConfig{.tip_mm = profile.r1.tip_mm()},
                  HeadConfig{.tip_mm = profile.r2.tip_mm(),
                             .direction_deg = kDegPerRev / 2.0 + profile.head_r2_angle_error_deg,
                             .height_mm = profile.head_r2_height_error_mm}},
        .blank = {.diameter_mm = 2.0 * profile.blank.radius_mm, .height_mm = profile.blank.height_mm},
        .timing = {.dir_setup_ns = profile.port.dir_setup_ns,
                   .dir_hold_ns = profile.port.dir_hold_ns,
                   .step_high_ns = profile.port.step_high_ns,
                   .step_low_ns = profile.port.step_low_ns},
        .wiring = {.pins = profile.port.pins},
        .input_faults = {},
        .slip_faults = {}};
    for (const Axis axis : kAllAxes) {
        config.wiring.positive_is_high[index_of(axis)] = axis_motion(profile, axis).positive_is_high;
    }
    return config;
}

}  // namespace psicarve::sim
