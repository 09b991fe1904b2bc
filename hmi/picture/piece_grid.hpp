// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hmi/surface/carved_surface.hpp"

namespace psicarve::verify {

struct Vec3 {
    float x = 0.0F;
    float y = 0.0F;
    float z = 0.0F;
};

/// The carved piece as a grid fit for drawing: rows from the lowest to the highest, columns counter-clockwise
/// from direction 0. Finer surfaces are averaged down, so that 4 000 layers cost no more than 600.
struct PieceGrid {
    struct Node {
        Vec3 position_mm;
        Vec3 normal;
        float openness = 1.0F;  ///< 0 deep inside a groove .. 1 in the open: how much of the sky it sees
    };
    std::size_t rows = 0;
    std::size_t columns = 0;
    std::vector<Node> nodes;  ///< [rows * columns]
    float bottom_mm = 0.0F;
    float top_mm = 0.0F;
    float radius_mm = 0.0F;  ///< the largest

    const Node& at(std::size_t row, std::size_t column) const { return nodes[row * columns + column]; }
};

PieceGrid make_piece_grid(const CarvedSurface& surface);
/// Makes the grid from radii row by row, from the lowest height to the highest; at least one row.
PieceGrid make_piece_grid(std::size_t columns, std::vector<float> radii_mm, std::vector<float> heights_mm);

}  // namespace psicarve::verify
