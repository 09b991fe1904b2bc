// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rtcore/plan/path.hpp"

namespace psicarve::plan {

/// A stretch of path from rest to rest as a quadratic B-spline over nodes u_0 < u_1 < ... < u_n.
///
///     cell j     around node j: from half-way to the node before to half-way to the node after, H_j long;
///                a parabola. The first and the last are half as long, and straight
///     m_j        its middle (of the first and the last: u_0 and u_n), and its control point c_j
///     s_j        = (c_j+1 - c_j) / (m_j+1 - m_j): slope where cell j meets cell j + 1
///     q''_j      = (s_j - s_j-1) / H_j
///     q(m_j + d) = c_j + q''_j * (H_j^2 / 8 + d^2 / 2) + d * (s_j-1 + s_j) / 2
///
/// So acceleration is constant in a cell and neither position nor speed jump. Lanes are axes, in pulses.
struct CurveNodes {
    std::vector<double> step;             ///< to the next node [s of u]; the last is unused
    std::vector<double> cell;             ///< H_j
    std::vector<double> control_step;     ///< m_j+1 - m_j; the last is unused
    std::vector<double> offset;           ///< u_j - m_j
    std::vector<Lanes> low, high;         ///< where q(u_j) may be
    std::vector<Lanes> weight;            ///< of cell j's bending, > 0
    std::vector<std::uint32_t> point_at;  ///< index of the path point that the node stands on, or kNoPoint
    std::vector<std::uint32_t> span_at;   ///< index of the span in which the node begins
    static constexpr std::uint32_t kNoPoint = ~std::uint32_t{0};
};

/// A part of such a stretch from node to node, as what a fit needs of it. At its ends the curve is what the
/// fit is told; nothing is asked of it there.
struct NodesView {
    std::span<const double> cell, control_step, offset;
    std::span<const Lanes> low, high, weight;

    /// Nodes [first, last].
    static NodesView of(const CurveNodes& nodes, std::size_t first, std::size_t last) {
        const std::size_t count = last + 1 - first;
        return {std::span(nodes.cell).subspan(first, count),
                std::span(nodes.control_step).subspan(first, count),
                std::span(nodes.offset).subspan(first, count),
                std::span(nodes.low).subspan(first, count),
                std::span(nodes.high).subspan(first, count),
                std::span(nodes.weight).subspan(first, count)};
    }
    static NodesView of(const CurveNodes& nodes) { return of(nodes, 0, nodes.cell.size() - 1); }
};

/// Nodes for points [first, last] of a path: two a span, four beside a sharp corner, one where points are
/// dense, more where the tube is tight. All cells weigh the same. `memory` is used again.
CurveNodes curve_nodes(const MachineLimits& limits, std::span<const PathPoint> points,
                       std::span<const PathSpan> spans, std::span<const PathCorner> corners,
                       std::size_t first, std::size_t last, CurveNodes memory = {});

/// Sets the bounds of one span's nodes anew: the one after `node`, which stands on its begin, and so on.
void bind_again(const MachineLimits& limits, std::span<const PathPoint> points,
                std::span<const PathSpan> spans, std::size_t node, CurveNodes& nodes);

}  // namespace psicarve::plan
