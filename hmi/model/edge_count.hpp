// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "hmi/model/mesh.hpp"

namespace psicarve::model {

struct EdgeCounts {
    std::uint64_t open = 0;    ///< with an odd number of facets
    std::uint64_t turned = 0;  ///< whose facets disagree which side is outside
};

/// Counts the edges at which a mesh is not closed or not turned alike.
EdgeCounts count_edges(const TriangleList& triangles);

/// The same, but first joins vertices of such edges that are nearer to each other than `tolerance` on each
/// axis: a gap that an exporter's rounding makes is no hole. No other vertex is moved.
EdgeCounts join_torn_edges(TriangleList& triangles, double tolerance);

}  // namespace psicarve::model
