// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/flat/dxf_shapes.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

#include "shared/base/units.hpp"

namespace psicarve::flat {
namespace {

using Vector = std::array<double, 3>;

Vector cross(const Vector& a, const Vector& b) noexcept {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector unit(const Vector& v) noexcept {
    const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    if (!(length > 0.0)) return {0.0, 0.0, 1.0};
    return {v[0] / length, v[1] / length, v[2] / length};
}

/// Counter-clockwise angle from one to the other, a whole turn when they are the same [deg to rad].
double sweep_rad(double from_deg, double to_deg) noexcept {
    double sweep = std::fmod(to_deg - from_deg, kDegPerRev);
    if (sweep <= 0.0) sweep += kDegPerRev;
    return rad_from_deg(sweep);
}

void draw_arc(const DxfElement& element, PathMaker& maker) {
    const bool is_circle = element.type == "CIRCLE";
    const Point centre = element.point(10);
    const double radius = element.number(40, 0.0);
    if (!(radius > 0.0)) return;
    const double from_deg = is_circle ? 0.0 : element.number(50, 0.0);
    const double sweep = is_circle ? 2.0 * kPi : sweep_rad(from_deg, element.number(51, kDegPerRev));
    maker.move_to(centre);
    maker.ellipse(centre, {radius, 0.0}, {0.0, radius}, rad_from_deg(from_deg), sweep);
    if (is_circle) maker.close();
    maker.end();
}

void draw_ellipse(const DxfElement& element, PathMaker& maker) {
    const Point major = element.point(11);
    const double ratio = element.number(40, 1.0) * (element.number(230, 1.0) < 0.0 ? -1.0 : 1.0);
    const Point minor{-major.y * ratio, major.x * ratio};
    const double from = element.number(41, 0.0);
    double sweep = std::fmod(element.number(42, 2.0 * kPi) - from, 2.0 * kPi);
    constexpr double kWhole_rad = 1e-9;
    if (sweep <= kWhole_rad) sweep += 2.0 * kPi;
    maker.move_to(element.point(10));
    maker.ellipse(element.point(10), major, minor, from, sweep);
    if (sweep >= 2.0 * kPi - kWhole_rad) maker.close();
    maker.end();
}

void draw_lwpolyline(const DxfElement& element, PathMaker& maker) {
    std::vector<DxfVertex> vertices;
    for (const DxfGroup& group : element.groups) {
        const DxfElement one{{}, 0, 0, {group}};
        if (group.code == 10) vertices.push_back({{one.number(10, 0.0), 0.0}, 0.0});
        if (vertices.empty()) continue;
        if (group.code == 20) vertices.back().point.y = one.number(20, 0.0);
        if (group.code == 42) vertices.back().bulge = one.number(42, 0.0);
    }
    draw_bulges(vertices, (element.whole(70, 0) & 1) != 0, maker);
}

}  // namespace

Affine dxf_plane(const DxfElement& element) {
    const Vector n = unit({element.number(210, 0.0), element.number(220, 0.0), element.number(230, 1.0)});
    constexpr double kNearZ = 1.0 / 64.0;
    const bool is_near_z = std::abs(n[0]) < kNearZ && std::abs(n[1]) < kNearZ;
    const Vector x = unit(cross(is_near_z ? Vector{0.0, 1.0, 0.0} : Vector{0.0, 0.0, 1.0}, n));
    const Vector y = unit(cross(n, x));
    return {x[0], x[1], y[0], y[1], 0.0, 0.0};
}

void draw_bulges(const std::vector<DxfVertex>& vertices, bool is_closed, PathMaker& maker) {
    if (vertices.size() < 2) return;
    maker.move_to(vertices.front().point);
    const std::size_t count = vertices.size() - (is_closed ? 0 : 1);
    for (std::size_t i = 0; i < count; ++i) {
        const auto& [p, bulge] = vertices[i];
        const Point q = vertices[(i + 1) % vertices.size()].point;
        if (bulge != 0.0 && !(p == q)) {
            // The centre stands beside the chord's middle, to the left of a bulge of less than half a circle.
            const double beside = (1.0 - bulge * bulge) / (4.0 * bulge);
            const Point centre{0.5 * (p.x + q.x) - beside * (q.y - p.y),
                               0.5 * (p.y + q.y) + beside * (q.x - p.x)};
            const double radius = std::hypot(p.x - centre.x, p.y - centre.y);
            const double from_rad = std::atan2(p.y - centre.y, p.x - centre.x);
            maker.ellipse(centre, {radius, 0.0}, {0.0, radius}, from_rad, 4.0 * std::atan(bulge));
        }
        maker.line_to(q);
    }
    if (is_closed) maker.close();
    maker.end();
}

bool draw_dxf_shape(const DxfElement& element, const Affine& placement, PathMaker& maker) {
    const std::string_view type = element.type;
    maker.place(placement);
    if (type == "LINE") {
        maker.move_to(element.point(10));
        maker.line_to(element.point(11));
        maker.end();
        return true;
    }
    if (type == "ELLIPSE") {
        draw_ellipse(element, maker);
        return true;
    }
    maker.place(after(placement, dxf_plane(element)));
    if (type == "ARC" || type == "CIRCLE") {
        draw_arc(element, maker);
        return true;
    }
    if (type == "LWPOLYLINE") {
        draw_lwpolyline(element, maker);
        return true;
    }
    return false;
}

}  // namespace psicarve::flat
