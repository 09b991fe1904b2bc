// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hmi/flat/grooves.hpp"

namespace psicarve::flat {

/// Half the sides of the rectangle that a place stands for.
struct HalfCell {
    double along_mm = 0.0;
    double height_mm = 0.0;
};

/// How far places of a cylinder's surface are from the strokes on it, along that surface.
class StrokeIndex {
public:
    /// What is farther away than `reach_mm` from all floors is not told apart.
    StrokeIndex(const Grooves& grooves, double reach_mm);

    /// How far beside the nearest floor of a groove the place is; negative: on it. Infinite beyond the reach.
    /// `along_mm`: round the cylinder, any number of turns.
    double beside_floor_mm(double along_mm, double height_mm) const {
        return beside_floor_mm(along_mm, height_mm, {});
    }
    /// The same of all the places up to half a cell's sides away, whichever of them is the nearest. Half a
    /// cell's diagonal counts to the reach.
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
    std::vector<std::vector<std::uint32_t>> cells_;  ///< the pieces within reach of each
};

}  // namespace psicarve::flat
