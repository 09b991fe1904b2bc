// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "hmi/model/mesh.hpp"

namespace psicarve::model {

/// The connected parts of a mesh.
struct MeshParts {
    std::uint64_t components = 0;  ///< parts that share no corner with each other
    std::uint64_t inside_out = 0;  ///< of these: closed ones with a negative volume
    std::uint64_t open = 0;        ///< of these: with a hole
    std::uint64_t holes = 0;       ///< connected rims of open edges
};

/// Corners are the same when their coordinates are, bit for bit. Some 0.5 us a facet, 150 bytes.
MeshParts parts_of(const TriangleList& triangles);

}  // namespace psicarve::model
