// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "hmi/model/mesh.hpp"
#include "hmi/model/mesh_check.hpp"
#include "shared/base/units.hpp"

namespace psicarve::bench {

/// Radius of a figurine-like body of deep relief: shoulders, folds, a leaning axis and fine grain.
inline double relief_radius_mm(double theta_rad, double height_ratio) {
    const double t = theta_rad;
    const double u = height_ratio;
    const double body = 12.0 + 5.0 * std::sin(2.7 * kPi * u + 0.6) + 2.5 * std::cos(7.0 * kPi * u);
    const double folds =
        2.2 * std::sin(5.0 * t + 9.0 * u) * std::sin(kPi * u) + 1.1 * std::cos(13.0 * t - 21.0 * u);
    const double grain = 0.25 * std::sin(57.0 * t + 80.0 * u) * std::cos(43.0 * u * kPi);
    return body + folds + grain;
}

/// A closed surface of about `triangle_count` facets, 60 mm high, with its axis off the middle of its
/// sections.
inline model::Mesh relief_mesh(std::size_t triangle_count) {
    const auto rows = static_cast<std::size_t>(std::sqrt(static_cast<double>(triangle_count) / 2.0));
    const std::size_t columns = rows;
    const double height_mm = 60.0;
    const auto at = [&](std::size_t row, std::size_t column) {
        const double u = static_cast<double>(row) / static_cast<double>(rows);
        const double t = 2.0 * kPi * static_cast<double>(column % columns) / static_cast<double>(columns);
        const double r = relief_radius_mm(t, u);
        return std::array<float, 3>{static_cast<float>(r * std::cos(t) + 1.5 * std::sin(4.0 * u)),
                                    static_cast<float>(r * std::sin(t) + 1.0 * std::cos(3.0 * u)),
                                    static_cast<float>(u * height_mm)};
    };
    model::Mesh mesh;
    mesh.format = "generated";
    mesh.source_name = "relief";
    model::MeshCheck check;
    const auto add = [&](const std::array<float, 3>& a, const std::array<float, 3>& b,
                         const std::array<float, 3>& c) {
        const model::Triangle triangle{{a, b, c}};
        check.add_to(mesh.triangles, triangle);
    };
    const std::array<float, 3> foot{0.0F, 1.0F, 0.0F};
    const std::array<float, 3> head{static_cast<float>(1.5 * std::sin(4.0)),
                                    static_cast<float>(std::cos(3.0)), static_cast<float>(height_mm)};
    for (std::size_t column = 0; column < columns; ++column) {
        add(foot, at(0, column + 1), at(0, column));
        add(head, at(rows, column), at(rows, column + 1));
        for (std::size_t row = 0; row < rows; ++row) {
            add(at(row, column), at(row, column + 1), at(row + 1, column + 1));
            add(at(row, column), at(row + 1, column + 1), at(row + 1, column));
        }
    }
    mesh.facts = check.facts(mesh.origin);
    return mesh;
}

}  // namespace psicarve::bench
