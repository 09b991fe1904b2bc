// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/checkpoint/checkpoint_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <thread>

#include "shared/file/atomic_file.hpp"
#include "shared/record/snapshot_file.hpp"
#include "tests/rtcore/supervisor/kept_job.hpp"
#include "tests/shared/temporary_folder.hpp"

namespace psicarve::supervisor {
namespace {

using test::job_called;
using testing::HasSubstr;

/// No file grows beyond so many bytes.
class FullDisk {
public:
    explicit FullDisk(rlim_t most_bytes = 1) : before_handler_(signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit now{most_bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &now);
    }
    ~FullDisk() {
        setrlimit(RLIMIT_FSIZE, &before_);
        signal(SIGXFSZ, before_handler_);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

private:
    rlimit before_{};
    void (*before_handler_)(int);
};

class CheckpointFileTest : public testing::Test {
protected:
    CheckpointPlace place(const std::string& folder = "state") const {
        return {folder_.path(folder), "/shop", false, 77};
    }
    StateNames names() const { return {folder_.path("state"), "/shop", false}; }
    Checkpoint after(std::uint32_t layers, std::uint32_t earlier = 0) const {
        return checkpoint_at(vase_->checksum, layers, vase_->view.layer_count(), earlier);
    }
    /// Of a core that has ended.
    void keep(const Checkpoint& checkpoint, const std::shared_ptr<const LoadedJob>& job) const {
        CheckpointFile sut{place()};
        sut.keep({checkpoint, Keeping::carved}, job);
    }
    void keep_as(const Checkpoint& checkpoint, Keeping why) const {
        CheckpointFile sut{place()};
        sut.keep({checkpoint, why}, vase_);
    }
    std::uint32_t layer_on_disk() const {
        const auto saved = load_saved_checkpoint(names().checkpoint());
        return saved ? saved->checkpoint.next_layer : 999;
    }
    std::size_t files() const {
        const auto all = std::filesystem::directory_iterator{folder_.path("state")};
        return static_cast<std::size_t>(std::distance(begin(all), end(all)));
    }

    psicarve::test::TemporaryFolder folder_;
    std::shared_ptr<const LoadedJob> vase_ = job_called("vase.stl");
};

TEST_F(CheckpointFileTest, KeepsWhatSomebodyWantsToKnowAndTheJob) {
    keep(after(1), vase_);
    const auto saved = load_saved_checkpoint(names().checkpoint());
    ASSERT_TRUE(saved) << saved.error().message;
    EXPECT_EQ(saved->checkpoint.next_layer, 1U);
    EXPECT_EQ(saved->job_bytes, vase_->blob.size());
    EXPECT_EQ(saved->profile_hash, 77U);
    EXPECT_EQ(saved->source_name, "vase.stl");
    EXPECT_EQ(saved->tool, "ball, 3 mm");
    EXPECT_GT(saved->written_s, 1'700'000'000);
    const auto copy = load_snapshot(names().job(vase_->checksum));
    ASSERT_TRUE(copy) << copy.error().message;
    EXPECT_TRUE(copy->job_blob == vase_->blob);
    EXPECT_FALSE(copy->status);
    struct stat facts {};
    ASSERT_EQ(stat(folder_.path("state").c_str(), &facts), 0);
    EXPECT_EQ(facts.st_mode & 07777U, 0755U);
}

TEST_F(CheckpointFileTest, TheNextCoreFindsItForThatVeryJob) {
    keep(after(1, 2), vase_);
    CheckpointFile sut{place()};
    const auto left = sut.left_of(*job_called("vase.stl", 9));
    ASSERT_TRUE(left);
    EXPECT_EQ(left->checkpoint.next_layer, 1U);
    EXPECT_EQ(left->checkpoint.earlier_layer, 2U);
    EXPECT_FALSE(sut.left_of(*job_called("cup.stl")));
    ASSERT_TRUE(sut.left_of(*vase_)) << "another job that was only looked at changes nothing";
}

TEST_F(CheckpointFileTest, WhatWasLeftIsPastOnceSomethingIsKept) {
    keep(after(2), vase_);
    CheckpointFile sut{place()};
    ASSERT_TRUE(sut.left_of(*vase_));
    EXPECT_EQ(sut.most_told_of(*vase_), 2U);
    sut.keep({after(1), Keeping::carved}, vase_);
    EXPECT_FALSE(sut.left_of(*vase_));
    EXPECT_EQ(sut.most_told_of(*vase_), 2U) << "until the disk has done it";
}

TEST_F(CheckpointFileTest, EachIsNewerThanAllThatStoodThereWhateverTheClockSays) {
    keep(after(1), vase_);
    auto before = *load_saved_checkpoint(names().checkpoint());
    EXPECT_GT(before.sequence, 0U);
    before.sequence = std::uint64_t{1} << 63;
    before.written_s += 1'000'000;
    ASSERT_TRUE(save_checkpoint(before, names().checkpoint()));
    keep(after(2), vase_);
    EXPECT_EQ(load_saved_checkpoint(names().checkpoint())->sequence, before.sequence + 1);
}

TEST_F(CheckpointFileTest, ASequenceNeverComesAgainAlsoWhereAllWasForgotten) {
    keep(after(1), vase_);
    const auto first = *load_saved_checkpoint(names().checkpoint());
    std::filesystem::remove_all(folder_.path("state"));
    keep(after(1), vase_);
    EXPECT_FALSE(load_saved_checkpoint(names().checkpoint())->name() == first.name());
}

TEST_F(CheckpointFileTest, ForgetsTheNamedRecordAndNoOtherThatHasComeMeanwhile) {
    keep(after(1), vase_);
    const RecordName seen = load_saved_checkpoint(names().checkpoint())->name();
    {
        CheckpointFile sut{place()};
        sut.keep({after(2), Keeping::carved}, vase_);
        sut.forget(seen);
    }
    EXPECT_EQ(layer_on_disk(), 2U);
    EXPECT_EQ(files(), 2U);
    {
        CheckpointFile sut{place()};
        sut.forget(load_saved_checkpoint(names().checkpoint())->name());
        EXPECT_FALSE(sut.left_of(*vase_));
    }
    EXPECT_EQ(files(), 0U);
}

TEST_F(CheckpointFileTest, OfAnotherJobItIsAnotherFileAndTheOldCopyGoes) {
    keep(after(2), vase_);
    ASSERT_EQ(files(), 2U);
    const auto cup = job_called("cup.stl");
    keep(checkpoint_at(cup->checksum, 0, cup->view.layer_count()), cup);
    EXPECT_EQ(layer_on_disk(), 0U);
    EXPECT_EQ(files(), 2U);
    EXPECT_TRUE(load_snapshot(names().job(cup->checksum)));
    CheckpointFile sut{place()};
    EXPECT_FALSE(sut.left_of(*vase_));
}

TEST_F(CheckpointFileTest, TheNewestWinsWhenThereAreMany) {
    {
        CheckpointFile sut{place()};
        for (int i = 0; i < 5000; ++i)
            sut.keep({after(static_cast<std::uint32_t>(i) % 3), Keeping::carved}, vase_);
        sut.keep({after(2), Keeping::carved}, vase_);
    }
    EXPECT_EQ(layer_on_disk(), 2U);
}

TEST_F(CheckpointFileTest, ADamagedOneIsNone) {
    keep(after(2), vase_);
    auto bytes = *read_whole_file(names().checkpoint());
    bytes[100] ^= std::byte{4};
    ASSERT_TRUE(write_file_atomically(names().checkpoint(), bytes));
    testing::internal::CaptureStderr();
    {
        CheckpointFile sut{place()};
        EXPECT_FALSE(sut.left_of(*vase_));
    }
    EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("damaged: its checksum is wrong"));
}

TEST_F(CheckpointFileTest, WithoutAPlaceThereIsNone) {
    CheckpointFile sut{CheckpointPlace{}};
    sut.keep({after(1), Keeping::carved}, vase_);
    EXPECT_FALSE(sut.left_of(*vase_));
    EXPECT_EQ(folder_.file_count(), 0U);
}

TEST_F(CheckpointFileTest, WhatCannotBeWrittenIsSaidOnceAndLeavesNoFileOfAnotherPiece) {
    keep(after(2), vase_);
    testing::internal::CaptureStderr();
    {
        CheckpointFile sut{place()};
        // A folder in its place, for tests are run as root, too.
        std::filesystem::remove(names().checkpoint());
        std::filesystem::create_directory(names().checkpoint());
        sut.keep({after(0), Keeping::carved}, vase_);
        sut.keep({after(1), Keeping::carved}, vase_);
    }
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_THAT(said, HasSubstr("shop.checkpoint: is a folder"));
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
    EXPECT_THAT(said, HasSubstr("nobody knows how far the piece has come"));
}

TEST_F(CheckpointFileTest, AFileThatToldMoreThanIsCarvedNowGoesWhenItCannotBeReplaced) {
    keep(after(2), vase_);
    ASSERT_EQ(layer_on_disk(), 2U);
    {
        const FullDisk full;
        keep(after(0), vase_);
    }
    EXPECT_FALSE(std::filesystem::exists(names().checkpoint()));
}

TEST_F(CheckpointFileTest, AFileThatToldLessStaysWhenItCannotBeReplaced) {
    auto sut = std::make_unique<CheckpointFile>(place());
    sut->keep({after(1), Keeping::carved}, vase_);
    for (int i = 0; i < 60'000 && layer_on_disk() != 1; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds{1});
    {
        const FullDisk full;
        sut->keep({after(2), Keeping::carved}, vase_);
        sut.reset();
    }
    EXPECT_EQ(layer_on_disk(), 1U);
}

TEST_F(CheckpointFileTest, OfAPieceThatIsCarvedToItsEndNothingStaysThatSaysLess) {
    keep(after(1), vase_);
    {
        const FullDisk full;
        keep(after(vase_->view.layer_count()), vase_);
    }
    EXPECT_FALSE(std::filesystem::exists(names().checkpoint())) << "it would be offered again";
}

TEST_F(CheckpointFileTest, SaysThatTheDiskHasNotTakenTheNewest) {
    CheckpointFile sut{place()};
    EXPECT_EQ(sut.keeping(), CoreKeeping::in(folder_.path("state")));
    const auto is_told = [&](CoreKeeping::How how) {
        for (int i = 0; i < 60'000 && sut.keeping().how != how; ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds{1});
        return sut.keeping().how == how;
    };
    {
        const FullDisk full;
        sut.keep({after(1), Keeping::carved}, vase_);
        EXPECT_TRUE(is_told(CoreKeeping::How::refused));
    }
    sut.keep({after(2), Keeping::carved}, vase_);
    EXPECT_TRUE(is_told(CoreKeeping::How::kept));
    EXPECT_EQ(CheckpointFile{CheckpointPlace{}}.keeping().how, CoreKeeping::How::nowhere);
}

TEST_F(CheckpointFileTest, WhatADiskHasRefusedIsTriedAgainThoughNothingMoreIsCarved) {
    CheckpointFile sut{place()};
    const auto is_told = [&](CoreKeeping::How how) {
        for (int i = 0; i < 60'000 && sut.keeping().how != how; ++i) {
            sut.tend();
            std::this_thread::sleep_for(std::chrono::milliseconds{1});
        }
        return sut.keeping().how == how;
    };
    {
        const FullDisk full;
        sut.keep({after(1), Keeping::carved}, vase_);
        EXPECT_TRUE(is_told(CoreKeeping::How::refused));
    }
    EXPECT_TRUE(is_told(CoreKeeping::How::kept));
    EXPECT_EQ(layer_on_disk(), 1U);
}

TEST_F(CheckpointFileTest, ARecordThatIsNotForgottenIsToldOfOnce) {
    keep(after(1), vase_);
    testing::internal::CaptureStderr();
    {
        CheckpointFile sut{place()};
        for (std::uint64_t i = 1; i < 4; ++i) sut.forget({"/shop", false, vase_->checksum, i});
    }
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
}

TEST_F(CheckpointFileTest, AStartThatCarvedNothingLeavesAnotherJobsRecordAndCopyAsTheyWere) {
    keep(after(2), vase_);
    const auto stood = *load_saved_checkpoint(names().checkpoint());
    const auto cup = job_called("cup.stl");
    const auto of_cup = [&](std::uint32_t layers, std::uint32_t earlier = 0) {
        return checkpoint_at(cup->checksum, layers, cup->view.layer_count(), earlier);
    };
    {
        // The segment knows that a layer of the cup was carved.
        CheckpointFile sut{place()};
        sut.keep({of_cup(0, 1), Keeping::announced}, cup);
        for (int i = 0; i < 60'000 && layer_on_disk() != 0; ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds{1});
        ASSERT_EQ(layer_on_disk(), 0U);
        sut.keep({of_cup(1), Keeping::as_before}, cup);
    }
    const auto now = *load_saved_checkpoint(names().checkpoint());
    EXPECT_EQ(now.checkpoint.job_checksum, vase_->checksum);
    EXPECT_EQ(now.checkpoint.next_layer, 2U);
    EXPECT_EQ(now.source_name, "vase.stl");
    EXPECT_EQ(now.written_s, stood.written_s);
    EXPECT_TRUE(std::filesystem::exists(names().job(vase_->checksum)));
    {
        // Of nothing but the vase does the disk tell: that stays true until something is carved.
        CheckpointFile sut{place()};
        sut.keep({of_cup(0), Keeping::announced}, cup);
    }
    EXPECT_EQ(load_saved_checkpoint(names().checkpoint())->name(), now.name());
}

TEST_F(CheckpointFileTest, AnAnnouncementTellsOfTheRunBefore) {
    keep(after(2), vase_);
    keep_as(after(0), Keeping::announced);
    const auto saved = load_saved_checkpoint(names().checkpoint());
    EXPECT_EQ(saved->checkpoint.next_layer, 0U);
    EXPECT_EQ(saved->checkpoint.earlier_layer, 2U) << "of which the segment knew nothing";
}

TEST_F(CheckpointFileTest, FactsAreThoseOfTheJobWhateverItsGeneration) {
    const auto cup = job_called("cup.stl", vase_->generation);
    CheckpointFile sut{place()};
    sut.keep({after(1), Keeping::carved}, vase_);
    for (int i = 0; i < 60'000 && layer_on_disk() != 1; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds{1});
    sut.keep({checkpoint_at(cup->checksum, 2, cup->view.layer_count()), Keeping::carved}, cup);
    for (int i = 0; i < 60'000 && layer_on_disk() != 2; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds{1});
    EXPECT_EQ(load_saved_checkpoint(names().checkpoint())->source_name, "cup.stl");
}

TEST_F(CheckpointFileTest, AJobThatDidNotFitIsCopiedOnceThereIsRoom) {
    CheckpointFile sut{place()};
    {
        const FullDisk full{2000};
        sut.keep({after(1), Keeping::carved}, vase_);
        for (int i = 0; i < 60'000 && layer_on_disk() != 1; ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds{1});
    }
    for (int i = 0; i < 60'000 && !std::filesystem::exists(names().job(vase_->checksum)); ++i) {
        sut.keep({after(1 + static_cast<std::uint32_t>(i) % 2), Keeping::carved}, vase_);
        std::this_thread::sleep_for(std::chrono::milliseconds{1});
    }
    EXPECT_TRUE(load_snapshot(names().job(vase_->checksum)));
}

TEST_F(CheckpointFileTest, AJobThatDoesNotFitIsNotCopiedAndTheCheckpointIsThere) {
    {
        const FullDisk full{2000};
        ASSERT_GT(vase_->blob.size(), 2000U);
        keep(after(1), vase_);
    }
    EXPECT_EQ(layer_on_disk(), 1U);
    EXPECT_EQ(files(), 1U);
}

}  // namespace
}  // namespace psicarve::supervisor
