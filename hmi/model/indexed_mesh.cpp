// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/model/indexed_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "hmi/model/mesh.hpp"

namespace psicarve::model {

std::array<double, 3> origin_near(const std::array<double, 3>& first_point) noexcept {
    std::array<double, 3> origin{};
    for (std::size_t k = 0; k < 3; ++k) {
        const bool far = std::isfinite(first_point[k]) && std::abs(first_point[k]) > kFarFromOrigin;
        origin[k] = far ? std::trunc(first_point[k]) : 0.0;
    }
    return origin;
}

Triangle IndexedMesh::triangle(std::uint64_t a, std::uint64_t b, std::uint64_t c) const noexcept {
    Triangle out{};
    const std::array<std::uint64_t, 3> corners{a, b, c};
    for (std::size_t v = 0; v < 3; ++v) {
        for (std::size_t k = 0; k < 3; ++k) {
            out.vertices[v][k] = static_cast<float>(points_[corners[v]][k] - mesh_.origin[k]);
        }
    }
    return out;
}

bool IndexedMesh::add_polygon(std::span<const std::uint64_t> corners) {
    const bool all_there = std::all_of(corners.begin(), corners.end(),
                                       [this](std::uint64_t corner) { return corner < points_.size(); });
    if (!all_there) return false;
    if (!origin_chosen_ && !corners.empty()) {
        mesh_.origin = origin_near(points_[corners[0]]);
        origin_chosen_ = true;
    }
    for (std::size_t i = 2; i < corners.size(); ++i) {
        check_.add_to(mesh_.triangles, triangle(corners[0], corners[i - 1], corners[i]));
    }
    return true;
}

Mesh IndexedMesh::finish(const std::string& format) {
    mesh_.format = format;
    mesh_.facts = check_.facts(mesh_.origin);
    // A file whose facets each bring their own points is a soup, as STL is: doubles mean nothing there.
    std::sort(points_.begin(), points_.end());
    const auto end = std::unique(points_.begin(), points_.end());
    const auto doubled = static_cast<std::uint64_t>(points_.end() - end);
    const bool is_soup = points_.size() == 3 * mesh_.triangles.size();
    mesh_.facts.doubled_vertex_count = is_soup ? 0 : doubled;
    return std::move(mesh_);
}

}  // namespace psicarve::model
