// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>
#include <vector>

#include "tests/motion/random_operator.hpp"
#include "tests/rtcore/cycle/program_rig.hpp"

namespace psicarve::cycle {
namespace {

using plan::Supply;
using plan::test::random_program;
using plan::test::Script;
using plan::test::ScriptedSource;

TEST(Program, RunsFromWhereTheMachineStandsAndLeavesItReady) {
    ProgramRig sut;
    const Positions begin = sut.positions();
    const auto source = sut.give(some_steps(begin));
    ASSERT_EQ(sut.start(), Refusal::none);
    EXPECT_EQ(sut.cycle->state(), MachineState::carving);
    EXPECT_TRUE(sut.run_while([&] { return !sut.is_spindle_on(); }));
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(source->start, begin);
    const Positions end{begin[0] - 150, begin[1], begin[2] + 200, begin[3] + 20};
    EXPECT_EQ(sut.positions(), end) << "heads stay where they are";
    EXPECT_FALSE(sut.is_spindle_on());
    EXPECT_EQ(sut.program().program, kProgram);
    EXPECT_EQ(sut.program().line, 6U);
    EXPECT_EQ(sut.program().is_running, 0U);
    EXPECT_EQ(sut.program().is_done, 1U);
    EXPECT_EQ(sut.program().starvations, 0U);
    const Sample sample = sut.cycle->sample();
    EXPECT_EQ(sample.carve_first_tick, 0U) << "no job is carved";
    EXPECT_EQ(sample.job_end_tick, 0U);
    EXPECT_EQ(sample.points_done, 0U);
    EXPECT_EQ(sut.ask(RequestKind::start), Refusal::no_job);
}

TEST(Program, IsRunOnlyByAHomedMachineAtRest) {
    MachineRig off(program_profile());
    EXPECT_EQ(off.ask(RequestKind::run_program, 0, kProgram), Refusal::not_homed);
    ProgramRig sut;
    sut.give(some_steps(sut.positions()));
    ASSERT_EQ(sut.start(), Refusal::none);
    EXPECT_EQ(sut.start(), Refusal::not_in_this_state) << "one at a time";
    for (const RequestKind kind : {RequestKind::home, RequestKind::move, RequestKind::spindle,
                                   RequestKind::start, RequestKind::job_loaded, RequestKind::drives_off})
        EXPECT_NE(sut.ask(kind), Refusal::none);
    EXPECT_TRUE(sut.run_until(MachineState::ready));
}

TEST(Program, ShowsTheLineOfTheMotionAtHand) {
    ProgramRig sut;
    Script script{sut.positions()};
    for (int i = 0; i < 20; ++i) script.way({i % 2 == 0 ? 40 : -40, 0, 60, 0}, 0.01);
    script.dwell(0.05).end();
    sut.give(script.steps);
    ASSERT_EQ(sut.start(), Refusal::none);
    std::vector<std::uint64_t> lines;
    ASSERT_TRUE(sut.run_while([&] {
        const std::uint64_t line = sut.program().line;
        if (line != 0 && (lines.empty() || lines.back() != line)) lines.push_back(line);
        return sut.cycle->state() == MachineState::carving;
    }));
    std::vector<std::uint64_t> all(22);
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i + 1;
    EXPECT_EQ(lines, all);
}

TEST(Program, WaitsForTheOperatorWhereItSaysSo) {
    ProgramRig sut;
    Script script{sut.positions()};
    script.spindle(true)
        .way({-50, 0, 0, 0}, 0.01)
        .stop(StopReason::tool_change)
        .way({50, 0, 0, 0}, 0.01)
        .end();
    sut.give(script.steps);
    ASSERT_EQ(sut.start(), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::held));
    EXPECT_EQ(sut.program().hold, ProgramHold::tool_change);
    EXPECT_EQ(sut.program().line, 3U);
    EXPECT_EQ(sut.positions()[0], script.at()[0] - 50);
    sut.run(3 * kPatienceTicks);
    EXPECT_EQ(sut.cycle->state(), MachineState::held);
    EXPECT_EQ(sut.program().starvations, 0U);
    ASSERT_EQ(sut.ask(RequestKind::resume), Refusal::none);
    EXPECT_EQ(sut.program().hold, ProgramHold::none);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(sut.positions(), script.at());
}

TEST(Program, WaitsAfterEveryBlockOneAtATime) {
    ProgramRig sut;
    Script script{sut.positions()};
    script.way({-50, 0, 0, 0}, 0.01).way({0, 0, 80, 0}, 0.01).way({0, 0, 0, 20}, 0.01).end();
    sut.give(script.steps);
    ASSERT_EQ(sut.start(true), Refusal::none);
    for (std::uint64_t line = 1; line <= 3; ++line) {
        ASSERT_TRUE(sut.run_until(MachineState::held));
        EXPECT_EQ(sut.program().hold, ProgramHold::single);
        EXPECT_EQ(sut.program().line, line);
        ASSERT_EQ(sut.ask(RequestKind::resume), Refusal::none);
    }
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(sut.positions(), script.at());
}

TEST(Program, StarvesAtRestInHeldAndGoesOnWhenRecordsCome) {
    ProgramRig sut;
    Script script{sut.positions()};
    script.way({-50, 0, 0, 0}, 0.0).way({50, 0, 0, 0}, 0.0).end();
    const auto source = sut.give(script.steps);
    source->written = 1;
    ASSERT_EQ(sut.start(), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::held));
    EXPECT_EQ(sut.program().hold, ProgramHold::starved);
    EXPECT_EQ(sut.program().starvations, 1U);
    EXPECT_EQ(sut.program().line, 1U);
    EXPECT_EQ(sut.positions()[0], script.at()[0] - 50);
    EXPECT_EQ(sut.ask(RequestKind::resume), Refusal::none);
    sut.run(2 * kPatienceTicks);
    EXPECT_EQ(sut.cycle->state(), MachineState::held) << "there is nothing to resume";
    EXPECT_EQ(sut.program().starvations, 1U);
    source->written = 3;
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(sut.positions(), script.at());
    EXPECT_EQ(sut.program().starvations, 1U);
    EXPECT_EQ(sut.program().hold, ProgramHold::none);
}

TEST(Program, DoesNotStarveBeforeItsFirstStepNorInADwell) {
    ProgramRig sut;
    Script script{sut.positions()};
    script.dwell(1.0).way({-50, 0, 0, 0}, 0.0).end();
    const auto source = sut.give(script.steps);
    source->written = 0;
    ASSERT_EQ(sut.start(), Refusal::none);
    sut.run(3 * kPatienceTicks);
    EXPECT_EQ(sut.cycle->state(), MachineState::carving);
    source->written = 1;
    sut.run(19'000);
    EXPECT_EQ(sut.cycle->state(), MachineState::carving);
    source->written = 3;
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(sut.program().starvations, 0U);
}

TEST(Program, StaysHeldWhenRecordsComeIfTheOperatorHeldIt) {
    ProgramRig sut;
    Script script{sut.positions()};
    script.way({-50, 0, 0, 0}, 0.0).way({50, 0, 0, 0}, 0.0).end();
    const auto source = sut.give(script.steps);
    source->written = 1;
    ASSERT_EQ(sut.start(), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::held));
    ASSERT_EQ(sut.ask(RequestKind::hold), Refusal::none);
    source->written = 3;
    sut.run(2 * kPatienceTicks);
    EXPECT_EQ(sut.cycle->state(), MachineState::held);
    ASSERT_EQ(sut.ask(RequestKind::resume), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(sut.positions(), script.at());
}

TEST(Program, ThatLostItsWriterRunsWhatItHasAndCanOnlyBeStopped) {
    ProgramRig sut;
    Script script{sut.positions()};
    script.spindle(true).way({-50, 0, 0, 0}, 0.01);
    sut.give(script.steps, Supply::lost);
    ASSERT_EQ(sut.start(), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::held));
    EXPECT_EQ(sut.positions(), script.at());
    EXPECT_EQ(sut.program().hold, ProgramHold::feeder_lost);
    EXPECT_EQ(sut.program().line, 2U);
    EXPECT_EQ(sut.ask(RequestKind::resume), Refusal::not_in_this_state);
    sut.stop();
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_FALSE(sut.is_spindle_on());
    EXPECT_EQ(sut.program().is_running, 0U);
    EXPECT_GT(sut.positions()[0], script.at()[0]) << "heads are out";
    EXPECT_EQ(sut.program().line, 2U);
}

// Its spindle may stand in the cut: what it does there is for the operator to say.
TEST(Program, WithARefusedRecordRunsAllBeforeItAndCanOnlyBeStopped) {
    ProgramRig sut;
    Script script{sut.positions()};
    script.spindle(true).way({-50, 0, 0, 0}, 0.01);
    sut.give(script.steps, Supply::refused);
    ASSERT_EQ(sut.start(), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::held));
    EXPECT_EQ(sut.positions(), script.at());
    EXPECT_TRUE(sut.is_spindle_on());
    EXPECT_EQ(sut.program().hold, ProgramHold::refused);
    EXPECT_EQ(sut.program().line, 2U);
    EXPECT_EQ(sut.ask(RequestKind::resume), Refusal::not_in_this_state);
    EXPECT_EQ(sut.program().hold, ProgramHold::refused);
    sut.stop();
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_FALSE(sut.is_spindle_on());
    EXPECT_EQ(sut.program().is_done, 0U);
}

// Whoever slows down wants it to stay; nobody looks for a raised one in the next program.
TEST(Program, TakesARaisedOverrideAlongAtItsEndAlone) {
    ProgramRig sut;
    const auto override_percent = [&] { return sut.cycle->sample().override_percent; };
    ASSERT_EQ(sut.ask(RequestKind::override, 0, 130), Refusal::none);
    sut.give(some_steps(sut.positions()));
    ASSERT_EQ(sut.start(), Refusal::none);
    sut.stop();
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(override_percent(), 130U) << "broken off";
    sut.give(some_steps(sut.positions()));
    ASSERT_EQ(sut.start(), Refusal::none);
    EXPECT_EQ(override_percent(), 130U);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(sut.program().is_done, 1U);
    EXPECT_EQ(override_percent(), 100U);
    ASSERT_EQ(sut.ask(RequestKind::override, 0, 60), Refusal::none);
    sut.give(some_steps(sut.positions()));
    ASSERT_EQ(sut.start(), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(override_percent(), 60U);
}

TEST(Program, StopsWhereverItIs) {
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        ProgramRig sut;
        const auto source = sut.give(random_program(seed, sut.positions(), 60).steps);
        if (seed % 3 == 0) source->written = 20;
        ASSERT_EQ(sut.start(), Refusal::none);
        std::mt19937_64 random{seed};
        sut.run(1 + random() % 60'000);
        if (sut.cycle->state() == MachineState::ready) continue;
        sut.stop();
        ASSERT_TRUE(sut.run_until(MachineState::ready)) << "seed " << seed;
        EXPECT_FALSE(sut.is_spindle_on());
        EXPECT_EQ(sut.program().is_running, 0U);
        EXPECT_EQ(sut.cycle->sample().job_end_tick, 0U);
        EXPECT_EQ(sut.start(), Refusal::none) << "the source is gone, but nothing else";
    }
}

TEST(Program, EndsInAnAlarmAtAnEmergencyStop) {
    ProgramRig sut;
    sut.give(random_program(3, sut.positions(), 200).steps);
    ASSERT_EQ(sut.start(), Refusal::none);
    sut.run(9000);
    const auto before = sut.program();
    sut.emergency_stop();
    sut.tick();
    EXPECT_EQ(sut.cycle->state(), MachineState::alarm);
    EXPECT_FALSE(sut.is_spindle_on());
    EXPECT_EQ(sut.program().is_running, 0U);
    EXPECT_GE(sut.program().line, before.line);
    const auto alarms = sut.records_of(RecordKind::alarm);
    ASSERT_EQ(alarms.size(), 1U);
    const Positions at = sut.positions();
    sut.run(10'000);
    EXPECT_EQ(sut.positions(), at);
    ASSERT_EQ(sut.ask(RequestKind::reset_alarm), Refusal::none);
    EXPECT_EQ(sut.cycle->state(), MachineState::off) << "drives were off";
}

}  // namespace
}  // namespace psicarve::cycle
