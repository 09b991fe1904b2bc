// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/piece/surface_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace psicarve::piece {
namespace {

constexpr int kMostRings = 8;

using Vector = std::array<double, 3>;

Vector minus(const Vector& a, const Vector& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Squared distance of p from the straight line between a and b.
double segment2(const Vector& p, const Vector& a, const Vector& b) {
    const Vector ab = minus(b, a);
    const Vector ap = minus(p, a);
    const double length2 = dot(ab, ab);
    const double part = length2 > 0.0 ? std::clamp(dot(ap, ab) / length2, 0.0, 1.0) : 0.0;
    const Vector off{ap[0] - part * ab[0], ap[1] - part * ab[1], ap[2] - part * ab[2]};
    return dot(off, off);
}

/// Squared distance of p from a triangle: that from its plane where p stands over it, else from its edges.
double triangle2(const Vector& p, const Vector& a, const Vector& b, const Vector& c) {
    const Vector ab = minus(b, a);
    const Vector ac = minus(c, a);
    const Vector ap = minus(p, a);
    const double bb = dot(ab, ab);
    const double bc = dot(ab, ac);
    const double cc = dot(ac, ac);
    const double pb = dot(ap, ab);
    const double pc = dot(ap, ac);
    const double area = bb * cc - bc * bc;
    const double v = cc * pb - bc * pc;
    const double w = bb * pc - bc * pb;
    if (area > 0.0 && v >= 0.0 && w >= 0.0 && v + w <= area) {
        const double rest = dot(ap, ap) - (v * pb + w * pc) / area;
        return std::max(0.0, rest);
    }
    return std::min({segment2(p, a, b), segment2(p, b, c), segment2(p, a, c)});
}

}  // namespace

SurfaceDistance::SurfaceDistance(const StockMap& stock, std::span<const float> radii_mm)
    : SurfaceDistance(stock, radii_mm, {0, stock.row_count() - 1}) {}

SurfaceDistance::SurfaceDistance(const StockMap& stock, std::span<const float> radii_mm, Rows rows)
    : stock_(stock), radii_mm_(radii_mm), rows_(rows) {
    for (std::size_t column = 0; column < stock.column_count(); ++column) {
        cosine_.push_back(std::cos(stock.direction_rad(column)));
        sine_.push_back(std::sin(stock.direction_rad(column)));
    }
}

SurfaceDistance::Point SurfaceDistance::point(std::size_t row, std::size_t column) const {
    const double radius = radii_mm_[row * stock_.column_count() + column];
    return {radius * cosine_[column], radius * sine_[column], stock_.height_mm(row)};
}

double SurfaceDistance::nearest2_of_quad(const Point& from, std::size_t row, std::size_t column) const {
    const std::size_t next = column + 1 == stock_.column_count() ? 0 : column + 1;
    const Point low = point(row, column);
    const Point high = point(row + 1, next);
    return std::min(triangle2(from, low, point(row, next), high),
                    triangle2(from, low, high, point(row + 1, column)));
}

/// Of the quads that touch the square of cells `ring` away; ring 0 are those that meet in the cell itself.
double SurfaceDistance::nearest2_of_ring(const Point& from, std::size_t row, std::size_t column,
                                         int ring) const {
    double best = std::numeric_limits<double>::max();
    const auto first_row = static_cast<std::ptrdiff_t>(rows_.first);
    const auto last_row = static_cast<std::ptrdiff_t>(rows_.last);
    const auto columns = static_cast<std::ptrdiff_t>(stock_.column_count());
    for (std::ptrdiff_t up = -1 - ring; up <= ring; ++up) {
        const std::ptrdiff_t at_row = static_cast<std::ptrdiff_t>(row) + up;
        if (at_row < first_row || at_row >= last_row) continue;
        const bool is_whole = up == -1 - ring || up == ring;
        for (std::ptrdiff_t side = -1 - ring; side <= ring; side += is_whole ? 1 : 2 * ring + 1) {
            const std::ptrdiff_t at = (static_cast<std::ptrdiff_t>(column) + side + columns) % columns;
            best = std::min(
                best, nearest2_of_quad(from, static_cast<std::size_t>(at_row), static_cast<std::size_t>(at)));
        }
    }
    return best;
}

double SurfaceDistance::of(std::size_t row, std::size_t column, double radius_mm) const {
    const double along = std::abs(radius_mm - double{radii_mm_[row * stock_.column_count() + column]});
    if (along == 0.0) return 0.0;
    return nearest_mm(row, column,
                      {radius_mm * cosine_[column], radius_mm * sine_[column], stock_.height_mm(row)}, along,
                      0.0);
}

double SurfaceDistance::of(std::size_t row, std::size_t column, const Point& place, double most_mm) const {
    return nearest_mm(row, column, place, most_mm, 0.5);
}

double SurfaceDistance::nearest_mm(std::size_t row, std::size_t column, const Point& from, double most_mm,
                                   double beside) const {
    double best2 = most_mm * most_mm;
    const double radius_mm = std::hypot(from[0], from[1]);
    const int rings = std::min<int>(kMostRings, static_cast<int>(stock_.column_count() / 4));
    for (int ring = 0; ring < rings; ++ring) {
        // Nothing `ring` cells away is nearer than the side of the cells between.
        const double cells = std::max(0.0, ring - beside);
        const double side_mm = radius_mm * std::sin(stock_.direction_rad(1) * cells);
        const double least = std::min(side_mm, stock_.row_mm() * cells);
        if (least * least >= best2) break;
        best2 = std::min(best2, nearest2_of_ring(from, row, column, ring));
    }
    return std::sqrt(best2);
}

}  // namespace psicarve::piece
