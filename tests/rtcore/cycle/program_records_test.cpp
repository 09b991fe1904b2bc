// SPDX-License-Identifier: GPL-3.0-or-later
// What the flight recorder is told of a program.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "shared/machine/recorded_program.hpp"
#include "tests/rtcore/cycle/program_rig.hpp"

namespace psicarve::cycle {
namespace {

using plan::Supply;
using plan::test::kBeforeScript;
using plan::test::Script;
using Told = std::vector<std::string>;

constexpr std::uint64_t kSecondTicks = 20'000;

/// "held tool change, line 3": in the order of telling; the sequences are those of the lines.
Told told_of(const ProgramRig& rig) {
    Told told;
    for (const FlightRecord& record : rig.records_of(RecordKind::program)) {
        const ProgramEvent event = program_event_of(record);
        const std::uint8_t detail = program_detail_of(record);
        std::string text{name_of(event)};
        if (event == ProgramEvent::begun) text += " no.";
        if (event == ProgramEvent::held) text += " " + std::string{name_of(static_cast<ProgramHold>(detail))};
        if (event == ProgramEvent::ended)
            text += " " + std::string{name_of(static_cast<ProgramEnding>(detail))};
        told.push_back(text + " " + std::to_string(record.value));
        const auto value = static_cast<std::uint64_t>(record.value);
        const bool has_motion = event != ProgramEvent::begun && value != 0;
        EXPECT_EQ(record.answer, has_motion ? recorded_sequence(kBeforeScript + value) : 0U) << told.back();
        EXPECT_EQ(record.axis, recorded_starvations(record) > 0 ? 1U : kNoAxis);
    }
    return told;
}

/// Where it stands in the record of the machine's states that goes with it.
std::vector<RecordKind> kinds_at(const ProgramRig& rig, std::uint64_t tick) {
    std::vector<RecordKind> kinds;
    for (const Report& report : rig.reports)
        if (report.record.tick == tick) kinds.push_back(report.record.kind);
    return kinds;
}

TEST(ProgramRecords, TellItsNumberWhereItBeganAndWhereItWasDone) {
    ProgramRig sut;
    const Positions begin = sut.positions();
    sut.give(some_steps(begin));
    const std::uint64_t begin_tick = sut.cycle->next_tick();
    ASSERT_EQ(sut.start(), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(told_of(sut), (Told{"begun no. 7", "ended done 6"}));
    const auto records = sut.records_of(RecordKind::program);
    EXPECT_EQ(records[0].tick, begin_tick);
    EXPECT_EQ(program_detail_of(records[0]), 0);
    EXPECT_EQ(Positions(std::to_array(records[0].position_pulses)), begin);
    EXPECT_EQ(kinds_at(sut, begin_tick),
              (std::vector{RecordKind::program, RecordKind::state_change, RecordKind::command}));
    const auto states = sut.records_of(RecordKind::state_change);
    EXPECT_EQ(records[1].tick, states.back().tick);
    EXPECT_EQ(Positions(std::to_array(records[1].position_pulses)), sut.positions());
}

TEST(ProgramRecords, TellTheLineOnceASecondWhileItChanges) {
    ProgramRig sut;
    Script script{sut.positions()};
    for (int i = 0; i < 4; ++i) script.dwell(0.6);
    script.dwell(2.5).end();
    sut.give(script.steps);
    ASSERT_EQ(sut.start(), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(told_of(sut), (Told{"begun no. 7", "line 2", "line 4", "line 5", "ended done 6"}));
    const auto records = sut.records_of(RecordKind::program);
    const std::uint64_t sample_ticks = plan::cycle_config_from_profile(sut.profile).sample_ticks;
    for (std::size_t n = 1; n <= 3; ++n) {
        const std::uint64_t since = records[n].tick - records[n - 1].tick;
        EXPECT_GE(since, kSecondTicks);
        EXPECT_LT(since, kSecondTicks + sample_ticks) << n;
    }
}

// A loop's next pass comes to the same line with another record.
TEST(ProgramRecords, TellTheLineOfEveryPass) {
    ProgramRig sut;
    Script script{sut.positions()};
    script.dwell(1.5).dwell(1.5).end();
    for (plan::ProgramStep& step : script.steps) step.line = 1;
    sut.give(script.steps);
    ASSERT_EQ(sut.start(), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    std::vector<std::uint64_t> passes;
    for (const FlightRecord& record : sut.records_of(RecordKind::program)) {
        if (is_of_program(record, ProgramEvent::begun)) continue;
        EXPECT_EQ(record.value, 1);
        if (is_of_program(record, ProgramEvent::line)) passes.push_back(record.answer);
    }
    EXPECT_EQ(passes, (std::vector<std::uint64_t>{recorded_sequence(kBeforeScript + 1),
                                                  recorded_sequence(kBeforeScript + 2)}));
}

TEST(ProgramRecords, TellWhereItWaitsForTheOperatorAndGoesOn) {
    ProgramRig sut;
    Script script{sut.positions()};
    script.spindle(true).way({-50, 0, 0, 0}, 0.01).stop(StopReason::tool_change);
    script.way({50, 0, 0, 0}, 0.01).end();
    sut.give(script.steps);
    ASSERT_EQ(sut.start(), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::held));
    sut.run(3 * kSecondTicks);
    const std::uint64_t resume_tick = sut.cycle->next_tick();
    ASSERT_EQ(sut.ask(RequestKind::resume), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(told_of(sut), (Told{"begun no. 7", "held tool change 3", "resumed 3", "ended done 5"}));
    const auto records = sut.records_of(RecordKind::program);
    EXPECT_EQ(records[2].tick, resume_tick);
    EXPECT_EQ(kinds_at(sut, resume_tick),
              (std::vector{RecordKind::program, RecordKind::state_change, RecordKind::command}));
}

TEST(ProgramRecords, TellWhereACommandHeldItOnceItRests) {
    ProgramRig sut;
    Script script{sut.positions()};
    script.way({-700, 0, 0, 0}, 0.0, 3.0).end();
    sut.give(script.steps);
    ASSERT_EQ(sut.start(), Refusal::none);
    sut.run(9000);
    ASSERT_EQ(sut.ask(RequestKind::hold), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::held));
    const std::uint64_t rest_tick = sut.records_of(RecordKind::state_change).back().tick;
    ASSERT_EQ(sut.ask(RequestKind::resume), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(told_of(sut), (Told{"begun no. 7", "held  1", "resumed 1", "ended done 2"}));
    EXPECT_EQ(sut.records_of(RecordKind::program)[1].tick, rest_tick);
}

TEST(ProgramRecords, TellEveryBlockOfOneAtATime) {
    ProgramRig sut;
    Script script{sut.positions()};
    script.way({-50, 0, 0, 0}, 0.01).way({0, 0, 80, 0}, 0.01).end();
    sut.give(script.steps);
    ASSERT_EQ(sut.start(true), Refusal::none);
    for (int block = 0; block < 2; ++block) {
        ASSERT_TRUE(sut.run_until(MachineState::held));
        ASSERT_EQ(sut.ask(RequestKind::resume), Refusal::none);
    }
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(told_of(sut), (Told{"begun no. 7", "held single block 1", "resumed 1", "held single block 2",
                                  "resumed 2", "ended done 3"}));
    EXPECT_EQ(program_detail_of(sut.records_of(RecordKind::program)[0]), 1);
}

TEST(ProgramRecords, TellThatItStarvedAndOfAHoldMeanwhile) {
    for (const bool is_held : {false, true}) {
        ProgramRig sut;
        Script script{sut.positions()};
        script.way({-50, 0, 0, 0}, 0.0).way({50, 0, 0, 0}, 0.0).end();
        const auto source = sut.give(script.steps);
        source->written = 1;
        ASSERT_EQ(sut.start(), Refusal::none);
        ASSERT_TRUE(sut.run_until(MachineState::held));
        if (is_held) {
            ASSERT_EQ(sut.ask(RequestKind::hold), Refusal::none);
        }
        source->written = 3;
        if (is_held) {
            ASSERT_EQ(sut.ask(RequestKind::resume), Refusal::none);
        }
        ASSERT_TRUE(sut.run_until(MachineState::ready));
        Told expected{"begun no. 7", "held starved 1"};
        if (is_held) expected.insert(expected.end(), {"held  1", "resumed 1"});
        expected.emplace_back("ended done 3");
        EXPECT_EQ(told_of(sut), expected);
    }
}

TEST(ProgramRecords, TellThatItsWriterIsGoneOrARecordWasRefusedAndThatItWasStopped) {
    for (const Supply supply : {Supply::lost, Supply::refused}) {
        ProgramRig sut;
        Script script{sut.positions()};
        script.spindle(true).way({-50, 0, 0, 0}, 0.01);
        sut.give(script.steps, supply);
        ASSERT_EQ(sut.start(), Refusal::none);
        ASSERT_TRUE(sut.run_until(MachineState::held));
        sut.stop();
        ASSERT_TRUE(sut.run_until(MachineState::ready));
        const char* const why =
            supply == Supply::lost ? "held program feeder lost 2" : "held program refused 2";
        EXPECT_EQ(told_of(sut), (Told{"begun no. 7", why, "stopping 2", "ended stopped 2"}));
    }
}

TEST(ProgramRecords, TellWhereAStopFoundItAndWhereItCameToRest) {
    ProgramRig sut;
    Script script{sut.positions()};
    script.way({-600, 0, 0, 0}, 0.0, 0.9).dwell(1.0).end();
    sut.give(script.steps);
    ASSERT_EQ(sut.start(), Refusal::none);
    sut.run(9000);
    const std::uint64_t stop_tick = sut.cycle->next_tick();
    sut.stop();
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(told_of(sut), (Told{"begun no. 7", "stopping 1", "ended stopped 1"}));
    EXPECT_EQ(sut.records_of(RecordKind::program)[1].tick, stop_tick);
    EXPECT_EQ(kinds_at(sut, stop_tick),
              (std::vector{RecordKind::stop, RecordKind::program, RecordKind::state_change}));
}

TEST(ProgramRecords, TellWhereAnAlarmBrokeItOff) {
    for (const bool is_emergency_stop : {true, false}) {
        ProgramRig sut;
        Script script{sut.positions()};
        script.way({-600, 0, 0, 0}, 0.0, 0.9).way({600, 0, 0, 0}, 0.0, 0.9).end();
        sut.give(script.steps);
        ASSERT_EQ(sut.start(), Refusal::none);
        ASSERT_TRUE(sut.run_while([&] { return sut.program().line < 2; }));
        sut.run(2000);
        const std::uint64_t tick = sut.cycle->next_tick();
        if (is_emergency_stop) {
            sut.emergency_stop();
        } else {
            sut.machine->hold_input(Signal::estop, true);
        }
        sut.tick();
        ASSERT_EQ(sut.cycle->state(), MachineState::alarm);
        EXPECT_EQ(told_of(sut).back(), "ended alarm 2");
        EXPECT_EQ(kinds_at(sut, tick),
                  (std::vector{is_emergency_stop ? RecordKind::emergency_stop : RecordKind::input_edge,
                               RecordKind::alarm, RecordKind::program, RecordKind::state_change}));
    }
}

// A job, a move and a program that was refused tell nothing.
TEST(ProgramRecords, AreOfProgramsAlone) {
    ProgramRig sut;
    ASSERT_EQ(sut.ask(RequestKind::drives_off), Refusal::none);
    EXPECT_EQ(sut.start(), Refusal::not_homed);
    ASSERT_TRUE(sut.home());
    sut.load(random_job(2, 30, 3));
    ASSERT_EQ(sut.ask(RequestKind::start), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::waiting));
    ASSERT_EQ(sut.ask(RequestKind::start_interpolation), Refusal::none);
    sut.run(2000);
    sut.stop();
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_TRUE(sut.records_of(RecordKind::program).empty());
}

}  // namespace
}  // namespace psicarve::cycle
