// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hmi/model/large_memory.hpp"

namespace psicarve::flat {
struct Grooves;
}

namespace psicarve::model {

/// One facet as files store it: three vertices, in the order that turns counter-clockwise seen from outside.
/// Coordinates are the file's units, relative to Mesh::origin.
struct Triangle {
    std::array<std::array<float, 3>, 3> vertices;
};
static_assert(sizeof(Triangle) == 36);

using TriangleList = std::vector<Triangle, UnsetAllocator<Triangle>>;

/// What a reader found in a mesh. Nothing is repaired, except that repeated facets count once, and vertices
/// that rounding tore apart are joined.
struct MeshFacts {
    std::uint64_t dropped_count = 0;         ///< facets with a NaN or infinite coordinate, left out
    std::uint64_t degenerate_count = 0;      ///< facets without area, kept
    std::uint64_t duplicate_count = 0;       ///< repeated facets, left out
    std::uint64_t open_edge_count = 0;       ///< edges with an odd number of facets
    std::uint64_t turned_edge_count = 0;     ///< edges whose facets disagree which side is outside
    std::uint64_t doubled_vertex_count = 0;  ///< vertices of an indexed file at the same place
    bool saw_duplicates = false;             ///< found in a sample of one facet in 64: enough to notice a
                                             ///< doubled mesh
    bool closed = true;                      ///< every edge belongs to an even number of facets
    bool same_orientation = true;            ///< along every edge the facets agree which side is outside
    /// From one number that the file can hold to the next, at the farthest vertex. Unknown for a text file.
    double coordinate_step = 0.0;
    double signed_volume = 0.0;   ///< cubic file units; negative: inside out
    std::array<double, 3> min{};  ///< bounding box, file units, origin included
    std::array<double, 3> max{};
};

/// How a model was turned after it was read.
struct MeshTurn {
    std::array<double, 3> rotate_deg{};  ///< about the file's x, then y, then z
    std::optional<std::size_t> mirror;   ///< the coordinate that changes its sign, before that

    bool operator==(const MeshTurn&) const = default;
    bool any() const noexcept {
        return mirror || rotate_deg[0] != 0.0 || rotate_deg[1] != 0.0 || rotate_deg[2] != 0.0;
    }
};

/// A triangle soup and what is known about the file it came from.
struct Mesh {
    TriangleList triangles;
    std::array<double, 3> origin{};  ///< add to every stored coordinate; not zero only far from the origin
    MeshFacts facts;
    /// Position of the rotation axis, seen from above, if it is not the middle of the box.
    std::optional<std::array<double, 2>> axis_hint;
    /// How a drawing or picture became this body, for flat::flat_options_from_json; empty: the source is a
    /// mesh.
    std::string body_json;
    /// For line art on a cylinder: the source of a job's tables. The triangles only show it.
    std::shared_ptr<const flat::Grooves> grooves;
    MeshTurn turn;                  ///< the turn that was applied
    std::string format;             ///< "binary STL", "OBJ", ...
    std::string source_name;        ///< file name without folders
    std::uint64_t source_hash = 0;  ///< XXH3 of the file's bytes
    std::vector<std::string> warnings;
};

}  // namespace psicarve::model
