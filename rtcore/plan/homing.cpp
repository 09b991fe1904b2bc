// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/homing.hpp"

#include <algorithm>
#include <cmath>

#include "rtcore/cycle/fine_move.hpp"
#include "rtcore/plan/block_list.hpp"
#include "shared/base/units.hpp"

namespace psicarve::plan {
namespace {

using cycle::Spindle;
using cycle::Until;

constexpr double kLittleMore_units = 0.25;  // mm behind the edge, so that vibration does not trip it
constexpr std::int64_t kLittleMorePulses = 8;
constexpr std::int64_t kSearchSparePulses = 16;

std::int64_t ramp_pulses(const AxisMotion& axis, double speed_pps) {
    return static_cast<std::int64_t>(speed_pps * speed_pps / (2.0 * axis.accel_pps2)) + 1;
}

/// From an input's edge until motion heeds it.
double heed_s(const MachineLimits& limits) {
    return seconds_from_ns((cycle::FineMove::kCoarseTicks + 1) * limits.tick.interpolation_ns() +
                           (limits.tick.io_ticks + limits.tick.filter_ticks) * limits.tick.period_ns);
}

// Not so fast that slowing down behind the edge would need more than slowing down from home speed does, or
// than the mechanics allow, what passes until the edge is heeded included: v^2 / 2a + v t = room.
double seek_speed_pps(const MachineLimits& limits, const AxisMotion& axis) {
    const double overtravel = static_cast<double>(std::max<std::int64_t>(axis.overtravel_pulses - 1, 0));
    const double room =
        std::min(0.5 * axis.home_speed_pps * axis.home_speed_pps / axis.accel_pps2, overtravel);
    const double heeded = axis.accel_pps2 * heed_s(limits);
    const double stoppable = std::sqrt(heeded * heeded + 2.0 * axis.accel_pps2 * room) - heeded;
    return std::min(axis.home_speed_pps, std::max(axis.start_stop_pps, stoppable));
}

/// +1 when the sensor stands at the axis' high end, else -1.
std::int64_t towards_sensor(const AxisMotion& axis) {
    return axis.home == HomeSensor::max ? 1 : -1;
}

/// More than from one mechanical end to the other.
std::int64_t whole_way_pulses(const AxisMotion& axis) {
    const std::int64_t far_end =
        axis.home == HomeSensor::max ? axis.travel_min_pulses : axis.travel_max_pulses;
    return std::abs(axis.home_position_pulses - far_end) + 2 * axis.overtravel_pulses + kSearchSparePulses;
}

void leave_sensor(BlockList& list, const AxisMotion& motion, Axis axis) {
    const std::int64_t away = -towards_sensor(motion);
    list.seek(axis, Until::sensor_clear, away * whole_way_pulses(motion), motion.home_speed_pps);
}

void leave_a_little_more(BlockList& list, const AxisMotion& motion, Axis axis) {
    const std::int64_t wanted =
        std::max(kLittleMorePulses, pulses_from_mm(kLittleMore_units, motion.pulses_per_unit));
    const std::int64_t room = (motion.travel_max_pulses - motion.travel_min_pulses) / 2;
    list.homing_move(axis, -towards_sensor(motion) * std::min(wanted, room), motion.home_speed_pps);
}

void home_linear(BlockList& list, const MachineLimits& limits, Axis axis) {
    const AxisMotion& motion = limits.axes[index_of(axis)];
    const std::int64_t towards = towards_sensor(motion);
    list.seek(axis, Until::sensor_tripped, towards * whole_way_pulses(motion),
              seek_speed_pps(limits, motion));
    leave_sensor(list, motion, axis);
    const std::int64_t search =
        2 * ramp_pulses(motion, motion.home_speed_pps) + motion.overtravel_pulses + kSearchSparePulses;
    list.seek(axis, Until::sensor_tripped, towards * search, motion.start_stop_pps);
    // The edge is seen with the first pulse beyond the home position.
    list.latch(motion.home_position_pulses + towards);
    leave_sensor(list, motion, axis);
    leave_a_little_more(list, motion, axis);
}

/// How far psi may run past its index at home speed until it rests.
std::int64_t psi_overrun_pulses(const MachineLimits& limits) {
    const AxisMotion& motion = limits.axes[index_of(Axis::psi)];
    const double speed_pps = std::min(motion.home_speed_pps, motion.speed_pps);
    const double delay_s =
        seconds_from_ns(2 * cycle::FineMove::kCoarseTicks * limits.tick.interpolation_ns() +
                        2 * limits.tick.io_ticks * limits.tick.period_ns);
    return ramp_pulses(motion, speed_pps) + static_cast<std::int64_t>(speed_pps * delay_s) + 2;
}

void home_psi(BlockList& list, const MachineLimits& limits) {
    const AxisMotion& motion = limits.axes[index_of(Axis::psi)];
    const std::int64_t overrun = psi_overrun_pulses(limits);
    // A turn and a tenth: also from the middle of the index, which has to be left first.
    const std::int64_t way = limits.pulses_per_rev + limits.pulses_per_rev / 10 + overrun;
    list.seek(Axis::psi, Until::index_edge, way, motion.home_speed_pps);
    // Not from the sensor's own far edge: it may be passed already. Back over the most that the way can be.
    list.homing_move(Axis::psi, -(overrun + kLittleMorePulses), motion.home_speed_pps);
    list.seek(Axis::psi, Until::index_edge, overrun + kLittleMorePulses + kSearchSparePulses,
              motion.start_stop_pps);
    list.latch(motion.home_position_pulses);
}

void home_axis(BlockList& list, const MachineLimits& limits, Axis axis) {
    const AxisMotion& motion = limits.axes[index_of(axis)];
    if (motion.home == HomeSensor::none) {
        list.define(axis, motion.home_position_pulses);
    } else if (motion.home == HomeSensor::index) {
        home_psi(list, limits);
    } else {
        home_linear(list, limits, axis);
    }
}

}  // namespace

std::vector<cycle::MotionBlock> homing_blocks(const MachineLimits& limits, std::uint32_t axes) {
    BlockList list(limits);
    list.outputs(kAllDrives, Spindle::off);
    for (const Axis axis : {Axis::r1, Axis::r2, Axis::y, Axis::psi}) {
        if ((axes >> index_of(axis) & 1U) != 0) home_axis(list, limits, axis);
    }
    list.end();
    return std::move(list.blocks());
}

std::vector<cycle::MotionBlock> reset_height_blocks(const MachineLimits& limits) {
    BlockList list(limits);
    list.outputs(kAllDrives, Spindle::off);
    home_axis(list, limits, Axis::y);
    list.end();
    return std::move(list.blocks());
}

std::vector<cycle::MotionBlock> back_off_blocks(const MachineLimits& limits, Axis axis) {
    const AxisMotion& motion = limits.axes[index_of(axis)];
    BlockList list(limits);
    list.outputs(static_cast<std::uint8_t>(1U << index_of(axis)), Spindle::off);
    leave_sensor(list, motion, axis);
    leave_a_little_more(list, motion, axis);
    list.end();
    return std::move(list.blocks());
}

}  // namespace psicarve::plan
