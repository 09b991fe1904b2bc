// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/speed_up.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "shared/machine/signal.hpp"

namespace psicarve::plan {
namespace {

// Whole pulses in whole ticks shake a little.
constexpr double kSpeedUpShare = 0.97;

/// The acceleration that every axis has left at this speed.
double spare_accel(const cycle::PathTiming& timing, double speed2) {
    double spare = double{timing.accel_free[0]};
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        spare = std::min(spare, double{timing.accel_free[k]} - double{timing.accel_bend[k]} * speed2);
    }
    return kSpeedUpShare * std::max(spare, 0.0);
}

// Faster at its end, less is left: what is left there is left all the way.
double speed2_after(const cycle::PathTiming& timing, double speed2) {
    const double most2 = speed2 + 2.0 * timing.length * spare_accel(timing, speed2);
    return speed2 + 2.0 * timing.length * spare_accel(timing, most2);
}

}  // namespace

// What axes can do is the same forwards and backwards in time.
void slow_down_to_rest(std::span<cycle::MotionBlock> run) {
    const double end_speed = run.empty() ? 0.0 : double{run.back().path.start_stop_speed};
    double speed2 = end_speed * end_speed;
    for (auto block = run.rbegin(); block != run.rend(); ++block) {
        cycle::PathTiming& timing = block->path;
        if (speed2 >= timing.end_speed2[1]) return;
        const double before2 = speed2_after(timing, speed2);
        for (std::size_t i = 0; i < timing.end_speed2.size(); ++i) {
            timing.end_speed2[i] = std::min(timing.end_speed2[i], speed2);
            timing.start_speed2[i] = std::min(timing.start_speed2[i], before2);
        }
        speed2 = before2;
    }
}

void speed_up_from_rest(std::span<cycle::MotionBlock> run) {
    const double start_speed = run.empty() ? 0.0 : double{run.front().path.start_stop_speed};
    double speed2 = start_speed * start_speed;
    for (cycle::MotionBlock& block : run) {
        cycle::PathTiming& timing = block.path;
        if (speed2 >= timing.start_speed2[1]) return;
        const double after2 = speed2_after(timing, speed2);
        for (std::size_t i = 0; i < timing.start_speed2.size(); ++i) {
            timing.start_speed2[i] = std::min(timing.start_speed2[i], speed2);
            timing.end_speed2[i] = std::min(timing.end_speed2[i], after2);
        }
        speed2 = after2;
    }
}

double path_seconds(const cycle::PathTiming& timing) {
    return 2.0 * timing.length / (std::sqrt(timing.start_speed2[0]) + std::sqrt(timing.end_speed2[0]));
}

}  // namespace psicarve::plan
