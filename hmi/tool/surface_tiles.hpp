// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace psicarve::tool {

struct SampledRadii;

/// Square tiles of samples, smaller at the upper edge and before the seam, row after row. All samples of a
/// tile lie within `reach` of its place, and within `bulge` of the plane through that with its normal. A tile
/// without a surface is out of any tool's reach. Four tiles may be read from each on.
struct SurfaceTiles {
    static constexpr std::size_t kReadPast = 3;

    SurfaceTiles(const SampledRadii& surface, std::size_t side, unsigned thread_count);

    std::size_t side;
    std::size_t row_count;
    std::size_t column_count;
    std::vector<float> x, y, z;
    std::vector<float> normal_x, normal_y, normal_z;
    std::vector<float> bulge;
    std::vector<float> reach;
    std::vector<float> most_radius;   ///< of any sample of the tile
    std::vector<float> least_radius;  ///< of any sample, by row of tiles; 0 where there is none

private:
    void fill(const SampledRadii& surface, std::size_t first_row, std::size_t end_row);
};

}  // namespace psicarve::tool
