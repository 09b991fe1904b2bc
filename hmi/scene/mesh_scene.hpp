// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "hmi/model/mesh.hpp"

namespace psicarve::session {

using Facet = std::array<std::uint32_t, 3>;

/// A mesh for drawing, with no more facets than a picture can show. File units and axes.
struct MeshScene {
    std::vector<std::array<float, 3>> vertices;  ///< relative to the middle of the bounding box
    std::vector<std::uint32_t> vertex_rgb;       ///< a colour for each vertex, or empty
    std::vector<Facet> facets;
    std::vector<Facet> coarse_facets;  ///< the same shape with far fewer; may be empty
    std::array<double, 3> size{};      ///< of the bounding box
    std::array<double, 3> middle{};    ///< of the bounding box in the file
};

/// Joins the vertices in each cell of a grid of `cells` along the longest side; likewise for the coarse
/// facets. Cells grow where a rugged mesh would still have more facets than a view can draw in time.
MeshScene make_mesh_scene(const model::Mesh& mesh, std::uint32_t cells = 240,
                          std::uint32_t coarse_cells = 80);

}  // namespace psicarve::session
