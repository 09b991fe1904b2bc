// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "hmi/model/mesh.hpp"

namespace psicarve::model {

/// What a mesh is made of.
struct MeshParts {
    std::uint64_t components = 0;  ///< that share no corner with each other
    std::uint64_t inside_out = 0;  ///< of these: closed ones that enclose less than nothing
    std::uint64_t open = 0;        ///< of these: with a hole
    std::uint64_t holes = 0;       ///< connected rims of open edges
};

/// Corners are one where their coordinates are, bit for bit. Some 0.5 us a facet, 150 bytes.
MeshParts parts_of(const TriangleList& triangles);

}  // namespace psicarve::model
