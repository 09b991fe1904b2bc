// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/rtcore/cycle/machine_rig.hpp"

namespace psicarve::cycle {
namespace {

/// The pulses' ticks of one axis up to `last_tick`.
std::vector<std::uint64_t> pulse_ticks(const MachineRig& rig, Axis axis, std::uint64_t last_tick) {
    std::vector<std::uint64_t> ticks;
    SignalWord before = 0;
    for (const PortWrite& write : rig.port->writes) {
        if (write.tick > last_tick) break;
        if ((write.levels & ~before & bit_of(step_of(axis))) != 0) ticks.push_back(write.tick);
        before = write.levels;
    }
    return ticks;
}

std::uint64_t latch_tick(const MachineRig& rig, Axis axis) {
    std::uint64_t tick = 0;
    for (const FlightRecord& record : rig.records_of(RecordKind::home_latch)) {
        if (record.axis == index_of(axis)) tick = record.tick;
    }
    return tick;
}

TEST(HomingSpeed, TheSearchIsAtHomeSpeedAndTheEdgeIsTakenAtStartStopSpeed) {
    const Profile profile = quick_profile();
    MachineRig sut(profile);
    ASSERT_TRUE(sut.home());
    for (const Axis axis : kAllAxes) {
        const AxisMotion motion = axis_motion(profile, axis);
        const auto ticks_at = [&](double speed_pps) { return 1e9 / 50'000.0 / speed_pps; };
        const auto ticks = pulse_ticks(sut, axis, latch_tick(sut, axis));
        ASSERT_GT(ticks.size(), 100U) << name_of(axis);
        std::uint64_t least_gap = ~std::uint64_t{0};
        for (std::size_t i = 1; i < ticks.size(); ++i)
            least_gap = std::min(least_gap, ticks[i] - ticks[i - 1]);
        EXPECT_NEAR(static_cast<double>(least_gap), ticks_at(motion.home_speed_pps), 1.01) << name_of(axis);
        const std::size_t last = ticks.size() - 1;
        EXPECT_GE(static_cast<double>(ticks[last] - ticks[last - 3]),
                  3.0 * ticks_at(motion.start_stop_pps) - 3.0)
            << name_of(axis);
    }
}

TEST(HomingSpeed, PsiRestsOnItsIndex) {
    std::mt19937_64 random{19};
    for (int round = 0; round < 10; ++round) {
        Profile profile = quick_profile();
        profile.psi.home_position_deg = static_cast<double>(random() % 300) - 150.0;
        profile.psi.home_speed_deg_s = static_cast<double>(5 + random() % 220);
        MachineRig sut(profile, [&](sim::SimConfig& config) {
            config.axis(Axis::psi).start_pulses = static_cast<std::int64_t>(random() % 6400) - 3200;
            config.axis(Axis::psi).sensor.width_pulses = 1 + static_cast<std::int64_t>(random() % 60);
        });
        ASSERT_TRUE(sut.home()) << round;
        const std::int64_t home = axis_motion(profile, Axis::psi).home_position_pulses;
        EXPECT_EQ(sut.positions()[2], home) << round;
        EXPECT_EQ((sut.machine->position_pulses(Axis::psi) - home) % 6400, 0) << round;
    }
}

// The mechanics allow less than the ramp at home speed needs: the search is slower then.
TEST(HomingSpeed, NeverRunsIntoAnEndThatIsNear) {
    Profile profile = quick_profile();
    profile.r1.overtravel_mm = 0.05;
    MachineRig sut(profile);
    ASSERT_TRUE(sut.home());
    EXPECT_EQ(sut.machine->report().axis(Axis::r1).crashes, 0U);
    EXPECT_EQ(sut.machine->position_pulses(Axis::r1), sut.positions()[0]);
}

TEST(HomingSpeed, IsExactOnAMachineOfManyPulsesAndAShortTick) {
    Profile profile = quick_profile();
    profile.tick.period_us = 10.0;
    for (LinearAxisProfile* axis : {&profile.r1, &profile.r2, &profile.y}) {
        axis->pulses_per_mm = 4000.0;
        axis->travel_mm = {0.0, 5.0};
    }
    profile.r1.home_position_mm = profile.r2.home_position_mm = 5.0;
    profile.psi.pulses_per_rev = 128'000;
    profile.psi.speed_deg_s = 100.0;
    MachineRig sut(profile);
    ASSERT_TRUE(sut.home());
    for (const Axis axis : kAllAxes) {
        EXPECT_EQ((sut.machine->position_pulses(axis) - sut.positions()[index_of(axis)]) % 128'000, 0)
            << name_of(axis);
        EXPECT_EQ(sut.machine->report().axis(axis).stalls, 0U);
    }
}

}  // namespace
}  // namespace psicarve::cycle
