// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/hmi/model/shapes.hpp"

namespace psicarve::shapes {

/// A corner of a star-shaped outline about the axis.
struct Corner {
    double direction_deg;
    double radius;
};

/// An upright prism over such an outline, its corners in ascending directions.
inline model::Mesh star(const std::vector<Corner>& outline, double height) {
    const auto at = [&](std::size_t i, double z) {
        const Corner& corner = outline[i % outline.size()];
        const double angle = corner.direction_deg * std::numbers::pi / 180.0;
        return Point{corner.radius * std::cos(angle), corner.radius * std::sin(angle), z};
    };
    Builder body;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        body.quad(at(i, 0.0), at(i + 1, 0.0), at(i + 1, height), at(i, height));
        body.facet({0, 0, 0}, at(i + 1, 0.0), at(i, 0.0));
        body.facet({0, 0, height}, at(i, height), at(i + 1, height));
    }
    return body.mesh();
}

/// A round column of radius 15 and height 10 with a fin or needle out to radius 20 in one direction: so wide
/// at its foot and at its end [deg].
inline model::Mesh finned(double direction_deg, double foot_deg, double end_deg) {
    std::vector<Corner> outline;
    for (int k = 0; k < 180; ++k) {
        const double off = std::remainder(2.0 * k - direction_deg, 360.0);
        if (std::abs(off) > foot_deg) outline.push_back({2.0 * k, 15.0});
    }
    outline.insert(outline.end(), {{direction_deg - 0.5 * foot_deg, 15.0},
                                   {direction_deg - 0.5 * end_deg, 20.0},
                                   {direction_deg + 0.5 * end_deg, 20.0},
                                   {direction_deg + 0.5 * foot_deg, 15.0}});
    std::sort(outline.begin(), outline.end(),
              [](const Corner& a, const Corner& b) { return a.direction_deg < b.direction_deg; });
    return star(outline, 10.0);
}

/// The column whose needle stands square: straight up from its foot.
inline model::Mesh needle(double direction_deg, double width_deg) {
    return finned(direction_deg, width_deg + 0.02, width_deg);
}

}  // namespace psicarve::shapes
