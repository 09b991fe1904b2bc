// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/tool/column_ranges.hpp"

#include <algorithm>
#include <cmath>

#include "shared/base/units.hpp"

namespace psicarve::tool {
namespace {

constexpr double kTurn_rad = 2.0 * kPi;
constexpr double kRounding_rad = 1e-9;

double flat_cross(const Point& a, const Point& b) {
    return a[0] * b[1] - a[1] * b[0];
}

/// Of the rotation axis from the way between two points, seen from above.
double axis_distance(const Point& from, const Point& to) {
    const double x = to[0] - from[0];
    const double y = to[1] - from[1];
    const double length2 = x * x + y * y;
    const double share = length2 > 0.0 ? std::clamp(-(from[0] * x + from[1] * y) / length2, 0.0, 1.0) : 0.0;
    return std::hypot(from[0] + share * x, from[1] + share * y);
}

bool surrounds_axis(const std::array<Point, 3>& corners) {
    const double first = flat_cross(corners[0], corners[1]);
    const double second = flat_cross(corners[1], corners[2]);
    const double third = flat_cross(corners[2], corners[0]);
    return (first > 0.0 && second > 0.0 && third > 0.0) || (first < 0.0 && second < 0.0 && third < 0.0);
}

}  // namespace

ColumnRanges ColumnFinder::of(const Edge& edge) const {
    const std::array<Point, 2> corners{edge.from, edge.to};
    return of(corners, axis_distance(edge.from, edge.to) <= radius_);
}

ColumnRanges ColumnFinder::of(const Facet& facet) const {
    bool holds_axis = surrounds_axis(facet.corners);
    for (std::size_t k = 0; k < 3; ++k) {
        holds_axis = holds_axis || axis_distance(facet.corners[k], facet.corners[(k + 1) % 3]) <= radius_;
    }
    return of(facet.corners, holds_axis);
}

// A part that keeps its distance from the axis lies between the tangents to the circles around its corners.
ColumnRanges ColumnFinder::of(std::span<const Point> corners, bool holds_axis) const {
    if (holds_axis) return all();
    const Point& first = corners[0];
    double low = 0.0;
    double high = 0.0;
    for (const Point& corner : corners) {
        const double from_first =
            std::atan2(flat_cross(first, corner), first[0] * corner[0] + first[1] * corner[1]);
        const double half = std::asin(std::min(1.0, radius_ / std::hypot(corner[0], corner[1])));
        low = std::min(low, from_first - half);
        high = std::max(high, from_first + half);
    }
    const double base = std::atan2(first[1], first[0]);
    return between(base + low - kRounding_rad, base + high + kRounding_rad);
}

ColumnRanges ColumnFinder::between(double low_rad, double high_rad) const {
    if (directions_.empty() || high_rad - low_rad >= kTurn_rad) return all();
    const auto turns_before = [this](double angle) {
        return std::floor((angle - directions_.front()) / kTurn_rad) * kTurn_rad;
    };
    const double back = turns_before(low_rad);
    const double low = low_rad - back;
    const double high = high_rad - back;
    const auto first_from = [this](double angle) {
        return static_cast<std::uint32_t>(std::lower_bound(directions_.begin(), directions_.end(), angle) -
                                          directions_.begin());
    };
    ColumnRanges ranges;
    ranges.first[0] = first_from(low);
    ranges.end[0] = first_from(high);
    ranges.end[1] = std::min(first_from(high - kTurn_rad), ranges.first[0]);
    return ranges;
}

ColumnRanges ColumnFinder::all() const noexcept {
    ColumnRanges ranges;
    ranges.end[0] = static_cast<std::uint32_t>(directions_.size());
    return ranges;
}

}  // namespace psicarve::tool
