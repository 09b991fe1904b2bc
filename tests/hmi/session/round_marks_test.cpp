// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/round_marks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace psicarve::session {
namespace {

using Marks = std::vector<double>;

TEST(RoundMarks, StandAtRoundNumbersWithinTheRange) {
    EXPECT_EQ(round_marks(0.0, 120.0, 7).values, (Marks{0.0, 20.0, 40.0, 60.0, 80.0, 100.0, 120.0}));
    EXPECT_EQ(round_marks(3.7, 118.9, 7).values, (Marks{20.0, 40.0, 60.0, 80.0, 100.0}));
    EXPECT_EQ(round_marks(-12.0, 7.0, 5).values, (Marks{-10.0, -5.0, 0.0, 5.0}));
    EXPECT_EQ(round_marks(0.0, 120.0, 7).decimals, 0);
}

TEST(RoundMarks, AreExactWithTheirDecimals) {
    const RoundMarks sut = round_marks(0.0, 0.9, 6);
    ASSERT_EQ(sut.values.size(), 5U);
    EXPECT_EQ(sut.decimals, 1);
    EXPECT_NEAR(sut.values.back(), 0.8, 1e-12);
    EXPECT_EQ(round_marks(10.02, 10.09, 4).decimals, 2);
}

TEST(RoundMarks, AreNeverMoreThanThereIsRoomForAndNeverOutside) {
    for (int most = 1; most <= 12; ++most) {
        for (double extent = 0.003; extent < 5000.0; extent *= 1.37) {
            const RoundMarks sut = round_marks(17.3, 17.3 + extent, most);
            ASSERT_LE(sut.values.size(), static_cast<std::size_t>(most)) << extent;
            const double unit = std::pow(10.0, sut.decimals);
            for (const double value : sut.values) {
                EXPECT_GE(value, 17.3 - 1e-6);
                EXPECT_LE(value, 17.3 + extent + 1e-6);
                EXPECT_NEAR(value * unit, std::round(value * unit), 1e-6) << value;
            }
            EXPECT_TRUE(most < 3 || !sut.values.empty()) << extent << ", " << most;
        }
    }
}

TEST(RoundMarks, OfARangeWithoutExtentAreItsOwnValueOrNone) {
    EXPECT_LE(round_marks(5.0, 5.0, 6).values.size(), 6U);
    EXPECT_TRUE(round_marks(6.0, 5.0, 6).values.empty());
    EXPECT_TRUE(round_marks(0.0, std::numeric_limits<double>::infinity(), 6).values.empty());
}

}  // namespace
}  // namespace psicarve::session
