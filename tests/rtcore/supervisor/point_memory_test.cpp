// SPDX-License-Identifier: GPL-3.0-or-later
// The point within a layer is a place that the heads plunge to: whatever makes it doubtful removes it.
#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <optional>

#include "rtcore/checkpoint/piece_memory.hpp"
#include "shared/segment/reached_point.hpp"
#include "shared/segment/shared_record.hpp"
#include "tests/rtcore/supervisor/kept_job.hpp"
#include "tests/shared/temporary_folder.hpp"

namespace psicarve::supervisor {
namespace {

class PieceMemoryWithin : public testing::Test {
protected:
    PieceMemoryWithin() {
        sut_.enter(*header_);
        sut_.take_job(*header_, vase_);
    }
    std::optional<std::uint32_t> point() const {
        const auto known = read_record(header_->checkpoint);
        return known ? point_to_resume(header_->reached_point.load(), *known) : std::nullopt;
    }
    std::uint32_t next_layer() const { return read_record(header_->checkpoint)->next_layer; }
    /// A run that begins there goes to its first point.
    cycle::Sample start(std::uint64_t layer, std::uint64_t step = 0) {
        cycle::Sample sample{};
        sample.state = MachineState::positioning;
        sample.first_layer = layer;
        sample.first_step = step;
        sample.job_generation = vase_->generation;
        sample.job_start_tick = tick_ += 100;
        note(sample);
        return sample;
    }
    void carve(cycle::Sample sample, std::uint64_t points_done) {
        sample.state = MachineState::carving;
        sample.carve_first_tick = sample.job_start_tick + 1;
        sample.points_done = points_done;
        note(sample);
        sample.state = MachineState::ready;
        note(sample);
    }
    void note(const cycle::Sample& sample) { sut_.note(*header_, sample, vase_); }

    psicarve::test::TemporaryFolder folder_;
    std::shared_ptr<const LoadedJob> vase_ = test::job_called("vase.stl");
    std::uint64_t points_ = vase_->view.point_count();
    std::unique_ptr<SegmentHeader> header_ = std::make_unique<SegmentHeader>();
    PieceMemory sut_{CheckpointPlace{folder_.path("state"), "/shop", false, 77}};
    std::uint64_t tick_ = 0;
};

TEST_F(PieceMemoryWithin, ARunOfTheWholeJobHasAnotherPieceFromItsAnnouncementOn) {
    carve(start(0), points_ + 2);
    ASSERT_EQ(point(), 1U);
    cycle::Sample whole = start(0);
    EXPECT_FALSE(point()) << "a new blank may be on the table";
    EXPECT_EQ(next_layer(), 1U) << "nothing is carved of it";
    whole.state = MachineState::ready;
    note(whole);
    EXPECT_FALSE(point()) << "the way back is by layer";
    EXPECT_EQ(next_layer(), 1U);
}

TEST_F(PieceMemoryWithin, ARunThatGoesOnLeavesThePointUntilItCarves) {
    carve(start(0), points_ + 2);
    start(1);
    EXPECT_EQ(point(), 1U);
    start(1, 1);
    EXPECT_EQ(point(), 1U);
    cycle::Sample dry = start(1);
    dry.is_dry = 1;
    dry.first_layer = 0;
    dry.job_start_tick = tick_ += 100;
    note(dry);
    EXPECT_EQ(point(), 1U) << "a dry run carves nothing";
}

// They may have been lost in the run before.
TEST_F(PieceMemoryWithin, StepsLostOnTheWayToTheFirstPointTakeThePointBefore) {
    for (const bool is_program : {false, true}) {
        carve(start(0), points_ + 2);
        ASSERT_EQ(point(), 1U);
        cycle::Sample lost = is_program ? cycle::Sample{} : start(1, 1);
        lost.state = MachineState::alarm;
        lost.alarm_cause = AlarmCause::limit;
        lost.program.is_running = is_program ? 1 : 0;
        note(lost);
        EXPECT_EQ(point(), 1U) << "any other alarm leaves it";
        lost.alarm_cause = AlarmCause::steps_lost;
        note(lost);
        EXPECT_FALSE(point()) << is_program;
        lost.state = MachineState::off;
        lost.alarm_cause = AlarmCause::none;
        note(lost);
        EXPECT_FALSE(point()) << is_program;
        EXPECT_EQ(next_layer(), 1U);
    }
}

TEST_F(PieceMemoryWithin, StepsLostAfterTheEndOfARunTakeItsPointForGood) {
    carve(start(0), points_ + 2);
    cycle::Sample ended = start(1);
    ended.carve_first_tick = ended.job_start_tick + 1;
    ended.points_done = points_ + 2;
    ended.state = MachineState::alarm;
    ended.alarm_cause = AlarmCause::steps_lost;
    note(ended);
    ended.state = MachineState::off;
    ended.alarm_cause = AlarmCause::none;
    note(ended);
    EXPECT_FALSE(point());
}

// Whoever does a layer again distrusts it.
TEST_F(PieceMemoryWithin, ALayerBegunAnewKnowsNoPointOfTheRunBefore) {
    carve(start(0), points_ + 3);
    ASSERT_EQ(point(), 2U);
    carve(start(1), points_ + 1);
    EXPECT_FALSE(point()) << "stopped at its first point";
    carve(start(1), points_ + 2);
    EXPECT_EQ(point(), 1U) << "the newest run that began there counts";
    carve(start(1, 1), points_ + 3);
    EXPECT_EQ(point(), 2U) << "a run from a known point goes on from what is known";
    carve(start(1, 1), points_ + 2);
    EXPECT_EQ(point(), 2U) << "a part of it done again";
    carve(start(0, 1), 2);
    EXPECT_EQ(point(), 2U) << "in an earlier layer, too";
}

TEST_F(PieceMemoryWithin, AnEarlierLayerBegunAnewTakesThePointBeyondIt) {
    carve(start(0), 2 * points_ + 2);
    ASSERT_EQ(point(), 1U);
    carve(start(1), points_ + 2);
    EXPECT_EQ(next_layer(), 2U) << "that layer was carved";
    EXPECT_FALSE(point());
    carve(start(1, 1), 2 * points_ + 2);
    EXPECT_EQ(point(), 1U) << "carved on to there";
}

TEST_F(PieceMemoryWithin, ALaterLayerBegunBeyondAGapLeavesThePointBeforeIt) {
    carve(start(0), points_ + 2);
    carve(start(2), 2 * points_ + 2);
    EXPECT_EQ(next_layer(), 1U);
    EXPECT_EQ(point(), 1U);
    carve(start(1, 1), points_ + 3);
    EXPECT_EQ(point(), 2U) << "and it goes on there";
}

TEST_F(PieceMemoryWithin, AWordWithAnyOneBitChangedIsNoPlace) {
    carve(start(0), points_ + 3);
    ASSERT_EQ(point(), 2U);
    const std::uint64_t word = header_->reached_point.load();
    for (unsigned bit = 0; bit < 64; ++bit) {
        header_->reached_point.store(word ^ std::uint64_t{1} << bit);
        EXPECT_FALSE(point()) << bit;
    }
}

}  // namespace
}  // namespace psicarve::supervisor
