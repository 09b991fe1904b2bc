// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/slice/layer_scan.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
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
