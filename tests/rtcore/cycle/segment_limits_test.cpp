// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/segment_limits.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace psicarve::cycle {
namespace {

constexpr double kSegmentTick_s = 0.1;

/// Profiles from 4 to 8 and from 16 to 16, all 1/s^2, along a segment of 2.
PathTiming limits_timing() {
    PathTiming timing{};
    timing.length = 2.0;
    timing.start_speed2 = {4.0, 16.0};
    timing.end_speed2 = {8.0, 16.0};
    timing.accel_free.fill(1e30F);
    timing.start_stop_speed = 0.5F;
    return timing;
}

SegmentLimits limits_of(const PathTiming& timing) {
    SegmentLimits sut(kSegmentTick_s);
    sut.enter(timing);
    return sut;
}

TEST(SegmentLimits, ShowBothProfilesAndTheirSlopesPerTick) {
    const SegmentLimits sut = limits_of(limits_timing());
    const SegmentLimits::Profiles middle = sut.profiles_at(1.0);
    EXPECT_NEAR(middle.low, 0.06, 1e-12);
    EXPECT_NEAR(middle.high, 0.16, 1e-12);
    EXPECT_NEAR(middle.low_slope, 0.02, 1e-12);
    EXPECT_NEAR(middle.high_slope, 0.0, 1e-12);
    EXPECT_NEAR(sut.profiles_at(2.0).low, 0.08, 1e-12);
    EXPECT_NEAR(sut.start_stop_speed(), 0.05, 1e-9);
}

// Rounding at a segment's end may leave a profile a hair below 0, or the second below the first.
TEST(SegmentLimits, LetNoProfileFallBelowNothingNorTheSecondBelowTheFirst) {
    PathTiming timing = limits_timing();
    timing.end_speed2 = {0.0, 0.0};
    const SegmentLimits::Profiles beyond = limits_of(timing).profiles_at(2.5);
    EXPECT_EQ(beyond.low, 0.0);
    EXPECT_EQ(beyond.high, 0.0);
    timing = limits_timing();
    timing.start_speed2[1] = 1.0;
    const SegmentLimits::Profiles crossed = limits_of(timing).profiles_at(0.0);
    EXPECT_EQ(crossed.high, crossed.low);
}

TEST(SegmentLimits, AllowWhatTheProfilesDoWhereTheAxesHaveNothingLeft) {
    PathTiming timing = limits_timing();
    timing.accel_free.fill(0.0F);
    const SegmentLimits sut = limits_of(timing);
    const SegmentLimits::Profiles at = sut.profiles_at(0.0);
    const double on_low = std::sqrt(at.low);
    EXPECT_NEAR(sut.rising_accel(at, on_low), 0.5 * at.low_slope, 1e-12) << "along the first profile";
    EXPECT_NEAR(sut.falling_accel(at, on_low), 0.0, 1e-12) << "along the second, scaled down";
    const double half = std::sqrt(0.5 * at.low);
    EXPECT_NEAR(sut.rising_accel(at, half), 0.25 * at.low_slope, 1e-12) << "along half of the first";
    const double mixed = std::sqrt(0.5 * (at.low + at.high));
    EXPECT_NEAR(sut.rising_accel(at, mixed), 0.25 * at.low_slope, 1e-12) << "along their mean";
}

TEST(SegmentLimits, AllowMostOfWhatTheSlowestAxisHasLeft) {
    PathTiming timing = limits_timing();
    timing.accel_free = {50.0F, 3.0F, 50.0F, 50.0F};
    const SegmentLimits sut = limits_of(timing);
    const SegmentLimits::Profiles at = sut.profiles_at(0.0);
    constexpr double kSpare = 0.97 * 3.0 * 0.01;
    EXPECT_NEAR(sut.rising_accel(at, 0.1), kSpare, 1e-9);
    EXPECT_NEAR(sut.falling_accel(at, 0.1), -kSpare, 1e-9);
}

TEST(SegmentLimits, AllowLessWhereTheCurveBendsAndLeaveRoomForTheTicksEnd) {
    PathTiming timing = limits_timing();
    timing.accel_free.fill(3.0F);
    timing.accel_bend.fill(0.5F);
    const SegmentLimits sut = limits_of(timing);
    const SegmentLimits::Profiles at = sut.profiles_at(0.0);
    constexpr double kSpeed = 0.1;
    const double now = 0.97 * (0.03 - 0.5 * kSpeed * kSpeed);
    const double then = 0.97 * (0.03 - 0.5 * (kSpeed + now) * (kSpeed + now));
    EXPECT_NEAR(sut.falling_accel(at, kSpeed), -now, 1e-9);
    EXPECT_NEAR(sut.rising_accel(at, kSpeed), then, 1e-9);
    EXPECT_LT(then, now);
}

}  // namespace
}  // namespace psicarve::cycle
