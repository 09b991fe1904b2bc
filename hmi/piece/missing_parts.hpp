// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "hmi/piece/ridges.hpp"
#include "hmi/piece/stock_map.hpp"
#include "hmi/piece/surface_distance.hpp"

namespace psicarve::piece {

/// The parts of the model that a piece lacks, seen from the model: the distance from its surface to the
/// piece. A thin fin that was cut off lies far outside of a piece whose own surface equals the model beside
/// the fin.
class MissingParts {
public:
    /// `wanted_mm`: the model's radii in all cells; `rows`: the rows to compare, not empty. All outlive this.
    MissingParts(const StockMap& carved, std::span<const float> wanted_mm, std::span<const std::size_t> rows);

    /// For the model's place in a cell [mm]; 0 where the cells beside it hold material as far out: a map does
    /// not resolve less.
    double at_cell(std::size_t row, std::size_t column) const;
    /// For the part of a ridge that was cut off: the distance to the material that is left in its row, and in
    /// those above and below where layers lie so close that nothing else is left there. Sheets that stay
    /// between layers do not belong to the ridge.
    double at_ridge(const Ridges& ridges, std::size_t index) const;

private:
    double in_row_mm(const Ridge& ridge, std::size_t row) const;

    const StockMap& carved_;
    std::span<const float> wanted_mm_;
    std::size_t first_row_;
    std::size_t last_row_;
    SurfaceDistance piece_;
};

}  // namespace psicarve::piece
