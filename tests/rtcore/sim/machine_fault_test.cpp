// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/rtcore/sim/sim_rig.hpp"

namespace psicarve::sim {
namespace {

/// The default machine with the emergency stop on pin 15.
Profile profile_with_estop() {
    Profile profile;
    profile.port.pins[index_of(Signal::estop)] = 15;
    return profile;
}

TEST(MachineFault, EmergencyStopIsPressedAtATime) {
    const Profile profile = profile_with_estop();
    SimConfig config = sim_config_from_profile(profile);
    config.input_faults.push_back(
        {.signal = Signal::estop, .start_ns = 1'000'000, .trigger_axis = {}, .duration_ns = 500});
    SimRig sut(profile, config);
    sut.wait_until_ns(999'999);
    EXPECT_FALSE(sut.shows(Signal::estop));
    sut.wait_ns(1);
    EXPECT_TRUE(sut.shows(Signal::estop));
    sut.wait_ns(499);
    EXPECT_TRUE(sut.shows(Signal::estop));
    sut.wait_ns(1);
    EXPECT_FALSE(sut.shows(Signal::estop));
}

TEST(MachineFault, EmergencyStopIsPressedAtAPosition) {
    const Profile profile = profile_with_estop();
    SimConfig config = sim_config_from_profile(profile);
    config.input_faults.push_back(
        {.signal = Signal::estop, .start_ns = 0, .trigger_axis = Axis::psi, .trigger_pulses = -1'590});
    SimRig sut(profile, config);
    sut.enable_all();
    sut.aim(Axis::psi, true);
    sut.pulses(Axis::psi, 9);
    EXPECT_FALSE(sut.shows(Signal::estop));
    sut.pulse(Axis::psi);
    EXPECT_TRUE(sut.shows(Signal::estop));
    sut.wait_ns(3'600'000'000'000);
    EXPECT_TRUE(sut.shows(Signal::estop));
}

TEST(MachineFault, ChatteringLimitShowsBothLevelsInTurn) {
    SimConfig config = sim_config_from_profile(Profile{});
    config.input_faults.push_back({.signal = Signal::r1_limit,
                                   .start_ns = 1'000,
                                   .trigger_axis = {},
                                   .duration_ns = 4'000,
                                   .half_period_ns = 1'000});
    SimRig sut(Profile{}, config);
    for (const bool expected : {false, true, false, true, false, false, false}) {
        EXPECT_EQ(sut.shows(Signal::r1_limit), expected) << sut.now_ns();
        sut.wait_ns(1'000);
    }
}

TEST(MachineFault, ContactBouncesAfterEachChange) {
    SimConfig config = sim_config_from_profile(Profile{});
    config.axis(Axis::y).start_pulses = 0;
    config.axis(Axis::y).sensor.bounce_ns = 300'000;
    config.axis(Axis::y).sensor.bounce_half_period_ns = 100'000;
    SimRig sut(Profile{}, config);
    sut.enable_all();
    sut.aim(Axis::y, false);
    sut.set(Signal::y_step, true);
    const std::int64_t tripped_ns = sut.now_ns();
    EXPECT_TRUE(sut.shows(Signal::y_limit));
    sut.wait_until_ns(tripped_ns + 100'000);
    EXPECT_FALSE(sut.shows(Signal::y_limit));
    sut.wait_until_ns(tripped_ns + 200'000);
    EXPECT_TRUE(sut.shows(Signal::y_limit));
    sut.wait_until_ns(tripped_ns + 300'000);
    EXPECT_TRUE(sut.shows(Signal::y_limit));
}

TEST(MachineFault, SensorCanBeStuckEitherWay) {
    SimConfig config = sim_config_from_profile(Profile{});
    config.axis(Axis::r1).start_pulses = 24'001;
    config.axis(Axis::r1).sensor.fault = SensorFault::never_trips;
    SimRig sut(Profile{}, config);
    EXPECT_FALSE(sut.shows(Signal::r1_limit));
    sut.machine().set_sensor_fault(Axis::r1, SensorFault::none);
    EXPECT_TRUE(sut.shows(Signal::r1_limit));
    EXPECT_FALSE(sut.shows(Signal::y_limit));
    sut.machine().set_sensor_fault(Axis::y, SensorFault::always_trips);
    EXPECT_TRUE(sut.shows(Signal::y_limit));
}

TEST(MachineFault, HeldInputHidesTheTruthUntilReleased) {
    const Profile profile = profile_with_estop();
    SimRig sut(profile);
    sut.machine().hold_input(Signal::estop, true);
    EXPECT_TRUE(sut.shows(Signal::estop));
    sut.machine().release_input(Signal::estop);
    EXPECT_FALSE(sut.shows(Signal::estop));
}

TEST(MachineFault, SlipMovesTheAxisAgainstItsCount) {
    for (const std::int64_t slip : {-1, +3}) {
        SimConfig config = sim_config_from_profile(Profile{});
        config.slip_faults.push_back({.axis = Axis::psi, .after_pulses = 5, .slip_pulses = slip});
        SimRig sut(Profile{}, config);
        sut.enable_all();
        sut.aim(Axis::psi, true);
        sut.pulses(Axis::psi, 4);
        EXPECT_EQ(sut.position(Axis::psi), -1'596);
        sut.pulses(Axis::psi, 6);
        EXPECT_EQ(sut.position(Axis::psi), -1'590 + slip);
        EXPECT_EQ(sut.report(Axis::psi).pulses_taken, 10U);
    }
}

TEST(MachineFault, ShiftedIndexComesAsManyPulsesLater) {
    SimConfig config = sim_config_from_profile(Profile{});
    config.axis(Axis::psi).sensor.edge_pulses += 7;
    SimRig sut(Profile{}, config);
    sut.enable_all();
    sut.aim(Axis::psi, true);
    while (!sut.shows(Signal::psi_index)) sut.pulse(Axis::psi);
    EXPECT_EQ(sut.position(Axis::psi), 7);
}

TEST(MachineFault, BacklashDelaysTheSensorOnTheWayBack) {
    Profile profile;
    profile.r1.backlash_mm = 0.01;  // 4 pulses
    SimConfig config = sim_config_from_profile(profile);
    config.axis(Axis::r1).start_pulses = 24'000;
    SimRig sut(profile, config);
    sut.enable_all();
    sut.aim(Axis::r1, true);
    sut.pulse(Axis::r1);
    EXPECT_TRUE(sut.shows(Signal::r1_limit));
    sut.aim(Axis::r1, false);
    sut.pulses(Axis::r1, 4);
    EXPECT_TRUE(sut.shows(Signal::r1_limit));
    sut.pulse(Axis::r1);
    EXPECT_FALSE(sut.shows(Signal::r1_limit));
}

}  // namespace
}  // namespace psicarve::sim
