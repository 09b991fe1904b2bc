// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "hmi/model/mesh.hpp"
#include "hmi/slice/directions.hpp"
#include "hmi/slice/layer_scan.hpp"

namespace psicarve::slice {

/// Scan-converts one rising row of a spiral: two heads that face each other turn by half a revolution, each
/// from the row's bottom to its top. So every direction is passed once, at a height of its own:
///
///     top     |      o|      o      direction d of 2n is passed as point j of its head, 1 <= j <= n:
///             |   o   |   o         j = d - first (of the one), d - first - n (of the other); modulo 2n
///     bottom  |o      |o            height = bottom + (top - bottom) * j / n
///              first   first + n
class SpiralScan {
public:
    /// `directions` outlives it.
    explicit SpiralScan(const Directions& directions);

    /// Stored coordinates. Odd rows begin half a turn on.
    void begin_row(std::size_t row, double bottom, double top) noexcept;
    /// Draws into `scan` where the row cuts a facet.
    void add(const FacetCutter& cutter, const model::Triangle& facet, LayerScan& scan) const noexcept;

    /// Directions whose wall count shows a hole, before the scan is finished: the rays of both heads begin in
    /// one point of the axis, so when the two differ, one of them has met a hole. Both have where they differ
    /// from the row's both ends. (Between unlike ends the axis enters or leaves the solid.)
    std::uint32_t open_cells(const LayerScan& scan) const noexcept;

private:
    void add_in(const FacetCutter& cutter, const model::Triangle& facet, std::uint32_t first,
                std::uint32_t end, LayerScan& scan) const noexcept;

    const Directions& directions_;
    std::size_t row_ = 0;
    std::array<std::vector<double>, 2> part_;  ///< j / n by sorted cell, of even and of odd rows
    std::vector<double> height_;               ///< of this row, by sorted cell
};

}  // namespace psicarve::slice
