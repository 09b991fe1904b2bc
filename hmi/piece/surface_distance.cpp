// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/piece/surface_distance.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace psicarve::piece {
namespace {

constexpr int kMostRings = 8;

// Members by names, not an array: sanitizers check no index here, and this is most of the cost of a
// deviation.
struct Vector {
    double x;
    double y;
    double z;
};

Vector vector_of(const std::array<double, 3>& place) {
    return {place[0], place[1], place[2]};
}
Vector minus(const Vector& a, const Vector& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
double dot(const Vector& a, const Vector& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Squared distance of p from the straight line between a and b.
double segment2(const Vector& p, const Vector& a, const Vector& b) {
    const Vector ab = minus(b, a);
    const Vector ap = minus(p, a);
    const double length2 = dot(ab, ab);
    const double part = length2 > 0.0 ? std::clamp(dot(ap, ab) / length2, 0.0, 1.0) : 0.0;
    const Vector off{ap.x - part * ab.x, ap.y - part * ab.y, ap.z - part * ab.z};
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
    return std::min(std::min(segment2(p, a, b), segment2(p, b, c)), segment2(p, a, c));
}

/// How far p is outside of the range of these four along one axis.
double outside(double p, double a, double b, double c, double d) {
    const double below = std::min(std::min(a, b), std::min(c, d)) - p;
    const double above = p - std::max(std::max(a, b), std::max(c, d));
    return std::max(0.0, std::max(below, above));
}

/// Squared distance of p from the box around four corners: their quad is no nearer.
double box2(const Vector& p, const Vector& a, const Vector& b, const Vector& c, const Vector& d) {
    const Vector off{outside(p.x, a.x, b.x, c.x, d.x), outside(p.y, a.y, b.y, c.y, d.y),
                     outside(p.z, a.z, b.z, c.z, d.z)};
    return dot(off, off);
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

/// At most best2.
double SurfaceDistance::nearest2_of_quad(const Point& from, std::size_t row, std::size_t column,
                                         double best2) const {
    const std::size_t next = column + 1 == stock_.column_count() ? 0 : column + 1;
    const Vector p = vector_of(from);
    const Vector low = vector_of(point(row, column));
    const Vector right = vector_of(point(row, next));
    const Vector high = vector_of(point(row + 1, next));
    const Vector above = vector_of(point(row + 1, column));
    if (box2(p, low, right, high, above) >= best2) return best2;
    return std::min(best2, std::min(triangle2(p, low, right, high), triangle2(p, low, high, above)));
}

/// For the quads that touch the square of cells `ring` away, at most best2; ring 0 are those that meet in the
/// cell itself.
double SurfaceDistance::nearest2_of_ring(const Point& from, std::size_t row, std::size_t column, int ring,
                                         double best2) const {
    const auto first_row = static_cast<std::ptrdiff_t>(rows_.first);
    const auto last_row = static_cast<std::ptrdiff_t>(rows_.last);
    const auto columns = static_cast<std::ptrdiff_t>(stock_.column_count());
    for (std::ptrdiff_t up = -1 - ring; up <= ring; ++up) {
        const std::ptrdiff_t at_row = static_cast<std::ptrdiff_t>(row) + up;
        if (at_row < first_row || at_row >= last_row) continue;
        const bool is_whole = up == -1 - ring || up == ring;
        for (std::ptrdiff_t side = -1 - ring; side <= ring; side += is_whole ? 1 : 2 * ring + 1) {
            const std::ptrdiff_t at = (static_cast<std::ptrdiff_t>(column) + side + columns) % columns;
            best2 =
                nearest2_of_quad(from, static_cast<std::size_t>(at_row), static_cast<std::size_t>(at), best2);
        }
    }
    return best2;
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
        best2 = nearest2_of_ring(from, row, column, ring, best2);
    }
    return std::sqrt(best2);
}

}  // namespace psicarve::piece
