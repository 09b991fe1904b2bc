// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/straight_stretch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "shared/base/units.hpp"

namespace psicarve::plan {
namespace {

// As of a curve (path_stretch.cpp): whole pulses in whole ticks shake a little.
constexpr double kStraightSpeedShare = 0.998;
constexpr double kStraightAccelShare = 0.985;
// Pieces that are shorter, as a share of the way, are none.
constexpr double kStraightLeastShare = 1e-9;

/// One timing of the way.
struct Ramps {
    double stop2;
    double top2;
    double gain;   ///< 2 A
    double begin;  ///< where the first ramp ends [u]
    double end;    ///< where the last one begins

    double speed2(double along, double length) const {
        return std::min({top2, stop2 + gain * along, stop2 + gain * (length - along)});
    }
};

double axes_top2(const MachineLimits& limits, const Lanes& slope) {
    double top2 = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        if (slope[k] == 0.0) continue;
        const double speed = kStraightSpeedShare * limits.axes[k].speed_pps / std::abs(slope[k]);
        top2 = std::min(top2, speed * speed);
    }
    return top2;
}

Ramps ramps_of(const MachineLimits& limits, const PathSpan& span, std::size_t timing) {
    Ramps ramps{};
    ramps.top2 = axes_top2(limits, span.slope);
    if (span.least_pace2[timing] > 0.0) ramps.top2 = std::min(ramps.top2, 1.0 / span.least_pace2[timing]);
    ramps.stop2 = std::min(ramps.top2, stop_speed2(limits, span.slope, nullptr));
    ramps.gain = 2.0 * accel_along_way(limits, span.slope);
    const double ramp = std::min((ramps.top2 - ramps.stop2) / ramps.gain, 0.5 * span.length);
    ramps.begin = ramp;
    ramps.end = span.length - ramp;
    return ramps;
}

/// Where the way's own DDA is after so many iterations.
Pulses4 on_line(const Pulses4& way_pulses, std::int64_t capacity, std::int64_t iterations) {
    Pulses4 at{};
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        const std::int64_t count = (capacity / 2 + iterations * std::abs(way_pulses[k])) / capacity;
        at[k] = way_pulses[k] < 0 ? -count : count;
    }
    return at;
}

}  // namespace

double accel_along_way(const MachineLimits& limits, const Lanes& slope) {
    double accel = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        if (slope[k] == 0.0) continue;
        accel = std::min(accel, kStraightAccelShare * limits.axes[k].accel_pps2 / std::abs(slope[k]));
    }
    return accel;
}

void add_straight_stretch(const MachineLimits& limits, const PathSpan& span, const Pulses4& way_pulses,
                          std::uint32_t point, std::vector<PathPiece>& pieces) {
    const std::array ramps{ramps_of(limits, span, 0), ramps_of(limits, span, 1)};
    std::array bounds{ramps[0].begin, ramps[1].begin, ramps[0].end, ramps[1].end, span.length};
    std::sort(bounds.begin(), bounds.end());
    std::int64_t capacity = 0;
    for (const std::int64_t way : way_pulses) capacity = std::max(capacity, std::abs(way));
    double begin = 0.0;
    std::int64_t done = 0;
    Pulses4 at{};
    for (const double bound : bounds) {
        const bool is_last = bound == span.length;
        if (bound - begin <= kStraightLeastShare * span.length ||
            (!is_last && span.length - bound <= kStraightLeastShare * span.length))
            continue;
        PathPiece& piece = pieces.emplace_back();
        const std::int64_t iterations =
            is_last ? capacity : round_to_pulse(static_cast<double>(capacity) * (bound / span.length));
        const Pulses4 to = on_line(way_pulses, capacity, iterations);
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            piece.delta_pulses[k] = to[k] - at[k];
            piece.slope[k] = std::abs(span.slope[k]);
        }
        piece.line_pulses = way_pulses;
        piece.line_done = done;
        piece.length = bound - begin;
        for (std::size_t timing = 0; timing < kTimingCount; ++timing) {
            piece.begin_speed2[timing] = ramps[timing].speed2(begin, span.length);
            piece.end_speed2[timing] = ramps[timing].speed2(bound, span.length);
        }
        piece.point = is_last ? point : PathPiece::kNoPoint;
        begin = bound;
        done = iterations;
        at = to;
    }
}

}  // namespace psicarve::plan
