// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "hmi/piece/ridges.hpp"
#include "hmi/piece/stock_map.hpp"
#include "hmi/piece/surface_distance.hpp"

namespace psicarve::piece {

/// What a piece lacks of its model, seen from the model: how far its surface is from what is left. A thin
/// fin that was cut off lies far outside of a piece whose own surface is as the model is beside the fin.
class MissingParts {
public:
    /// `wanted_mm`: the model's radii in all cells; `rows`: those that are compared, not empty. All outlive
    /// this.
    MissingParts(const StockMap& carved, std::span<const float> wanted_mm, std::span<const std::size_t> rows);

    /// Of the model's place in a cell [mm]; 0 where the cells beside it hold material as far out: that near a
    /// map does not tell.
    double at_cell(std::size_t row, std::size_t column) const;
    /// Of what was cut off a ridge: the way to what is left in its row, and in those above and below where
    /// layers lie so close that nothing else is left there. Sheets that stay between layers are not the
    /// ridge.
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
