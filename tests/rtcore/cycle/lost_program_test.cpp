// SPDX-License-Identifier: GPL-3.0-or-later
// Programs whose writer is killed at any of their steps: what came is run to its end, in the order of the
// whole program, and nothing else.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "rtcore/plan/record_program.hpp"
#include "tests/rtcore/cycle/program_rig.hpp"
#include "tests/thoroughness.hpp"

namespace psicarve::cycle {
namespace {

using plan::RecordProgram;
using plan::test::Script;

/// Steps, each with the line at which the machine is then.
struct RunOfSteps {
    std::vector<std::uint32_t> order;
    std::vector<std::uint64_t> lines;  ///< by step
};

/// Of the first `count` steps of a program; the writer is killed behind them.
RunOfSteps run_of_first(std::size_t count, const Script& script, ProgramRig& sut) {
    auto steps = script.steps;
    const bool is_whole = count >= steps.size();
    if (!is_whole) steps.resize(count);
    sut.give(steps, is_whole ? plan::Supply::ended : plan::Supply::lost);
    EXPECT_EQ(sut.start(), Refusal::none);
    RunOfSteps run;
    PinCounter pins{{}};
    EXPECT_TRUE(sut.run_while([&] {
        for (const PortWrite& write : sut.port->writes) {
            const std::uint32_t axes = pins.take(write.levels);
            if (axes == 0) continue;
            run.order.push_back(axes);
            run.lines.push_back(sut.program().line);
        }
        sut.port->writes.clear();
        const MachineState state = sut.cycle->state();
        const bool is_lost = state == MachineState::held && sut.program().hold == ProgramHold::feeder_lost;
        if (state == MachineState::held && !is_lost) sut.ask(RequestKind::resume);
        return !is_lost && state != MachineState::ready && state != MachineState::alarm;
    }));
    return run;
}

// A path rests where its writer was killed, and so bends otherwise on the way there than in the whole
// program: in the part at hand, whose curve was not decided yet, or on the last points of the part before,
// where it comes to rest if no curve goes on.
void expect_begin_of_whole(std::uint64_t seed, std::size_t kills) {
    ProgramRig whole_rig;
    const Positions from = whole_rig.positions();
    const Script script = plan::test::dense_program(seed, 1400, 0b1101, 5.0, from);
    const RunOfSteps whole = run_of_first(script.steps.size(), script, whole_rig);
    std::mt19937_64 random{seed};
    for (std::size_t kill = 0; kill < kills; ++kill) {
        const std::size_t count = 1 + random() % (script.steps.size() - 1);
        ProgramRig sut;
        const RunOfSteps part = run_of_first(count, script, sut);
        ASSERT_EQ(sut.cycle->state(), MachineState::held) << count;
        ASSERT_EQ(sut.positions(), script.steps[count - 1].target_pulses) << count;
        const std::size_t tail = RecordProgram::kTailPoints;
        const std::size_t parts = (count - std::min(count, tail)) / RecordProgram::kPartPoints;
        const auto same =
            static_cast<std::size_t>(std::ranges::mismatch(part.order, whole.order).in1 - part.order.begin());
        const std::uint64_t line = same < part.order.size() ? part.lines[same] : count;
        ASSERT_GE(line + tail, parts * RecordProgram::kPartPoints) << "killed behind step " << count;
        const sim::SimReport report = sut.machine->report();
        for (const Axis axis : kAllAxes) ASSERT_EQ(report.axis(axis).stalls, 0U) << name_of(axis);
    }
}

TEST(LostProgram, RunsInItsOrderAllThatCameWheneverItsWriterIsKilled) {
    const std::size_t kills = test::is_long_run() ? 100 : test::is_thorough() ? 8 : 2;
    for (std::uint64_t seed = 1; seed <= 3 && !::testing::Test::HasFatalFailure(); ++seed)
        expect_begin_of_whole(seed, kills);
}

}  // namespace
}  // namespace psicarve::cycle
