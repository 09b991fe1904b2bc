// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "hmi/model/mesh.hpp"
#include "hmi/slice/placement.hpp"

namespace psicarve::tool {

/// x, y from the rotation axis, z up. File units; z as in the file.
using Point = std::array<double, 3>;

struct Edge {
    Point from;
    Point to;
};

struct Facet {
    std::array<Point, 3> corners;
    Point normal;     ///< length 1, to either side
    double distance;  ///< normal * p for points of the facet's plane
};

/// The parts of a mesh that a tool can touch: facets that have an area, and edges that stand out. A hollow
/// edge, or one within a plane, is left out: a convex body that touches it touches one of its facets, too.
/// Where a mesh is open or contradicts itself all edges are kept.
struct ContactParts {
    std::vector<Facet> facets;
    std::vector<Edge> edges;
};

ContactParts contact_parts(const model::Mesh& mesh, const slice::Placement& placement);

}  // namespace psicarve::tool
