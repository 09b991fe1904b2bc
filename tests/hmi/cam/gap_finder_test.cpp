// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cam/gap_finder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "hmi/slice/directions.hpp"
#include "shared/base/units.hpp"

namespace psicarve::cam {
namespace {

// Against the angle itself, also a hair beside the directions.
TEST(GapFinder, AgreesWithTheAngle) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> turn(0.0, 2.0 * kPi);
    std::uniform_real_distribution<double> far(0.001, 300.0);
    for (const int points : {13, 180, 1000}) {
        const std::vector<double> round_rad = slice::full_circle_rad(points, 72'000, 0.0);
        const GapFinder sut(round_rad);
        int unsure = 0;
        for (int i = 0; i < 40'000; ++i) {
            double angle = turn(random);
            if (i % 4 == 0)
                angle = round_rad[static_cast<std::size_t>(i) % round_rad.size()] + 1e-9 * (i % 3);
            const double radius = far(random);
            const double x = radius * std::cos(angle);
            const double y = radius * std::sin(angle);
            const std::size_t gap = sut.gap_at(x, y);
            if (gap == GapFinder::kUnsure) {
                ++unsure;
                continue;
            }
            const double end = gap + 1 < round_rad.size() ? round_rad[gap + 1] : 2.0 * kPi;
            ASSERT_LE(round_rad[gap], angle + 1e-14);
            ASSERT_GE(end, angle - 1e-14);
            const double along = (angle - round_rad[gap]) / (end - round_rad[gap]);
            const auto [least, most] = sut.along(gap, x, y);
            ASSERT_LE(least, along);
            ASSERT_GE(most, along);
            ASSERT_LT(most - least, points > 100 ? 1e-3 : 0.03);
        }
        EXPECT_LT(unsure, 5000) << points;  // of 10 000 on a direction every third
    }
}

TEST(GapFinder, IsUnsureOnADirectionAtTheAxisAndOfWideGaps) {
    const GapFinder sut(slice::full_circle_rad(180, 72'000, 0.0));
    EXPECT_EQ(sut.gap_at(3.0, 0.0), GapFinder::kUnsure);
    EXPECT_EQ(sut.gap_at(0.0, 0.0), GapFinder::kUnsure);
    EXPECT_EQ(sut.gap_at(3.0, -1e-15), GapFinder::kUnsure);
    EXPECT_NE(sut.gap_at(3.0, 0.01), GapFinder::kUnsure);
    EXPECT_EQ(GapFinder(slice::full_circle_rad(3, 72'000, 0.0)).gap_at(3.0, 1.0), GapFinder::kUnsure);
}

}  // namespace
}  // namespace psicarve::cam
