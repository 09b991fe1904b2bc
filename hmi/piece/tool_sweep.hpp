// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "hmi/piece/stock_map.hpp"
#include "hmi/piece/tool_cut.hpp"
#include "hmi/tool/tool.hpp"

namespace psicarve::piece {

/// Cuts what ToolCut cuts at the same places one after the other, to the last bit, several places at a time:
/// those that follow each other at one height, near each other. Tests cells in blocks of a row's columns.
/// Bounds tell which places can change a block, first for all places of several blocks; of those that can,
/// the deepest comes first, and most of the others find nothing left.
///
/// The same result, since
///   - a bound is the entry itself, computed from the least and the most of what a block's columns have:
///     rounded operations keep their order, so no column enters less far out;
///   - where all a block's cells are within the tool's side at all places, each ends at the least entry,
///     whatever the order, for cells only become smaller; elsewhere the places come in their own order.
///
/// No other code adds material to the stock. One thread.
class ToolSweep {
public:
    ToolSweep(const tool::Tool& tool, StockMap& stock, double point_reach_rad = 7.0,
              double point_reach_mm = 0.0);

    /// The tool's axis at a direction (0 <= direction < one turn) and height, its tip at a radius >= 0. May
    /// cut it later.
    void at(double direction_rad, double height_mm, double tip_mm);
    /// Cuts all that waits; call it before the stock is read.
    void flush();

    /// The greatest angle between the first of the places that are cut together and any other, to either
    /// side.
    static constexpr double kMostTurn_rad = 0.05;

private:
    static constexpr std::size_t kPlaces = 16;
    static constexpr std::size_t kColumns = 8;  ///< of a block
    static constexpr std::size_t kBlocks = 8;   ///< of a stretch

    using PerColumn = std::array<float, kColumns>;
    using PerPlace = std::array<float, kPlaces>;
    using PerBlock = std::array<float, kBlocks>;
    /// The values from which an entry is computed; see the shapes in the .cpp.
    template <typename Values>
    struct Terms {
        Values ahead;
        Values aside;
        Values spread;
        Values sine2;
    };
    /// The least over several columns or places, and of `spread` the most as well.
    template <typename Values>
    struct Bounds {
        Terms<Values> least;
        Values most_spread;
    };
    /// Neighbouring columns, as seen from each place.
    struct Block {
        std::array<Terms<PerColumn>, kPlaces> at;
        Bounds<PerPlace> bounds;
        float most_sine2;  ///< of all places and columns
    };
    struct Place {
        double direction_rad;
        double tip_mm;
        ReachedColumns columns;
    };
    struct Row {
        std::size_t index;
        float across2;
        float height2;
    };

    template <typename Shape>
    void sweep(const Shape& shape);
    void choose_blocks();
    template <typename Shape>
    void look_from(const Shape& shape, std::size_t place);
    void bound_blocks();
    template <typename Shape>
    void cut_row(const Shape& shape, const Row& row);
    template <typename Shape>
    void cut_block(const Shape& shape, std::size_t index, const Row& row);
    std::size_t block_in_row(std::size_t block) const noexcept;

    tool::Tool tool_;
    ToolCut plain_;  ///< for a point
    StockMap& stock_;
    std::size_t blocks_in_row_;
    std::vector<float> cosine_;  ///< by column, of whole blocks
    std::vector<float> sine_;
    std::vector<float> top_mm_;  ///< nothing in a block of the map stands further out
    std::vector<Place> places_;
    double height_mm_ = 0.0;
    std::size_t first_block_ = 0;              ///< of a row: the first that a place reaches
    std::vector<Block> blocks_;                ///< from there on, round the row's end
    std::vector<Bounds<PerBlock>> stretches_;  ///< of all places, blocks_ by kBlocks
};

}  // namespace psicarve::piece
