// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/machine/recorded_program.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "shared/machine/command.hpp"
#include "shared/machine/unreplayed_program.hpp"

namespace psicarve {
namespace {

FlightRecord record_of(ProgramEvent event, std::int64_t value, std::uint32_t sequence = 0,
                       std::uint8_t detail = 0) {
    FlightRecord record{};
    record.kind = RecordKind::program;
    record.code = recorded_code(event, detail);
    record.axis = kNoAxis;
    record.value = value;
    record.answer = sequence;
    return record;
}

TEST(RecordedProgram, IsTheLastOneAsItsRecordsHaveIt) {
    std::vector<FlightRecord> records{record_of(ProgramEvent::begun, 7'000'000'000, 0, 1)};
    const auto sut = [&] { return recorded_program(records); };
    EXPECT_EQ(sut().program, 7'000'000'000U);
    EXPECT_EQ(sut().is_running, 1U);
    EXPECT_EQ(sut().is_single, 1U);
    EXPECT_EQ(sut().line, 0U);
    records.push_back(record_of(ProgramEvent::line, 8, 34));
    EXPECT_EQ(sut().line, 8U);
    EXPECT_EQ(sut().sequence, 34U);
    for (const std::uint64_t waits : {1U, 2U}) {
        records.push_back(record_of(ProgramEvent::held, 9, 35, 5));
        EXPECT_EQ(sut().hold, ProgramHold::starved);
        EXPECT_EQ(sut().starvations, waits);
        records.push_back(record_of(ProgramEvent::resumed, 9, 35));
        EXPECT_EQ(sut().hold, ProgramHold::none);
    }
    records.push_back(record_of(ProgramEvent::ended, 11, 40, 0));
    EXPECT_EQ(sut().is_running, 0U);
    EXPECT_EQ(sut().is_done, 1U);
    EXPECT_EQ(sut().line, 11U);
    records.push_back(record_of(ProgramEvent::begun, 7'000'000'001));
    EXPECT_EQ(sut().line, 0U);
    EXPECT_EQ(sut().is_done, 0U);
    records.push_back(record_of(ProgramEvent::ended, 2, 3, 1));
    EXPECT_EQ(sut().is_done, 0U);
}

TEST(RecordedProgram, HasStarvedAsOftenAsItsRecordsSay) {
    std::vector<FlightRecord> records{record_of(ProgramEvent::begun, 7),
                                      record_of(ProgramEvent::held, 9, 35, 5)};
    records.back().axis = 4;
    EXPECT_EQ(recorded_program(records).starvations, 4U);
    records.push_back(record_of(ProgramEvent::held, 9, 35, 5));
    records.back().axis = kNoAxis;
    EXPECT_EQ(recorded_program(records).starvations, 5U) << "one of an older core";
    records.push_back(record_of(ProgramEvent::line, 10, 36));
    EXPECT_EQ(recorded_program(records).hold, ProgramHold::none);
}

TEST(RecordedProgram, IsOneLineAtATimeAsItWasSwitchedLast) {
    FlightRecord single{};
    single.kind = RecordKind::command;
    single.code = static_cast<std::uint16_t>(CommandKind::single);
    single.value = 1;
    single.answer = static_cast<std::uint32_t>(AnswerKind::refused);
    std::vector<FlightRecord> records{record_of(ProgramEvent::begun, 7), single};
    EXPECT_EQ(recorded_program(records).is_single, 0U);
    records.back().answer = static_cast<std::uint32_t>(AnswerKind::done);
    EXPECT_EQ(recorded_program(records).is_single, 1U);
    records.push_back(records.back());
    records.back().value = 0;
    EXPECT_EQ(recorded_program(records).is_single, 0U);
}

TEST(RecordedProgram, WaitsAtM1AsItWasBegunAndSwitchedLast) {
    std::vector<FlightRecord> records{record_of(ProgramEvent::begun, 7)};
    records[0].code = recorded_code(ProgramEvent::begun, kProgramStopsAtOptional);
    EXPECT_EQ(recorded_program(records).stops_at_optional, 1U);
    EXPECT_EQ(recorded_program(records).is_single, 0U);
    FlightRecord off{};
    off.kind = RecordKind::command;
    off.code = static_cast<std::uint16_t>(CommandKind::optional_stop);
    off.answer = static_cast<std::uint32_t>(AnswerKind::done);
    records.push_back(off);
    EXPECT_EQ(recorded_program(records).stops_at_optional, 0U);
}

// That of a core that is no more is told by its guard, which knows of no program.
TEST(RecordedProgram, EndsWithAnAlarm) {
    FlightRecord alarm{};
    alarm.kind = RecordKind::alarm;
    const std::vector<FlightRecord> records{record_of(ProgramEvent::begun, 7),
                                            record_of(ProgramEvent::held, 8, 34, 3), alarm};
    const ProgramStatus sut = recorded_program(records);
    EXPECT_EQ(sut.is_running, 0U);
    EXPECT_EQ(sut.hold, ProgramHold::none);
    EXPECT_EQ(sut.line, 8U);
    EXPECT_EQ(sut.is_done, 0U);
}

TEST(RecordedProgram, IsNoneWhereNoneWasRunAndHasNoNumberWhereItsBeginningIsLost) {
    FlightRecord other{};
    other.kind = RecordKind::gap;
    other.value = 5;
    const ProgramStatus none = recorded_program(std::vector{other});
    EXPECT_EQ(none.program, 0U);
    EXPECT_EQ(none.line, 0U);
    EXPECT_EQ(none.is_running, 0U);
    const ProgramStatus late = recorded_program(std::vector{record_of(ProgramEvent::resumed, 5, 6)});
    EXPECT_EQ(late.program, 0U);
    EXPECT_EQ(late.line, 5U);
    EXPECT_EQ(late.is_running, 1U);
}

// A file may hold anything.
TEST(RecordedProgram, TakesNoEventAndNoReasonThatItDoesNotKnow) {
    FlightRecord record = record_of(ProgramEvent::begun, 7);
    record.code = 0xFF06;
    EXPECT_EQ(recorded_program(std::vector{record}).program, 0U);
    EXPECT_EQ(recorded_program(std::vector{record}).is_running, 0U);
    record = record_of(ProgramEvent::held, 8, 34, 200);
    EXPECT_EQ(recorded_program(std::vector{record}).hold, ProgramHold::none);
}

TEST(RecordedProgram, TellsWhyItIsNotReplayedWhereThereIsOne) {
    EXPECT_EQ(unreplayed_program_text({}), "");
    std::vector records{record_of(ProgramEvent::begun, 7)};
    EXPECT_NE(unreplayed_program_text(records).find("in G-code, before its first line, "), std::string::npos);
    records.push_back(record_of(ProgramEvent::held, 8, 34));
    EXPECT_NE(unreplayed_program_text(records).find("a program in G-code, up to line 8, "),
              std::string::npos);
}

TEST(RecordedProgram, TakesTheLargestSequenceThatFits) {
    EXPECT_EQ(recorded_sequence(0xFFFF'FFFE), 0xFFFF'FFFEU);
    EXPECT_EQ(recorded_sequence(0x1'0000'0005), 0xFFFF'FFFFU);
}

}  // namespace
}  // namespace psicarve
