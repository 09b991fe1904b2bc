// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "shared/profile/profile.hpp"

namespace psicarve {
namespace {

TEST(AxisMotion, IsTheProfileInPulses) {
    Profile profile;
    profile.r1.backlash_mm = 0.03;
    const AxisMotion r1 = axis_motion(profile, Axis::r1);
    EXPECT_EQ(r1.pulses_per_unit, 400.0);
    EXPECT_EQ(r1.speed_pps, 4000.0);
    EXPECT_EQ(r1.accel_pps2, 40000.0);
    EXPECT_EQ(r1.start_stop_pps, 400.0);
    EXPECT_EQ(r1.home_speed_pps, 2000.0);
    EXPECT_EQ(r1.travel_min_pulses, 0);
    EXPECT_EQ(r1.home_position_pulses, 24000);
    EXPECT_EQ(r1.overtravel_pulses, 400);
    EXPECT_EQ(r1.backlash_pulses, 12);
    EXPECT_EQ(r1.home, HomeSensor::max);
    EXPECT_TRUE(r1.has_travel);
    EXPECT_TRUE(r1.positive_is_high);
}

TEST(AxisMotion, OfPsiCountsDegreesAndHasNoTravel) {
    Profile profile;
    profile.psi.home_position_deg = 90.0;
    profile.psi.backlash_deg = 0.9;
    profile.psi.positive_is_high = false;
    const AxisMotion psi = axis_motion(profile, Axis::psi);
    EXPECT_DOUBLE_EQ(psi.pulses_per_unit, 6400.0 / 360.0);
    EXPECT_DOUBLE_EQ(psi.speed_pps, 4000.0);
    EXPECT_DOUBLE_EQ(psi.accel_pps2, 40000.0);
    EXPECT_DOUBLE_EQ(psi.start_stop_pps, 400.0);
    EXPECT_DOUBLE_EQ(psi.home_speed_pps, 800.0);
    EXPECT_EQ(psi.home_position_pulses, 1600);
    EXPECT_EQ(psi.backlash_pulses, 16);
    EXPECT_FALSE(psi.has_travel);
    EXPECT_FALSE(psi.positive_is_high);
}

TEST(AxisMotion, TravelEndsAtTheHomePositionWhereTheSensorIsStillClear) {
    const Profile profile;
    EXPECT_EQ(axis_motion(profile, Axis::r1).travel_max_pulses, 24000);
    EXPECT_EQ(axis_motion(profile, Axis::y).travel_min_pulses, 0);
    EXPECT_EQ(axis_motion(profile, Axis::y).travel_max_pulses, 60000);
}

TEST(AxisMotion, ASensorInsideTheTravelCutsIt) {
    Profile profile;
    profile.r1.home_position_mm = 50.0;
    profile.y.home_position_mm = 10.0;
    EXPECT_EQ(axis_motion(profile, Axis::r1).travel_max_pulses, 20000);
    EXPECT_EQ(axis_motion(profile, Axis::y).travel_min_pulses, 4000);
}

TEST(AxisMotion, ASensorBeyondTheTravelLeavesItWhole) {
    Profile profile;
    profile.r1.home_position_mm = 60.5;
    profile.y.home_position_mm = -0.5;
    EXPECT_EQ(axis_motion(profile, Axis::r1).travel_max_pulses, 24000);
    EXPECT_EQ(axis_motion(profile, Axis::y).travel_min_pulses, 0);
}

TEST(AxisMotion, WithoutASensorTheTravelIsWhole) {
    Profile profile;
    profile.r1.home = HomeSensor::none;
    EXPECT_EQ(axis_motion(profile, Axis::r1).travel_max_pulses, 24000);
}

TEST(CoreRadius, IsACountedPositionOfTheRealTip) {
    Profile profile;
    profile.r2.pulses_per_mm = 1000.0;
    profile.r2.tip_offset_mm = 0.25;
    EXPECT_EQ(core_radius_pulses(profile, Axis::r1), 600);
    EXPECT_EQ(core_radius_pulses(profile, Axis::r2), 1250);
}

TEST(TicksBetweenEdges, LeaveRoomForTheWrites) {
    EXPECT_EQ(ticks_between_edges(0, 50'000), 1);
    EXPECT_EQ(ticks_between_edges(47'500, 50'000), 1);
    EXPECT_EQ(ticks_between_edges(47'501, 50'000), 2);
    EXPECT_EQ(ticks_between_edges(50'000, 50'000), 2);
    EXPECT_EQ(ticks_between_edges(97'500, 50'000), 2);
    Profile profile;
    profile.port.step_high_ns = 120'000;
    profile.port.step_low_ns = 49'000;
    EXPECT_EQ(pulse_period_ns(profile), 5 * 50'000);
}

TEST(TickPeriod, IsWholeNanoseconds) {
    Profile profile;
    EXPECT_EQ(tick_period_ns(profile), 50'000);
    profile.tick.period_us = 33.3333;
    EXPECT_EQ(tick_period_ns(profile), 33'333);
}

}  // namespace
}  // namespace psicarve
