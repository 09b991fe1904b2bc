// SPDX-License-Identifier: GPL-3.0-or-later
// A program crosses from one real process to another, whatever pauses, stops or kills do to either.
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <optional>
#include <random>
#include <thread>

#include "rtcore/program/record_intake.hpp"
#include "shared/base/units.hpp"
#include "shared/segment/segment_program.hpp"
#include "tests/shared/record_fixture.hpp"
#include "tests/shared/segment_fixture.hpp"
#include "tests/thoroughness.hpp"
#include "tests/two_process/child_process.hpp"

namespace psicarve {
namespace {

using plan::ProgramStep;
using plan::Supply;
using program::RecordIntake;
using std::chrono::microseconds;
using std::chrono::milliseconds;
using test::ChildProcess;
using test::is_long_run;
using test::numbered_record;

constexpr milliseconds kPatience{60'000};
constexpr std::uint64_t kEndless = ~std::uint64_t{0};

MotionRecord end_of_program(std::uint64_t line) {
    MotionRecord record{};
    record.kind = MotionKind::end;
    record.line = line;
    return record;
}

/// Sometimes, by a seed, a little while.
class Pauses {
public:
    Pauses(std::uint32_t seed, std::uint32_t one_in) : random_(seed), one_in_(one_in) {}
    void maybe() {
        if (one_in_ == 0 || random_() % one_in_ != 0) return;
        std::this_thread::sleep_for(microseconds{random_() % 300});
    }

private:
    std::mt19937 random_;
    std::uint32_t one_in_;
};

class ProgramRing : public testing::Test {
protected:
    void make_segment(std::uint32_t capacity) {
        SegmentOptions options = name_.options();
        options.capacity_records = capacity;
        auto segment = Segment::create_or_attach(options);
        ASSERT_TRUE(segment.has_value()) << segment.error().message;
        segment_.emplace(std::move(segment).value());
        ASSERT_TRUE(segment_->claim_core().has_value());
        desk_.emplace(*segment_);
    }
    /// A process that writes `count` numbered records and the end, and raises a signal when it has begun.
    auto write(std::uint64_t count, std::uint32_t one_in = 0) const {
        return [this, count, one_in](const ChildProcess::Signal& begun) {
            Segment segment = Segment::attach(name_.get()).value();
            ProgramWriter writer = ProgramWriter::claim(segment).value();
            ASSERT_TRUE(writer.begin(kPatience).has_value());
            begun.raise();
            Pauses pauses{11, one_in};
            for (std::uint64_t i = 1; i <= count; ++i) {
                ASSERT_EQ(writer.put(numbered_record(i)), ProgramPut::done);
                pauses.maybe();
            }
            ASSERT_EQ(writer.put(end_of_program(1)), ProgramPut::done);
            writer.close();
        };
    }
    std::optional<RecordIntake> open() {
        const auto deadline = std::chrono::steady_clock::now() + kPatience;
        while (std::chrono::steady_clock::now() < deadline) {
            if (const auto feed = desk_->open()) return RecordIntake{*feed, profile_, {}};
            std::this_thread::sleep_for(microseconds{200});
        }
        return std::nullopt;
    }
    /// The next step is the record of that sequence, to the pulse.
    void expect_record(const ProgramStep& step, std::uint64_t sequence) const {
        const MotionRecord wanted = numbered_record(sequence);
        ASSERT_EQ(step.line, wanted.line) << sequence;
        ASSERT_EQ(step.target_pulses[0], pulses_from_mm(wanted.target[0], profile_.r1.pulses_per_mm));
    }
    /// All that is there now; counts in `taken`.
    Supply take_all(RecordIntake& intake, std::uint64_t& taken, std::uint64_t most = kEndless) const {
        ProgramStep step;
        while (taken < most) {
            const Supply supply = intake.next(step);
            if (supply != Supply::step) return supply;
            expect_record(step, ++taken);
            if (HasFatalFailure()) return Supply::refused;
        }
        return Supply::step;
    }

    test::SegmentName name_;
    const Profile profile_{};
    std::optional<Segment> segment_;
    std::optional<ProgramDesk> desk_;
};

class ProgramRingOf : public ProgramRing, public testing::WithParamInterface<std::uint32_t> {};
INSTANTIATE_TEST_SUITE_P(Records, ProgramRingOf, testing::Values(64U, 8'192U, 65'536U),
                         [](const auto& parameter) { return std::to_string(parameter.param); });

TEST_P(ProgramRingOf, TwoHundredThousandCrossInOrderWhateverPausesEitherMakes) {
    constexpr std::uint64_t kCount = 200'000;
    make_segment(GetParam());
    ChildProcess writer{write(kCount, 2'000)};
    std::optional<RecordIntake> intake = open();
    ASSERT_TRUE(intake.has_value());
    Pauses pauses{13, 1'500};
    ProgramStep step;
    for (std::uint64_t taken = 0; taken < kCount;) {
        const Supply supply = intake->next(step);
        if (supply == Supply::later) {
            intake->wait_for(milliseconds{1'000});
            continue;
        }
        ASSERT_EQ(supply, Supply::step) << taken;
        expect_record(step, ++taken);
        if (HasFatalFailure()) return;
        pauses.maybe();
    }
    EXPECT_TRUE(writer.ends_well()) << "what is queued to its end needs no writer";
    ASSERT_EQ(intake->next(step), Supply::step);
    EXPECT_EQ(step.kind, MotionKind::end);
    EXPECT_EQ(intake->next(step), Supply::ended);
}

// Of each instant: stopped is not dead, killed is; what was put before arrives; the next one can write.
TEST_F(ProgramRing, AWriterKilledOrStoppedAtRandomInstantsLosesNothingThatItPut) {
    make_segment(64);
    std::mt19937 random{20261127};
    std::uint64_t in_all = 0;
    for (int round = 0; round < (is_long_run() ? 300 : 100); ++round) {
        ChildProcess writer{write(kEndless, 40)};
        std::optional<RecordIntake> intake = open();
        ASSERT_TRUE(intake.has_value());
        ASSERT_TRUE(writer.wait_for_signal());
        std::uint64_t taken = 0;
        std::uint64_t most = random() % 200;
        while (taken < most) {
            ASSERT_NE(take_all(*intake, taken, most), Supply::refused) << round;
            if (taken < most) intake->wait_for(milliseconds{1'000});
        }
        std::this_thread::sleep_for(microseconds{random() % 200});
        const bool is_stopped_first = round % 2 == 1;
        if (is_stopped_first) {
            writer.stop();
            ASSERT_EQ(take_all(*intake, taken), Supply::later) << "it lives, " << round;
            Segment other = Segment::attach(name_.get()).value();
            const auto second = ProgramWriter::claim(other);
            ASSERT_FALSE(second.has_value()) << round;
            EXPECT_EQ(second.error().said.arguments[0].bits, writer.pid());
        }
        writer.kill();
        const std::uint64_t queued = intake->queued();
        const std::uint64_t before = taken;
        ASSERT_EQ(take_all(*intake, taken), Supply::lost) << round;
        EXPECT_EQ(taken - before, queued) << "what is queued arrives, " << round;
        EXPECT_EQ(intake->refusal()->said.id, MessageId::program_lost);
        desk_->end();
        in_all += taken;
        Segment other = Segment::attach(name_.get()).value();
        EXPECT_TRUE(ProgramWriter::claim(other).has_value()) << round;
    }
    EXPECT_GT(in_all, 5'000U);
}

TEST_F(ProgramRing, AForkedChildLeavesItsParentsClaimAlone) {
    make_segment(64);
    ProgramWriter writer = ProgramWriter::claim(*segment_).value();
    ChildProcess child{[&](const ChildProcess::Signal&) { writer.release(); }};

    EXPECT_TRUE(child.ends_well());

    EXPECT_FALSE(ProgramWriter::claim(*segment_).has_value());
}

TEST_F(ProgramRing, AWriterThatWaitsForRoomHearsWithinALookThatTheCoreIsDead) {
    SegmentOptions options = name_.options();
    options.capacity_records = 64;
    segment_.emplace(Segment::create_or_attach(options).value());
    ChildProcess core{[this](const ChildProcess::Signal& opened) {
        Segment segment = Segment::attach(name_.get()).value();
        ASSERT_TRUE(segment.claim_core().has_value());
        opened.raise();
        ProgramDesk desk{segment};
        while (!desk.open()) std::this_thread::sleep_for(microseconds{200});
        ::pause();
    }};
    ASSERT_TRUE(core.wait_for_signal());
    ProgramWriter writer = ProgramWriter::claim(*segment_).value();
    ASSERT_TRUE(writer.begin(kPatience).has_value());
    for (std::uint64_t i = 1; i <= 64; ++i) ASSERT_EQ(writer.put(numbered_record(i)), ProgramPut::done);
    core.stop();
    EXPECT_EQ(writer.put_for(numbered_record(65), milliseconds{1}), ProgramPut::full)
        << "stopped is not dead";
    std::thread killer{[&] {
        std::this_thread::sleep_for(milliseconds{5});
        core.kill();
    }};

    const ProgramPut put = writer.put(numbered_record(65));
    killer.join();

    EXPECT_EQ(put, ProgramPut::no_core);
    EXPECT_EQ(writer.error_of(put).code, ErrorCode::no_core);
}

}  // namespace
}  // namespace psicarve
