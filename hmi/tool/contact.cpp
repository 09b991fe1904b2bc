// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/tool/contact.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace psicarve::tool {
namespace {

// Of the tool's radius: so long an edge is a point to it, so far outside still counts as touched.
constexpr double kPointShare = 1e-9;
constexpr double kRimShare = 1e-12;
// A facet that is seen from its side this exactly is touched at its edges.
constexpr double kSideways = 1e-9;
// Facets reach so far over their edges, so that rounding leaves no gap between two of them.
constexpr double kOverlap = 1e-9;
constexpr double kNothing = -std::numeric_limits<double>::max();

/// A point in the column's own directions.
struct Seen {
    double across;
    double up;
    double out;
};

Seen seen(const Point& point, const Column& column) {
    return {point[1] * column.cosine - point[0] * column.sine, point[2],
            point[0] * column.cosine + point[1] * column.sine};
}

/// The rows from `low` to `high`.
struct RowRange {
    std::size_t first;
    std::size_t end;
};

RowRange rows_between(const Column& column, double low, double high) {
    const auto begin = column.heights.begin();
    const auto first = std::lower_bound(begin, column.heights.end(), low);
    const auto end = std::upper_bound(first, column.heights.end(), high);
    return {static_cast<std::size_t>(first - begin), static_cast<std::size_t>(end - begin)};
}

/// An edge as a line over the plane across the tool: `length` along (across, up), rising by `slope`.
struct Line {
    Seen from;
    double along_across;
    double along_up;
    double length;
    double slope;
};

Line line_of(const Seen& from, const Seen& to, double radius) {
    const double across = to.across - from.across;
    const double up = to.up - from.up;
    const double length = std::sqrt(across * across + up * up);
    if (length > kPointShare * radius) {
        return {from, across / length, up / length, length, (to.out - from.out) / length};
    }
    return {{from.across, from.up, std::max(from.out, to.out)}, 1.0, 0.0, 0.0, 0.0};
}

/// The contact of a tool's shape with a line: where on it, from the foot of the tool's axis on, it would
/// touch, and how far behind the tip. `reach2` and `reach`: how far the line is within the tool to both sides
/// of the foot; `off2`: squared distance of the foot from the axis.
struct BallOnLine {
    double share;
    double radius;
    BallOnLine(const Line& line, const Tool& tool, double /*flank_slope*/)
        : share(line.slope / std::sqrt(1.0 + line.slope * line.slope)), radius(tool.radius) {}
    double place(double reach, double /*off2*/) const { return share * reach; }
    double rise(double /*off2*/, double place2, double reach2) const {
        return radius - std::sqrt(std::max(0.0, reach2 - place2));
    }
};
struct FlatOnLine {
    double side;
    FlatOnLine(const Line& line, const Tool& /*tool*/, double /*flank_slope*/)
        : side(line.slope > 0.0 ? 1.0 : -1.0) {}
    double place(double reach, double /*off2*/) const { return side * reach; }
    double rise(double /*off2*/, double /*place2*/, double /*reach2*/) const { return 0.0; }
};
struct VeeOnLine {
    double share;
    double flank_slope;
    VeeOnLine(const Line& line, const Tool& /*tool*/, double slope) : flank_slope(slope) {
        // A line steeper than the flank is touched at the rim.
        const double free2 = slope * slope - line.slope * line.slope;
        share = free2 > 0.0 ? line.slope / std::sqrt(free2) : std::copysign(1e30, line.slope);
    }
    double place(double reach, double off2) const {
        return std::min(std::max(share * std::sqrt(off2), -reach), reach);
    }
    double rise(double off2, double place2, double /*reach2*/) const {
        return flank_slope * std::sqrt(off2 + place2);
    }
};

// The height over the line falls off to both sides of the shape's contact, so the edge's nearest place to it
// is its best.
template <typename Shape>
void touch_line(const Line& line, const Shape& shape, double radius, RowRange rows, const Column& column) {
    const double radius2 = radius * radius;
    const double rim2 = kRimShare * radius2;
    const double* heights = column.heights.data();
    double* tips = column.tips.data();
    for (std::size_t i = rows.first; i < rows.end; ++i) {
        const double up = heights[i] - line.from.up;
        const double foot = up * line.along_up - line.from.across * line.along_across;
        const double off = up * line.along_across + line.from.across * line.along_up;
        const double off2 = off * off;
        const double reach2 = radius2 - off2;
        const double reach = std::sqrt(std::max(reach2, 0.0));
        const double at = std::min(std::max(foot + shape.place(reach, off2), 0.0), line.length);
        const double place2 = (at - foot) * (at - foot);
        const double tip = line.from.out + line.slope * at - shape.rise(off2, place2, reach2);
        const double touched = place2 <= reach2 + rim2 ? tip : kNothing;
        tips[i] = touched > tips[i] ? touched : tips[i];
    }
}

/// Where a tool touches a plane, from its tip: across, up, and how far behind.
struct PlaneContact {
    double across = 0.0;
    double up = 0.0;
    double rise = 0.0;
};

// `normal` looks outwards.
PlaneContact plane_contact(const Tool& tool, double flank_slope, const Seen& normal) {
    if (tool.shape == Shape::ball) {
        return {-tool.radius * normal.across, -tool.radius * normal.up, tool.radius * (1.0 - normal.out)};
    }
    const double tilt = std::sqrt(normal.across * normal.across + normal.up * normal.up);
    // The tip stands on planes less steep than the flank; on others the rim does.
    if (tilt <= flank_slope * normal.out || tilt == 0.0) return {};
    return {-tool.radius * normal.across / tilt, -tool.radius * normal.up / tilt, tool.radius * flank_slope};
}

/// How far up and down a triangle reaches at one place across.
struct Extent {
    double low = std::numeric_limits<double>::max();
    double high = -std::numeric_limits<double>::max();

    void add_crossing(const Seen& a, const Seen& b, double across) {
        if ((a.across < across) == (b.across < across)) {
            if (a.across == across) add(a.up);
            if (b.across == across) add(b.up);
            return;
        }
        add(a.up + (b.up - a.up) * ((across - a.across) / (b.across - a.across)));
    }
    void add(double up) {
        low = std::min(low, up);
        high = std::max(high, up);
    }
};

}  // namespace

Contact::Contact(const Tool& tool) : tool_(tool), flank_slope_(tool::flank_slope(tool)) {}

void Contact::touch(const Edge& edge, const Column& column) const {
    const Seen from = seen(edge.from, column);
    const Seen to = seen(edge.to, column);
    if (from.out <= 0.0 && to.out <= 0.0) return;
    double nearest = 0.0;
    if ((from.across < 0.0) == (to.across < 0.0))
        nearest = std::min(std::abs(from.across), std::abs(to.across));
    if (nearest > tool_.radius) return;
    const double half = std::sqrt(tool_.radius * tool_.radius - nearest * nearest);
    const RowRange rows =
        rows_between(column, std::min(from.up, to.up) - half, std::max(from.up, to.up) + half);
    if (rows.first == rows.end) return;
    const Line line = line_of(from, to, tool_.radius);
    if (tool_.shape == Shape::ball) {
        touch_line(line, BallOnLine(line, tool_, flank_slope_), tool_.radius, rows, column);
    } else if (tool_.shape == Shape::flat) {
        touch_line(line, FlatOnLine(line, tool_, flank_slope_), tool_.radius, rows, column);
    } else {
        touch_line(line, VeeOnLine(line, tool_, flank_slope_), tool_.radius, rows, column);
    }
}

void Contact::touch(const Facet& facet, const Column& column) const {
    Seen normal = seen(facet.normal, column);
    double distance = facet.distance;
    if (normal.out < 0.0) {
        normal = {-normal.across, -normal.up, -normal.out};
        distance = -distance;
    }
    if (normal.out < kSideways) return;
    const PlaneContact contact = plane_contact(tool_, flank_slope_, normal);
    const std::array<Seen, 3> corners{seen(facet.corners[0], column), seen(facet.corners[1], column),
                                      seen(facet.corners[2], column)};
    Extent extent;
    for (std::size_t k = 0; k < 3; ++k) {
        extent.add_crossing(corners[k], corners[(k + 1) % 3], contact.across);
    }
    if (extent.low > extent.high) return;
    const double overlap = kOverlap * normal.out;
    const RowRange rows =
        rows_between(column, extent.low - contact.up - overlap, extent.high - contact.up + overlap);
    const double per_up = -normal.up / normal.out;
    const double at_zero = (distance - normal.across * contact.across) / normal.out - contact.rise;
    for (std::size_t i = rows.first; i < rows.end; ++i) {
        const double tip = at_zero + per_up * (column.heights[i] + contact.up);
        column.tips[i] = std::max(column.tips[i], tip);
    }
}

}  // namespace psicarve::tool
