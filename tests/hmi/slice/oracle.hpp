// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "hmi/model/mesh.hpp"

namespace psicarve::oracle {

/// r(theta, h) by its definition, slowly: every facet is met by the ray from the axis by itself, by solving
/// axis + r * direction = a + s * (b - a) + t * (c - a) with determinants in long double. Shares nothing with
/// the slicer: no sections, no layers, no order.
inline double radius(const model::Mesh& mesh, double axis_x, double axis_y, double theta_rad, double height) {
    using Real = long double;
    const Real dx = std::cos(static_cast<Real>(theta_rad));
    const Real dy = std::sin(static_cast<Real>(theta_rad));
    Real outermost = 0.0L;
    for (const model::Triangle& facet : mesh.triangles) {
        const auto& [a, b, c] = facet.vertices;
        if (std::max({a[2], b[2], c[2]}) < height || std::min({a[2], b[2], c[2]}) > height) continue;
        const Real ux = Real{b[0]} - a[0], uy = Real{b[1]} - a[1], uz = Real{b[2]} - a[2];
        const Real vx = Real{c[0]} - a[0], vy = Real{c[1]} - a[1], vz = Real{c[2]} - a[2];
        const Real wx = static_cast<Real>(axis_x) - a[0];
        const Real wy = static_cast<Real>(axis_y) - a[1];
        const Real wz = static_cast<Real>(height) - a[2];
        // Unknowns s, t, r: s*u + t*v - r*d = w, with d = (dx, dy, 0).
        const Real det = -dx * (uy * vz - uz * vy) + dy * (ux * vz - uz * vx);
        if (det == 0.0L) continue;
        const Real s = (-dx * (wy * vz - wz * vy) + dy * (wx * vz - wz * vx)) / det;
        const Real t = (-dx * (uy * wz - uz * wy) + dy * (ux * wz - uz * wx)) / det;
        const Real r = (ux * (vy * wz - vz * wy) - uy * (vx * wz - vz * wx) + uz * (vx * wy - vy * wx)) / det;
        if (s >= 0.0L && t >= 0.0L && s + t <= 1.0L && r > 0.0L) outermost = std::max(outermost, r);
    }
    return static_cast<double>(outermost);
}

}  // namespace psicarve::oracle
