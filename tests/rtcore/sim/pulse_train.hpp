// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "shared/base/units.hpp"

namespace psicarve::sim {

/// A move of one motor as a planner sees it: from start speed up, along, down to start speed.
struct Trapezoid {
    double start_pps;
    double top_pps;
    double accel_pps2;
    double length_pulses;

    double ramp_pulses() const { return (peak() * peak() - start_pps * start_pps) / (2.0 * accel_pps2); }
    double peak() const {
        const double reachable = std::sqrt(start_pps * start_pps + accel_pps2 * length_pulses);
        return reachable < top_pps ? reachable : top_pps;
    }
    double ramp_s() const { return (peak() - start_pps) / accel_pps2; }
    /// When the motion has covered `pulses`.
    double time_at(double pulses) const {
        if (pulses <= 0.0) return pulses / start_pps;
        if (pulses >= length_pulses) {
            return total_s() + (pulses - length_pulses) / start_pps;
        }
        const double ramp = ramp_pulses();
        if (pulses < ramp) {
            return (std::sqrt(start_pps * start_pps + 2.0 * accel_pps2 * pulses) - start_pps) / accel_pps2;
        }
        if (pulses > length_pulses - ramp) return total_s() - time_at(length_pulses - pulses);
        return ramp_s() + (pulses - ramp) / peak();
    }
    double total_s() const { return 2.0 * ramp_s() + (length_pulses - 2.0 * ramp_pulses()) / peak(); }
};

/// Times [ns] of the pulses of a move as ticks emit them: each in the first tick at or after its time, which
/// the DDA may shift by up to `jitter_pulses` of the motion either way, and no two closer than two ticks.
inline std::vector<std::int64_t> pulse_times(const Trapezoid& move, std::int64_t tick_ns,
                                             double jitter_pulses, std::uint32_t seed,
                                             std::int64_t begin_ns = 0) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> jitter(-jitter_pulses, jitter_pulses);
    std::vector<std::int64_t> times;
    std::int64_t least_tick = begin_ns / tick_ns;
    const auto pulses = static_cast<int>(move.length_pulses);
    for (int n = 0; n < pulses; ++n) {
        const double time_ns = move.time_at(n + 0.5 + jitter(random)) * 1e9;
        const std::int64_t wanted = static_cast<std::int64_t>(
            std::ceil((time_ns + static_cast<double>(begin_ns)) / static_cast<double>(tick_ns)));
        const std::int64_t tick = wanted > least_tick ? wanted : least_tick;
        times.push_back(tick * tick_ns);
        least_tick = tick + 2;
    }
    return times;
}

}  // namespace psicarve::sim
