// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/offsets/settled_offsets.hpp"

#include <gtest/gtest.h>

#include "shared/segment/shared_record.hpp"
#include "tests/shared/segment_fixture.hpp"
#include "tests/shared/temporary_folder.hpp"

namespace psicarve::offsets {
namespace {

constexpr std::uint64_t kProgram = 7;

class SettledOffsets : public test::SegmentOfTwo {
protected:
    void SetUp() override {
        SegmentOfTwo::SetUp();
        ASSERT_TRUE(core_->claim_core().has_value());
        tell(kProgram, ProgramEnd::ended);
        pending_.kept.systems[0].origin[0] = 1.0;
        Pending left{identity_of(*hmi_, kProgram), {}};
        left.offsets.systems[0].origin[0] = 2.0;
        pending_.pending = left;
        ASSERT_TRUE(write_offsets(place(), pending_, {}));
    }
    OffsetsPlace place() const { return {folder_.path("m.offsets"), 0640}; }
    void tell(std::uint64_t program, ProgramEnd end, bool is_running = false, bool is_done = true) {
        ProgramStatus status{};
        status.program = program;
        status.is_running = is_running ? 1 : 0;
        status.is_done = is_done ? 1 : 0;
        write_record(core_->header().program.status, status);
        write_record(core_->header().program.progress,
                     ProgramProgress{program, 3, 9, static_cast<std::uint32_t>(end), 0, 0});
    }
    Result<Settled> settled() const { return settled_offsets(place(), {}, {hmi_->name(), {}}); }
    double x_mm_kept() const { return read_offsets(place(), {})->kept.systems[0].origin[0]; }
    void expect_dropped() const {
        const auto read = settled();
        ASSERT_TRUE(read);
        EXPECT_NE(read->warning, "");
        EXPECT_EQ(read->offsets.kept, pending_.kept);
        EXPECT_FALSE(read->offsets.pending);
        EXPECT_FALSE(read_offsets(place(), {})->pending);
        EXPECT_EQ(x_mm_kept(), 1.0);
        EXPECT_EQ(settled()->warning, "");
    }

    test::TemporaryFolder folder_;
    Offsets pending_;
};

TEST_F(SettledOffsets, AreThoseOfAProgramThatItsCoreHasEnded) {
    const auto read = settled();
    ASSERT_TRUE(read);
    EXPECT_EQ(read->warning, "");
    EXPECT_EQ(read->offsets.kept, pending_.pending->offsets);
    EXPECT_EQ(x_mm_kept(), 2.0);
    EXPECT_FALSE(read_offsets(place(), {})->pending);
}

TEST_F(SettledOffsets, WaitForAProgramThatRuns) {
    tell(kProgram, ProgramEnd::ended, true, false);
    const auto read = settled();
    ASSERT_TRUE(read);
    EXPECT_EQ(read->warning, "");
    EXPECT_EQ(read->offsets, pending_);
    EXPECT_EQ(*read_offsets(place(), {}), pending_);
}

TEST_F(SettledOffsets, WaitForWhoeverHasTheLock) {
    const auto lock = OffsetsLock::take(place(), std::chrono::milliseconds{0});
    ASSERT_TRUE(lock);
    EXPECT_EQ(settled()->offsets, pending_);
    EXPECT_EQ(*read_offsets(place(), {}), pending_);
}

TEST_F(SettledOffsets, DropThoseOfAProgramThatWasStopped) {
    tell(kProgram, ProgramEnd::ended, false, false);
    expect_dropped();
}

TEST_F(SettledOffsets, DropThoseOfAProgramWhoseWriterWasLost) {
    tell(kProgram, ProgramEnd::lost);
    expect_dropped();
}

TEST_F(SettledOffsets, DropThoseThatAnotherProgramFollowed) {
    tell(kProgram + 1, ProgramEnd::ended);
    expect_dropped();
}

TEST_F(SettledOffsets, DropThoseOfAnotherCoreOrBoot) {
    for (const bool is_boot : {false, true}) {
        Offsets other = pending_;
        if (is_boot) other.pending->of.boot_id = "another";
        if (!is_boot) ++other.pending->of.core_start_time;
        ASSERT_TRUE(write_offsets(place(), other, {}));
        expect_dropped();
    }
}

TEST_F(SettledOffsets, DropThoseOfACoreThatIsGone) {
    core_->release_core();
    expect_dropped();
}

TEST_F(SettledOffsets, AreAnErrorWhereTheCoresWordsCannotBeRead) {
    core_->header().program.status.sequence.fetch_add(1);
    EXPECT_FALSE(settled());
    EXPECT_EQ(*read_offsets(place(), {}), pending_);
    core_->header().program.status.sequence.fetch_add(1);
    EXPECT_EQ(settled()->offsets.kept, pending_.pending->offsets);
}

}  // namespace
}  // namespace psicarve::offsets
