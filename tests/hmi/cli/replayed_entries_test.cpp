// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/replayed_entries.hpp"

#include <gtest/gtest.h>

#include "shared/machine/command.hpp"
#include "shared/machine/recorded_program.hpp"

namespace psicarve::cli {
namespace {

using Entries = std::vector<FlightRecord>;

FlightRecord entry(std::uint64_t tick, RecordKind kind, unsigned code = 0, std::int64_t value = 0) {
    FlightRecord record{};
    record.tick = tick;
    record.kind = kind;
    record.code = static_cast<std::uint16_t>(code);
    record.value = value;
    return record;
}

FlightRecord event(std::uint64_t tick, ProgramEvent what, std::int64_t value) {
    return entry(tick, RecordKind::program, static_cast<unsigned>(what), value);
}

FlightRecord done(FlightRecord record) {
    record.answer = static_cast<std::uint32_t>(AnswerKind::done);
    return record;
}

TEST(ReplayedEntries, AreThoseOfTheLastProgramUpToTheNextJob) {
    const Entries all{event(10, ProgramEvent::begun, 4),   event(20, ProgramEvent::ended, 2),
                      entry(30, RecordKind::state_change), event(40, ProgramEvent::begun, 5),
                      entry(41, RecordKind::input_edge),   entry(42, RecordKind::alarm),
                      done(entry(50, RecordKind::job)),    entry(60, RecordKind::state_change)};
    const Entries found = entries_of_program(all, 5);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].tick, 40U);
    EXPECT_EQ(found[1].tick, 42U);
    EXPECT_TRUE(entries_of_program(all, 4).empty()) << "not the last one";
    EXPECT_TRUE(entries_of_program({}, 5).empty());
    Entries started{all.begin() + 3, all.begin() + 6};
    started.push_back(done(entry(45, RecordKind::command, static_cast<unsigned>(CommandKind::start))));
    started.push_back(entry(46, RecordKind::state_change));
    EXPECT_EQ(entries_of_program(started, 5).size(), 2U);
}

TEST(ReplayedEntries, OfACoreThatRecordedNoGapsAreTheSame) {
    const auto ready = static_cast<unsigned>(MachineState::ready);
    const Entries old{event(10, ProgramEvent::begun, 5), entry(20, RecordKind::state_change, ready)};
    Entries replayed{event(10, ProgramEvent::begun, 5), entry(20, RecordKind::state_change, ready, 7)};
    EXPECT_EQ(compare_entries(old, replayed).same_count, 2U);
    const Entries recorded = replayed;
    replayed[1].value = 8;
    EXPECT_EQ(compare_entries(recorded, replayed).same_count, 1U);
}

TEST(ReplayedEntries, AreComparedFromTheBeginOfEach) {
    Entries recorded{event(1000, ProgramEvent::begun, 5), event(1500, ProgramEvent::held, 7),
                     entry(1600, RecordKind::alarm, 2, 9)};
    Entries replayed{event(70, ProgramEvent::begun, 5), event(570, ProgramEvent::held, 7),
                     entry(670, RecordKind::alarm, 2, 1), entry(700, RecordKind::state_change)};
    EntryComparison found = compare_entries(recorded, replayed);
    EXPECT_EQ(found.same_count, 3U) << "a core counts its own alarms";
    EXPECT_FALSE(found.first_other.has_value());
    EXPECT_EQ(found.most_ticks, 0U);
    EXPECT_EQ(found.most_pulses, 0);
    replayed[1].tick -= 4;
    replayed[2].position_pulses[3] = -6;
    found = compare_entries(recorded, replayed);
    EXPECT_FALSE(found.first_other.has_value());
    EXPECT_EQ(found.most_ticks, 4U);
    EXPECT_EQ(found.most_pulses, 6);
}

TEST(ReplayedEntries, ThatAreNotRepeatedAreNamed) {
    const Entries recorded{event(1, ProgramEvent::begun, 5), event(9, ProgramEvent::held, 7)};
    for (const Entries& replayed :
         {Entries{event(1, ProgramEvent::begun, 5)},
          Entries{event(1, ProgramEvent::begun, 5), event(9, ProgramEvent::held, 8)},
          Entries{event(1, ProgramEvent::begun, 5), event(9, ProgramEvent::resumed, 7)}}) {
        const EntryComparison found = compare_entries(recorded, replayed);
        EXPECT_EQ(found.same_count, 1U);
        ASSERT_TRUE(found.first_other.has_value());
        EXPECT_EQ(found.first_other->tick, 9U);
    }
    EXPECT_TRUE(compare_entries(recorded, {}).first_other.has_value());
}

TEST(ReplayedEntries, LieNoFurtherApartThanTheirRecorderLeavesUntold) {
    constexpr std::int64_t kPeriod_ns = 50'000;
    const Entries entries{event(1000, ProgramEvent::begun, 5), event(9000, ProgramEvent::ended, 7)};
    Entries all{entry(900, RecordKind::gap, 1, 800), entry(1200, RecordKind::gap, 3, 25),
                entry(9100, RecordKind::gap, 1, 900)};
    EXPECT_EQ(untold_ticks(entries, all, kPeriod_ns), 4000U + 25U) << "200 ms, and those missed meanwhile";
    EXPECT_EQ(untold_ticks({}, all, kPeriod_ns), 0U);
    EXPECT_EQ(untold_ticks(entries, all, 0), 0U);
    all[1].value = -5;
    EXPECT_EQ(untold_ticks(entries, all, kPeriod_ns), 4000U);
    EntryComparison found;
    found.most_ticks = 4025;
    found.most_pulses = 3;
    EXPECT_TRUE(is_as_recorded(found, 4025));
    EXPECT_FALSE(is_as_recorded(found, 4024));
    EXPECT_FALSE(is_as_recorded(found, 0)) << "a virtual clock's is repeated to the tick";
    found.most_ticks = 0;
    EXPECT_FALSE(is_as_recorded(found, 4025)) << "elsewhere at the very tick";
    found.most_pulses = 0;
    EXPECT_TRUE(is_as_recorded(found, 0));
    found.first_other = entries[1];
    EXPECT_FALSE(is_as_recorded(found, 4025));
}

}  // namespace
}  // namespace psicarve::cli
