// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/tool/surface_tiles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "hmi/tool/map_dilation.hpp"
#include "shared/base/units.hpp"

namespace psicarve::tool {
namespace {

/// No slack: the bounds have one of their own, which is more than single precision takes.
void expect_all_held(const SampledRadii& map, std::size_t side) {
    const SurfaceTiles tiles(map, side, 2);
    for (std::size_t i = 0; i < map.radius.size(); ++i) {
        const double radius = map.radius[i];
        if (!(radius > 0.0)) continue;
        const std::size_t row = i / map.column_count;
        const std::size_t column = i % map.column_count;
        const std::size_t tile = row / side * tiles.column_count + column / side;
        const double angle_rad =
            2.0 * kPi * static_cast<double>(column) / static_cast<double>(map.column_count);
        const double x = radius * std::cos(angle_rad) - static_cast<double>(tiles.x[tile]);
        const double y = radius * std::sin(angle_rad) - static_cast<double>(tiles.y[tile]);
        const double z = static_cast<double>(row) * map.row_pitch - static_cast<double>(tiles.z[tile]);
        const double along = x * static_cast<double>(tiles.normal_x[tile]) +
                             y * static_cast<double>(tiles.normal_y[tile]) +
                             z * static_cast<double>(tiles.normal_z[tile]);
        ASSERT_LE(std::hypot(x, y, z), tiles.reach[tile]) << "sample " << i;
        ASSERT_LE(std::abs(along), tiles.bulge[tile]) << "sample " << i;
        ASSERT_LE(radius, tiles.most_radius[tile]) << "sample " << i;
        ASSERT_GE(radius, tiles.least_radius[row / side]) << "sample " << i;
    }
}

TEST(SurfaceTiles, HoldEachSampleAlsoInTilesThatHolesOrTheEdgesCut) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    for (const double holes : {0.0, 0.3, 0.93}) {
        for (const double rough : {0.001, 8.0}) {
            std::vector<float> radii;
            for (std::size_t i = 0; i < 41 * 103; ++i)
                radii.push_back(share(random) < holes ? 0.0F
                                                      : static_cast<float>(40.0 + rough * share(random)));
            for (const std::size_t side : {4U, 16U}) expect_all_held({41, 103, 5.0, radii}, side);
        }
    }
}

TEST(SurfaceTiles, AreTightWhereOneSampleStandsAlone) {
    constexpr std::size_t kSide = 20;
    std::vector<float> radii(kSide * kSide, 0.0F);
    for (std::size_t tile = 0; tile < 25; ++tile) {
        const std::size_t row = tile / 5 * 4 + tile % 4;
        const std::size_t column = tile % 5 * 4 + tile % 3;
        radii[row * kSide + column] = 10.0F + static_cast<float>(tile);
    }
    const SurfaceTiles tiles({kSide, kSide, 0.5, radii}, 4, 1);
    for (std::size_t tile = 0; tile < 25; ++tile) {
        EXPECT_LT(tiles.bulge[tile], 0.001F) << "tile " << tile;
        EXPECT_LT(tiles.reach[tile], 0.001F) << "tile " << tile;
        EXPECT_NEAR(tiles.most_radius[tile], 10.0 + static_cast<double>(tile), 0.001);
    }
}

}  // namespace
}  // namespace psicarve::tool
