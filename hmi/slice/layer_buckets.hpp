// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hmi/model/mesh.hpp"
#include "hmi/slice/placement.hpp"

namespace psicarve::slice {

/// A facet that some layer cuts: turned upright, its vertices sorted from the lowest to the highest.
struct CutTriangle {
    std::array<std::array<float, 3>, 3> vertices;  ///< x, y, z as stored in the mesh, turned upright
    std::uint32_t end_layer : 31;                  ///< the first layer above that it does not reach
    std::uint32_t turned : 1;                      ///< sorting made its outside its inside
};
static_assert(sizeof(CutTriangle) == 40);

/// The facets of a mesh in the order of the first layer that cuts them. Layer i cuts the facet when
/// lowest z <= height[i] < highest z.
class LayerBuckets {
public:
    /// `heights`: ascending, in stored coordinates (file units less the mesh's origin).
    LayerBuckets(const model::TriangleList& triangles, Up up, std::span<const double> heights);

    std::size_t layer_count() const noexcept { return starts_.size() - 1; }
    std::span<const CutTriangle> starting_in(std::size_t layer) const noexcept {
        return std::span(triangles_).subspan(starts_[layer], starts_[layer + 1] - starts_[layer]);
    }
    /// How many facets each layer cuts.
    const std::vector<std::uint32_t>& cut_counts() const noexcept { return cut_counts_; }

private:
    std::vector<CutTriangle, model::UnsetAllocator<CutTriangle>> triangles_;
    std::vector<std::size_t> starts_;
    std::vector<std::uint32_t> cut_counts_;
};

}  // namespace psicarve::slice
