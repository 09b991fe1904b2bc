// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever is written over the ring and its control words: what the core takes is what was put, in its order.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "shared/base/units.hpp"
#include "tests/rtcore/program/program_in_memory.hpp"
#include "tests/thoroughness.hpp"

namespace psicarve::program {
namespace {

using plan::ProgramStep;
using plan::Supply;
using test::numbered_record;

constexpr std::uint64_t kRecords = 400;
constexpr std::size_t kControlBytes = sizeof(ProgramControl);
/// Every byte of the control words twice, and as many of the ring, whose records are what is mostly refused,
/// however large the control words grow: layout 14 added 192 bytes that the core believes nothing of.
constexpr std::size_t kRingMutations = 1'592;
/// Of what the writer tells of its program, most of all the text of its profile, the intake reads nothing: a
/// sanitizer is shown each of so many bytes of it.
constexpr std::size_t kToldStep = 32;

class RecordMutation : public testing::Test {
protected:
    /// One run of a program of which `at` bytes are overwritten when `when` records are put.
    void run(std::size_t at, std::uint64_t when);
    void mutate(test::ProgramInMemory& program, std::size_t at);

    std::mt19937 random_{40977};
    const Profile profile_{};
    int ended_ = 0;
    int refused_ = 0;
    int other_ = 0;
};

/// Those of the control words that are mutated.
std::vector<std::size_t> control_places() {
    std::vector<std::size_t> places;
    for (std::size_t at = 0; at < kControlBytes; ++at) {
        const bool is_told = at >= offsetof(ProgramControl, source);
        if (!is_told || at % kToldStep == 0 || test::is_thorough()) places.push_back(at);
    }
    return places;
}

/// Control words first, then the ring's records.
void RecordMutation::mutate(test::ProgramInMemory& program, std::size_t at) {
    auto* bytes = reinterpret_cast<unsigned char*>(&program.control());
    std::size_t most = kControlBytes;
    if (at >= kControlBytes) {
        bytes = reinterpret_cast<unsigned char*>(&program.records().record(0));
        at -= kControlBytes;
        most = kLeastRingRecords * sizeof(RingRecord);
    }
    std::size_t count = random_() % 3 == 0 ? 1 + random_() % 12 : 1;
    for (; count > 0 && at < most; --count, ++at)
        bytes[at] ^= static_cast<unsigned char>(1 + random_() % 255);
}

void RecordMutation::run(std::size_t at, std::uint64_t when) {
    test::ProgramInMemory program;
    RecordWriter writer{program.ring(), 0};
    RecordIntake sut{program.feed(), profile_, test::middle_of(profile_)};
    std::uint64_t put = 0;
    std::uint64_t taken = 0;
    bool is_over = false;
    for (std::uint64_t turn = 0; !is_over && turn < 10 * kRecords; ++turn) {
        if (put >= when && turn >= when) {
            mutate(program, at);
            when = ~std::uint64_t{0};
        }
        for (auto left = random_() % 9; left > 0 && put < kRecords; --left) {
            MotionRecord record = numbered_record(put + 1);
            if (put + 1 == kRecords) {
                record.kind = MotionKind::end;
                record.axes = 0;
                record.check = record_check(record);
            }
            if (writer.try_put(record) != RingAnswer::done) break;
            ++put;
        }
        for (auto left = random_() % 9; left > 0 && !is_over; --left) {
            ProgramStep step;
            const Supply supply = sut.next(step);
            if (supply == Supply::later) break;
            is_over = supply != Supply::step;
            if (is_over) {
                ended_ += supply == Supply::ended ? 1 : 0;
                refused_ += supply == Supply::refused ? 1 : 0;
                other_ += supply == Supply::lost ? 1 : 0;
                continue;
            }
            ASSERT_LT(taken, put) << "nothing is taken that was not put, byte " << at;
            const MotionRecord wanted = numbered_record(++taken);
            ASSERT_EQ(step.line, wanted.line) << "byte " << at;
            if (step.kind == MotionKind::end) {
                ASSERT_EQ(taken, kRecords);
                continue;
            }
            ASSERT_EQ(step.target_pulses[3], pulses_from_mm(wanted.target[3], profile_.y.pulses_per_mm));
            ASSERT_EQ(step.target_pulses[0], pulses_from_mm(wanted.target[0], profile_.r1.pulses_per_mm));
        }
    }
    if (!is_over) ++other_;
}

TEST_F(RecordMutation, ThousandsLetNoTornOrForeignRecordThrough) {
    const std::vector<std::size_t> places = control_places();
    const std::size_t in_control = 2 * places.size();
    for (std::size_t turn = 0; turn < in_control + kRingMutations && !HasFatalFailure(); ++turn) {
        constexpr std::size_t kRingBytes = kLeastRingRecords * sizeof(RingRecord);
        const std::size_t at =
            turn < in_control ? places[turn % places.size()] : kControlBytes + random_() % kRingBytes;
        run(at, random_() % kRecords);
    }
    RecordProperty("ended", ended_);
    RecordProperty("refused", refused_);
    RecordProperty("other", other_);
    EXPECT_GT(ended_, 500) << "words that do not matter";
    EXPECT_GT(refused_, 100);
}

}  // namespace
}  // namespace psicarve::program
