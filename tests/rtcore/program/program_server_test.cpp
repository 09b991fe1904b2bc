// SPDX-License-Identifier: GPL-3.0-or-later
// Who gets a number, when a program is over, and that the planner then reads no ring any more.
#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <thread>
#include <utility>

#include "rtcore/program/program_server.hpp"
#include "tests/shared/segment_fixture.hpp"

namespace psicarve::program {
namespace {

using plan::ProgramStep;
using plan::Supply;
using std::chrono::milliseconds;

/// A segment with a core's side and a writer's, in one process.
class ProgramServing : public ::testing::Test {
protected:
    ProgramServing() {
        const SegmentOptions options = name_.options();
        core_ = std::make_shared<Segment>(Segment::create_or_attach(options).value());
        EXPECT_TRUE(core_->claim_core());
        writers_ = std::make_unique<Segment>(Segment::attach(options.name).value());
    }
    /// A writer with a number. The core's rounds go on meanwhile.
    ProgramWriter begun() {
        ProgramWriter writer = ProgramWriter::claim(*writers_).value();
        EXPECT_TRUE(begin(writer));
        return writer;
    }
    bool begin(ProgramWriter& writer) {
        bool has_begun = false;
        std::thread asking{[&] { has_begun = writer.begin(milliseconds{60'000}).has_value(); }};
        const std::uint64_t before = writer.program();
        while (program_report(*writers_).running == before || program_report(*writers_).running == 0)
            sut_.serve(core_, status_);
        asking.join();
        return has_begun;
    }
    /// The tick has it.
    void run(std::uint64_t program) {
        status_ = ProgramStatus{};
        status_.program = program;
        status_.is_running = 1;
        sut_.serve(core_, status_);
        sut_.note_answer(program, true);
    }
    void end() {
        status_.is_running = 0;
        sut_.serve(core_, status_);
    }
    static MotionRecord dwell(std::uint64_t line) {
        MotionRecord record{};
        record.kind = MotionKind::dwell;
        record.line = line;
        record.seconds = 1.0;
        return record;
    }

    test::SegmentName name_;
    std::shared_ptr<Segment> core_;
    std::unique_ptr<Segment> writers_;
    ProgramStatus status_{};
    ProgramServer sut_{Profile{}};
};

// Also where the core before gave a thousand in its last second.
TEST(ProgramNumbers, OfALaterCoreAreGreaterAndExactInJson) {
    using Time = std::chrono::steady_clock::time_point;
    using namespace std::chrono_literals;
    EXPECT_EQ(first_program_number(Time{}), 0U) << "the first that is given is one more";
    EXPECT_GT(first_program_number(Time{17s + 1s}), first_program_number(Time{17s}) + 1000);
    EXPECT_LT(first_program_number(Time{24h * 365 * 20}), std::uint64_t{1} << 53U);
}

TEST_F(ProgramServing, GivesTheStepsOfTheProgramThatHasItsNumberAndOfNoOther) {
    ProgramWriter writer = begun();
    EXPECT_FALSE(sut_.open(writer.program() + 1));
    EXPECT_FALSE(sut_.open(0));
    const auto source = sut_.open(writer.program());
    ASSERT_TRUE(source);
    ASSERT_EQ(writer.put(dwell(3)), ProgramPut::done);
    (*source)->begin({});
    ProgramStep step;
    ASSERT_EQ((*source)->next(step), Supply::step);
    EXPECT_EQ(step.line, 3U);
    EXPECT_EQ((*source)->next(step), Supply::later);
}

// A second command for a program that was asked for is refused, and changes nothing for the first.
TEST_F(ProgramServing, IsNotConfusedByASecondCommandForTheSameProgram) {
    ProgramWriter writer = begun();
    const std::uint64_t program = writer.program();
    const auto source = sut_.open(program);
    ASSERT_TRUE(source);
    EXPECT_FALSE(sut_.open(program));
    run(program);
    EXPECT_FALSE(sut_.open(program)) << "it runs";
    end();
    EXPECT_FALSE(sut_.open(program)) << "it has run";
    ASSERT_EQ(writer.try_put(dwell(1)), ProgramPut::over);
    ProgramStep step;
    EXPECT_EQ((*source)->next(step), Supply::lost);
}

TEST_F(ProgramServing, CanBeAskedAgainForAProgramThatTheTickHasRefused) {
    ProgramWriter writer = begun();
    const auto refused = sut_.open(writer.program());
    ASSERT_TRUE(refused);
    sut_.note_answer(writer.program(), false);
    ASSERT_EQ(writer.put(dwell(1)), ProgramPut::done);
    ProgramStep step;
    EXPECT_EQ((*refused)->next(step), Supply::lost) << "nobody reads by it any more";
    const auto again = sut_.open(writer.program());
    ASSERT_TRUE(again);
    EXPECT_EQ((*again)->next(step), Supply::step);
}

// The planner may go on asking for a program that an alarm has ended; the ring is the next one's by then.
TEST_F(ProgramServing, KeepsAProgramThatIsOverFromTheNextOnesRecords) {
    std::shared_ptr<plan::StepSource> before;
    ProgramStep step;
    {
        ProgramWriter writer = begun();
        before = sut_.open(writer.program()).value();
        run(writer.program());
        for (std::uint64_t line = 1; line <= 5; ++line) ASSERT_EQ(writer.put(dwell(line)), ProgramPut::done);
        ASSERT_EQ(before->next(step), Supply::step);
        end();
    }
    ProgramWriter next = begun();
    for (std::uint64_t line = 11; line <= 13; ++line) ASSERT_EQ(next.put(dwell(line)), ProgramPut::done);
    EXPECT_EQ(before->next(step), Supply::lost);
    const auto source = sut_.open(next.program());
    ASSERT_TRUE(source);
    for (std::uint64_t line = 11; line <= 13; ++line) {
        ASSERT_EQ((*source)->next(step), Supply::step);
        EXPECT_EQ(step.line, line);
    }
    EXPECT_EQ((*source)->next(step), Supply::later);
}

// An answer that never came: the tick says what runs.
TEST_F(ProgramServing, EndsAProgramWhoseAnswerWasLost) {
    ProgramWriter writer = begun();
    const auto source = sut_.open(writer.program());
    ASSERT_TRUE(source);
    status_.program = writer.program();
    status_.is_running = 1;
    sut_.serve(core_, status_);
    end();
    ProgramStep step;
    EXPECT_EQ((*source)->next(step), Supply::lost);
    EXPECT_EQ(program_report(*writers_).running, 0U);
}

TEST_F(ProgramServing, GivesAWriterAnotherNumberWhereItWantsOne) {
    ProgramWriter writer = begun();
    const std::uint64_t first = writer.program();
    ASSERT_TRUE(begin(writer));
    EXPECT_GT(writer.program(), first);
    EXPECT_FALSE(sut_.open(first));
    EXPECT_TRUE(sut_.open(writer.program()));
}

TEST_F(ProgramServing, IsFreeAgainOnceItsWriterHasLetGo) {
    std::uint64_t first = 0;
    {
        ProgramWriter writer = begun();
        first = writer.program();
    }
    sut_.serve(core_, status_);
    EXPECT_EQ(program_report(*writers_).running, 0U);
    EXPECT_GT(begun().program(), first);
}

// The segment that is replaced ends what is in it; its ring stays mapped for the planner.
TEST_F(ProgramServing, LeavesTheOldSegmentWhereThereIsANewOne) {
    ProgramWriter writer = begun();
    const auto source = sut_.open(writer.program());
    ASSERT_TRUE(source);
    run(writer.program());
    const test::SegmentName other;
    auto fresh = std::make_shared<Segment>(Segment::create_or_attach(other.options()).value());
    ASSERT_TRUE(fresh->claim_core());
    sut_.serve(fresh, status_);
    core_.reset();
    ProgramStep step;
    EXPECT_EQ((*source)->next(step), Supply::lost);
}

}  // namespace
}  // namespace psicarve::program
