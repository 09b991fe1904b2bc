// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/pin_tracer.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <optional>

namespace psicarve::cycle {
namespace {

using Kind = trace::TraceEntry::Kind;
constexpr PinTracer::Positions kPositions{1, 2, 3, 4};
constexpr PinTracer::Positions kCrossed{0, 7, 0, 3};
constexpr std::uint32_t kToken = 77;

struct TracerRig {
    explicit TracerRig(bool traces_always) {
        io->trace = ring.get();
        io->traces_always = traces_always;
    }
    std::optional<trace::TraceEntry> next() {
        trace::TraceEntry entry;
        if (!ring->pop_into(entry)) return std::nullopt;
        return entry;
    }

    std::unique_ptr<trace::TraceRing> ring = std::make_unique<trace::TraceRing>();
    std::unique_ptr<CycleIo> io = std::make_unique<CycleIo>();
    PinTracer sut{*io};
};

TEST(PinTracer, TellsEveryChangeOnceWithItsTick) {
    TracerRig rig(true);
    rig.sut.trace_change(0, 1);
    EXPECT_FALSE(rig.next().has_value()) << "all pins are low at first";
    rig.sut.trace_change(0b11, 2);
    rig.sut.trace_change(0b11, 3);
    const auto entry = rig.next().value();
    EXPECT_EQ(entry.kind, Kind::pins);
    EXPECT_EQ(entry.levels, 0b11U);
    EXPECT_EQ(entry.tick, 2U);
    EXPECT_EQ(entry.offset_ns, 0U);
    EXPECT_FALSE(rig.next().has_value());
    rig.sut.trace_pins(0b01, 3, 700);
    EXPECT_EQ(rig.next().value().offset_ns, 700U);
    rig.sut.trace_change(0b01, 4);
    EXPECT_FALSE(rig.next().has_value());
}

TEST(PinTracer, IsOffWithoutARing) {
    TracerRig rig(true);
    rig.io->trace = nullptr;
    EXPECT_FALSE(rig.sut.is_on());
    EXPECT_FALSE(rig.sut.can_record());
    rig.sut.trace_change(0b11, 2);
    rig.sut.note_new_position();
    rig.sut.trace_position(0, 2, kPositions);
    rig.sut.trace_job(0, 2, kPositions, 5);
    EXPECT_EQ(rig.sut.lost(), 0U);
    EXPECT_EQ(rig.ring->size(), 0U);
}

TEST(PinTracer, TellsNothingUntilARecordingBegins) {
    TracerRig rig(false);
    rig.sut.trace_change(0b1, 1);
    rig.sut.note_new_position();
    rig.sut.trace_position(0b1, 1, kPositions);
    EXPECT_FALSE(rig.sut.has_new_position()) << "nor later";
    rig.sut.trace_job(0b1, 1, kPositions, 5);
    EXPECT_FALSE(rig.next().has_value());
    ASSERT_TRUE(rig.sut.can_record());
    rig.sut.begin_recording(RecordingForm::vcd, kToken, 0b1, 2, {kPositions, kCrossed});
    const auto begin = rig.next().value();
    EXPECT_EQ(begin.kind, Kind::begin_vcd);
    EXPECT_EQ(begin.token, kToken);
    EXPECT_EQ(begin.levels, 0b1U);
    EXPECT_EQ(begin.position_pulses, kPositions);
    EXPECT_EQ(begin.crossed_pulses, kCrossed);
    rig.sut.trace_change(0b1, 3);
    EXPECT_FALSE(rig.next().has_value()) << "the begin told these levels";
    rig.sut.trace_change(0b10, 4);
    EXPECT_EQ(rig.next().value().levels, 0b10U);
}

TEST(PinTracer, RecordsForOneAtATimeUntilThatOneEndsIt) {
    TracerRig rig(false);
    rig.sut.begin_recording(RecordingForm::binary, kToken, 0, 1, {kPositions, {}});
    EXPECT_EQ(rig.next().value().kind, Kind::begin_binary);
    EXPECT_FALSE(rig.sut.can_record());
    EXPECT_FALSE(rig.sut.end_recording(kToken + 1, 0, 2, kPositions));
    EXPECT_TRUE(rig.sut.is_on());
    EXPECT_TRUE(rig.sut.end_recording(kToken, 0b1, 3, kPositions));
    const auto end = rig.next().value();
    EXPECT_EQ(end.kind, Kind::end);
    EXPECT_EQ(end.token, kToken);
    EXPECT_FALSE(rig.sut.is_on());
    EXPECT_TRUE(rig.sut.end_recording(kToken, 0b1, 4, kPositions)) << "none goes on";
    EXPECT_FALSE(rig.next().has_value());
    rig.sut.begin_recording(RecordingForm::binary, kToken, 0, 5, {kPositions, {}});
    EXPECT_TRUE(rig.sut.end_recording(0, 0, 6, kPositions)) << "whoever's it is";
    EXPECT_TRUE(rig.sut.can_record());
}

TEST(PinTracer, TellsANewPositionOnceAndAJobByItsGeneration) {
    TracerRig rig(true);
    rig.sut.note_new_position();
    EXPECT_TRUE(rig.sut.has_new_position());
    rig.sut.trace_position(0b1, 8, kPositions);
    EXPECT_FALSE(rig.sut.has_new_position());
    const auto position = rig.next().value();
    EXPECT_EQ(position.kind, Kind::position);
    EXPECT_EQ(position.position_pulses, kPositions);
    rig.sut.trace_job(0b1, 9, kPositions, (std::uint64_t{3} << 32U) + 5);
    const auto job = rig.next().value();
    EXPECT_EQ(job.kind, Kind::job);
    EXPECT_EQ(job.token, 5U);
}

TEST(PinTracer, CountsWhatFindsTheRingFullAndTellsTheLevelsLater) {
    TracerRig rig(true);
    for (std::size_t i = 0; i < trace::kTraceRingEntries; ++i)
        rig.sut.trace_change(static_cast<SignalWord>(1 + i % 2), i);
    EXPECT_EQ(rig.sut.lost(), 0U);
    rig.sut.trace_change(0b100, 70'000);
    rig.sut.trace_job(0b100, 70'000, kPositions, 5);
    EXPECT_EQ(rig.sut.lost(), 2U);
    while (rig.next().has_value()) {
    }
    rig.sut.trace_change(0b100, 70'001);
    EXPECT_EQ(rig.next().value().tick, 70'001U);
}

}  // namespace
}  // namespace psicarve::cycle
