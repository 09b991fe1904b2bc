// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/straight_way.hpp"

#include <algorithm>
#include <cstdlib>

namespace psicarve::cycle {

bool start_straight(FineMove& move, const CycleConfig& config,
                    const std::array<std::int64_t, kAxisCount>& way_pulses,
                    const SpeedLimits4& most_per_tick) noexcept {
    std::int64_t longest = 0;
    for (const std::int64_t way : way_pulses) longest = std::max(longest, std::abs(way));
    if (longest == 0) return false;
    double start = 1.0;
    double speed = 1.0;
    double accel = 1.0;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        if (way_pulses[k] == 0) continue;
        const AxisConfig& axis = config.axes[k];
        const double ratio = static_cast<double>(longest) / static_cast<double>(std::abs(way_pulses[k]));
        start = std::min(start, axis.start_stop_per_tick * ratio);
        speed = std::min(speed, most_per_tick[k] * ratio);
        accel = std::min(accel, axis.accel_per_tick2 * ratio);
    }
    move.start(way_pulses, std::min(start, speed), speed, accel);
    return true;
}

void step_along(FineMove& move, PulseStage& pulses, std::uint64_t tick, bool must_slow,
                std::uint32_t still_axes) noexcept {
    std::uint32_t due = move.due();
    if (due == 0) {
        move.tick(must_slow);
        due = move.due();
    }
    for (std::size_t k = 0; due != 0 && k < kAxisCount; ++k) {
        const std::uint32_t axis = due & (1U << k);
        if (axis == 0 || !pulses.may_step_apart(axis, tick)) continue;
        pulses.step(axis & ~still_axes, tick);
        move.take(k);
    }
}

}  // namespace psicarve::cycle
