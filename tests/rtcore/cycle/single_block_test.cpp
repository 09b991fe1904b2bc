// SPDX-License-Identifier: GPL-3.0-or-later
// What an operator switches while a program runs.
#include <gtest/gtest.h>

#include <vector>

#include "tests/rtcore/cycle/program_rig.hpp"

namespace psicarve::cycle {
namespace {

using plan::test::Script;

/// Lines in whose ends a program under G64 was held, each resumed.
std::vector<std::uint64_t> held_lines(ProgramRig& sut) {
    std::vector<std::uint64_t> lines;
    while (sut.run_while([&] {
        return sut.cycle->state() != MachineState::held && sut.cycle->state() != MachineState::ready;
    }) && sut.cycle->state() == MachineState::held) {
        EXPECT_EQ(sut.program().hold, ProgramHold::single);
        lines.push_back(sut.program().line);
        EXPECT_EQ(sut.ask(RequestKind::resume), Refusal::none);
    }
    return lines;
}

TEST(SingleBlock, HoldsAtTheEndOfEachLineFromThatAtHandOn) {
    ProgramRig sut;
    EXPECT_EQ(sut.ask(RequestKind::single, 0, 1), Refusal::no_program);
    Script script{sut.positions()};
    for (int i = 0; i < 4; ++i) script.way({-40, 0, 60, 20}, 0.01, 0.02).way({40, 0, 50, 0}, 0.01, 0.02);
    script.spindle(true).dwell(0.01).output(Signal::mist, true).way({0, 0, 30, 0}, 0.0);
    script.stepped_line({-20, 0, 10, 0}).stop().dwell(0.0).end();
    sut.give(script.steps);
    ASSERT_EQ(sut.start(), Refusal::none);
    ASSERT_TRUE(sut.run_while([&] { return sut.program().line < 3; }));
    ASSERT_EQ(sut.ask(RequestKind::single, 0, 1), Refusal::none);
    EXPECT_EQ(sut.program().is_single, 1U);
    for (std::uint64_t line = 3; line <= 13; ++line) {
        ASSERT_TRUE(sut.run_until(MachineState::held)) << line;
        EXPECT_EQ(sut.program().hold, ProgramHold::single);
        EXPECT_EQ(sut.program().line, line);
        ASSERT_EQ(sut.ask(RequestKind::resume), Refusal::none);
    }
    ASSERT_TRUE(sut.run_until(MachineState::held));
    EXPECT_EQ(sut.program().hold, ProgramHold::program);
    ASSERT_EQ(sut.ask(RequestKind::resume), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(sut.positions(), script.at());
    EXPECT_EQ(sut.ask(RequestKind::single, 0, 0), Refusal::no_program);
}

TEST(SingleBlock, RunsOnFromTheNextResumeOnceSingleIsSwitchedOff) {
    for (const bool from_the_start : {true, false}) {
        ProgramRig sut;
        Script script{sut.positions()};
        for (int i = 0; i < 6; ++i) script.way({-40, 0, 60, 20}, 0.01, 0.02).way({40, 0, 50, 0}, 0.01, 0.02);
        script.end();
        sut.give(script.steps);
        ASSERT_EQ(sut.start(from_the_start), Refusal::none);
        ASSERT_EQ(sut.ask(RequestKind::single, 0, 1), Refusal::none);
        ASSERT_TRUE(sut.run_until(MachineState::held));
        ASSERT_EQ(sut.ask(RequestKind::single, 0, 0), Refusal::none);
        EXPECT_EQ(sut.cycle->state(), MachineState::held);
        EXPECT_EQ(sut.program().is_single, 0U);
        ASSERT_EQ(sut.ask(RequestKind::resume), Refusal::none);
        EXPECT_TRUE(held_lines(sut).empty());
        EXPECT_EQ(sut.positions(), script.at());
    }
}

TEST(SingleBlock, SwitchedOffInTheVeryRestOfALineHoldsNoMore) {
    const auto begun = [](ProgramRig& sut) {
        Script script{sut.positions()};
        for (int i = 0; i < 3; ++i) script.way({-40, 0, 60, 20}, 0.01, 0.02);
        script.end();
        sut.give(script.steps);
        EXPECT_EQ(sut.start(), Refusal::none);
        EXPECT_EQ(sut.ask(RequestKind::single, 0, 1), Refusal::none);
        return script.at();
    };
    ProgramRig held;
    begun(held);
    const std::uint64_t begin = held.cycle->next_tick();
    ASSERT_TRUE(held.run_until(MachineState::held));
    const std::uint64_t ticks = held.cycle->next_tick() - begin;
    for (std::uint64_t before = 1; before <= 6; ++before) {
        ProgramRig sut;
        const auto end = begun(sut);
        sut.run(ticks - before);
        ASSERT_EQ(sut.cycle->state(), MachineState::carving);
        ASSERT_EQ(sut.ask(RequestKind::single, 0, 0), Refusal::none);
        EXPECT_TRUE(held_lines(sut).empty()) << before << " ticks before it was held";
        EXPECT_EQ(sut.positions(), end);
    }
}

// What is asked for in the tick of such a rest is done.
TEST(SingleBlock, StopsOrHoldsInTheRestAtALinesEnd) {
    for (const std::uint64_t after : {0U, 1U, 2U}) {
        for (const bool stops : {false, true}) {
            ProgramRig sut;
            Script script{sut.positions()};
            for (int i = 0; i < 6; ++i) script.way({-40, 0, 60, 20}, 0.01, 0.02);
            script.end();
            sut.give(script.steps);
            ASSERT_EQ(sut.start(), Refusal::none);
            ASSERT_EQ(sut.ask(RequestKind::single, 0, 1), Refusal::none);
            // The last pulse of the first line, and a few ticks.
            const std::int64_t end_y = script.steps[0].target_pulses[kY] - 1;
            ASSERT_TRUE(sut.run_while([&] { return sut.positions()[kY] < end_y; }));
            sut.run(after);
            if (stops) {
                sut.stop();
                ASSERT_TRUE(sut.run_until(MachineState::ready));
            } else {
                (void)sut.ask(RequestKind::hold);  // refused if it is held already
                ASSERT_TRUE(sut.run_until(MachineState::held));
            }
        }
    }
}

TEST(RapidOverride, IsOfAProgramAndStaysUntilTheNextJob) {
    ProgramRig sut;
    for (const std::uint64_t percent : {0U, 9U, 101U, 200U})
        EXPECT_EQ(sut.ask(RequestKind::rapid_override, 0, percent), Refusal::bad_rapid_override);
    const auto ticks_at = [](std::uint64_t feed_percent, std::uint64_t rapid_percent) {
        ProgramRig rig;
        Script script{rig.positions()};
        script.way({0, 0, 0, 2000}, 0.01, 0.0, true).end();
        rig.give(script.steps);
        EXPECT_EQ(rig.ask(RequestKind::override, 0, feed_percent), Refusal::none);
        EXPECT_EQ(rig.ask(RequestKind::rapid_override, 0, rapid_percent), Refusal::none);
        EXPECT_EQ(rig.cycle->sample().rapid_override_percent, rapid_percent);
        EXPECT_EQ(rig.start(), Refusal::none);
        const std::uint64_t begin = rig.cycle->next_tick();
        EXPECT_TRUE(rig.run_until(MachineState::ready));
        EXPECT_EQ(rig.cycle->sample().rapid_override_percent, rapid_percent) << "stays";
        return rig.cycle->next_tick() - begin;
    };
    const std::uint64_t plain = ticks_at(100, 100);
    EXPECT_EQ(ticks_at(10, 100), plain);
    EXPECT_GT(ticks_at(100, 50), plain * 3 / 2);
    EXPECT_GT(ticks_at(200, 10), plain * 5);
    ASSERT_EQ(sut.ask(RequestKind::rapid_override, 0, 40), Refusal::none);
    ASSERT_EQ(sut.ask(RequestKind::job_loaded, 0, 3), Refusal::none);
    EXPECT_EQ(sut.cycle->sample().rapid_override_percent, 100U) << "with the next job it is as planned";
}

}  // namespace
}  // namespace psicarve::cycle
