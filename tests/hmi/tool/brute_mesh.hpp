// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "hmi/model/mesh.hpp"
#include "hmi/slice/placement.hpp"
#include "shared/profile/profile.hpp"
#include "tests/hmi/tool/brute_force.hpp"

namespace psicarve::brute {

/// How far a tool's flank stands behind its tip at s from its axis, as docs/tools.md has it.
inline double behind_tip(const ToolProfile& tool, double s) {
    const double radius = 0.5 * tool.diameter_mm;
    if (tool.shape == ToolShape::ball) return radius - std::sqrt(std::max(0.0, radius * radius - s * s));
    return tool.shape == ToolShape::vee ? s / std::tan(0.5 * tool.angle_deg * std::acos(-1.0) / 180.0) : 0.0;
}

/// The mesh as it stands on the table [mm]: turned upright, its box's middle on the axis, its foot at 0.
inline model::Mesh standing(const model::Mesh& mesh, slice::Up up, double height_mm) {
    constexpr double kFar = std::numeric_limits<double>::max();
    std::array<double, 3> least{kFar, kFar, kFar};
    std::array<double, 3> most{-kFar, -kFar, -kFar};
    const auto turned = [up](const auto& v) {
        const double x = v[0], y = v[1], z = v[2];
        return up == slice::Up::y ? std::array{z, x, y} : std::array{x, y, z};
    };
    for (const model::Triangle& facet : mesh.triangles) {
        for (const auto& vertex : facet.vertices) {
            const auto point = turned(vertex);
            for (std::size_t k = 0; k < 3; ++k) {
                least[k] = std::min(least[k], point[k]);
                most[k] = std::max(most[k], point[k]);
            }
        }
    }
    const double scale = height_mm / (most[2] - least[2]);
    model::Mesh out;
    for (const model::Triangle& facet : mesh.triangles) {
        model::Triangle placed;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto point = turned(facet.vertices[i]);
            placed.vertices[i] = {static_cast<float>(scale * (point[0] - 0.5 * (least[0] + most[0]))),
                                  static_cast<float>(scale * (point[1] - 0.5 * (least[1] + most[1]))),
                                  static_cast<float>(scale * (point[2] - least[2]))};
        }
        out.triangles.push_back(placed);
    }
    return out;
}

/// Facets above and below the tool, and those that do not reach out beyond the greatest tip so far, cannot
/// lift it: they are left out. No less than `least_mm`, beyond which alone it is looked.
inline double tip_mm(const model::Mesh& mesh, const ToolProfile& tool, double direction_rad, double height_mm,
                     double least_mm = 0.0) {
    const auto rise = [&tool](double s) { return behind_tip(tool, s); };
    const Shape<decltype(rise)> shape{0.5 * tool.diameter_mm, rise};
    const double cosine = std::cos(direction_rad);
    const double sine = std::sin(direction_rad);
    const double low = height_mm - shape.radius;
    const double high = height_mm + shape.radius;
    double greatest = least_mm;
    for (const model::Triangle& facet : mesh.triangles) {
        const auto& [a, b, c] = facet.vertices;
        if (a[2] < low && b[2] < low && c[2] < low) continue;
        if (a[2] > high && b[2] > high && c[2] > high) continue;
        const auto out = [cosine, sine](const std::array<float, 3>& v) {
            return v[0] * cosine + v[1] * sine;
        };
        if (std::max({out(a), out(b), out(c)}) <= greatest) continue;
        greatest = std::max(greatest, tip_radius(facet, direction_rad, height_mm, shape));
    }
    return greatest;
}

}  // namespace psicarve::brute
