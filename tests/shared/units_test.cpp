// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/base/units.hpp"

#include <gtest/gtest.h>

namespace psicarve {
namespace {

TEST(RoundToPulse, TakesTheNearestAndHalvesAwayFromZero) {
    EXPECT_EQ(round_to_pulse(0.0), 0);
    EXPECT_EQ(round_to_pulse(0.5), 1);
    EXPECT_EQ(round_to_pulse(-0.5), -1);
    EXPECT_EQ(round_to_pulse(1.5), 2);
    EXPECT_EQ(round_to_pulse(2.5), 3);
    EXPECT_EQ(round_to_pulse(-2.49), -2);
    EXPECT_EQ(round_to_pulse(-2.51), -3);
}

TEST(RoundToPulse, IsExactWhereASumWouldRound) {
    EXPECT_EQ(round_to_pulse(0.49999999999999994), 0);
    EXPECT_EQ(round_to_pulse(-0.49999999999999994), 0);
    EXPECT_EQ(round_to_pulse(4503599627370497.0), 4503599627370497);  // 2^52 + 1
    EXPECT_EQ(round_to_pulse(9007199254740991.0), 9007199254740991);
    EXPECT_EQ(round_to_pulse(-9007199254740991.0), -9007199254740991);
}

TEST(Units, GoThereAndBack) {
    EXPECT_EQ(pulses_from_mm(60.0, 400.0), 24000);
    EXPECT_EQ(mm_from_pulses(24000, 400.0), 60.0);
    EXPECT_EQ(pulses_from_deg(-90.0, 6400), -1600);
    EXPECT_EQ(deg_from_pulses(1600, 6400), 90.0);
    EXPECT_DOUBLE_EQ(rad_from_deg(180.0), kPi);
    EXPECT_DOUBLE_EQ(deg_from_rad(kPi), 180.0);
    EXPECT_DOUBLE_EQ(rad_from_pulses(3200, 6400), kPi);
    EXPECT_EQ(seconds_from_ns(1'500'000'000), 1.5);
}

TEST(TicksCovering, RoundsUpAndNeedsNoneForNothing) {
    EXPECT_EQ(ticks_covering_ns(0, 50'000), 0);
    EXPECT_EQ(ticks_covering_ns(1, 50'000), 1);
    EXPECT_EQ(ticks_covering_ns(50'000, 50'000), 1);
    EXPECT_EQ(ticks_covering_ns(50'001, 50'000), 2);
}

TEST(PointAngle, IsTheRoundedShareOfTheSweep) {
    EXPECT_EQ(point_angle_pulses(0, 3200, 500), 0);
    EXPECT_EQ(point_angle_pulses(499, 3200, 500), 3200);
    EXPECT_EQ(point_angle_pulses(1, 3200, 500), 6);       // 6.41
    EXPECT_EQ(point_angle_pulses(250, 3200, 500), 1603);  // 1603.2
    EXPECT_EQ(point_angle_pulses(1, 5, 3), 3);            // 2.5
    EXPECT_EQ(point_angle_pulses(999'998, 50'000'000, 1'000'000), 49'999'950);
}

TEST(PointAngle, NeverStandsStillWhileThereAreMorePulsesThanSteps) {
    for (std::int64_t points = 2; points <= 3201; points += 13) {
        for (std::int64_t j = 1; j < points; ++j) {
            ASSERT_GT(point_angle_pulses(j, 3200, points), point_angle_pulses(j - 1, 3200, points)) << points;
        }
    }
}

}  // namespace
}  // namespace psicarve
