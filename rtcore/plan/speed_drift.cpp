// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/speed_drift.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace psicarve::plan {
namespace {

constexpr double kJointShare_ratio = 0.5;
constexpr std::array<std::size_t, 17> kDistances{1,  2,  3,  4,  6,   8,   12,  16, 24,
                                                 32, 48, 64, 96, 128, 160, 192, 256};

struct Slopes {
    std::array<double, kAxisCount> per_iteration;  ///< s_k, signed
    double end_iterations;                         ///< of the run, at this line's end
};

/// Lines without a pulse take no time and change no speed: they are left out.
std::vector<Slopes> slopes_of(std::span<const TableLine> lines) {
    std::vector<Slopes> slopes;
    slopes.reserve(lines.size());
    double end_iterations = 0.0;
    for (const TableLine& line : lines) {
        std::int64_t capacity = 0;
        for (const std::int64_t delta : line.delta_pulses) capacity = std::max(capacity, std::abs(delta));
        if (capacity == 0) continue;
        end_iterations += static_cast<double>(capacity);
        Slopes& own = slopes.emplace_back();
        own.end_iterations = end_iterations;
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            own.per_iteration[k] = static_cast<double>(line.delta_pulses[k]) / static_cast<double>(capacity);
        }
    }
    return slopes;
}

/// The largest V with V * change <= jump + accel * way / V.
double fastest(double change, double jump_pps, double accel_pps2, double way_iterations) {
    return (jump_pps + std::sqrt(jump_pps * jump_pps + 4.0 * change * accel_pps2 * way_iterations)) /
           (2.0 * change);
}

}  // namespace

double drift_limit_per_s(const MachineLimits& limits, std::span<const TableLine> lines) {
    const std::vector<Slopes> slopes = slopes_of(lines);
    double least = limits.max_iterations_per_s;
    for (const std::size_t distance : kDistances) {
        for (std::size_t m = distance; m < slopes.size(); ++m) {
            const Slopes& from = slopes[m - distance];
            const double way = slopes[m - 1].end_iterations - from.end_iterations;
            for (std::size_t k = 0; k < kAxisCount; ++k) {
                const double change = std::fabs(slopes[m].per_iteration[k] - from.per_iteration[k]);
                const AxisMotion& axis = limits.axes[k];
                const double accel_pps2 = kJointShare_ratio * axis.accel_pps2;
                // The cheap question first: is this pair within bounds at the speed found so far?
                if (least * least * change <= axis.start_stop_pps * least + accel_pps2 * way) continue;
                least = fastest(change, axis.start_stop_pps, accel_pps2, way);
            }
        }
    }
    return least;
}

}  // namespace psicarve::plan
