// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rtcore/plan/machine_limits.hpp"

namespace psicarve::plan {

/// One number for each axis.
using Lanes = std::array<double, kAxisCount>;

/// A position that the machine passes exactly.
struct PathPoint {
    Pulses4 pulses;
    std::uint32_t layer;  ///< of the job
    std::uint32_t point;
    bool is_on_the_way;  ///< between two layers: not a point of the table
};

constexpr bool is_between_layers(const PathPoint& from, const PathPoint& to) noexcept {
    return from.layer != to.layer || from.is_on_the_way || to.is_on_the_way;
}

/// The straight way between two neighbouring points, and the tube around it.
///
///     path parameter u of the span:  length = sqrt(sum (d_k / v_k)^2)  [s]
///
/// so that du/dt = 1 is about as fast as the motors turn.
struct PathSpan {
    double length;                    ///< > 0 [s]
    Lanes slope;                      ///< of the chord [pulses / s of u]
    Lanes band;                       ///< how far the curve may leave the chord [pulses]
    Lanes end_band;                   ///< and how far its ends [pulses]
    std::array<double, 2> radius_mm;  ///< by head: of the tip, at the larger end
    bool is_link;                     ///< between two layers: heads never further in than its ends
};

/// A turn of the polyline at a point.
struct PathCorner {
    bool is_stop;   ///< the tube is so tight that coming to rest is faster
    bool is_tight;  ///< the tube lets the curve turn over a part of the spans only
    double radius;  ///< half the length over which the tube lets the curve turn, in u [s]
};

/// How fast one may leave or reach a stop, as the square of du/dt along this span: every axis within its
/// start-stop speed, or half of that where it turns back.
double stop_speed2(const MachineLimits& limits, const PathSpan& span, const PathSpan* across);

/// Tube and parameter of every way between neighbouring points (points.size() - 1 of them). Requires
/// neighbours that differ.
std::vector<PathSpan> path_spans(const MachineLimits& limits, std::span<const PathPoint> points);
/// One for each inner point: corners[i] lies between spans[i] and spans[i + 1].
std::vector<PathCorner> path_corners(const MachineLimits& limits, std::span<const PathSpan> spans);

}  // namespace psicarve::plan
