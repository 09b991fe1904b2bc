// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/replay/entry.hpp"

#include <gtest/gtest.h>

#include "shared/machine/command.hpp"
#include "shared/machine/recorded_program.hpp"

namespace psicarve::replay {
namespace {

// A file may say what it likes.
TEST(TimeOfTicks, StaysATime) {
    EXPECT_EQ(time_of_ticks(3, 50'000), 150'000);
    EXPECT_EQ(time_of_ticks(7, 0), 7);
    const auto all = std::numeric_limits<std::uint64_t>::max();
    EXPECT_GT(time_of_ticks(all, 50'000), 0);
    EXPECT_LE(time_of_ticks(all, 50'000), kLatest_ns);
    EXPECT_EQ(time_of_ticks(all, std::numeric_limits<std::int64_t>::max()), 0);
}

using session::Severity;

std::string text_of(const Entry& entry) {
    return in_english(entry.what);
}

TEST(ReplayEntry, SaysWhatTheFlightRecorderHolds) {
    FlightRecord record{};
    record.kind = RecordKind::command;
    record.code = static_cast<std::uint16_t>(CommandKind::home);
    record.answer = static_cast<std::uint32_t>(AnswerKind::done);
    EXPECT_EQ(text_of(entry_of(record, 0)), "Command: home");
    record.answer = static_cast<std::uint32_t>(AnswerKind::refused);
    EXPECT_EQ(text_of(entry_of(record, 0)), "Refused: home");
    EXPECT_EQ(entry_of(record, 0).severity, Severity::warning);
    record.kind = RecordKind::alarm;
    record.code = static_cast<std::uint16_t>(AlarmCause::limit);
    record.axis = 1;
    EXPECT_EQ(text_of(entry_of(record, 7)), "Alarm: limit of R2");
    EXPECT_EQ(entry_of(record, 7).severity, Severity::alarm);
    EXPECT_EQ(entry_of(record, 7).time_ns, 7);
    record.kind = static_cast<RecordKind>(999);
    EXPECT_EQ(text_of(entry_of(record, 0)), "Entry of kind 999");
}

Entry program_entry(ProgramEvent event, std::uint8_t detail = 0) {
    FlightRecord record{};
    record.kind = RecordKind::program;
    record.code = recorded_code(event, detail);
    record.value = 12;
    return entry_of(record, 0);
}

TEST(ReplayEntry, SaysWhereAProgramWasAndWhatHappenedToIt) {
    const auto words = [](ProgramEvent event, std::uint8_t detail = 0) {
        return text_of(program_entry(event, detail));
    };
    EXPECT_EQ(words(ProgramEvent::begun), "Program begun");
    EXPECT_EQ(words(ProgramEvent::line), "Program, line 12");
    EXPECT_EQ(words(ProgramEvent::held), "Program held in line 12");
    EXPECT_EQ(words(ProgramEvent::held, 3), "Program held in line 12: tool change (M6)");
    EXPECT_EQ(words(ProgramEvent::held, 99), "Program held in line 12");
    EXPECT_EQ(words(ProgramEvent::resumed), "Program goes on in line 12");
    EXPECT_EQ(words(ProgramEvent::stopping), "Program slows down to a stop in line 12");
    EXPECT_EQ(words(ProgramEvent::ended, 0), "Program done, up to line 12");
    EXPECT_EQ(words(ProgramEvent::ended, 1), "Program stopped in line 12");
    EXPECT_EQ(words(ProgramEvent::ended, 2), "Program ended by an alarm in line 12");
    EXPECT_EQ(words(static_cast<ProgramEvent>(77)), "Entry of kind 13");
    EXPECT_EQ(program_entry(ProgramEvent::held, 6).severity, Severity::warning);
    EXPECT_EQ(program_entry(ProgramEvent::ended, 2).severity, Severity::warning);
    EXPECT_TRUE(program_entry(ProgramEvent::held, 3).is_major);
    EXPECT_FALSE(program_entry(ProgramEvent::held, 4).is_major) << "every block";
    EXPECT_FALSE(program_entry(ProgramEvent::line).is_major);
}

TEST(ReplayEntry, ReadsDrivesSpindleAndSwitchesOffThePins) {
    const SignalWord drives = kEnableMask;
    const SignalWord spindle = bit_of(Signal::spindle);
    const SignalWord limit = bit_of(Signal::y_limit);
    const auto entries = entries_of({{10, 0, drives, false},
                                     {20, drives, drives | spindle | limit, false},
                                     {30, drives, drives, true},
                                     {40, drives | limit, limit | bit_of(Signal::estop), false}});
    std::vector<std::string> texts;
    for (const Entry& entry : entries) texts.push_back(std::to_string(entry.time_ns) + " " + text_of(entry));
    EXPECT_EQ(texts,
              (std::vector<std::string>{"10 Drives switched on", "20 Spindle on", "20 Limit switch Y closed",
                                        "30 Homing: positions defined", "40 Drives switched off",
                                        "40 Emergency stop switch pressed"}));
    EXPECT_EQ(entries.back().severity, Severity::alarm);
}

TEST(ReplayEntry, FindsItsNeighboursInTime) {
    std::vector<Entry> entries(3);
    entries[0].time_ns = 10;
    entries[1].time_ns = 20;
    entries[2].time_ns = 20;
    EXPECT_EQ(entry_at(entries, 9), -1);
    EXPECT_EQ(entry_at(entries, 20), 2);
    EXPECT_EQ(next_entry(entries, 10), 1);
    EXPECT_EQ(next_entry(entries, 20), -1);
    EXPECT_EQ(entry_before(entries, 20), 0);
    EXPECT_EQ(entry_before(entries, 10), -1);
    EXPECT_EQ(next_entry({}, 0), -1);
}

}  // namespace
}  // namespace psicarve::replay
