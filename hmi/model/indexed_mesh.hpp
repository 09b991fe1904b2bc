// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "hmi/model/mesh.hpp"
#include "hmi/model/mesh_check.hpp"

namespace psicarve::model {

// Beyond this a float no longer resolves a tenth of a micrometre: coordinates are then stored from an origin.
inline constexpr double kFarFromOrigin = 1000.0;
std::array<double, 3> origin_near(const std::array<double, 3>& first_point) noexcept;

/// Points and polygons of a file that names points by number.
class IndexedMesh {
public:
    void add_point(const std::array<double, 3>& point) { points_.push_back(point); }
    std::size_t point_count() const noexcept { return points_.size(); }

    /// Adds a polygon as a fan of triangles. False when it names a point that is not there (yet).
    bool add_polygon(std::span<const std::uint64_t> corners);

    Mesh finish(const std::string& format);

private:
    Triangle triangle(std::uint64_t a, std::uint64_t b, std::uint64_t c) const noexcept;

    std::vector<std::array<double, 3>> points_;
    Mesh mesh_;
    MeshCheck check_;
    bool origin_chosen_ = false;
};

}  // namespace psicarve::model
