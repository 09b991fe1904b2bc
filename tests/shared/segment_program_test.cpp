// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/segment/segment_program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

#include "shared/computer/process_identity.hpp"
#include "shared/segment/shared_record.hpp"
#include "tests/shared/record_fixture.hpp"
#include "tests/shared/segment_fixture.hpp"

namespace psicarve {
namespace {

using std::chrono::milliseconds;
using test::numbered_record;
using testing::HasSubstr;

class SegmentProgram : public test::SegmentOfTwo {
protected:
    void SetUp() override {
        SegmentOfTwo::SetUp();
        ASSERT_TRUE(core_->claim_core().has_value());
        desk_.emplace(*core_);
    }
    ProgramControl& control() { return core_->header().program; }
    /// The core answers the writer's question in a thread of its own, as the writer waits for it.
    std::optional<ProgramFeed> open_for(ProgramWriter& writer, std::uint64_t first = 0) {
        std::optional<ProgramFeed> feed;
        std::thread core{[&] {
            while (!(feed = desk_->open(first))) std::this_thread::yield();
        }};
        const auto begun = writer.begin(milliseconds{60'000});
        core.join();
        EXPECT_TRUE(begun.has_value());
        return feed;
    }
    /// A claim as a process leaves that was killed.
    void claim_as_dead() {
        constexpr std::uint64_t kDeadPid = 4'194'300;
        control().claim.store((kDeadPid << 32U) | 77U);
        control().claim_start_time.store(1);
    }
    static MotionRecord end_record() {
        MotionRecord record{};
        record.kind = MotionKind::end;
        record.line = 9;
        return record;
    }
    std::optional<ProgramDesk> desk_;
};

TEST_F(SegmentProgram, RecordsGoFromTheWriterToTheCoreWithNumberAndSequence) {
    ProgramWriter writer = ProgramWriter::claim(*hmi_).value();
    std::optional<ProgramFeed> feed = open_for(writer);
    ASSERT_TRUE(feed.has_value());

    for (int i = 0; i < 3; ++i) ASSERT_EQ(writer.put(numbered_record(55)), ProgramPut::done);

    for (std::uint64_t sequence = 1; sequence <= 3; ++sequence) {
        MotionRecord record{};
        ASSERT_EQ(feed->take(record), RingAnswer::done);
        EXPECT_EQ(record.program, writer.program());
        EXPECT_EQ(record.sequence, sequence);
    }
    EXPECT_EQ(program_report(*hmi_).running, writer.program());
    EXPECT_EQ(program_report(*hmi_).writer_pid, own_pid());
}

TEST_F(SegmentProgram, WhatAWriterTellsOfItsModesIsReadWithItsProgramOnly) {
    ProgramWriter writer = ProgramWriter::claim(*hmi_).value();
    ASSERT_TRUE(open_for(writer).has_value());
    ProgramStatus status{};
    status.program = writer.program();
    desk_->tell(status);
    EXPECT_FALSE(program_report(*hmi_).modes.has_value());

    ProgramModes modes{};
    modes.line = 3;
    modes.g_codes.fill(-1);
    modes.g_codes[0] = 540;
    writer.tell(modes);

    const auto told = program_report(*hmi_).modes;
    ASSERT_TRUE(told.has_value());
    EXPECT_EQ(told->program, writer.program());
    EXPECT_EQ(told->line, 3U);
    EXPECT_EQ(told->g_codes[0], 540);
    ++status.program;
    desk_->tell(status);
    EXPECT_FALSE(program_report(*hmi_).modes.has_value());
}

TEST_F(SegmentProgram, ASecondWriterIsRefusedWithThePidOfTheFirst) {
    const ProgramWriter first = ProgramWriter::claim(*hmi_).value();

    const auto second = ProgramWriter::claim(*hmi_);

    ASSERT_FALSE(second.has_value());
    EXPECT_EQ(second.error().code, ErrorCode::machine_refused);
    EXPECT_EQ(second.error().said.id, MessageId::program_has_writer);
    EXPECT_EQ(second.error().said.arguments[0].bits, own_pid());
    EXPECT_THAT(second.error().message, HasSubstr(std::to_string(own_pid())));
}

TEST_F(SegmentProgram, AClaimEndsWithItsWriter) {
    {
        ProgramWriter first = ProgramWriter::claim(*hmi_).value();
        const ProgramWriter moved = std::move(first);
        EXPECT_NE(control().claim.load(), 0U);
    }
    EXPECT_EQ(control().claim.load(), 0U);
    EXPECT_TRUE(ProgramWriter::claim(*hmi_).has_value());
}

TEST_F(SegmentProgram, TheClaimOfADeadWriterIsTakenByTheNext) {
    claim_as_dead();

    const auto next = ProgramWriter::claim(*hmi_);

    ASSERT_TRUE(next.has_value());
    EXPECT_EQ(program_report(*core_).writer_pid, own_pid());
}

TEST_F(SegmentProgram, TheCoreFreesTheClaimOfADeadWriterThatItSees) {
    claim_as_dead();

    EXPECT_FALSE(desk_->waiting_writer().has_value());

    EXPECT_EQ(control().claim.load(), 0U);
}

TEST_F(SegmentProgram, ALivingProcessThatGotTheDeadWritersPidHasNoClaim) {
    control().claim.store((std::uint64_t{own_pid()} << 32U) | 77U);
    control().claim_start_time.store(process_start_time(own_pid()) + 1);

    EXPECT_TRUE(ProgramWriter::claim(*hmi_).has_value());
}

TEST_F(SegmentProgram, NumbersAreNeverZeroAndNeverComeAgain) {
    std::uint64_t before = 0;
    for (int i = 0; i < 3; ++i) {
        ProgramWriter writer = ProgramWriter::claim(*hmi_).value();
        ASSERT_TRUE(open_for(writer).has_value());
        EXPECT_GT(writer.program(), before);
        before = writer.program();
        desk_->end();
        // Of a segment that follows on a lost one.
        desk_.emplace(*core_, desk_->last_program());
    }
}

TEST_F(SegmentProgram, OneWriterMayWriteSeveralProgramsOneAfterAnother) {
    ProgramWriter writer = ProgramWriter::claim(*hmi_).value();
    for (int i = 0; i < 3; ++i) {
        std::optional<ProgramFeed> feed = open_for(writer);
        ASSERT_EQ(writer.put(end_record()), ProgramPut::done);
        MotionRecord record{};
        ASSERT_EQ(feed->take(record), RingAnswer::done);
        EXPECT_EQ(record.sequence, 1U);
        EXPECT_EQ(record.program, feed->program());
        desk_->end();
    }
}

TEST_F(SegmentProgram, OnlyAWriterThatAsksGetsAProgram) {
    const ProgramWriter writer = ProgramWriter::claim(*hmi_).value();

    EXPECT_FALSE(desk_->waiting_writer().has_value());
    EXPECT_FALSE(desk_->open().has_value());
}

TEST_F(SegmentProgram, WhoGivesUpWaitingHasNotAsked) {
    ProgramWriter writer = ProgramWriter::claim(*hmi_).value();

    const auto begun = writer.begin(milliseconds{5});

    ASSERT_FALSE(begun.has_value());
    EXPECT_EQ(begun.error().code, ErrorCode::timed_out);
    EXPECT_FALSE(desk_->open().has_value());
}

TEST_F(SegmentProgram, WithoutACoreNoProgramBegins) {
    core_->release_core();
    ProgramWriter writer = ProgramWriter::claim(*hmi_).value();

    const auto begun = writer.begin(milliseconds{60'000});

    ASSERT_FALSE(begun.has_value());
    EXPECT_EQ(begun.error().code, ErrorCode::no_core);
}

TEST_F(SegmentProgram, AFullRingIsSaidAfterTheLimitAndAnEndedCoreAtOnce) {
    ProgramWriter writer = ProgramWriter::claim(*hmi_).value();
    ASSERT_TRUE(open_for(writer).has_value());
    for (std::uint32_t i = 0; i < kDefaultRingRecords; ++i)
        ASSERT_EQ(writer.try_put(numbered_record(1)), ProgramPut::done);

    EXPECT_EQ(writer.try_put(numbered_record(1)), ProgramPut::full);
    EXPECT_EQ(writer.put_for(numbered_record(1), milliseconds{1}), ProgramPut::full);
    EXPECT_EQ(writer.error_of(ProgramPut::full).code, ErrorCode::timed_out);
    core_->release_core();
    EXPECT_EQ(writer.put(numbered_record(1)), ProgramPut::no_core);
    EXPECT_EQ(writer.put_for(numbered_record(1), milliseconds{1}), ProgramPut::no_core);
    EXPECT_EQ(writer.sequence(), kDefaultRingRecords);
}

TEST_F(SegmentProgram, TheSourceOfAProgramIsThereWithWhatTheCoreTookOfIt) {
    ProgramWriter writer = ProgramWriter::claim(*hmi_).value();
    EXPECT_EQ(recorded_source(*hmi_), nullptr);
    std::optional<ProgramFeed> feed = open_for(writer);
    EXPECT_EQ(recorded_source(*hmi_), nullptr) << "its writer has told nothing";
    auto source = std::make_unique<ProgramSource>();
    source->program = 1234;
    source->text_bytes = 77;
    writer.tell(*source);
    feed->say(3, 11, ProgramEnd::none, 99);

    const auto recorded = recorded_source(*hmi_);

    ASSERT_NE(recorded, nullptr);
    EXPECT_EQ(recorded->source.program, writer.program());
    EXPECT_EQ(recorded->source.text_bytes, 77U);
    EXPECT_EQ(recorded->taken, 3U);
    EXPECT_EQ(recorded->record_sum, 99U);
    source->profile_bytes = kSourceProfileBytes + 1;
    writer.tell(*source);
    EXPECT_EQ(recorded_source(*hmi_), nullptr) << "overwritten";
    desk_->end();
    writer.release();
    ProgramWriter next = ProgramWriter::claim(*hmi_).value();
    (void)open_for(next);
    EXPECT_EQ(recorded_source(*hmi_), nullptr) << "that of another program";
}

TEST_F(SegmentProgram, AWriterThatWaitsHearsThatTheProgramIsOverAndWhy) {
    ProgramWriter writer = ProgramWriter::claim(*hmi_).value();
    std::optional<ProgramFeed> feed = open_for(writer);
    for (std::uint32_t i = 0; i < kDefaultRingRecords; ++i)
        ASSERT_EQ(writer.try_put(numbered_record(1)), ProgramPut::done);
    std::thread core{[&] {
        feed->say_refusal(12, message_of(MessageId::program_number_not_finite, count_argument(12)));
        feed->say(3, 11, ProgramEnd::refused, 0);
        desk_->end();
    }};

    const ProgramPut put = writer.put(numbered_record(1));
    core.join();

    EXPECT_EQ(put, ProgramPut::over);
    EXPECT_EQ(writer.error_of(put).said.id, MessageId::program_number_not_finite);
    const ProgramReport report = program_report(*hmi_);
    ASSERT_TRUE(report.refusal.has_value());
    EXPECT_EQ(report.refusal->line, 12U);
    EXPECT_EQ(report.progress.taken, 3U);
    EXPECT_EQ(report.running, 0U);
}

TEST_F(SegmentProgram, BehindItsEndAndOnceClosedAProgramTakesNoMore) {
    ProgramWriter writer = ProgramWriter::claim(*hmi_).value();
    EXPECT_EQ(writer.put(numbered_record(1)), ProgramPut::closed);
    ASSERT_TRUE(open_for(writer).has_value());
    ASSERT_EQ(writer.put(end_record()), ProgramPut::done);
    EXPECT_EQ(writer.put(numbered_record(1)), ProgramPut::closed);
    desk_->end();
    ASSERT_TRUE(open_for(writer).has_value());
    writer.close();
    EXPECT_EQ(writer.put(numbered_record(1)), ProgramPut::closed);
}

TEST_F(SegmentProgram, ItIsLeftOnceItIsClosedOrItsWriterHasLetGoOrDied) {
    ProgramWriter writer = ProgramWriter::claim(*hmi_).value();
    std::optional<ProgramFeed> feed = open_for(writer);
    EXPECT_FALSE(feed->is_left());
    writer.close();
    EXPECT_TRUE(feed->is_left());
    desk_->end();

    feed = open_for(writer);
    EXPECT_FALSE(feed->is_left());
    control().claim_start_time.store(1);
    EXPECT_TRUE(feed->is_left());
    writer.release();
    EXPECT_TRUE(feed->is_left());
}

TEST_F(SegmentProgram, ANewCoreTakesNothingOfTheProgramBeforeIt) {
    ProgramWriter writer = ProgramWriter::claim(*hmi_).value();
    ASSERT_TRUE(open_for(writer).has_value());
    ASSERT_EQ(writer.put(numbered_record(1)), ProgramPut::done);
    core_->release_core();
    Segment next = Segment::attach(name_.get()).value();
    ASSERT_TRUE(next.claim_core().has_value());

    EXPECT_EQ(writer.put(numbered_record(1)), ProgramPut::over);
    EXPECT_FALSE(ProgramDesk{next}.open().has_value());
    EXPECT_EQ(program_report(next).progress.program, 0U);
}

// It would be told that its program is over, and that somebody stopped it.
TEST_F(SegmentProgram, AWriterThatOutlivesItsCoreHearsThatTheCoreHasEnded) {
    ProgramWriter writer = ProgramWriter::claim(*hmi_).value();
    ASSERT_TRUE(open_for(writer).has_value());
    core_->release_core();
    Segment next = Segment::attach(name_.get()).value();
    ASSERT_TRUE(next.claim_core().has_value());
    next.header().core.start_time.fetch_add(1);  // both are of this process

    for (const ProgramPut answer : {writer.put(numbered_record(1)), writer.try_put(numbered_record(1)),
                                    writer.put_for(numbered_record(1), milliseconds{1})}) {
        EXPECT_EQ(answer, ProgramPut::no_core);
        EXPECT_EQ(writer.error_of(answer).said.id, MessageId::core_ended);
    }
}

// Not what the core before had given, which still stands there until the next one serves programs.
TEST_F(SegmentProgram, AWriterThatOutlivesItsCoreGetsAProgramOfTheNext) {
    ProgramWriter writer = ProgramWriter::claim(*hmi_).value();
    ASSERT_TRUE(open_for(writer).has_value());
    core_->release_core();
    ASSERT_TRUE(core_->claim_core().has_value());
    core_->header().core.start_time.fetch_add(1);
    const auto too_early = writer.begin(milliseconds{1});
    ASSERT_FALSE(too_early.has_value());
    EXPECT_EQ(too_early.error().code, ErrorCode::timed_out);
    desk_.emplace(*core_, 1000);

    ASSERT_TRUE(open_for(writer).has_value());

    EXPECT_EQ(writer.put(numbered_record(1)), ProgramPut::done);
}

TEST_F(SegmentProgram, WhereTheMachineIsIsToldWhole) {
    ProgramStatus status{};
    status.program = 7;
    status.line = 1ULL << 40U;
    status.starvations = 3;
    status.hold = ProgramHold::starved;
    desk_->tell(status);
    const ProgramStatus told = program_report(*hmi_).status;
    EXPECT_EQ(told.program, 7U);
    EXPECT_EQ(told.line, 1ULL << 40U);
    EXPECT_EQ(told.starvations, 3U);
    EXPECT_EQ(told.hold, ProgramHold::starved);
}

TEST(SegmentRing, HasTheCapacityThatItsMakerChose) {
    for (const std::uint32_t capacity : {64U, 65'536U}) {
        const test::SegmentName name;
        SegmentOptions options = name.options();
        options.capacity_records = capacity;
        ASSERT_TRUE(Segment::create_or_attach(options).has_value());
        Segment segment = Segment::attach(name.get()).value();

        EXPECT_EQ(segment.record_ring().capacity, capacity);
        // The last of its words can be touched.
        segment.record_ring().records[capacity - 1].words[10].store(1);
    }
}

TEST(SegmentRing, ACapacityThatCannotBeIsWrongUsage) {
    const test::SegmentName name;
    for (const std::uint32_t capacity : {0U, 32U, 100U, 131'072U}) {
        SegmentOptions options = name.options();
        options.capacity_records = capacity;
        const auto made = Segment::create_or_attach(options);
        ASSERT_FALSE(made.has_value()) << capacity;
        EXPECT_EQ(made.error().code, ErrorCode::bad_usage);
    }
}

TEST(SegmentRing, ACapacityThatWasOverwrittenIsRefused) {
    const test::SegmentName name;
    Segment segment = Segment::create_or_attach(name.options()).value();
    for (const std::uint32_t capacity : {0U, 64U, 8'191U, 16'384U, ~0U}) {
        segment.header().capacity_records = capacity;
        EXPECT_FALSE(Segment::attach(name.get()).has_value()) << capacity;
        EXPECT_EQ(segment.record_ring().capacity, kDefaultRingRecords);
    }
}

}  // namespace
}  // namespace psicarve
