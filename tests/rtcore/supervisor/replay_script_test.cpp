// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/replay/replay_script.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

#include "shared/machine/command.hpp"
#include "shared/machine/recorded_gaps.hpp"
#include "shared/machine/recorded_program.hpp"

namespace psicarve::supervisor {
namespace {

FlightRecord state_change(std::uint64_t tick, MachineState state) {
    FlightRecord record{};
    record.tick = tick;
    record.kind = RecordKind::state_change;
    record.code = static_cast<std::uint16_t>(state);
    return record;
}

FlightRecord command(std::uint64_t tick, CommandKind kind, AnswerKind answer = AnswerKind::done) {
    FlightRecord record{};
    record.tick = tick;
    record.kind = RecordKind::command;
    record.code = static_cast<std::uint16_t>(kind);
    record.answer = static_cast<std::uint32_t>(answer);
    return record;
}

TEST(ReplayScript, BeginsAtTheFirstHomedRest) {
    FlightRecord ready = state_change(1000, MachineState::ready);
    ready.position_pulses[0] = 24000;
    ready.signals = bit_of(Signal::psi_index);
    const auto sut =
        script_from_records({command(10, CommandKind::home), ready, command(1500, CommandKind::start)});
    ASSERT_TRUE(sut.has_value());
    EXPECT_EQ(sut->start_position_pulses[0], 24000);
    EXPECT_EQ(sut->start_levels, bit_of(Signal::psi_index));
    ASSERT_EQ(sut->steps.size(), 1U);
    EXPECT_EQ(sut->steps[0].request, cycle::RequestKind::start);
    EXPECT_EQ(sut->steps[0].tick, 500U);
    EXPECT_EQ(sut->end_tick, 500U);
}

// The job came while the machine rested there.
TEST(ReplayScript, BeginsWithTheGapsOfTheRestBeforeIt) {
    FlightRecord ready = state_change(1000, MachineState::ready);
    ready.value = recorded_gaps({0, 7, 0, 65'535});
    FlightRecord job = command(1200, CommandKind::none);
    job.kind = RecordKind::job;
    const FlightRecord start = command(1500, CommandKind::start);
    for (const bool with_job : {false, true}) {
        std::vector<FlightRecord> records{state_change(500, MachineState::ready), ready, start};
        if (with_job) records.insert(records.begin() + 2, job);
        if (!with_job) records.erase(records.begin());
        const auto sut = script_from_records(records);
        ASSERT_TRUE(sut.has_value());
        EXPECT_EQ(sut->first_tick, with_job ? 1200U : 1000U);
        EXPECT_EQ(sut->start_gaps, (GapsLeft{0, 7, 0, 65'535}));
    }
    EXPECT_EQ(recorded_gaps({0, 0, 0, 70'000}), recorded_gaps({0, 0, 0, 65'535}));
    EXPECT_EQ(recorded_gaps({}), 0);
}

// One above 100 % has ended with the program before.
TEST(ReplayScript, BeginsWithTheOverrideThatAProgramLeft) {
    for (const std::int64_t percent : {150, 60}) {
        FlightRecord asked = command(1200, CommandKind::override);
        asked.value = percent;
        FlightRecord done{};
        done.tick = 4000;
        done.kind = RecordKind::program;
        done.code = recorded_code(ProgramEvent::ended, static_cast<std::uint8_t>(ProgramEnding::done));
        const auto sut = script_from_records(
            {state_change(1000, MachineState::ready), asked, command(2000, CommandKind::program),
             state_change(2000, MachineState::carving), done, state_change(4000, MachineState::ready),
             command(5000, CommandKind::start)});
        ASSERT_TRUE(sut.has_value());
        ASSERT_EQ(sut->steps.size(), percent > 100 ? 1U : 2U);
        EXPECT_EQ(sut->steps.back().request, cycle::RequestKind::start);
        if (percent > 100) continue;
        EXPECT_EQ(sut->steps.front().request, cycle::RequestKind::override);
        EXPECT_EQ(sut->steps.front().value, 60U);
    }
}

// Its records are not in the snapshot: nothing before its end can be done again.
TEST(ReplayScript, BeginsAfterTheLastProgram) {
    FlightRecord after = state_change(4000, MachineState::ready);
    after.position_pulses[1] = 77;
    std::vector<FlightRecord> records{state_change(1000, MachineState::ready),
                                      command(1500, CommandKind::move), command(2000, CommandKind::program),
                                      state_change(2000, MachineState::carving),
                                      command(2500, CommandKind::hold)};
    EXPECT_FALSE(script_from_records(records).has_value());
    records.push_back(after);
    records.push_back(command(5000, CommandKind::move));
    const auto sut = script_from_records(records);
    ASSERT_TRUE(sut.has_value());
    EXPECT_EQ(sut->start_position_pulses[1], 77);
    ASSERT_EQ(sut->steps.size(), 1U);
    EXPECT_EQ(sut->steps[0].tick, 1000U);
}

TEST(ReplayScript, LeavesOutWhatTheMachineRefused) {
    const auto sut = script_from_records({state_change(0, MachineState::ready),
                                          command(5, CommandKind::resume, AnswerKind::refused),
                                          command(9, CommandKind::start)});
    ASSERT_TRUE(sut.has_value());
    ASSERT_EQ(sut->steps.size(), 1U);
    EXPECT_EQ(sut->steps[0].tick, 9U);
}

TEST(ReplayScript, KeepsStopsAndInputEdgesInOrder) {
    FlightRecord edge{};
    edge.tick = 20;
    edge.kind = RecordKind::input_edge;
    edge.signals = bit_of(Signal::r1_limit) | bit_of(Signal::spindle);
    FlightRecord stop{};
    stop.tick = 30;
    stop.kind = RecordKind::stop;
    FlightRecord estop{};
    estop.tick = 31;
    estop.kind = RecordKind::emergency_stop;
    const auto sut = script_from_records({state_change(10, MachineState::ready), edge, stop, estop});
    ASSERT_TRUE(sut.has_value());
    ASSERT_EQ(sut->steps.size(), 3U);
    EXPECT_EQ(sut->steps[0].kind, ReplayStep::Kind::inputs);
    EXPECT_EQ(sut->steps[0].inputs, bit_of(Signal::r1_limit)) << "outputs are the core's own doing";
    EXPECT_EQ(sut->steps[1].kind, ReplayStep::Kind::stop);
    EXPECT_EQ(sut->steps[2].kind, ReplayStep::Kind::emergency_stop);
    EXPECT_EQ(sut->steps[2].tick, 21U);
}

FlightRecord job(std::uint64_t tick) {
    FlightRecord record{};
    record.tick = tick;
    record.kind = RecordKind::job;
    record.answer = static_cast<std::uint32_t>(AnswerKind::done);
    return record;
}

TEST(ReplayScript, BeginsWithTheJobThatTheSnapshotHolds) {
    FlightRecord second = job(300);
    second.position_pulses[2] = 1234;
    const auto sut = script_from_records(
        {job(0), state_change(100, MachineState::ready), command(110, CommandKind::start),
         state_change(200, MachineState::ready), second, command(310, CommandKind::start)});
    ASSERT_TRUE(sut.has_value());
    EXPECT_EQ(sut->first_tick, 300U);
    EXPECT_EQ(sut->start_position_pulses[2], 1234);
    ASSERT_EQ(sut->steps.size(), 1U) << "the first job's start cannot be run again";
    EXPECT_EQ(sut->steps[0].tick, 10U);
}

TEST(ReplayScript, AJobLoadedBeforeHomingBeginsWhenTheMachineIsHomed) {
    const auto sut =
        script_from_records({job(5), command(10, CommandKind::home), state_change(10, MachineState::homing),
                             state_change(100, MachineState::ready), command(110, CommandKind::start)});
    ASSERT_TRUE(sut.has_value());
    EXPECT_EQ(sut->first_tick, 100U);
    EXPECT_EQ(sut->steps.size(), 1U);
}

TEST(ReplayScript, KeepsMissedTicksAndTheCoresOwnFailures) {
    FlightRecord gap{};
    gap.tick = 20;
    gap.kind = RecordKind::gap;
    gap.value = 7;
    FlightRecord failure{};
    failure.tick = 40;
    failure.kind = RecordKind::failure;
    failure.code = static_cast<std::uint16_t>(AlarmCause::missed_ticks);
    const auto sut = script_from_records({state_change(10, MachineState::ready), gap, failure});
    ASSERT_TRUE(sut.has_value());
    ASSERT_EQ(sut->steps.size(), 2U);
    EXPECT_EQ(sut->steps[0].kind, ReplayStep::Kind::gap);
    EXPECT_EQ(sut->steps[0].value, 7U);
    EXPECT_EQ(sut->steps[1].request, cycle::RequestKind::fail);
    EXPECT_EQ(sut->steps[1].value, static_cast<std::uint64_t>(AlarmCause::missed_ticks));
}

TEST(ReplayScript, KnowsOfHowManyGapsMissedTicksAre) {
    FlightRecord gaps{};
    gaps.tick = 20;
    gaps.kind = RecordKind::gap;
    gaps.value = 700;
    for (const int count : {0, 1, 100}) {
        gaps.code = static_cast<std::uint16_t>(count);
        const auto sut = script_from_records({state_change(10, MachineState::ready), gaps});
        ASSERT_TRUE(sut.has_value());
        EXPECT_EQ(sut->steps[0].gap_count, std::max<std::uint64_t>(1, static_cast<std::uint64_t>(count)));
    }
}

FlightRecord order(std::uint64_t tick, OrderPart part, std::uint32_t axis, std::int64_t value) {
    FlightRecord record{};
    record.tick = tick;
    record.kind = RecordKind::order;
    record.code = static_cast<std::uint16_t>(part);
    record.axis = axis;
    record.value = value;
    return record;
}

TEST(ReplayScript, GivesACommandTheOrderThatWasRecordedBeforeIt) {
    FlightRecord let_go{};
    let_go.tick = 60;
    let_go.kind = RecordKind::jog_end;
    let_go.code = static_cast<std::uint16_t>(MoveEnd::lease_gone);
    const auto sut =
        script_from_records({state_change(10, MachineState::ready), order(20, OrderPart::target, 1, 4000),
                             order(20, OrderPart::target, 3, -7), order(20, OrderPart::shape, kNoAxis, 2),
                             order(20, OrderPart::centre, 0, 11), order(20, OrderPart::centre, 1, -12),
                             command(20, CommandKind::move), order(50, OrderPart::target, 2, 1),
                             order(50, OrderPart::speed, kNoAxis, std::bit_cast<std::int64_t>(812.5)),
                             command(50, CommandKind::jog_on), let_go, command(70, CommandKind::home)});
    ASSERT_TRUE(sut.has_value());
    ASSERT_EQ(sut->steps.size(), 4U);
    EXPECT_EQ(sut->steps[0].request, cycle::RequestKind::move);
    EXPECT_EQ(sut->steps[0].order.axes, 0b1010U);
    EXPECT_EQ(sut->steps[0].order.target_pulses, (std::array<std::int64_t, kAxisCount>{0, 4000, 0, -7}));
    EXPECT_EQ(sut->steps[0].order.shape, cycle::OrderShape::arc);
    EXPECT_EQ(sut->steps[0].order.centre_pulses, (std::array<std::int64_t, 2>{11, -12}));
    EXPECT_EQ(sut->steps[1].request, cycle::RequestKind::jog_on);
    EXPECT_EQ(sut->steps[1].order.shape, cycle::OrderShape::straight);
    EXPECT_EQ(sut->steps[1].order.axes, 0b100U);
    EXPECT_EQ(sut->steps[1].order.speed_pps, 812.5);
    EXPECT_EQ(sut->steps[2].request, cycle::RequestKind::end_jog);
    EXPECT_EQ(sut->steps[2].value, static_cast<std::uint64_t>(MoveEnd::lease_gone));
    EXPECT_EQ(sut->steps[3].order.axes, 0U);
}

TEST(ReplayScript, BeginsWithTheOverrideThatHeldThen) {
    FlightRecord slower = command(7, CommandKind::override);
    slower.value = 30;
    FlightRecord slower_rapids = command(8, CommandKind::rapid_override);
    slower_rapids.value = 40;
    const auto script =
        script_from_records({job(5), slower, slower_rapids, command(10, CommandKind::home),
                             state_change(10, MachineState::homing), state_change(100, MachineState::ready),
                             command(110, CommandKind::start)});
    ASSERT_TRUE(script.has_value());
    ASSERT_EQ(script->steps.size(), 3U);
    EXPECT_EQ(script->steps[1].tick, 0U);
    EXPECT_EQ(script->steps[1].request, cycle::RequestKind::rapid_override);
    EXPECT_EQ(script->steps[1].value, 40U);
    EXPECT_EQ(script->steps[0].tick, 0U);
    EXPECT_EQ(script->steps[0].request, cycle::RequestKind::override);
    EXPECT_EQ(script->steps[0].value, 30U);
}

FlightRecord program_command(std::uint64_t tick, std::int64_t number) {
    FlightRecord record = command(tick, CommandKind::program);
    record.axis = kNoAxis;
    record.value = number;
    return record;
}

FlightRecord begun(std::uint64_t tick, std::int64_t number, bool is_single) {
    FlightRecord record{};
    record.tick = tick;
    record.kind = RecordKind::program;
    record.code =
        static_cast<std::uint16_t>(static_cast<unsigned>(ProgramEvent::begun) | (is_single ? 1U : 0U) << 8U);
    record.value = number;
    return record;
}

TEST(ReplayScriptOfAProgram, BeginsAtTheRestBeforeTheLastOne) {
    FlightRecord ready = state_change(300, MachineState::ready);
    ready.position_pulses[2] = 77;
    const auto script = script_of_program(
        {state_change(10, MachineState::ready), begun(20, 8, false), program_command(20, 8), job(200), ready,
         begun(310, 9, true), program_command(310, 9), command(400, CommandKind::hold)},
        9);
    ASSERT_TRUE(script.has_value());
    EXPECT_EQ(script->start_position_pulses[2], 77);
    EXPECT_EQ(script->first_tick, 300U);
    EXPECT_EQ(script->end_tick, 100U);
    EXPECT_FALSE(script->is_cut);
    ASSERT_EQ(script->steps.size(), 2U);
    EXPECT_EQ(script->steps[0].request, cycle::RequestKind::run_program);
    EXPECT_EQ(script->steps[0].value, 9U);
    EXPECT_EQ(script->steps[0].axis, 1U) << "one block at a time";
    EXPECT_EQ(script->steps[0].tick, 10U);
    EXPECT_EQ(script->steps[1].request, cycle::RequestKind::hold);
}

TEST(ReplayScriptOfAProgram, HasTheSpindleOnThatWasOnAndNoRecordingOfPins) {
    FlightRecord ready = state_change(300, MachineState::ready);
    ready.signals = bit_of(Signal::spindle) | bit_of(Signal::y_dir);
    const auto script = script_of_program(
        {ready, command(305, CommandKind::record), begun(310, 9, false), program_command(310, 9)}, 9);
    ASSERT_TRUE(script.has_value());
    EXPECT_EQ(script->start_levels, ready.signals);
    ASSERT_EQ(script->steps.size(), 2U);
    EXPECT_EQ(script->steps[0].request, cycle::RequestKind::spindle);
    EXPECT_EQ(script->steps[0].value, 1U);
    EXPECT_EQ(script->steps[1].request, cycle::RequestKind::run_program);
    EXPECT_EQ(script->steps[1].axis, 0U);
}

// A job that is loaded carves as planned.
TEST(ReplayScriptOfAProgram, HasNoOverrideOfBeforeAJobThatWasLoadedSince) {
    FlightRecord feed = command(301, CommandKind::override);
    feed.value = 50;
    FlightRecord rapids = command(302, CommandKind::rapid_override);
    rapids.value = 30;
    FlightRecord later = command(304, CommandKind::rapid_override);
    later.value = 40;
    const auto script = script_of_program({state_change(300, MachineState::ready), feed, rapids, job(303),
                                           later, begun(310, 9, false), program_command(310, 9)},
                                          9);
    ASSERT_TRUE(script.has_value());
    ASSERT_EQ(script->steps.size(), 2U);
    EXPECT_EQ(script->steps[0].request, cycle::RequestKind::rapid_override);
    EXPECT_EQ(script->steps[0].value, 40U);
    EXPECT_EQ(script->steps[1].request, cycle::RequestKind::run_program);
}

TEST(ReplayScriptOfAProgram, EndsAtTheNextJob) {
    for (const FlightRecord& next : {job(500), command(500, CommandKind::start)}) {
        const auto script = script_of_program(
            {state_change(300, MachineState::ready), begun(310, 9, false), program_command(310, 9),
             command(400, CommandKind::hold), next, command(600, CommandKind::start_interpolation)},
            9);
        ASSERT_TRUE(script.has_value());
        EXPECT_TRUE(script->is_cut);
        EXPECT_EQ(script->end_tick, 100U);
        EXPECT_EQ(script->steps.size(), 2U);
    }
}

TEST(ReplayScriptOfAProgram, IsNothingOfAnotherOneOrWithoutTheRestBeforeIt) {
    EXPECT_FALSE(script_of_program({}, 9).has_value());
    EXPECT_FALSE(script_of_program({begun(310, 9, false), program_command(310, 9)}, 9).has_value());
    EXPECT_FALSE(
        script_of_program(
            {state_change(300, MachineState::ready), begun(310, 9, false), program_command(310, 9)}, 8)
            .has_value());
}

TEST(ReplayScript, IsNothingWithoutARunFromRest) {
    EXPECT_FALSE(script_from_records({}).has_value());
    EXPECT_FALSE(script_from_records({state_change(5, MachineState::ready)}).has_value());
    EXPECT_FALSE(script_from_records({command(1, CommandKind::home)}).has_value());
}

}  // namespace
}  // namespace psicarve::supervisor
