// SPDX-License-Identifier: GPL-3.0-or-later
// Programs while an operator holds, resumes and overrides, and writers pause.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "tests/motion/random_operator.hpp"
#include "tests/rtcore/cycle/program_rig.hpp"
#include "tests/thoroughness.hpp"

namespace psicarve::cycle {
namespace {

using plan::test::random_program;
using plan::test::Script;
using plan::test::ScriptedSource;

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
TEST(DisturbedProgram, EndsWhereItSaysOnOtherMachines) {
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
            motion::Operator hand{seed, 20'000, motion::Operator::Of::programs};
            ASSERT_TRUE(sut.run_while([&] {
                hand(sut);
                return sut.cycle->state() != MachineState::ready && sut.cycle->state() != MachineState::alarm;
            }));
            EXPECT_EQ(sut.cycle->state(), MachineState::ready);
            EXPECT_EQ(sut.positions(), script.at());
        }
    }
}

// Heads on their way back from a hold are at work, however long nothing is queued behind them.
TEST(DisturbedProgram, StarvesOnlyOnceItsHeadsAreBackOnThePath) {
    Profile lifting = program_profile();
    lifting.job.lifts_on_hold = true;
    lifting.job.plunge_mm_s = 0.5;
    ProgramRig sut{lifting};
    Script script{sut.positions()};
    script.way({-200, -100, 0, 50}, 0.0).way({100, 0, 50, 0}, 0.0).end();
    const auto source = sut.give(script.steps);
    source->written = 1;
    ASSERT_EQ(sut.start(), Refusal::none);
    const Positions first = script.steps[0].target_pulses;
    ASSERT_TRUE(sut.run_while([&] { return sut.positions() != first; }));
    // It rests, and has not starved yet.
    ASSERT_EQ(sut.ask(RequestKind::hold), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::held));
    const Positions out = sut.positions();
    ASSERT_EQ(sut.ask(RequestKind::resume), Refusal::none);
    std::uint64_t ticks_on_the_way = 0;
    ASSERT_TRUE(sut.run_while([&] {
        ++ticks_on_the_way;
        EXPECT_FALSE(sut.cycle->state() == MachineState::held && sut.cycle->are_heads_lifted());
        return sut.program().starvations == 0;
    }));
    EXPECT_GT(ticks_on_the_way, 2 * kPatienceTicks) << "the way back takes longer than patience";
    EXPECT_LT(sut.positions()[0], out[0]);
    source->written = script.steps.size();
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(sut.positions(), script.at());
    const sim::SimReport report = sut.machine->report();
    for (const Axis axis : kAllAxes) EXPECT_EQ(report.axis(axis).stalls, 0U) << name_of(axis);
}

/// A writer that pauses so long that it starves, and an operator who holds, resumes and overrides.
void expect_order_kept(std::uint64_t seed, bool is_single) {
    const auto plain = order_with(seed, is_single,
                                  [](ProgramRig& rig, ScriptedSource&, std::size_t) { resume_halted(rig); });
    ASSERT_GT(plain.size(), 100U);
    motion::Operator hand{seed, 6000, motion::Operator::Of::programs};
    std::mt19937_64 random{seed};
    std::uint64_t next_tick = 0;
    bool has_begun = false;
    const auto disturbed =
        order_with(seed, is_single, [&](ProgramRig& rig, ScriptedSource& source, std::size_t all) {
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

TEST(DisturbedProgram, KeepsTheOrderOfItsPulsesHoweverItIsDisturbed) {
    const std::uint64_t seeds = test::is_long_run() ? 200 : test::is_thorough() ? 40 : 6;
    for (std::uint64_t seed = 1; seed <= seeds && !::testing::Test::HasFatalFailure(); ++seed)
        expect_order_kept(seed, false);
}

TEST(DisturbedProgram, KeepsTheOrderOfItsPulsesBlockByBlock) {
    const std::uint64_t seeds = test::is_long_run() ? 200 : test::is_thorough() ? 10 : 2;
    for (std::uint64_t seed = 1; seed <= seeds && !::testing::Test::HasFatalFailure(); ++seed)
        expect_order_kept(seed, true);
}

// Switched on and off at random ticks, also while it holds or starves.
TEST(DisturbedProgram, KeepsTheOrderOfItsPulsesWhenSingleBlockIsSwitched) {
    const std::uint64_t seeds = test::is_long_run() ? 200 : test::is_thorough() ? 20 : 4;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const bool begins_single = seed % 3 == 0;
        const auto plain = order_with(
            seed, begins_single, [](ProgramRig& rig, ScriptedSource&, std::size_t) { resume_halted(rig); });
        ASSERT_GT(plain.size(), 100U);
        motion::Operator hand{seed, 6000, motion::Operator::Of::programs};
        std::mt19937_64 random{seed};
        std::uint64_t next_tick = 0;
        std::uint64_t halts = 0;
        bool has_begun = false;
        bool was_single = false;
        const auto switched =
            order_with(seed, begins_single, [&](ProgramRig& rig, ScriptedSource& source, std::size_t all) {
                if (!has_begun) source.written = 0;
                has_begun = true;
                hand(rig);
                const bool is_single = rig.program().hold == ProgramHold::single;
                if (is_single && !was_single) ++halts;
                was_single = is_single;
                const std::uint64_t now = rig.cycle->next_tick();
                if (now < next_tick) return;
                next_tick = now + 1 + random() % 3000;
                rig.ask(RequestKind::single, 0, random() % 2);
                source.written = std::min<std::size_t>(all, source.written + random() % 6);
            });
        ASSERT_EQ(switched, plain) << "seed " << seed;
        EXPECT_GT(halts, 3U) << "seed " << seed;
    }
}

}  // namespace
}  // namespace psicarve::cycle
