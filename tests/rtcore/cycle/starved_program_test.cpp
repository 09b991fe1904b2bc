// SPDX-License-Identifier: GPL-3.0-or-later
// Programs whose writer is late, in the midst of motion: they slow down, rest on the path and go on.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "rtcore/plan/record_program.hpp"
#include "tests/motion/random_operator.hpp"
#include "tests/rtcore/cycle/program_rig.hpp"
#include "tests/thoroughness.hpp"

namespace psicarve::cycle {
namespace {

using plan::RecordProgram;
using plan::test::dense_program;
using plan::test::Script;

constexpr std::size_t kTwoParts = 2 * RecordProgram::kPartPoints + RecordProgram::kTailPoints;
constexpr unsigned kSpatial = 0b1101;

Script waves(const ProgramRig& rig, std::uint64_t seed = 1, int ways = 2500) {
    return dense_program(seed, ways, kSpatial, 6.0, rig.positions());
}

void expect_no_stall(const ProgramRig& rig) {
    const sim::SimReport report = rig.machine->report();
    for (const Axis axis : kAllAxes) EXPECT_EQ(report.axis(axis).stalls, 0U) << name_of(axis);
}

TEST(StarvedProgram, RestsOnItsPathAndGoesOnWithTheSamePulses) {
    std::vector<std::uint32_t> plain;
    for (const bool is_late : {false, true}) {
        ProgramRig sut;
        const Script script = waves(sut);
        const auto source = sut.give(script.steps);
        if (is_late) source->written = kTwoParts + 1;
        ASSERT_EQ(sut.start(), Refusal::none);
        if (is_late) {
            ASSERT_TRUE(sut.run_until(MachineState::held));
            EXPECT_EQ(sut.program().hold, ProgramHold::starved);
            EXPECT_EQ(sut.program().starvations, 1U);
            // The end of the only group that is settled.
            EXPECT_EQ(sut.program().line, RecordProgram::kPartPoints);
            // On the curve, which passes the point within the tolerance.
            const plan::Pulses4 point = script.steps[RecordProgram::kPartPoints - 1].target_pulses;
            for (std::size_t k = 0; k < kAxisCount; ++k)
                EXPECT_NEAR(static_cast<double>(sut.positions()[k]), static_cast<double>(point[k]), 8.0);
            sut.run(3 * kPatienceTicks);
            EXPECT_EQ(sut.program().starvations, 1U);
            source->written = script.steps.size();
        }
        ASSERT_TRUE(sut.run_until(MachineState::ready));
        EXPECT_EQ(sut.program().starvations, is_late ? 1U : 0U);
        EXPECT_EQ(sut.positions(), script.at());
        expect_no_stall(sut);
        const auto order = order_of(sut.port->writes);
        if (!is_late) plain = order;
        EXPECT_EQ(order, plain);
    }
}

// Records that come while it slows down: it never rests.
TEST(StarvedProgram, SpeedsUpAgainIfRecordsComeBeforeItRests) {
    ProgramRig sut;
    const Script script = waves(sut);
    const auto source = sut.give(script.steps);
    source->written = kTwoParts + 1;
    ASSERT_EQ(sut.start(), Refusal::none);
    ASSERT_TRUE(sut.run_while([&] { return !sut.cycle->awaits_blocks(); }));
    sut.run(60);
    ASSERT_NE(sut.positions(), script.steps[RecordProgram::kPartPoints - 1].target_pulses);
    source->written = script.steps.size();
    std::uint64_t still = 0;
    std::uint64_t longest_still = 0;
    Positions before = sut.positions();
    ASSERT_TRUE(sut.run_while([&] {
        still = sut.positions() == before ? still + 1 : 0;
        before = sut.positions();
        longest_still = std::max(longest_still, still);
        return sut.program().line < script.steps.size() - 10;
    }));
    EXPECT_LT(longest_still, 200U);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(sut.program().starvations, 0U);
    expect_no_stall(sut);
}

TEST(StarvedProgram, HoldsAndStopsWhileItSlowsDown) {
    for (const std::uint64_t after : {0U, 1U, 40U, 100U, 200U}) {
        for (const bool stops : {false, true}) {
            ProgramRig sut;
            const Script script = waves(sut);
            const auto source = sut.give(script.steps);
            source->written = kTwoParts + 1;
            ASSERT_EQ(sut.start(), Refusal::none);
            ASSERT_TRUE(sut.run_while([&] { return !sut.cycle->awaits_blocks(); }));
            sut.run(after);
            if (stops) {
                sut.stop();
            } else {
                ASSERT_EQ(sut.ask(RequestKind::hold), Refusal::none);
                ASSERT_TRUE(sut.run_until(MachineState::held));
                EXPECT_NE(sut.program().hold, ProgramHold::starved);
                source->written = script.steps.size();
                sut.run(2 * kPatienceTicks);
                EXPECT_EQ(sut.cycle->state(), MachineState::held);
                ASSERT_EQ(sut.ask(RequestKind::resume), Refusal::none);
            }
            ASSERT_TRUE(sut.run_until(MachineState::ready));
            if (!stops) {
                EXPECT_EQ(sut.positions(), script.at());
            }
            expect_no_stall(sut);
        }
    }
}

TEST(StarvedProgram, ThatLostItsWriterRestsAtTheLastOfItsPoints) {
    ProgramRig sut;
    Script script = waves(sut);
    script.steps.resize(1800);
    sut.give(script.steps, plan::Supply::lost);
    ASSERT_EQ(sut.start(), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::held));
    EXPECT_EQ(sut.program().hold, ProgramHold::feeder_lost);
    EXPECT_EQ(sut.positions(), script.steps.back().target_pulses);
    expect_no_stall(sut);
}

/// A writer that pauses, an operator who holds, resumes and overrides.
void expect_end_however_disturbed(const Profile& profile, std::uint64_t seed) {
    std::vector<std::uint32_t> plain;
    for (const bool is_disturbed : {false, true}) {
        ProgramRig sut{profile};
        const Script script = waves(sut, seed, 2200);
        const auto source = sut.give(script.steps);
        if (is_disturbed) source->written = 0;
        ASSERT_EQ(sut.start(), Refusal::none);
        motion::Operator hand{seed, 20'000};
        std::mt19937_64 random{seed};
        std::uint64_t next_tick = 0;
        ASSERT_TRUE(sut.run_while([&] {
            if (is_disturbed) hand(sut);
            if (sut.cycle->next_tick() >= next_tick) {
                next_tick = sut.cycle->next_tick() + 1 + random() % 9000;
                source->written =
                    std::min<std::size_t>(script.steps.size(), source->written + random() % 400);
            }
            return sut.cycle->state() != MachineState::ready && sut.cycle->state() != MachineState::alarm;
        }));
        EXPECT_EQ(sut.cycle->state(), MachineState::ready) << "seed " << seed;
        EXPECT_EQ(sut.positions(), script.at()) << "seed " << seed;
        expect_no_stall(sut);
        const auto order = order_of(sut.port->writes);
        if (!is_disturbed) plain = order;
        if (!profile.job.lifts_on_hold) {
            EXPECT_TRUE(order == plain) << "seed " << seed;
        }
    }
}

// A record each time would push all else out of the recorder.
TEST(StarvedProgram, IsRecordedOnceASecondAtMostWithHowOftenItWas) {
    ProgramRig sut;
    Script script{sut.positions()};
    for (int i = 0; i < 25; ++i) script.way({i % 2 == 0 ? -20 : 20, 0, 0, 0}, 0.0);
    script.end();
    const auto source = sut.give(script.steps);
    source->written = 1;
    ASSERT_EQ(sut.start(), Refusal::none);
    const std::uint64_t begin = sut.cycle->next_tick();
    while (source->written < script.steps.size()) {
        ASSERT_TRUE(sut.run_until(MachineState::held));
        EXPECT_EQ(sut.program().hold, ProgramHold::starved);
        ++source->written;
        ASSERT_TRUE(sut.run_while([&] { return sut.cycle->state() == MachineState::held; }));
    }
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(sut.program().starvations, 25U);
    const double seconds = 1e-9 * static_cast<double>(tick_period_ns(sut.profile)) *
                           static_cast<double>(sut.cycle->next_tick() - begin);
    std::uint64_t starvations = 0;
    std::size_t records = 0;
    for (const FlightRecord& record : sut.records_of(RecordKind::program)) {
        EXPECT_FALSE(is_of_program(record, ProgramEvent::resumed));
        starvations += recorded_starvations(record);
        records += recorded_starvations(record) > 0 ? 1 : 0;
    }
    EXPECT_EQ(starvations, 25U);
    EXPECT_LE(static_cast<double>(records), seconds + 2.0);
    for (const FlightRecord& record : sut.records_of(RecordKind::state_change)) {
        EXPECT_NE(record.code, static_cast<std::uint16_t>(MachineState::held));
        EXPECT_NE(record.code, static_cast<std::uint16_t>(MachineState::holding));
    }
}

// Waits that are over before they are told do not add up.
TEST(StarvedProgram, IsNoneWhoseWriterIsOftenALittleLate) {
    ProgramRig sut;
    Script script{sut.positions()};
    for (int i = 0; i < 6; ++i) script.way({i % 2 == 0 ? -20 : 20, 0, 0, 0}, 0.0);
    script.end();
    const auto source = sut.give(script.steps);
    source->written = 1;
    ASSERT_EQ(sut.start(), Refusal::none);
    while (source->written < script.steps.size()) {
        const Positions end = script.steps[source->written - 1].target_pulses;
        ASSERT_TRUE(sut.run_while([&] { return sut.positions() != end; }));
        sut.run(kPatienceTicks / 2);
        EXPECT_EQ(sut.cycle->state(), MachineState::carving) << source->written;
        ++source->written;
    }
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(sut.program().starvations, 0U);
    EXPECT_EQ(sut.positions(), script.at());
}

// It is held from then on, and that is told.
TEST(StarvedProgram, IsRecordedAsHeldWhereSomebodyHoldsIt) {
    ProgramRig sut;
    Script script{sut.positions()};
    script.way({-50, 0, 0, 0}, 0.0).way({50, 0, 0, 0}, 0.0).end();
    const auto source = sut.give(script.steps);
    source->written = 1;
    ASSERT_EQ(sut.start(), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::held));
    ASSERT_EQ(sut.ask(RequestKind::hold), Refusal::none);
    const auto states = sut.records_of(RecordKind::state_change);
    ASSERT_FALSE(states.empty());
    EXPECT_EQ(states.back().code, static_cast<std::uint16_t>(MachineState::held));
    const auto told = sut.records_of(RecordKind::program);
    EXPECT_EQ(told.back().code, recorded_code(ProgramEvent::held));
    source->written = script.steps.size();
    ASSERT_EQ(sut.ask(RequestKind::resume), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(sut.positions(), script.at());
}

class StarvedMachines : public ::testing::TestWithParam<int> {};

TEST_P(StarvedMachines, EndWhereTheySayHoweverTheyAreDisturbed) {
    Profile profile = program_profile();
    if (GetParam() == 1) {
        profile.tick.schedule = Schedule::two_timer;
        profile.tick.period_us = 100.0;
        profile.psi.speed_deg_s = 112.5;
        profile.psi.accel_deg_s2 = 1125.0;
        for (LinearAxisProfile* axis : {&profile.r1, &profile.r2, &profile.y}) {
            axis->speed_mm_s = 5.0;
            axis->accel_mm_s2 = 50.0;
            axis->home_speed_mm_s = 4.0;
        }
    }
    if (GetParam() == 2) {
        profile.r1.backlash_mm = 0.02;
        profile.y.backlash_mm = 0.05;
    }
    if (GetParam() == 3) profile.job.lifts_on_hold = true;
    const std::uint64_t seeds = test::is_long_run() ? 40 : test::is_thorough() ? 10 : 2;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) expect_end_however_disturbed(profile, seed);
}

INSTANTIATE_TEST_SUITE_P(PlainTwoTimerWornLifting, StarvedMachines, ::testing::Range(0, 4));

}  // namespace
}  // namespace psicarve::cycle
