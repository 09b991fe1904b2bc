// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "hmi/tool/dilation_kernel.hpp"
#include "hmi/tool/map_dilation.hpp"
#include "hmi/tool/surface_tiles.hpp"

namespace psicarve::tool::dilation {

/// The data that all blocks share.
struct DilationScene {
    DilationScene(const SampledRadii& sampled, const Tool& moved, unsigned thread_count);

    const SampledRadii& surface;
    DilationTool tool;
    SurfaceTiles fine;    ///< of kFineSide
    SurfaceTiles coarse;  ///< of kCoarseSide
    TurnTable table;
    std::vector<double> reach_columns;  ///< how far the tool may reach, by row of coarse tiles
};

/// Tips of kLanes x kBlockRows places at a time, which go along their rows once round.
class DilationBlock {
public:
    DilationBlock(const DilationScene& scene, std::size_t first_row);

    /// Fills all rows, in the order of `tips`.
    void fill_rows(std::vector<float>& tips);

private:
    struct Seat {
        std::size_t row;
        std::size_t column;
        float excess;
    };

    template <Shape kShape>
    void fill_rows_of(std::vector<float>& tips);
    template <Shape kShape>
    void begin(std::size_t first_column);
    template <Shape kShape>
    void try_contacts(std::size_t row, std::int32_t rows_on, std::int32_t columns_on);
    void set_centres(std::size_t row);
    void set_view();
    void set_disc();
    template <Shape kShape>
    void seek_coarse();
    template <Shape kShape>
    void seek_coarse_row(std::size_t row);
    template <Shape kShape>
    void seek_fine(Seat coarse);
    template <Shape kShape>
    void touch(std::size_t tile_row, std::size_t tile_column);
    template <Shape kShape>
    bool try_tile(std::size_t row, std::size_t lane, std::size_t tile_row, std::size_t tile_column);

    const DilationScene& scene_;
    std::array<std::size_t, kBlockRows> rows_{};  ///< past the last one: the last one again
    std::size_t first_column_ = 0;
    PlaceBlock places_;
    BlockView view_;
    std::vector<Seat> coarse_;
};

}  // namespace psicarve::tool::dilation
