// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hmi/model/large_memory.hpp"
#include "hmi/model/mesh.hpp"
#include "hmi/slice/placement.hpp"

namespace psicarve::slice {

/// A facet that some layer cuts.
struct CutFacet {
    std::uint32_t facet;      ///< index in the mesh
    std::uint32_t end_layer;  ///< the first layer above that it does not reach
};

/// Which layers cut which facets of a mesh: layer i cuts a facet when lowest z <= height[i] < highest z. A
/// row that rises from a bottom to a top may cut what has lowest z <= top and bottom < highest z.
class LayerBuckets {
public:
    /// Heights are ascending, in stored coordinates (file units less the mesh's origin). For rows that do not
    /// rise give the same heights twice.
    LayerBuckets(const model::TriangleList& triangles, Up up, std::span<const double> bottoms,
                 std::span<const double> tops);

    /// The facets whose first layer this is, in the mesh's order.
    std::span<const CutFacet> starting_in(std::size_t layer) const noexcept {
        return std::span(facets_).subspan(starts_[layer], starts_[layer + 1] - starts_[layer]);
    }
    /// How many facets each layer cuts.
    const std::vector<std::uint32_t>& cut_counts() const noexcept { return cut_counts_; }

private:
    std::vector<CutFacet, model::UnsetAllocator<CutFacet>> facets_;
    std::vector<std::size_t> starts_;
    std::vector<std::uint32_t> cut_counts_;
};

}  // namespace psicarve::slice
