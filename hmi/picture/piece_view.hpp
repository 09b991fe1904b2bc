// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hmi/picture/piece_grid.hpp"

namespace psicarve::verify {

/// Pixels in cairo's form: 0xAARRGGBB, colours premultiplied by alpha.
struct PixelImage {
    std::size_t width = 0;
    std::size_t height = 0;
    std::vector<std::uint32_t> argb;
};

/// The view of the piece: parallel projection without a vanishing point, so that lengths can be measured.
struct PieceCamera {
    double azimuth_rad = 0.0;    ///< workpiece direction that faces the viewer
    double elevation_rad = 0.0;  ///< above the horizon
    double px_per_mm = 1.0;
    std::size_t width_px = 0;
    std::size_t height_px = 0;
};

/// The largest scale at which the piece fits the picture with a margin.
double fitting_px_per_mm(const PieceGrid& grid, double elevation_rad, double width_px, double height_px);

/// The piece shaded, transparent around it; the middle of its axis lies in the picture's middle.
PixelImage draw_piece(const PieceGrid& grid, const PieceCamera& camera);

}  // namespace psicarve::verify
