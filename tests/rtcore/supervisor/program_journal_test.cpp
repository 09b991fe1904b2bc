// SPDX-License-Identifier: GPL-3.0-or-later
// What the journal keeps of a program.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "rtcore/journal/journal.hpp"
#include "shared/machine/recorded_program.hpp"
#include "shared/record/journal_file.hpp"
#include "tests/shared/temporary_folder.hpp"

namespace psicarve::supervisor {
namespace {

using Whats = std::vector<std::string>;

class ProgramJournalTest : public ::testing::Test {
protected:
    void note(RecordKind kind, std::uint16_t code, std::int64_t value = 0) {
        cycle::Report report{};
        report.record.kind = kind;
        report.record.code = code;
        report.record.axis = kNoAxis;
        report.record.value = value;
        sut_.note_report(report, {}, nullptr);
    }
    void note(ProgramEvent event, std::int64_t value, ProgramHold hold = ProgramHold::none) {
        note(RecordKind::program, recorded_code(event, static_cast<std::uint8_t>(hold)), value);
    }
    void note(MachineState state) { note(RecordKind::state_change, static_cast<std::uint16_t>(state)); }
    void begin(std::uint8_t single = 0) {
        note(RecordKind::program, recorded_code(ProgramEvent::begun, single), 7);
        note(MachineState::carving);
    }
    void hold(std::int64_t line, ProgramHold why) {
        note(MachineState::holding);
        note(ProgramEvent::held, line, why);
        note(MachineState::held);
    }
    void resume(std::int64_t line) {
        note(ProgramEvent::resumed, line);
        note(MachineState::carving);
    }
    void end(std::int64_t line) {
        note(ProgramEvent::ended, line);
        note(MachineState::ready);
        sut_.note_end({});
    }
    std::vector<JournalRecord> records() const {
        auto read = read_journal(JournalFiles{StateNames{folder_.path("state"), "/shop", true}});
        return read ? std::move(*read) : std::vector<JournalRecord>{};
    }
    Whats whats() const {
        Whats words;
        for (const JournalRecord& record : records()) words.push_back(record.what);
        return words;
    }

    test::TemporaryFolder folder_;
    JournalPlace place_{folder_.path("state"), "/shop", true};
    Journal sut_{{place_, 0x1234, "sim", true}};
};

TEST_F(ProgramJournalTest, TellsWhereItWasHeldAndWentOn) {
    begin();
    hold(8, ProgramHold::tool_change);
    resume(8);
    hold(9, ProgramHold::none);
    resume(9);
    end(12);
    ASSERT_EQ(whats(), (Whats{"start", "program started", "program held", "program resumed", "program held",
                              "program resumed", "program ended", "end"}));
    const auto all = records();
    EXPECT_EQ(all[1].facts.number("number"), 7);
    EXPECT_FALSE(all[1].facts.number("single"));
    EXPECT_EQ(all[2].facts.text("how"), "tool change");
    EXPECT_EQ(all[2].facts.number("line"), 8);
    EXPECT_EQ(all[3].facts.number("line"), 8);
    EXPECT_EQ(all[4].facts.text("how"), "");
    EXPECT_EQ(all[6].facts.text("how"), "done");
    EXPECT_EQ(all[6].facts.number("line"), 12);
    EXPECT_FALSE(all[6].facts.number("waits"));
}

TEST_F(ProgramJournalTest, TellsOneWaitForRecordsAndHowManyThereWere) {
    begin();
    for (std::int64_t line = 1; line <= 100; ++line) hold(line, ProgramHold::starved);
    hold(100, ProgramHold::single);
    resume(100);
    end(101);
    ASSERT_EQ(whats(), (Whats{"start", "program started", "program held", "program ended", "end"}));
    EXPECT_EQ(records()[2].facts.text("how"), "starved");
    EXPECT_EQ(records()[3].facts.number("waits"), 100);
}

TEST_F(ProgramJournalTest, TellsNoBlockOfOneAtATime) {
    begin(1);
    hold(1, ProgramHold::single);
    resume(1);
    end(2);
    ASSERT_EQ(whats(), (Whats{"start", "program started", "program ended", "end"}));
    EXPECT_EQ(records()[1].facts.number("single"), 1);
}

}  // namespace
}  // namespace psicarve::supervisor
