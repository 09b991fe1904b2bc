// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/flight_log.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace psicarve::supervisor {
namespace {

FlightRecord record_at(std::uint64_t tick, RecordKind kind, std::int64_t value = 0, std::uint16_t code = 0) {
    FlightRecord record{};
    record.tick = tick;
    record.kind = kind;
    record.value = value;
    record.code = code;
    return record;
}

FlightRecord gap_at(std::uint64_t tick, std::int64_t missed, std::uint32_t longest_harmless = kAnyGap) {
    FlightRecord record = record_at(tick, RecordKind::gap, missed, 1);
    record.answer = longest_harmless;
    return record;
}

FlightRecord line_at(std::uint64_t tick, std::int64_t line) {
    return record_at(tick, RecordKind::program, line, recorded_code(ProgramEvent::line));
}

class FlightLogTest : public testing::Test {
protected:
    std::vector<FlightRecord> kept() const {
        RingReader reader{*ring_};
        std::vector<FlightRecord> records;
        while (const auto record = reader.next()) records.push_back(*record);
        return records;
    }
    std::unique_ptr<FlightRecorder> ring_ = std::make_unique<FlightRecorder>();
    FlightLog sut_;
};

// Two years of an idle core on a busy computer.
TEST_F(FlightLogTest, NoFloodOfMissedTicksPushesAnythingOut) {
    sut_.append(*ring_, record_at(7, RecordKind::alarm));
    for (std::uint64_t i = 0; i < 10 * kFlightRecords; ++i) sut_.append(*ring_, gap_at(10 + i, 3));
    const auto records = kept();
    ASSERT_EQ(records.size(), 2U);
    EXPECT_EQ(records[0].kind, RecordKind::alarm);
    EXPECT_EQ(records[1].tick, 10U) << "of the first";
    EXPECT_EQ(records[1].value, static_cast<std::int64_t>(30 * kFlightRecords));
    EXPECT_EQ(records[1].code, 0xFFFF) << "as many as can be said";
}

TEST_F(FlightLogTest, HalfOfTheRecordsAreNeverCounters) {
    for (std::uint64_t i = 0; i < kFlightRecords / 2; ++i) {
        for (int k = 0; k < 20; ++k) sut_.append(*ring_, gap_at(3 * i, 1));
        sut_.append(*ring_, record_at(3 * i + 1, RecordKind::command));
    }
    const auto records = kept();
    ASSERT_EQ(records.size(), kFlightRecords);
    EXPECT_EQ(records.front().value, 20);
    EXPECT_EQ(records[1].tick, 1U) << "the first command is still there";
}

TEST_F(FlightLogTest, WhatComesBetweenEndsACounter) {
    sut_.append(*ring_, gap_at(1, 3));
    sut_.append(*ring_, gap_at(2, 4));
    sut_.append(*ring_, record_at(3, RecordKind::command));
    sut_.append(*ring_, gap_at(4, 5));
    const auto records = kept();
    ASSERT_EQ(records.size(), 3U);
    EXPECT_EQ(records[0].value, 7);
    EXPECT_EQ(records[2].value, 5);
}

TEST_F(FlightLogTest, AGapThatWasAnAlarmIsCountedWithNoOther) {
    for (const std::uint32_t longest : {49U, kAnyGap}) {
        sut_.append(*ring_, record_at(1, RecordKind::command));
        sut_.append(*ring_, gap_at(2, 2, longest));
        sut_.append(*ring_, gap_at(3, 60, kAlarmingGap));
        sut_.append(*ring_, gap_at(4, 2, longest));
    }
    const auto records = kept();
    ASSERT_EQ(records.size(), 8U);
    for (const std::size_t n : {2U, 6U}) {
        EXPECT_EQ(records[n].value, 60);
        EXPECT_EQ(records[n].code, 1);
    }
}

// In a replay all come where the first one was.
TEST_F(FlightLogTest, WhatIsHarmlessAtRestAloneIsNotCountedInMotion) {
    sut_.append(*ring_, gap_at(1, 2, 49));
    sut_.append(*ring_, gap_at(2, 49, 80));
    sut_.append(*ring_, gap_at(3, 50));
    sut_.append(*ring_, gap_at(4, 3, 49));
    sut_.append(*ring_, gap_at(5, 5000));
    const auto records = kept();
    ASSERT_EQ(records.size(), 2U);
    EXPECT_EQ(records[0].value, 51);
    EXPECT_EQ(records[0].code, 2);
    EXPECT_EQ(records[1].tick, 3U);
    EXPECT_EQ(records[1].value, 5053);
    EXPECT_EQ(records[1].code, 3);
}

TEST_F(FlightLogTest, NoAverageIsLongerThanItsGaps) {
    constexpr std::int64_t kGaps = 70'000;
    for (std::int64_t n = 0; n < kGaps; ++n) sut_.append(*ring_, gap_at(1, 40, 49));
    const auto records = kept();
    ASSERT_EQ(records.size(), 2U);
    EXPECT_EQ(records[0].code, 0xFFFF);
    EXPECT_EQ(records[1].code, kGaps - 0xFFFF);
    for (const FlightRecord& record : records) EXPECT_EQ(record.value, 40 * std::int64_t{record.code});
}

// A program runs for weeks on a busy computer.
TEST_F(FlightLogTest, NoLinesAndMissedTicksOfAProgramPushAnythingOut) {
    sut_.append(*ring_, record_at(7, RecordKind::alarm));
    const auto flights = static_cast<std::int64_t>(kFlightRecords);
    for (std::int64_t i = 0; i < 4 * flights; ++i) {
        const auto tick = static_cast<std::uint64_t>(10 + 3 * i);
        sut_.append(*ring_, line_at(tick, i));
        sut_.append(*ring_, gap_at(tick + 1, 3));
        if (i % 2 == 0) sut_.append(*ring_, gap_at(tick + 2, 1));
    }
    const auto records = kept();
    ASSERT_EQ(records.size(), 4U);
    EXPECT_EQ(records[0].kind, RecordKind::alarm);
    EXPECT_EQ(records[1].value, 0) << "the line before the first gap";
    EXPECT_EQ(records[2].tick, 11U);
    EXPECT_EQ(records[2].value, 14 * flights);
    EXPECT_TRUE(is_of_program(records[3], ProgramEvent::line));
    EXPECT_EQ(records[3].value, 4 * flights - 1) << "and the last";
    EXPECT_EQ(records[3].tick, static_cast<std::uint64_t>(12 * flights + 7));
}

TEST_F(FlightLogTest, ALineReplacesNothingButTheLineBefore) {
    sut_.append(*ring_, line_at(1, 5));
    sut_.append(*ring_, line_at(2, 6));
    sut_.append(*ring_, record_at(3, RecordKind::command));
    sut_.append(*ring_, line_at(4, 7));
    sut_.append(*ring_, record_at(5, RecordKind::program, 7, recorded_code(ProgramEvent::held, 1)));
    sut_.append(*ring_, line_at(6, 8));
    sut_.append(*ring_, gap_at(7, 60, kAlarmingGap));
    sut_.append(*ring_, line_at(8, 9));
    sut_.append(*ring_, gap_at(9, 2, 49));
    std::vector<std::uint64_t> ticks;
    for (const FlightRecord& record : kept()) ticks.push_back(record.tick);
    EXPECT_EQ(ticks, (std::vector<std::uint64_t>{2, 3, 4, 5, 6, 7, 8, 9}));
}

TEST_F(FlightLogTest, ANewSegmentBeginsWithNoLineOfTheOldOne) {
    sut_.append(*ring_, gap_at(1, 3));
    sut_.append(*ring_, line_at(2, 5));
    auto fresh = std::make_unique<FlightRecorder>();
    sut_.begin_anew();
    sut_.append(*fresh, line_at(9, 6));
    EXPECT_EQ(fresh->published.load(), 1U);
}

TEST_F(FlightLogTest, ANewSegmentBeginsWithNoCounterOfTheOldOne) {
    sut_.append(*ring_, gap_at(1, 3));
    auto fresh = std::make_unique<FlightRecorder>();
    sut_.begin_anew();
    sut_.append(*fresh, gap_at(9, 4));
    EXPECT_EQ(fresh->published.load(), 1U);
    ring_ = std::move(fresh);
    EXPECT_EQ(kept().front().value, 4);
}

}  // namespace
}  // namespace psicarve::supervisor
