// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "hmi/piece/stock_map.hpp"

namespace psicarve::piece {

/// The distance of a place from a surface that is given by its radii in a stock map's cells: triangles
/// between neighbouring cells. Searches the cells within the distance that it has found, at most 8 to each
/// side: beyond that the answer is the way along the radius, if nothing nearer was found.
class SurfaceDistance {
public:
    /// The rows of a map that form the surface.
    struct Rows {
        std::size_t first = 0;
        std::size_t last = 0;
    };

    /// `radii_mm` as many as the map's cells, row by row; both outlive this.
    SurfaceDistance(const StockMap& stock, std::span<const float> radii_mm);
    SurfaceDistance(const StockMap& stock, std::span<const float> radii_mm, Rows rows);

    /// For the place at this radius in the middle of a cell [mm].
    double of(std::size_t row, std::size_t column, double radius_mm) const;
    /// For any place, whose nearest cell this is; `most_mm` where nothing is nearer.
    double of(std::size_t row, std::size_t column, const std::array<double, 3>& place, double most_mm) const;

private:
    using Point = std::array<double, 3>;
    Point point(std::size_t row, std::size_t column) const;
    /// `beside`: how far from the cell's middle the place may be, in cells.
    double nearest_mm(std::size_t row, std::size_t column, const Point& from, double most_mm,
                      double beside) const;
    double nearest2_of_ring(const Point& from, std::size_t row, std::size_t column, int ring,
                            double best2) const;
    double nearest2_of_quad(const Point& from, std::size_t row, std::size_t column, double best2) const;

    const StockMap& stock_;
    std::span<const float> radii_mm_;
    Rows rows_;
    std::vector<double> cosine_;
    std::vector<double> sine_;
};

}  // namespace psicarve::piece
