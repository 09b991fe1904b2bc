// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/sim/machine.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "tests/rtcore/sim/sim_rig.hpp"

namespace psicarve::sim {
namespace {

SimConfig config_with_start(Axis axis, std::int64_t start_pulses) {
    SimConfig config = sim_config_from_profile(Profile{});
    config.axis(axis).start_pulses = start_pulses;
    return config;
}

TEST(Machine, HasAllDrivesOffAtFirst) {
    SimRig sut;
    sut.aim(Axis::r1, true);
    sut.pulses(Axis::r1, 5);
    EXPECT_EQ(sut.report(Axis::r1).pulses_ignored, 5U);
    EXPECT_EQ(sut.position(Axis::r1), 12'000);
}

TEST(Machine, IsClearAtItsHomePositionsAndTrippedFromTheNextPulseOn) {
    const Profile profile;
    SimRig high(profile, config_with_start(Axis::r2, 23'999));
    high.enable_all();
    high.aim(Axis::r2, true);
    high.pulse(Axis::r2);
    EXPECT_FALSE(high.shows(Signal::r2_limit));
    high.pulse(Axis::r2);
    EXPECT_TRUE(high.shows(Signal::r2_limit));
    high.pulses(Axis::r2, 500);
    EXPECT_TRUE(high.shows(Signal::r2_limit));
    EXPECT_EQ(high.position(Axis::r2), 24'400) << "the mechanical end";
    EXPECT_EQ(high.report(Axis::r2).crashes, 1U);
    high.aim(Axis::r2, false);
    high.pulses(Axis::r2, 399);
    EXPECT_TRUE(high.shows(Signal::r2_limit));
    high.pulse(Axis::r2);
    EXPECT_FALSE(high.shows(Signal::r2_limit));

    SimRig low(profile, config_with_start(Axis::y, 0));
    low.enable_all();
    low.aim(Axis::y, false);
    EXPECT_FALSE(low.shows(Signal::y_limit));
    low.pulse(Axis::y);
    EXPECT_TRUE(low.shows(Signal::y_limit));
}

TEST(Machine, ShowsTheIndexAtTheSamePlaceEveryTurnBothWays) {
    SimRig sut;
    sut.enable_all();
    constexpr std::int64_t kTurn = 6'400;
    constexpr std::int64_t kWidth = 16;
    for (const bool positive : {true, false}) {
        sut.aim(Axis::psi, positive);
        for (int i = 0; i < 3 * kTurn; ++i) {
            sut.pulse(Axis::psi);
            const std::int64_t position = sut.position(Axis::psi);
            const std::int64_t in_turn = ((position % kTurn) + kTurn) % kTurn;
            ASSERT_EQ(sut.shows(Signal::psi_index), in_turn < kWidth) << position;
        }
    }
    EXPECT_EQ(sut.position(Axis::psi), -1'600);
    EXPECT_EQ(sut.report(Axis::psi).sensor_changes, 12U);
}

TEST(Machine, MeetsTheIndexFirstAtCountZeroTurningPositive) {
    SimRig sut;
    sut.enable_all();
    sut.aim(Axis::psi, true);
    while (!sut.shows(Signal::psi_index)) sut.pulse(Axis::psi);
    EXPECT_EQ(sut.position(Axis::psi), 0);
}

TEST(Machine, TimesTheSpindle) {
    SimRig sut;
    sut.set(Signal::spindle, true);
    sut.wait_ns(1'500'000'000);
    sut.set(Signal::spindle, false);
    sut.wait_ns(7);
    sut.set(Signal::spindle, true);
    sut.wait_ns(500);
    sut.set(Signal::spindle, false);
    EXPECT_EQ(sut.machine().report().spindle_on_ns, 1'500'000'500);
    EXPECT_EQ(sut.machine().report().spindle_starts, 2U);
}

TEST(Machine, FindsAMotorThatRanPastWithoutAnyFurtherPulse) {
    SimRig sut;
    sut.enable_all();
    sut.aim(Axis::psi, true);
    std::int64_t period_ns = 2'500'000;
    while (period_ns > 250'000) {
        sut.pulse(Axis::psi, period_ns);
        period_ns -= period_ns / 100;
    }
    const std::int64_t counted = sut.position(Axis::psi);
    sut.wait_ns(1'000'000'000);
    sut.inputs();
    EXPECT_EQ(sut.report(Axis::psi).stalls, 1U);
    EXPECT_GT(sut.position(Axis::psi), counted + 16);
}

TEST(Machine, CoastsWhenItsDriveIsSwitchedOffAtSpeed) {
    SimRig sut;
    sut.enable_all();
    sut.aim(Axis::psi, true);
    for (std::int64_t period_ns = 2'500'000; period_ns > 250'000; period_ns -= period_ns / 100) {
        sut.pulse(Axis::psi, period_ns);
    }
    const std::int64_t counted = sut.position(Axis::psi);
    sut.set(Signal::psi_enable, false);
    sut.set(Signal::r1_enable, false);
    EXPECT_GT(sut.position(Axis::psi), counted + 16);
}

/// Random pins at random times, seeded; what the machine shows in between.
std::vector<std::int64_t> random_life(std::uint32_t seed) {
    std::mt19937 random(seed);
    SimRig rig;
    rig.enable_all();
    std::vector<std::int64_t> seen;
    for (int i = 0; i < 20'000; ++i) {
        const auto signal = static_cast<Signal>(random() % kFirstInput);
        const bool level =
            is_output(signal) && index_of(signal) >= 8 ? random() % 50 != 0 : random() % 2 != 0;
        rig.set(signal, level);
        rig.wait_ns(static_cast<std::int64_t>(random() % 400'000));
        seen.push_back(rig.inputs());
    }
    for (const Axis axis : kAllAxes) {
        const AxisReport report = rig.report(axis);
        seen.insert(seen.end(), {report.position_pulses, static_cast<std::int64_t>(report.pulses_taken),
                                 static_cast<std::int64_t>(report.timing_lost()),
                                 static_cast<std::int64_t>(report.stalls)});
    }
    return seen;
}

TEST(Machine, LivesTheSameLifeTwice) {
    EXPECT_EQ(random_life(3), random_life(3));
    EXPECT_NE(random_life(3), random_life(4));
}

TEST(Machine, AccountsForEveryStepEdge) {
    std::mt19937 random(11);
    SimRig sut;
    sut.enable_all();
    std::uint64_t edges = 0;
    for (int i = 0; i < 50'000; ++i) {
        sut.set(Signal::r1_enable, random() % 20 != 0);
        sut.set(Signal::psi_enable, random() % 20 != 0);
        sut.set(Signal::r1_dir, random() % 10 < 6);
        sut.wait_ns(static_cast<std::int64_t>(random() % 20'000));
        sut.set(Signal::r1_step, true);
        ++edges;
        sut.wait_ns(static_cast<std::int64_t>(random() % 20'000));
        sut.set(Signal::r1_dir, random() % 10 < 6);
        sut.wait_ns(static_cast<std::int64_t>(random() % 20'000));
        sut.set(Signal::r1_step, false);
        sut.wait_ns(static_cast<std::int64_t>(random() % 300'000));
    }
    const AxisReport report = sut.report(Axis::r1);
    EXPECT_EQ(report.pulses_taken + report.pulses_ignored + report.timing_lost() +
                  report.pulses_lost_stalled + report.pulses_lost_at_stop,
              edges);
    EXPECT_GT(report.lost_dir_setup, 0U);
    EXPECT_GT(report.lost_dir_hold, 0U);
    EXPECT_GT(report.lost_step_high, 0U);
    EXPECT_GT(report.lost_step_low, 0U);
}

}  // namespace
}  // namespace psicarve::sim
