// SPDX-License-Identifier: GPL-3.0-or-later
// What is kept while a disk takes its time.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "rtcore/checkpoint/piece_memory.hpp"
#include "shared/segment/shared_record.hpp"
#include "tests/rtcore/supervisor/kept_job.hpp"
#include "tests/rtcore/supervisor/slow_disk.hpp"
#include "tests/shared/temporary_folder.hpp"

namespace psicarve::supervisor {
namespace {

using test::SlowDisk;
using testing::HasSubstr;

class SlowDiskTest : public testing::Test {
protected:
    SlowDiskTest() {
        sut_->enter(*header_);
        sut_->take_job(*header_, cup_);
    }
    CheckpointPlace place() const { return {folder_.path("state"), "/shop", false, 77}; }
    std::optional<SavedCheckpoint> on_disk() const {
        const auto saved =
            load_saved_checkpoint(StateNames{folder_.path("state"), "/shop", false}.checkpoint());
        return saved ? std::optional{*saved} : std::nullopt;
    }
    std::string told() const {
        const auto saved = on_disk();
        return saved ? saved->source_name + " " + std::to_string(saved->checkpoint.next_layer) : "nothing";
    }
    void note(const std::shared_ptr<const LoadedJob>& job, MachineState state, std::uint64_t start_tick,
              std::uint64_t layers = 0, bool is_carved = false) {
        cycle::Sample sample{};
        sample.state = state;
        sample.job_generation = job->generation;
        sample.job_start_tick = start_tick;
        sample.carve_first_tick = is_carved ? start_tick + 1 : 0;
        sample.points_done = layers * job->view.point_count();
        sut_->note(*header_, sample, job);
    }
    void carve(const std::shared_ptr<const LoadedJob>& job, std::uint64_t layers, std::uint64_t start_tick) {
        note(job, MachineState::carving, start_tick, layers, true);
        note(job, MachineState::ready, start_tick, layers, true);
    }
    CoreKeeping::How how() const { return CoreKeeping::unpack(header_->core.keeping.load()).how; }
    bool comes(const std::function<bool()>& is_so) {
        for (int i = 0; i < 60'000; ++i) {
            sut_->note(*header_, {}, nullptr);
            if (is_so()) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds{1});
        }
        return false;
    }
    /// Of a core that has ended.
    void end_core() { sut_.reset(); }

    psicarve::test::TemporaryFolder folder_;
    std::shared_ptr<const LoadedJob> vase_ = test::job_called("vase.stl", 1);
    std::shared_ptr<const LoadedJob> cup_ = test::job_called("cup.stl", 2);
    std::unique_ptr<SegmentHeader> header_ = std::make_unique<SegmentHeader>();
    std::unique_ptr<PieceMemory> sut_ = std::make_unique<PieceMemory>(place());
};

TEST_F(SlowDiskTest, AnotherJobsStartThatCarvesNothingPushesNoRecordOut) {
    carve(cup_, 1, 50);
    ASSERT_TRUE(comes([&] { return told() == "cup.stl 1"; }));
    {
        const SlowDisk slow;
        carve(cup_, 2, 50);
        slow.wait_for_somebody();
        sut_->take_job(*header_, vase_);
        carve(vase_, 1, 100);
        sut_->take_job(*header_, cup_);
        note(cup_, MachineState::waiting, 500);
        note(cup_, MachineState::ready, 500);
    }
    end_core();
    EXPECT_EQ(told(), "vase.stl 1");
}

TEST_F(SlowDiskTest, WhatIsCarvedAfterAnAnnouncementThatWaitsStands) {
    carve(cup_, 1, 50);
    {
        const SlowDisk slow;
        carve(cup_, 2, 50);
        slow.wait_for_somebody();
        note(cup_, MachineState::waiting, 500);
        carve(cup_, 1, 500);
    }
    end_core();
    EXPECT_EQ(told(), "cup.stl 1");
    EXPECT_EQ(on_disk()->checkpoint.earlier_layer, 2U);
}

TEST_F(SlowDiskTest, ManyThatAreToBeForgottenSwitchNothingOff) {
    carve(cup_, 1, 50);
    ASSERT_TRUE(comes([&] { return told() == "cup.stl 1"; }));
    {
        const SlowDisk slow;
        carve(cup_, 2, 50);
        slow.wait_for_somebody();
        testing::internal::CaptureStderr();
        Message last{};
        for (std::uint64_t i = 0; i < 300; ++i) last = sut_->forget(*header_, {"/shop", false, 4711, i});
        EXPECT_EQ(last.id, MessageId::forget_disk_silent);
    }
    carve(cup_, 3, 50);
    EXPECT_TRUE(comes([&] { return told() == "cup.stl 3"; })) << told();
    end_core();
    testing::internal::GetCapturedStderr();
}

TEST_F(SlowDiskTest, WhatIsNamedByAnOlderRecordThanIsCarvedStays) {
    carve(cup_, 1, 50);
    ASSERT_TRUE(comes([&] { return told() == "cup.stl 1"; }));
    {
        const SlowDisk slow;
        carve(cup_, 2, 50);
        EXPECT_EQ(sut_->forget(*header_, on_disk()->name()).id, MessageId::record_is_another);
    }
    EXPECT_EQ(read_record(header_->checkpoint)->next_layer, 2U);
    ASSERT_TRUE(comes([&] { return told() == "cup.stl 2"; }));
    EXPECT_TRUE(sut_->forget(*header_, on_disk()->name()).is_none());
    EXPECT_TRUE(read_record(header_->checkpoint)->is_empty());
    end_core();
    EXPECT_EQ(told(), "nothing");
}

TEST_F(SlowDiskTest, WhatIsForgottenBeforeTheDiskAnswersDoesNotComeBack) {
    carve(cup_, 2, 50);
    end_core();
    for (const bool is_by_job : {false, true}) {
        write_record(header_->checkpoint, Checkpoint{});
        RecordName named = on_disk()->name();
        if (is_by_job) named.sequence = 0;
        {
            const SlowDisk slow;
            sut_ = std::make_unique<PieceMemory>(place());
            sut_->take_job(*header_, cup_);
            EXPECT_TRUE(sut_->forget(*header_, named).is_none());
        }
        EXPECT_TRUE(comes([&] {
            note(cup_, MachineState::ready, 0);
            return how() == CoreKeeping::How::kept;
        }));
        EXPECT_TRUE(read_record(header_->checkpoint)->is_empty());
        end_core();
        EXPECT_EQ(told(), is_by_job ? "cup.stl 2" : "nothing");
        sut_ = std::make_unique<PieceMemory>(place());
        carve(cup_, 2, 50);
        end_core();
    }
}

TEST_F(SlowDiskTest, OneThatDoesNotAnswerIsSaidToRefuseUntilItDoes) {
    carve(cup_, 1, 50);
    ASSERT_TRUE(comes([&] { return told() == "cup.stl 1"; }));
    testing::internal::CaptureStderr();
    for (int i = 0; i < 2; ++i) {
        const SlowDisk slow;
        carve(cup_, 2 + static_cast<std::uint64_t>(i), 50);
        EXPECT_TRUE(comes([&] { return how() == CoreKeeping::How::refused; }));
        if (i == 1) break;
        carve(cup_, 3, 50);
        EXPECT_EQ(how(), CoreKeeping::How::refused);
    }
    EXPECT_TRUE(comes([&] { return how() == CoreKeeping::How::kept; }));
    end_core();
    EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("the disk does not answer"));
    EXPECT_EQ(told(), "cup.stl 3");
}

}  // namespace
}  // namespace psicarve::supervisor
