// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "hmi/model/mesh.hpp"

namespace psicarve::brute {

/// How far behind its tip a tool stands at a distance from its axis: any function that is convex from 0 to
/// radius.
template <typename Rise>
struct Shape {
    double radius;
    Rise rise;
};

namespace detail {

/// The greatest value between 0 and 1 of a function that rises and then falls, by the golden section.
template <typename Function>
double greatest(const Function& function) {
    constexpr int kSteps = 36;
    constexpr double kGolden = 0.6180339887498949;
    double low = 0.0;
    double high = 1.0;
    double a = 1.0 - kGolden;
    double b = kGolden;
    double at_a = function(a);
    double at_b = function(b);
    for (int i = 0; i < kSteps; ++i) {
        if (at_a < at_b) {
            low = a;
            a = b;
            at_a = at_b;
            b = low + kGolden * (high - low);
            at_b = function(b);
        } else {
            high = b;
            b = a;
            at_b = at_a;
            a = high - kGolden * (high - low);
            at_a = function(a);
        }
    }
    return std::max({function(0.0), function(1.0), at_a, at_b});
}

struct Place {
    double across, up, out;
};

inline Place between(const Place& a, const Place& b, double share) {
    return {a.across + share * (b.across - a.across), a.up + share * (b.up - a.up),
            a.out + share * (b.out - a.out)};
}

}  // namespace detail

/// The tip radius of one facet by its definition, slowly: the facet is cut into strips across the tool, each
/// strip clipped to the tool's disc, and both are searched by the golden section; out - rise is concave. 0:
/// out of reach. Shares nothing with the tool offset: no edges, no corners, no normals.
template <typename Rise>
double tip_radius(const model::Triangle& facet, double direction_rad, double height,
                  const Shape<Rise>& tool) {
    using detail::Place;
    std::array<Place, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto& v = facet.vertices[k];
        const double x = v[0], y = v[1], z = v[2];
        corners[k] = {y * std::cos(direction_rad) - x * std::sin(direction_rad), z - height,
                      x * std::cos(direction_rad) + y * std::sin(direction_rad)};
    }
    std::sort(corners.begin(), corners.end(),
              [](const Place& a, const Place& b) { return a.across < b.across; });
    const double low = std::max(corners[0].across, -tool.radius);
    const double high = std::min(corners[2].across, tool.radius);
    if (low > high) return 0.0;
    const auto [lowest, highest] = std::minmax({corners[0].up, corners[1].up, corners[2].up});
    if (lowest > tool.radius || highest < -tool.radius) return 0.0;
    if (std::max({corners[0].out, corners[1].out, corners[2].out}) <= 0.0) return 0.0;
    const auto at_across = [](const Place& a, const Place& b, double across) {
        return a.across == b.across ? a : detail::between(a, b, (across - a.across) / (b.across - a.across));
    };
    const auto best_of_strip = [&](double share) {
        const double across = low + share * (high - low);
        const Place first = at_across(corners[0], corners[2], across);
        const Place second = across < corners[1].across ? at_across(corners[0], corners[1], across)
                                                        : at_across(corners[1], corners[2], across);
        const double half = std::sqrt(std::max(0.0, tool.radius * tool.radius - across * across));
        double from = 0.0;
        double to = 1.0;
        const double rise = second.up - first.up;
        if (rise != 0.0) {
            from = std::clamp((-half - first.up) / rise, 0.0, 1.0);
            to = std::clamp((half - first.up) / rise, 0.0, 1.0);
        }
        const auto tip_at = [&](double part) {
            const Place p = detail::between(first, second, from + part * (to - from));
            // Outside of the disc: less, the further, so that the search finds its way in.
            const double away = std::hypot(across, p.up);
            if (away > tool.radius * (1.0 + 1e-9)) return -1e3 - away;
            return p.out - tool.rise(std::min(away, tool.radius));
        };
        return detail::greatest(tip_at);
    };
    return std::max(0.0, detail::greatest(best_of_strip));
}

template <typename Rise>
double tip_radius(const model::Mesh& mesh, double direction_rad, double height, const Shape<Rise>& tool) {
    double greatest = 0.0;
    for (const model::Triangle& facet : mesh.triangles) {
        greatest = std::max(greatest, tip_radius(facet, direction_rad, height, tool));
    }
    return greatest;
}

}  // namespace psicarve::brute
