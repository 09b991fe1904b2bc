// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/program/record_intake.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>

#include "shared/segment/shared_record.hpp"
#include "shared/wording/wording.hpp"
#include "tests/rtcore/program/program_in_memory.hpp"

namespace psicarve::program {
namespace {

using plan::ProgramStep;
using plan::Supply;
using test::numbered_record;

class RecordIntakeTest : public testing::Test {
protected:
    RecordIntakeTest() : writer_(program_.ring(), 0), sut_(program_.feed(), profile_, start_) {}

    /// As a writer would that makes each record right in itself.
    void put(
        MotionRecord record, const std::function<void(MotionRecord&)>& change = [](MotionRecord&) {}) {
        change(record);
        record.check = record_check(record);
        ASSERT_EQ(writer_.try_put(record), RingAnswer::done);
    }
    void put_end(std::uint64_t sequence) {
        put(numbered_record(sequence), [](MotionRecord& record) {
            record.kind = MotionKind::end;
            record.axes = 0;
        });
    }
    Supply next() { return sut_.next(step_); }
    /// It is refused for this, with that line, and stays so whatever comes; nothing after it is given.
    void expect_refusal(MessageId id, std::uint64_t line) {
        const plan::Pulses4 at = sut_.position_pulses();
        const std::uint64_t taken = sut_.taken();
        ASSERT_EQ(next(), Supply::refused);
        ASSERT_TRUE(sut_.refusal().has_value());
        EXPECT_EQ(sut_.refusal()->said.id, id);
        EXPECT_EQ(sut_.refusal()->line, line);
        EXPECT_TRUE(is_sound(sut_.refusal()->said));
        (void)writer_.try_put(numbered_record(taken + 1));
        EXPECT_EQ(next(), Supply::refused);
        EXPECT_EQ(sut_.position_pulses(), at);
        EXPECT_EQ(sut_.taken(), taken);
        const auto said = read_refusal();
        EXPECT_EQ(said.said.id, id);
        EXPECT_EQ(said.line, line);
        EXPECT_EQ(progress().end, static_cast<std::uint32_t>(ProgramEnd::refused));
    }
    ProgramProgress progress() { return load_words<ProgramProgress>(program_.control().progress.words); }
    ProgramRefusal read_refusal() { return load_words<ProgramRefusal>(program_.control().refusal.words); }

    test::ProgramInMemory program_;
    Profile profile_;
    plan::Pulses4 start_ = test::middle_of(profile_);
    RecordWriter writer_;
    RecordIntake sut_;
    ProgramStep step_;
};

// An axis that a record does not name stays where the program has it, not where its pulses are.
TEST_F(RecordIntakeTest, KeepsWhatRoundingTookFromAnAxisUntilItIsNamedAgain) {
    const double per_mm = axis_motion(profile_, Axis::r1).pulses_per_unit;
    const auto put_way = [&](std::uint64_t sequence, std::uint8_t axes, double r1_pulses) {
        put(numbered_record(sequence), [&](MotionRecord& record) {
            record.axes = axes;
            record.target[0] = r1_pulses / per_mm;
        });
    };
    put_way(1, 1, 8'000.25);
    put_way(2, 1U << index_of(Axis::psi), 0.0);
    put_way(3, 1, 8'000.0);
    ASSERT_EQ(next(), Supply::step);
    EXPECT_EQ(step_.target_pulses[0], 8'000);
    EXPECT_NEAR(step_.rounded_off_pulses[0], 0.25, 1e-9);
    ASSERT_EQ(next(), Supply::step);
    EXPECT_NEAR(step_.rounded_off_pulses[0], 0.25, 1e-9);
    ASSERT_EQ(next(), Supply::step);
    EXPECT_NEAR(step_.rounded_off_pulses[0], 0.0, 1e-9);
    sut_.begin(start_);
    put_way(4, 1U << index_of(Axis::psi), 0.0);
    ASSERT_EQ(next(), Supply::step);
    EXPECT_EQ(step_.rounded_off_pulses[0], 0.0);
}

TEST_F(RecordIntakeTest, GivesEachRecordOnceInItsOrderAndThenItsEnd) {
    for (std::uint64_t i = 1; i <= 9; ++i) put(numbered_record(i));
    put_end(10);

    for (std::uint64_t i = 1; i <= 9; ++i) {
        ASSERT_EQ(next(), Supply::step);
        EXPECT_EQ(step_.line, numbered_record(i).line);
        EXPECT_EQ(step_.target_pulses[0], 8'000 + static_cast<std::int64_t>(i));
        EXPECT_EQ(sut_.taken(), i);
    }
    std::uint64_t sum = 0;
    for (std::uint64_t i = 1; i <= 9; ++i) sum = with_record(sum, numbered_record(i).check);
    EXPECT_EQ(progress().record_sum, sum);
    ASSERT_EQ(next(), Supply::step);
    EXPECT_EQ(step_.kind, MotionKind::end);
    EXPECT_EQ(next(), Supply::ended);
    EXPECT_EQ(next(), Supply::ended);
    EXPECT_FALSE(sut_.refusal().has_value());
    EXPECT_EQ(progress().taken, 10U);
    EXPECT_NE(progress().record_sum, sum);
    EXPECT_EQ(progress().end, static_cast<std::uint32_t>(ProgramEnd::ended));
}

TEST_F(RecordIntakeTest, WaitsForMoreAsLongAsTheWriterIsThere) {
    EXPECT_EQ(next(), Supply::later);
    put(numbered_record(1));
    EXPECT_EQ(next(), Supply::step);
    EXPECT_EQ(next(), Supply::later);
    EXPECT_EQ(sut_.position_pulses(), step_.target_pulses);
}

TEST_F(RecordIntakeTest, IsLostBehindAllThatADeadWriterPut) {
    put(numbered_record(1));
    put(numbered_record(2));
    program_.writer_dies();

    EXPECT_EQ(next(), Supply::step);
    EXPECT_EQ(next(), Supply::step);
    EXPECT_EQ(next(), Supply::lost);
    EXPECT_EQ(next(), Supply::lost);
    ASSERT_TRUE(sut_.refusal().has_value());
    EXPECT_EQ(sut_.refusal()->said.id, MessageId::program_lost);
    EXPECT_TRUE(is_sound(sut_.refusal()->said));
    EXPECT_EQ(progress().end, static_cast<std::uint32_t>(ProgramEnd::lost));
}

TEST_F(RecordIntakeTest, IsLostWhereItIsClosedWithoutItsEnd) {
    put(numbered_record(1));
    program_.control().closed.store(test::kProgram);

    EXPECT_EQ(next(), Supply::step);
    EXPECT_EQ(next(), Supply::lost);
}

TEST_F(RecordIntakeTest, NeedsNoWriterOnceItIsQueuedToItsEnd) {
    put(numbered_record(1));
    put_end(2);
    program_.writer_dies();

    EXPECT_EQ(next(), Supply::step);
    EXPECT_EQ(next(), Supply::step);
    EXPECT_EQ(next(), Supply::ended);
}

TEST_F(RecordIntakeTest, RefusesWhatComesAfterTheEnd) {
    put_end(1);
    put(numbered_record(2));
    ASSERT_EQ(next(), Supply::step);
    expect_refusal(MessageId::program_goes_on_after_end, 1);
}

TEST_F(RecordIntakeTest, RefusesWhatComesLongAfterTheEnd) {
    put_end(1);
    ASSERT_EQ(next(), Supply::step);
    ASSERT_EQ(next(), Supply::ended);
    put(numbered_record(2));
    expect_refusal(MessageId::program_goes_on_after_end, 1);
}

TEST_F(RecordIntakeTest, RefusesAGapAndARepetition) {
    put(numbered_record(1));
    put(numbered_record(3));
    ASSERT_EQ(next(), Supply::step);
    expect_refusal(MessageId::program_record_out_of_order, 2);
}

TEST_F(RecordIntakeTest, RefusesARepetition) {
    put(numbered_record(1));
    put(numbered_record(1));
    ASSERT_EQ(next(), Supply::step);
    expect_refusal(MessageId::program_record_out_of_order, 1);
}

TEST_F(RecordIntakeTest, BeginsWithTheFirst) {
    put(numbered_record(2));
    expect_refusal(MessageId::program_record_out_of_order, 1);
}

TEST_F(RecordIntakeTest, RefusesARecordOfAnotherProgramAndItsLine) {
    put(numbered_record(1));
    put(numbered_record(2, 8), [](MotionRecord& record) { record.line = 4'000; });
    ASSERT_EQ(next(), Supply::step);
    expect_refusal(MessageId::program_record_foreign, 1);
}

TEST_F(RecordIntakeTest, RefusesATornRecord) {
    put(numbered_record(1));
    put(numbered_record(2));
    program_.records().record(1).words[4].fetch_xor(1);
    ASSERT_EQ(next(), Supply::step);
    expect_refusal(MessageId::program_record_torn, 1);
}

TEST_F(RecordIntakeTest, RefusesARingWhoseIndexCannotBe) {
    put(numbered_record(1));
    put(numbered_record(2));
    ASSERT_EQ(next(), Supply::step);
    program_.control().ends.written.store(1'000);
    expect_refusal(MessageId::program_ring_damaged, 1);
}

TEST_F(RecordIntakeTest, RefusesWhatTheMachineCannotDoByItsLine) {
    put(numbered_record(1));
    put(numbered_record(2), [](MotionRecord& record) {
        record.line = 17;
        record.target[index_of(Axis::y)] = 151.0;
    });
    ASSERT_EQ(next(), Supply::step);
    expect_refusal(MessageId::program_outside_travel, 17);
}

}  // namespace
}  // namespace psicarve::program
