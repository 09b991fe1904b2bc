// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/slice/layer_scan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <span>
#include <vector>

namespace psicarve::slice {
namespace {

std::vector<double> every_degree_rad() {
    std::vector<double> angles_rad;
    for (int i = 0; i < 360; ++i) angles_rad.push_back(i * std::numbers::pi / 180.0);
    return angles_rad;
}

/// A wall that all but follows a ray: from radius 1 on one side of it to radius 3 on the other, and so
/// through the ray at 1.5.
SectionSegment wall_along(double angle_rad, double aside_rad) {
    const double from_rad = angle_rad - aside_rad;
    const double to_rad = angle_rad + aside_rad;
    return {std::cos(from_rad), std::sin(from_rad), 3.0 * std::cos(to_rad), 3.0 * std::sin(to_rad)};
}

// Bit for bit: walls on all sides, along the axes too, short and long, some through the axis.
TEST(LayerScan, SeveralWallsAtOnceAreTheSameWallsOneByOne) {
    std::mt19937_64 random{31};
    std::uniform_real_distribution<double> place{-9.0, 9.0};
    std::vector<SectionSegment> walls{{1, 0, 0, 1},    {0, 1, -1, 0},     {-1, 0, 0, -1},
                                      {0, -1, 1, 0},   {0, 0, 2, 1},      {1, -0.0, 2, 3},
                                      {-0.0, 1, 1, 1}, {-1, -0.0, -1, 1}, {3, -1e-320, 3, 1}};
    while (walls.size() < LayerScan::kMostAtOnce) {
        const double x = place(random);
        const double y = place(random);
        const double length = walls.size() % 3 == 0 ? 4.0 : 0.01;
        walls.push_back({x, y, x + length * place(random), y + length * place(random)});
    }
    const Directions directions{every_degree_rad()};
    LayerScan sut{directions};
    LayerScan one_by_one{directions};
    for (const std::size_t count : {std::size_t{0}, std::size_t{9}, walls.size()}) {
        sut.add_segments(std::span(walls).first(count));
        for (std::size_t i = 0; i < count; ++i) one_by_one.add_segment(walls[i]);
        const LayerTotals totals = sut.finish();
        const LayerTotals expected = one_by_one.finish();
        EXPECT_EQ(totals.radius_sum, expected.radius_sum) << count;
        EXPECT_EQ(totals.walls, expected.walls) << count;
        EXPECT_TRUE(std::ranges::equal(sut.radius(), one_by_one.radius())) << count;
        EXPECT_TRUE(std::ranges::equal(sut.wall_counts(), one_by_one.wall_counts())) << count;
    }
}

// Both ends' diamond angles are worked out at once there.
TEST(LayerScan, EndsOfWallsOnAnyRayAreWhereDirectionsSayTheyAre) {
    const Directions directions{every_degree_rad()};
    LayerScan sut{directions};
    for (std::size_t degree = 0; degree < 360; ++degree) {
        const double from_rad = every_degree_rad()[degree] - 0.01;
        const double to_rad = every_degree_rad()[degree] + 0.01;
        sut.add_segment({std::cos(from_rad), std::sin(from_rad), std::cos(to_rad), std::sin(to_rad)});
        EXPECT_EQ(sut.finish().walls, 1U) << degree;
        EXPECT_EQ(sut.wall_counts()[degree], 1U) << degree;
    }
}

// The quotient of a line and a ray is 0 : 0 there.
TEST(LayerScan, AWallThatAllButFollowsARayIsMetWhereItCrossesIt) {
    const Directions directions{every_degree_rad()};
    LayerScan sut{directions};
    for (std::size_t degree = 0; degree < 360; ++degree) {
        const double angle_rad = every_degree_rad()[degree];
        for (const double aside_rad : {1e-8, 1e-10, 1e-12}) {
            sut.add_segment(wall_along(angle_rad, aside_rad));
            const LayerTotals totals = sut.finish();
            EXPECT_EQ(totals.walls, 1U) << degree;
            EXPECT_NEAR(sut.radius()[degree], 1.5, 1e-15 / aside_rad + 1e-6) << degree << " " << aside_rad;
        }
    }
}

// So near that rounding decides on which side of the ray its ends lie: a wall that is counted still stands
// between its ends, where the quotient would be anything, or nothing.
TEST(LayerScan, AWallAlongARayIsMetBetweenItsEnds) {
    constexpr int kWallsARay = 40;
    std::mt19937_64 random{29};
    std::uniform_real_distribution<double> aside_rad{-1e-15, 1e-15};
    const std::vector<double> rays_rad = every_degree_rad();
    const Directions directions{rays_rad};
    LayerScan sut{directions};
    int met = 0;
    for (std::size_t degree = 0; degree < rays_rad.size(); ++degree) {
        for (int wall = 0; wall < kWallsARay; ++wall) {
            const double from_rad = rays_rad[degree] + aside_rad(random);
            const double to_rad = rays_rad[degree] + aside_rad(random);
            sut.add_segment(
                {std::cos(from_rad), std::sin(from_rad), 3.0 * std::cos(to_rad), 3.0 * std::sin(to_rad)});
            const LayerTotals totals = sut.finish();
            if (totals.walls == 0) continue;
            ++met;
            EXPECT_GT(sut.radius()[degree], 1.0 - 1e-12) << degree << " " << from_rad << " " << to_rad;
            EXPECT_LT(sut.radius()[degree], 3.0 + 1e-12) << degree << " " << from_rad << " " << to_rad;
            EXPECT_EQ(totals.radius_sum, sut.radius()[degree]);
        }
    }
    EXPECT_GT(met, 360);
}

}  // namespace
}  // namespace psicarve::slice
