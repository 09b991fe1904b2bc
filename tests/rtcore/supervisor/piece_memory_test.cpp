// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/checkpoint/piece_memory.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <thread>

#include "shared/segment/reached_point.hpp"
#include "shared/segment/shared_record.hpp"
#include "shared/wording/wording.hpp"
#include "tests/rtcore/supervisor/kept_job.hpp"
#include "tests/shared/temporary_folder.hpp"

namespace psicarve::supervisor {
namespace {

using testing::HasSubstr;

constexpr std::uint64_t kPieceProfile = 77;

class PieceMemoryTest : public testing::Test {
protected:
    CheckpointPlace place(bool is_simulator = false) const {
        return {folder_.path("state"), "/shop", is_simulator, kPieceProfile};
    }
    StateNames names() const { return {folder_.path("state"), "/shop", false}; }
    Checkpoint after(std::uint32_t layers, std::uint32_t origin = 0) const {
        return checkpoint_at(vase_->checksum, layers, vase_->view.layer_count(), 0, origin);
    }
    /// Of a core that has ended, of the real machine.
    void leave_on_disk(std::uint32_t layers) const {
        CheckpointFile file{place()};
        file.keep({after(layers), Keeping::carved}, vase_);
    }
    void leave_in_segment(const Checkpoint& checkpoint) { write_record(header_->checkpoint, checkpoint); }
    /// What a core finds that begins now and accepts the job.
    std::string remark_of_new_core(bool is_simulator = false) {
        PieceMemory sut{place(is_simulator)};
        sut.enter(*header_);
        return in_words(sut.take_job(*header_, vase_));
    }
    Checkpoint in_segment() const { return read_record(header_->checkpoint).value_or(Checkpoint{}); }
    std::uint32_t layer_on_disk() const {
        const auto saved = load_saved_checkpoint(names().checkpoint());
        return saved ? saved->checkpoint.next_layer : 999;
    }
    cycle::Sample carving_from(std::uint64_t first_layer, MachineState state) const {
        cycle::Sample sample{};
        sample.state = state;
        sample.first_layer = first_layer;
        sample.job_generation = vase_->generation;
        sample.job_start_tick = 100;
        return sample;
    }

    psicarve::test::TemporaryFolder folder_;
    std::shared_ptr<const LoadedJob> vase_ = test::job_called("vase.stl");
    std::unique_ptr<SegmentHeader> header_ = std::make_unique<SegmentHeader>();
};

TEST_F(PieceMemoryTest, TakesTheDisksWordIntoAFreshSegmentAndMarksIt) {
    leave_on_disk(2);
    EXPECT_EQ(remark_of_new_core(), "");
    EXPECT_EQ(in_segment().next_layer, 2U);
    EXPECT_TRUE(in_segment().is_from_disk());
    EXPECT_FALSE(in_segment().is_simulated());
}

TEST_F(PieceMemoryTest, LeavesADamagedRecordAsItIs) {
    leave_on_disk(2);
    Checkpoint damaged = after(1);
    damaged.check ^= 1;
    leave_in_segment(damaged);
    remark_of_new_core();
    EXPECT_FALSE(is_checkpoint(in_segment()));
    EXPECT_FALSE(in_segment().is_empty());
}

TEST_F(PieceMemoryTest, ASimulatedCarvesRecordNeverStandsForTheRealPiece) {
    leave_on_disk(1);
    leave_in_segment(after(2, kCheckpointSimulated));
    remark_of_new_core();
    EXPECT_EQ(in_segment().next_layer, 1U);
    EXPECT_FALSE(in_segment().is_simulated());
    // Nor the other way round.
    leave_in_segment(after(2));
    remark_of_new_core(true);
    EXPECT_TRUE(in_segment().is_empty());
}

TEST_F(PieceMemoryTest, WhereSegmentAndDiskDisagreeTheLowerLayerIsTakenAndThatIsSaid) {
    leave_on_disk(1);
    leave_in_segment(after(2));
    EXPECT_THAT(remark_of_new_core(), HasSubstr("segment: layer 2, disk: 1"));
    EXPECT_EQ(in_segment().next_layer, 1U);
    EXPECT_TRUE(in_segment().is_from_disk());

    leave_on_disk(2);
    leave_in_segment(after(1));
    EXPECT_THAT(remark_of_new_core(), HasSubstr("segment: layer 1, disk: 2"));
    EXPECT_EQ(in_segment().next_layer, 1U);
    EXPECT_FALSE(in_segment().is_from_disk());
    EXPECT_EQ(layer_on_disk(), 1U) << "the disk learns it";
}

TEST_F(PieceMemoryTest, AStartOfWhichTheSegmentKnowsNothingIsAnnouncedWhereTheDiskTellsMore) {
    leave_on_disk(2);
    Checkpoint damaged = after(1);
    damaged.check ^= 1;
    leave_in_segment(damaged);
    {
        PieceMemory sut{place()};
        sut.enter(*header_);
        sut.take_job(*header_, vase_);
        sut.note(*header_, carving_from(0, MachineState::positioning), vase_);
    }
    EXPECT_EQ(layer_on_disk(), 0U) << "before the first point is left";
    leave_on_disk(2);
    {
        PieceMemory sut{place()};
        sut.take_job(*header_, vase_);
        sut.note(*header_, carving_from(1, MachineState::positioning), vase_);
    }
    EXPECT_EQ(layer_on_disk(), 1U);
}

// The machine carves it as it does a job, and the sample still has the figures of the job that ran before.
TEST_F(PieceMemoryTest, AProgramLeavesThePiecesRecordAsItIs) {
    for (const std::uint64_t carve_first_tick : {std::uint64_t{0}, std::uint64_t{150}}) {
        leave_on_disk(2);
        leave_in_segment(after(2));
        {
            PieceMemory sut{place()};
            sut.enter(*header_);
            sut.take_job(*header_, vase_);
            cycle::Sample sample = carving_from(0, MachineState::carving);
            sample.carve_first_tick = carve_first_tick;
            sample.program.is_running = 1;
            sut.note(*header_, sample, vase_);
            sample.program.is_running = 0;
            sample.state = MachineState::ready;
            sut.note(*header_, sample, vase_);
        }
        EXPECT_EQ(layer_on_disk(), 2U) << carve_first_tick;
        EXPECT_EQ(in_segment().next_layer, 2U) << carve_first_tick;
    }
}

TEST_F(PieceMemoryTest, AStartThatIsAbortedBeforeItCarvesLeavesTheDisksRecord) {
    const auto cup = test::job_called("cup.stl");
    const Checkpoint of_cup = checkpoint_at(cup->checksum, 1, cup->view.layer_count());
    Checkpoint damaged = after(1);
    damaged.check ^= 1;
    for (const Checkpoint& in_segment_before : {damaged, of_cup}) {
        leave_on_disk(2);
        leave_in_segment(in_segment_before);
        {
            PieceMemory sut{place()};
            sut.enter(*header_);
            sut.take_job(*header_, vase_);
            sut.note(*header_, carving_from(0, MachineState::positioning), vase_);
            for (int i = 0; i < 60'000 && layer_on_disk() != 0; ++i)
                std::this_thread::sleep_for(std::chrono::milliseconds{1});
            ASSERT_EQ(layer_on_disk(), 0U);
            sut.note(*header_, carving_from(0, MachineState::ready), vase_);
        }
        EXPECT_EQ(layer_on_disk(), 2U);
        EXPECT_EQ(load_saved_checkpoint(names().checkpoint())->checkpoint.earlier_layer, 0U);
    }
}

TEST_F(PieceMemoryTest, SaysInTheSegmentWhereItKeepsIt) {
    PieceMemory sut{place()};
    sut.enter(*header_);
    EXPECT_EQ(CoreKeeping::unpack(header_->core.keeping.load()), CoreKeeping::in(folder_.path("state")));
    PieceMemory nowhere{CheckpointPlace{}};
    nowhere.enter(*header_);
    EXPECT_EQ(CoreKeeping::unpack(header_->core.keeping.load()).how, CoreKeeping::How::nowhere);
}

TEST_F(PieceMemoryTest, WhatAStartHadAnnouncedIsTakenBackAlsoWhereAnotherRecordIsForgotten) {
    leave_on_disk(2);
    {
        PieceMemory sut{place()};
        sut.take_job(*header_, vase_);
        sut.note(*header_, carving_from(0, MachineState::positioning), vase_);
        for (int i = 0; i < 60'000 && layer_on_disk() != 0; ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds{1});
        sut.forget(*header_, {"/shop", false, vase_->checksum, 1});
        sut.note(*header_, carving_from(0, MachineState::ready), vase_);
    }
    EXPECT_EQ(layer_on_disk(), 2U);
}

TEST_F(PieceMemoryTest, ForgetsNoOtherJobsRecord) {
    leave_on_disk(2);
    const auto of_vase = load_saved_checkpoint(names().checkpoint())->name();
    const auto cup = test::job_called("cup.stl");
    PieceMemory sut{place()};
    leave_in_segment(checkpoint_at(cup->checksum, 1, cup->view.layer_count()));
    sut.forget(*header_, of_vase);
    EXPECT_EQ(in_segment().job_checksum, cup->checksum);
}

TEST_F(PieceMemoryTest, ForgetsNoRealPieceForTheSimulatedMachines) {
    leave_on_disk(2);
    auto of_simulated = load_saved_checkpoint(names().checkpoint())->name();
    of_simulated.is_simulator = true;
    {
        PieceMemory sut{place()};
        sut.take_job(*header_, vase_);
        EXPECT_EQ(sut.forget(*header_, of_simulated).id, MessageId::record_of_other_kind);
    }
    EXPECT_EQ(in_segment().next_layer, 2U);
    EXPECT_EQ(layer_on_disk(), 2U);
}

TEST_F(PieceMemoryTest, ForgetsNoRecordThatIsNewerThanTheNamedOne) {
    leave_on_disk(1);
    const auto seen = load_saved_checkpoint(names().checkpoint())->name();
    leave_on_disk(2);
    RecordName of_segment_alone = seen;
    of_segment_alone.sequence = 0;
    {
        PieceMemory sut{place()};
        sut.take_job(*header_, vase_);
        EXPECT_EQ(sut.forget(*header_, seen).id, MessageId::record_is_another);
        EXPECT_EQ(sut.forget(*header_, of_segment_alone).id, MessageId::record_is_another);
    }
    EXPECT_EQ(in_segment().next_layer, 2U);
    EXPECT_EQ(layer_on_disk(), 2U);
}

TEST_F(PieceMemoryTest, ForgetsWhatTheSegmentAloneKnows) {
    leave_in_segment(after(1));
    PieceMemory sut{place()};
    EXPECT_TRUE(sut.forget(*header_, {"/shop", false, vase_->checksum, 0}).is_none());
    EXPECT_TRUE(in_segment().is_empty());
}

TEST_F(PieceMemoryTest, TakesNothingThatIsAnotherSegmentsOrTheOtherMachines) {
    for (const bool is_simulator : {false, true}) {
        leave_on_disk(2);
        auto saved = *load_saved_checkpoint(names().checkpoint());
        if (is_simulator) saved.is_simulator = true;
        if (!is_simulator) saved.segment_name = "/other";
        ASSERT_TRUE(save_checkpoint(saved, names().checkpoint()));
        testing::internal::CaptureStderr();
        remark_of_new_core();
        EXPECT_TRUE(in_segment().is_empty());
        EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("it is not taken"));
    }
}

TEST_F(PieceMemoryTest, GoesOnWithinALayerOnlyWhereItSawItCarvedSoFar) {
    const std::uint64_t points = vase_->view.point_count();
    PieceMemory sut{place()};
    std::uint64_t tick = 0;
    const auto carve = [&](std::uint64_t layer, std::uint64_t step, std::uint64_t points_done) {
        cycle::Sample sample = carving_from(layer, MachineState::carving);
        sample.first_step = step;
        sample.job_start_tick = tick += 100;
        sample.carve_first_tick = tick + 1;
        sample.points_done = points_done;
        sut.note(*header_, sample, vase_);
        return in_segment().next_layer;
    };
    EXPECT_EQ(carve(1, 2, 2 * points), 0U) << "of this piece nothing is known";
    EXPECT_EQ(carve(0, 0, 2), 0U);
    EXPECT_EQ(carve(0, 2, points), 0U) << "the first layer's third point was never reached";
    EXPECT_EQ(carve(0, 0, points + 2), 1U);
    EXPECT_EQ(carve(0, 1, points - 1), 1U) << "a part done again";
    EXPECT_EQ(carve(1, 2, 2 * points), 1U) << "its third point was never reached";
    EXPECT_EQ(carve(1, 1, 2 * points), 2U) << "its second was";
    EXPECT_EQ(carve(2, 1, 3 * points), 2U) << "of the layer after nothing is carved";
}

TEST_F(PieceMemoryTest, ThePointWithinALayerOutlivesTheCoreInTheSegmentAlone) {
    const auto point = [&] { return point_to_resume(header_->reached_point.load(), in_segment()); };
    const std::uint64_t points = vase_->view.point_count();
    std::uint64_t tick = 0;
    const auto carve = [&](PieceMemory& sut, std::uint64_t layer, std::uint64_t step, std::uint64_t done,
                           AlarmCause cause = AlarmCause::none) {
        cycle::Sample sample = carving_from(layer, MachineState::carving);
        sample.first_step = step;
        sample.job_start_tick = tick += 100;
        sample.carve_first_tick = tick + 1;
        sample.points_done = done;
        sample.alarm_cause = cause;
        sut.note(*header_, sample, vase_);
    };
    {
        PieceMemory sut{place()};
        sut.enter(*header_);
        sut.take_job(*header_, vase_);
        carve(sut, 0, 0, 1);
        EXPECT_FALSE(point()) << "with the first point it is the layer's begin";
        carve(sut, 0, 0, 2);
        EXPECT_EQ(point(), 1U) << "in the first layer, too";
        carve(sut, 0, 0, points);
        EXPECT_FALSE(point()) << "nothing is left of the layer";
        carve(sut, 0, 0, points + 2);
        EXPECT_EQ(point(), 1U);
        carve(sut, 1, 0, points + 1);
        EXPECT_FALSE(point()) << "the layer done again";
        carve(sut, 1, 0, points + 2);
        EXPECT_EQ(point(), 1U);
        carve(sut, 2, 1, 2 * points + 2);
        EXPECT_EQ(point(), 1U) << "a run that leaves a gap";
    }
    {
        PieceMemory sut{place()};
        sut.enter(*header_);
        sut.take_job(*header_, vase_);
        EXPECT_EQ(point(), 1U) << "another core";
        carve(sut, 1, 1, 2 * points);
        EXPECT_EQ(in_segment().next_layer, 2U) << "it goes on there";
        carve(sut, 2, 0, 2 * points + 2, AlarmCause::steps_lost);
        EXPECT_FALSE(point()) << "none of its points is known to be right";
        carve(sut, 2, 0, 2 * points + 2);
        EXPECT_EQ(point(), 1U);
    }
    PieceMemory sut{place()};
    sut.take_job(*header_, vase_);
    EXPECT_EQ(point(), 1U);
    sut.forget(*header_,
               {"/shop", false, vase_->checksum, load_saved_checkpoint(names().checkpoint())->sequence});
    EXPECT_FALSE(point());
    EXPECT_EQ(header_->reached_point.load(), 0U);
}

TEST_F(PieceMemoryTest, APointIsOfTheRecordThatItWasWrittenBeside) {
    const Checkpoint known = after(1);
    const std::uint64_t word = reached_word(vase_->checksum, 1, 2);
    EXPECT_EQ(point_to_resume(word, known), 2U);
    EXPECT_FALSE(point_to_resume(0, known));
    EXPECT_FALSE(point_to_resume(word, after(2)));
    EXPECT_FALSE(point_to_resume(word, after(1, kCheckpointFromDisk)));
    EXPECT_FALSE(point_to_resume(reached_word(~vase_->checksum, 1, 2), known));
    Checkpoint damaged = known;
    damaged.check ^= 1;
    EXPECT_FALSE(point_to_resume(word, damaged));
    const Checkpoint large = checkpoint_at(~std::uint64_t{0}, 999'998, 1'000'000);
    EXPECT_EQ(point_to_resume(reached_word(~std::uint64_t{0}, 999'998, 999'999), large), 999'999U);
    // A record of the other kind of machine takes its point along; so does a disk's lower word.
    leave_in_segment(after(1, kCheckpointSimulated));
    header_->reached_point.store(word);
    remark_of_new_core();
    EXPECT_EQ(header_->reached_point.load(), 0U);
}

TEST_F(PieceMemoryTest, SaysThatThePieceWasBegunWithAnotherProfile) {
    leave_on_disk(2);
    CheckpointPlace other = place();
    other.profile_hash = kPieceProfile + 1;
    PieceMemory sut{other};
    EXPECT_THAT(in_words(sut.take_job(*header_, vase_)), HasSubstr("begun with another profile"));
}

TEST_F(PieceMemoryTest, ForgetsInSegmentAndOnDisk) {
    leave_on_disk(2);
    {
        PieceMemory sut{place()};
        sut.take_job(*header_, vase_);
        ASSERT_EQ(in_segment().next_layer, 2U);
        sut.forget(*header_, load_saved_checkpoint(names().checkpoint())->name());
        EXPECT_TRUE(in_segment().is_empty());
        sut.take_job(*header_, vase_);
        EXPECT_TRUE(in_segment().is_empty());
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder_.path("state")));
}

}  // namespace
}  // namespace psicarve::supervisor
