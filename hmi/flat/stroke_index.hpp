// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hmi/flat/grooves.hpp"

namespace psicarve::flat {

/// Half the sides of the rectangle around a place.
struct HalfCell {
    double along_mm = 0.0;
    double height_mm = 0.0;
};

/// Distances of places on a cylinder from the strokes on it, along its surface.
class StrokeIndex {
public:
    /// Places farther than `reach_mm` from all floors get no exact distance.
    StrokeIndex(const Grooves& grooves, double reach_mm);

    /// Distance of the place from the nearest floor of a groove; negative: on it. Infinite beyond the reach.
    /// `along_mm`: round the cylinder, any number of turns.
    double beside_floor_mm(double along_mm, double height_mm) const {
        return beside_floor_mm(along_mm, height_mm, {});
    }
    /// The least such distance over all the places up to half a cell's sides away. Half a cell's diagonal
    /// counts towards the reach.
    double beside_floor_mm(double along_mm, double height_mm, const HalfCell& around) const;

private:
    struct Piece {
        Point from;
        Point to;
        double half_floor_mm;
    };
    void add(Point from, Point to, double half_floor_mm);
    void enter(const Piece& piece, std::uint32_t index);
    std::size_t row_of(double height_mm) const;

    double round_mm_;
    double reach_mm_;
    double cell_x_mm_ = 1.0;
    double cell_y_mm_ = 1.0;
    std::size_t columns_ = 1;
    std::size_t rows_ = 1;
    std::vector<Piece> pieces_;
    std::vector<std::vector<std::uint32_t>> cells_;  ///< for each cell the pieces within its reach
};

}  // namespace psicarve::flat
