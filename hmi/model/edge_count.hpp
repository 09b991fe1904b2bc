// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "hmi/model/mesh.hpp"

namespace psicarve::model {

struct EdgeCounts {
    std::uint64_t open = 0;    ///< with an odd number of facets
    std::uint64_t turned = 0;  ///< whose facets disagree about what is outside
};

/// Counts the edges at which a mesh is not closed or not turned alike. Vertices nearer to each other than
/// `tolerance` on each axis are one there: what an exporter's rounding tears apart is no hole.
EdgeCounts count_edges(const TriangleList& triangles, double tolerance);

}  // namespace psicarve::model
