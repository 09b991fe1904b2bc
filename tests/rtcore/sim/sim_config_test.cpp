// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/sim/sim_config.hpp"

#include <gtest/gtest.h>

#include "shared/profile/profile.hpp"

namespace psicarve::sim {
namespace {

TEST(SimConfig, PutsSensorsAndEndsWhereTheProfileSays) {
    const SimConfig sut = sim_config_from_profile(Profile{});
    EXPECT_EQ(sut.axis(Axis::r1).sensor.kind, SensorKind::high_end);
    EXPECT_EQ(sut.axis(Axis::r1).sensor.edge_pulses, 24'001) << "clear at the home position";
    EXPECT_EQ(sut.axis(Axis::r1).high_end_pulses, 24'400);
    EXPECT_EQ(sut.axis(Axis::r1).low_end_pulses, -400);
    EXPECT_EQ(sut.axis(Axis::y).sensor.kind, SensorKind::low_end);
    EXPECT_EQ(sut.axis(Axis::y).sensor.edge_pulses, -1);
    EXPECT_EQ(sut.axis(Axis::y).low_end_pulses, -400);
    EXPECT_EQ(sut.axis(Axis::y).high_end_pulses, 60'400);
    EXPECT_EQ(sut.axis(Axis::psi).sensor.kind, SensorKind::index);
    EXPECT_EQ(sut.axis(Axis::psi).sensor.edge_pulses, 0);
    EXPECT_EQ(sut.axis(Axis::psi).sensor.width_pulses, 16);
    EXPECT_FALSE(sut.axis(Axis::psi).has_ends);
}

TEST(SimConfig, StartsInsideWithTheTableAQuarterTurnBeforeItsIndex) {
    const SimConfig sut = sim_config_from_profile(Profile{});
    EXPECT_EQ(sut.axis(Axis::r1).start_pulses, 12'000);
    EXPECT_EQ(sut.axis(Axis::r2).start_pulses, 12'000);
    EXPECT_EQ(sut.axis(Axis::psi).start_pulses, -1'600);
    EXPECT_EQ(sut.axis(Axis::y).start_pulses, 2'000);
}

TEST(SimConfig, GivesMotorsAReserveAndDriversNone) {
    const SimConfig sut = sim_config_from_profile(Profile{});
    const MotorConfig& motor = sut.axis(Axis::r1).motor;
    EXPECT_DOUBLE_EQ(motor.speed_pps, 5'200.0);
    EXPECT_DOUBLE_EQ(motor.accel_pps2, 60'000.0);
    EXPECT_DOUBLE_EQ(motor.start_stop_pps, 520.0);
    EXPECT_DOUBLE_EQ(motor.slip_pulses, 16.0);
    EXPECT_EQ(sut.timing.dir_setup_ns, 5'000);
    EXPECT_EQ(sut.timing.step_low_ns, 10'000);
}

TEST(SimConfig, FollowsAProfileWithoutSensors) {
    Profile profile;
    profile.y.home = HomeSensor::none;
    profile.psi.home_position_deg = 90.0;
    const SimConfig sut = sim_config_from_profile(profile);
    EXPECT_EQ(sut.axis(Axis::y).sensor.kind, SensorKind::none);
    EXPECT_EQ(sut.axis(Axis::y).start_pulses, 30'000);
    EXPECT_EQ(sut.axis(Axis::psi).sensor.edge_pulses, 1'600);
    EXPECT_EQ(sut.axis(Axis::psi).start_pulses, 0);
}

}  // namespace
}  // namespace psicarve::sim
