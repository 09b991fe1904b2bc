// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>
#include <vector>

#include "tests/motion/random_operator.hpp"
#include "tests/rtcore/cycle/machine_rig.hpp"
#include "tests/rtcore/plan/scripted_source.hpp"

namespace psicarve::cycle {
namespace {

using plan::Supply;
using plan::test::random_program;
using plan::test::Script;
using plan::test::ScriptedSource;

constexpr std::uint64_t kProgram = 7;
constexpr std::uint64_t kPatienceTicks = 4000;

Profile program_profile() {
    Profile profile = quick_profile();
    profile.job.planner = Planner::lookahead;
    return profile;
}

/// A homed machine, and a program that it is asked to run.
class ProgramRig : public MachineRig {
public:
    explicit ProgramRig(const Profile& machine_profile = program_profile()) : MachineRig(machine_profile) {
        EXPECT_TRUE(home());
        EXPECT_EQ(ask(move_to({-800, -700, 300, 600})), Refusal::none);
        EXPECT_TRUE(run_until(MachineState::ready));
        port->writes.clear();
        reports.clear();
    }
    std::shared_ptr<ScriptedSource> give(std::vector<plan::ProgramStep> steps,
                                         Supply at_the_end = Supply::ended) {
        auto source = std::make_shared<ScriptedSource>(std::move(steps), at_the_end);
        planner->set_source(source, kProgram);
        return source;
    }
    Refusal start(bool is_single = false) {
        return ask(RequestKind::run_program, is_single ? 1 : 0, kProgram);
    }
    ProgramStatus program() const { return cycle->sample().program; }
    bool is_spindle_on() const { return (cycle->pulses().levels() & bit_of(Signal::spindle)) != 0; }

private:
    Request move_to(const Positions& delta) const {
        Request request{};
        request.kind = RequestKind::move;
        request.order.axes = 0xF;
        for (std::size_t k = 0; k < kAxisCount; ++k)
            request.order.target_pulses[k] = positions()[k] + delta[k];
        return request;
    }
};

std::vector<plan::ProgramStep> some_steps(const Positions& from) {
    Script script{from};
    script.spindle(true).way({-200, 0, 100, 50}, 0.01, 0.05).way({100, -50, 100, 0}, 0.01, 0.05).dwell(0.01);
    script.way({-50, 50, 0, -30}, 0.0).end();
    return script.steps;
}

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

TEST(Program, WithARefusedRecordRunsAllBeforeItAndEnds) {
    ProgramRig sut;
    Script script{sut.positions()};
    script.spindle(true).way({-50, 0, 0, 0}, 0.01);
    sut.give(script.steps, Supply::refused);
    ASSERT_EQ(sut.start(), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(sut.positions(), script.at());
    EXPECT_FALSE(sut.is_spindle_on());
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

/// The merged order of iterations, while `disturb` does what it likes.
template <typename Disturb>
std::vector<std::uint32_t> order_with(std::uint64_t seed, bool is_single, Disturb&& disturb) {
    ProgramRig sut;
    auto steps = random_program(seed, sut.positions(), 40).steps;
    const auto source = sut.give(steps);
    EXPECT_EQ(sut.start(is_single), Refusal::none);
    const bool has_ended = sut.run_while(
        [&] {
            disturb(sut, *source, steps.size());
            return sut.cycle->state() != MachineState::ready && sut.cycle->state() != MachineState::alarm;
        },
        10'000'000);
    EXPECT_TRUE(has_ended) << "seed " << seed;
    EXPECT_EQ(sut.cycle->state(), MachineState::ready) << "seed " << seed;
    return order_of(sut.port->writes);
}

void resume_halted(ProgramRig& rig) {
    if (rig.cycle->state() == MachineState::held && !(rig.program().hold == ProgramHold::starved))
        rig.ask(RequestKind::resume);
}

// Two timers, backlash, heads that leave the cut on hold: each has ways of its own to wait.
TEST(Program, EndsWhereItSaysOnOtherMachines) {
    Profile two_timer = program_profile();
    two_timer.tick.schedule = Schedule::two_timer;
    two_timer.tick.period_us = 100.0;
    two_timer.psi.speed_deg_s = 112.5;
    two_timer.psi.accel_deg_s2 = 1125.0;
    for (LinearAxisProfile* axis : {&two_timer.r1, &two_timer.r2, &two_timer.y}) {
        axis->speed_mm_s = 5.0;
        axis->accel_mm_s2 = 50.0;
        axis->home_speed_mm_s = 4.0;
    }
    Profile worn = program_profile();
    worn.r1.backlash_mm = 0.02;
    worn.y.backlash_mm = 0.05;
    Profile lifting = program_profile();
    lifting.job.lifts_on_hold = true;
    for (const Profile& profile : {two_timer, worn, lifting}) {
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            ProgramRig sut{profile};
            const Script script = random_program(seed, sut.positions(), 30);
            sut.give(script.steps);
            ASSERT_EQ(sut.start(), Refusal::none);
            motion::Operator hand{seed, 20'000};
            ASSERT_TRUE(sut.run_while([&] {
                hand(sut);
                return sut.cycle->state() != MachineState::ready && sut.cycle->state() != MachineState::alarm;
            }));
            EXPECT_EQ(sut.cycle->state(), MachineState::ready);
            EXPECT_EQ(sut.positions(), script.at());
        }
    }
}

// Writers that pause so long that it starves, an operator who holds, resumes and overrides, block by block.
TEST(Program, KeepsTheOrderOfItsPulsesHoweverItIsDisturbed) {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        const auto plain = order_with(
            seed, false, [](ProgramRig& rig, ScriptedSource&, std::size_t) { resume_halted(rig); });
        ASSERT_GT(plain.size(), 100U);
        motion::Operator hand{seed, 6000};
        std::mt19937_64 random{seed};
        std::uint64_t next_tick = 0;
        bool has_begun = false;
        const auto disturbed =
            order_with(seed, false, [&](ProgramRig& rig, ScriptedSource& source, std::size_t all) {
                if (!has_begun) source.written = 0;
                has_begun = true;
                hand(rig);
                const std::uint64_t now = rig.cycle->next_tick();
                if (now < next_tick) return;
                next_tick = now + 1 + random() % (seed % 4 == 0 ? 12'000 : 500);
                source.written = std::min<std::size_t>(all, source.written + random() % 6);
            });
        ASSERT_EQ(disturbed, plain) << "seed " << seed;
    }
}

}  // namespace
}  // namespace psicarve::cycle
