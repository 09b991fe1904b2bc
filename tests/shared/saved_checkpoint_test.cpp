// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/record/saved_checkpoint.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <thread>

#include "shared/file/atomic_file.hpp"
#include "shared/record/snapshot_file.hpp"
#include "tests/places.hpp"
#include "tests/shared/temporary_folder.hpp"
#include "tests/two_process/child_process.hpp"

namespace psicarve {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::uint64_t kSavedJob = 0x1234'5678'9abc'def0ULL;

std::uint64_t last_sequence = 0;

SavedCheckpoint saved_at(std::uint32_t next_layer, std::int64_t written_s = 1'764'185'000) {
    SavedCheckpoint saved;
    saved.checkpoint = checkpoint_at(kSavedJob, next_layer, 400, 0);
    saved.job_bytes = 5000;
    saved.profile_hash = 77;
    saved.written_s = written_s;
    saved.sequence = ++last_sequence;
    saved.segment_name = "/shop";
    saved.source_name = "vase \u00e9.stl";
    saved.tool = "ball, 3 mm";
    return saved;
}

std::string problem_of(std::span<const std::byte> bytes) {
    const auto parsed = parse_saved_checkpoint(bytes, "x");
    return parsed ? std::string{} : parsed.error().message;
}

/// Sets the place for as long as it lives; tests have none otherwise.
class StateVariable {
public:
    explicit StateVariable(const std::string& folder) { setenv("PSICARVE_STATE", folder.c_str(), 1); }
    ~StateVariable() { setenv("PSICARVE_STATE", "", 1); }
    StateVariable(const StateVariable&) = delete;
    StateVariable& operator=(const StateVariable&) = delete;
};

TEST(SavedCheckpoint, ComesBackAsItWas) {
    SavedCheckpoint saved = saved_at(131);
    saved.checkpoint = checkpoint_at(kSavedJob, 131, 400, 250);
    saved.is_simulator = true;
    const auto sut = parse_saved_checkpoint(saved_checkpoint_bytes(saved), "x");
    ASSERT_TRUE(sut) << sut.error().message;
    EXPECT_EQ(sut->checkpoint.job_checksum, kSavedJob);
    EXPECT_EQ(sut->checkpoint.next_layer, 131U);
    EXPECT_EQ(sut->checkpoint.layer_count, 400U);
    EXPECT_EQ(sut->checkpoint.earlier_layer, 250U);
    EXPECT_EQ(sut->job_bytes, 5000U);
    EXPECT_EQ(sut->profile_hash, 77U);
    EXPECT_EQ(sut->written_s, 1'764'185'000);
    EXPECT_TRUE(sut->is_simulator);
    EXPECT_EQ(sut->source_name, saved.source_name);
    EXPECT_EQ(sut->tool, "ball, 3 mm");
}

TEST(SavedCheckpoint, EveryTruncationIsNone) {
    const auto bytes = saved_checkpoint_bytes(saved_at(131));
    for (std::size_t size = 0; size < bytes.size(); ++size)
        EXPECT_NE(problem_of(std::span{bytes}.first(size)), "") << size;
    auto longer = bytes;
    longer.push_back(std::byte{0});
    EXPECT_THAT(problem_of(longer), HasSubstr("wrong size"));
}

TEST(SavedCheckpoint, EveryFlippedBitIsNone) {
    auto bytes = saved_checkpoint_bytes(saved_at(131));
    for (std::size_t at = 0; at < bytes.size(); ++at) {
        for (int bit = 0; bit < 8; ++bit) {
            bytes[at] ^= std::byte{1} << bit;
            EXPECT_NE(problem_of(bytes), "") << at << ", " << bit;
            bytes[at] ^= std::byte{1} << bit;
        }
    }
    EXPECT_EQ(problem_of(bytes), "");
}

TEST(SavedCheckpoint, SaysWhatAFileIsThatIsNone) {
    test::TemporaryFolder folder;
    const auto problem = [](const std::string& path) {
        const auto loaded = load_saved_checkpoint(path);
        return loaded ? std::string{} : loaded.error().message;
    };
    EXPECT_NE(problem(folder.path("gone")), "");
    EXPECT_NE(problem(folder.path("")), "") << "a folder";
    EXPECT_NE(problem("/dev/zero"), "") << "a device";
    const std::string foreign = "Dear diary, today I carved a vase and it was a good one.";
    ASSERT_TRUE(write_file_atomically(folder.path("a"), std::as_bytes(std::span{foreign})));
    EXPECT_THAT(problem(folder.path("a")), HasSubstr("is no psicarve checkpoint"));
    SavedCheckpoint nonsense = saved_at(131);
    nonsense.checkpoint.next_layer = 401;
    ASSERT_TRUE(save_checkpoint(nonsense, folder.path("b")));
    EXPECT_THAT(problem(folder.path("b")), HasSubstr("holds no checkpoint"));
}

TEST(SavedCheckpoint, EverybodyMayReadItWhateverTheUmask) {
    test::TemporaryFolder folder;
    const mode_t before = umask(0077);
    const auto saved = save_checkpoint(saved_at(1), folder.path("a"));
    umask(before);
    ASSERT_TRUE(saved) << saved.error().message;
    struct stat facts {};
    ASSERT_EQ(stat(folder.path("a").c_str(), &facts), 0);
    EXPECT_EQ(facts.st_mode & 07777U, 0644U);
}

TEST(SavedCheckpoint, NamesTheToolAsAPersonDoes) {
    EXPECT_EQ(tool_text({.shape = ToolShape::point}), "point");
    EXPECT_EQ(tool_text({.shape = ToolShape::ball, .diameter_mm = 6.0}), "ball, 6 mm");
    EXPECT_EQ(tool_text({.shape = ToolShape::vee, .diameter_mm = 3.175}), "vee, 3.175 mm");
    EXPECT_EQ(tool_text({.shape = ToolShape::flat, .diameter_mm = 10.0}), "flat, 10 mm");
}

TEST(SavedCheckpoint, IsUnfinishedFromTheFirstLayerToTheLastButOne) {
    const auto is_unfinished = [](std::uint32_t next, std::uint32_t earlier) {
        SavedCheckpoint saved;
        saved.checkpoint = checkpoint_at(kSavedJob, next, 10, earlier);
        return saved.is_unfinished();
    };
    EXPECT_FALSE(is_unfinished(0, 0)) << "nothing is carved";
    EXPECT_TRUE(is_unfinished(0, 7)) << "by the run before";
    EXPECT_TRUE(is_unfinished(1, 0));
    EXPECT_TRUE(is_unfinished(9, 0));
    EXPECT_FALSE(is_unfinished(10, 0));
}

TEST(SavedCheckpoint, TheRealMachinesIsFoundBeforeTheSimulatedOnes) {
    test::TemporaryFolder folder;
    const StateVariable variable{folder.path("")};
    const StateNames real{folder.path(""), "/shop", false};
    const StateNames simulated{folder.path(""), "/shop", true};
    EXPECT_FALSE(find_unfinished("/shop"));
    SavedCheckpoint practice = saved_at(20, 2'000'000'000);
    practice.is_simulator = true;
    ASSERT_TRUE(save_checkpoint(practice, simulated.checkpoint()));
    ASSERT_TRUE(find_unfinished("/shop"));
    EXPECT_EQ(find_unfinished("/shop")->saved.checkpoint.next_layer, 20U);
    EXPECT_EQ(find_unfinished("/shop")->job_path, "");
    EXPECT_FALSE(find_unfinished("/shop", false));
    EXPECT_FALSE(find_unfinished("/other"));
    ASSERT_TRUE(save_checkpoint(saved_at(131), real.checkpoint()));
    EXPECT_EQ(find_unfinished("/shop")->saved.checkpoint.next_layer, 131U);
    EXPECT_EQ(find_unfinished("/shop", true)->saved.checkpoint.next_layer, 20U);
    // A job that is carved to its end is nothing to go on with, nor is the job before it.
    ASSERT_TRUE(save_checkpoint(saved_at(400), real.checkpoint()));
    EXPECT_FALSE(find_unfinished("/shop", false));
    // What stands under the wrong name is none.
    ASSERT_TRUE(save_checkpoint(practice, real.checkpoint()));
    EXPECT_FALSE(find_unfinished("/shop", false));
}

TEST(SavedCheckpoint, IsOfThatVerySegmentAndMachine) {
    test::TemporaryFolder folder;
    const StateVariable variable{folder.path("")};
    const StateNames names{folder.path(""), "/shop", false};
    SavedCheckpoint other = saved_at(131);
    other.segment_name = "/shop2";
    ASSERT_TRUE(save_checkpoint(other, names.checkpoint()));
    EXPECT_FALSE(find_unfinished("/shop"));
}

/// Two folders that readers know, each with a record of the same segment.
class TwoFolders : public testing::Test {
protected:
    TwoFolders() {
        for (const std::string& folder : {one_, two_}) std::filesystem::create_directory(folder);
        // Sequences of two folders say nothing of each other.
        put(one_, 20, 1'000'000'000, 700);
        put(two_, 131, 2'000'000'000, 3);
    }
    static void put(const std::string& folder, std::uint32_t layer, std::int64_t written_s,
                    std::uint64_t sequence) {
        SavedCheckpoint saved = saved_at(layer, written_s);
        saved.sequence = sequence;
        ASSERT_TRUE(save_checkpoint(saved, StateNames(folder, "/shop", false).checkpoint()));
    }
    std::optional<FoundCheckpoint> found(const CoreKeeping& core = {}) const {
        const auto found = find_newest("/shop", false, {one_, two_}, core);
        const auto backward = find_newest("/shop", false, {two_, one_}, core);
        EXPECT_EQ(found.has_value(), backward.has_value());
        EXPECT_EQ(found ? found->path : "", backward ? backward->path : "");
        return found;
    }

    test::TemporaryFolder folder_;
    std::string one_ = folder_.path("one");
    std::string two_ = folder_.path("two");
};

TEST_F(TwoFolders, WithoutACoreTheDateDecidesAndTheOtherPieceIsNamed) {
    const auto sut = found();
    ASSERT_TRUE(sut);
    EXPECT_EQ(sut->saved.checkpoint.next_layer, 131U);
    EXPECT_EQ(sut->keeper, Keeper::unknown);
    EXPECT_THAT(sut->other_paths, ElementsAre(StateNames(one_, "/shop", false).checkpoint()));
    put(one_, 400, 1'000'000'000, 701);
    EXPECT_THAT(found()->other_paths, ElementsAre()) << "one that is carved to its end";
}

TEST_F(TwoFolders, WhereTheCoreKeepsItHasTheLastWord) {
    const auto sut = found(CoreKeeping::in(one_));
    ASSERT_TRUE(sut);
    EXPECT_EQ(sut->saved.checkpoint.next_layer, 20U);
    EXPECT_EQ(sut->keeper, Keeper::this_core);
    EXPECT_EQ(found(CoreKeeping::in(one_, CoreKeeping::How::refused))->saved.checkpoint.next_layer, 20U);
    std::filesystem::remove(StateNames(one_, "/shop", false).checkpoint());
    EXPECT_FALSE(found(CoreKeeping::in(one_))) << "also that there is none";
}

TEST_F(TwoFolders, WhatIsNotTheCoresIsSaidToBeAnothers) {
    for (const CoreKeeping& core : {CoreKeeping::in(""), CoreKeeping::in(folder_.path("elsewhere"))}) {
        const auto sut = found(core);
        ASSERT_TRUE(sut);
        EXPECT_EQ(sut->saved.checkpoint.next_layer, 131U);
        EXPECT_EQ(sut->keeper, Keeper::other_core);
    }
}

TEST(CoreKeeping, KnowsItsFolderByAnyNameOfIt) {
    const auto sut = CoreKeeping::in("/srv/state");
    for (const char* folder : {"/srv/state", "/srv/state/", "/srv//state", "/srv/x/../state"})
        EXPECT_TRUE(sut.is_in(folder)) << folder;
    EXPECT_FALSE(sut.is_in("/srv/state2"));
    EXPECT_TRUE(CoreKeeping::in("state").is_in(std::filesystem::current_path() / "state"));
    EXPECT_FALSE(CoreKeeping{}.is_in(""));
    EXPECT_EQ(CoreKeeping::in("").how, CoreKeeping::How::nowhere);
    for (const CoreKeeping& one :
         {CoreKeeping{}, CoreKeeping::in(""), sut, CoreKeeping::in("/srv", CoreKeeping::How::refused)})
        EXPECT_EQ(CoreKeeping::unpack(one.pack()), one);
    EXPECT_EQ(CoreKeeping{}.pack(), 0U);
}

TEST(SavedCheckpoint, NoneButTheOneThatIsNamedIsForgotten) {
    test::TemporaryFolder folder;
    const StateNames names{folder.path(""), "/shop", false};
    ASSERT_TRUE(save_checkpoint(saved_at(131), names.checkpoint()));
    const auto found = find_unfinished("/shop", false, folder.path(""));
    ASSERT_TRUE(found);
    // Meanwhile the same job has come further.
    ASSERT_TRUE(save_checkpoint(saved_at(132), names.checkpoint()));
    const auto left = forget_piece(*found);
    ASSERT_FALSE(left);
    EXPECT_THAT(left.error().message, HasSubstr("another record has come meanwhile"));
    EXPECT_EQ(load_saved_checkpoint(names.checkpoint())->checkpoint.next_layer, 132U);
    // What cannot be told is not taken away either.
    const std::string foreign = "PSCKEPT1 of a newer program";
    ASSERT_TRUE(write_file_atomically(names.checkpoint(), std::as_bytes(std::span{foreign})));
    EXPECT_FALSE(forget_piece(*found));
    EXPECT_TRUE(std::filesystem::exists(names.checkpoint()));
    std::filesystem::remove(names.checkpoint());
    EXPECT_TRUE(forget_piece(*found)) << "it is gone";
}

TEST(SavedCheckpoint, ACommandToForgetItNamesItWhole) {
    const RecordName record{"/shop", true, 0xFEDC'BA98'7654'3210ULL, 0x8000'0000'0000'0001ULL};
    EXPECT_EQ(record_to_forget(command_to_forget(record), "/shop"), record);
}

TEST(SavedCheckpoint, IsForgottenWithItsJob) {
    test::TemporaryFolder folder;
    const StateNames names{folder.path(""), "/shop", false};
    ASSERT_TRUE(save_checkpoint(saved_at(131), names.checkpoint()));
    ASSERT_TRUE(save_job_for_everybody(std::vector<std::byte>(64), names.job(kSavedJob)));
    const auto found = find_unfinished("/shop", false, folder.path(""));
    ASSERT_TRUE(found);
    ASSERT_TRUE(forget_piece(*found));
    EXPECT_EQ(folder.file_count(), 0U);
}

TEST(SavedCheckpoint, ItsJobIsFoundByItsChecksumAlone) {
    test::TemporaryFolder folder;
    const StateVariable variable{folder.path("")};
    const StateNames names{folder.path(""), "/shop", false};
    ASSERT_TRUE(save_checkpoint(saved_at(131), names.checkpoint()));
    const std::vector<std::byte> blob(64);
    ASSERT_TRUE(save_job_for_everybody(blob, names.job(kSavedJob + 1)));
    EXPECT_EQ(find_unfinished("/shop")->job_path, "") << "another job's";
    ASSERT_TRUE(save_job_for_everybody(blob, names.job(kSavedJob)));
    EXPECT_EQ(find_unfinished("/shop")->job_path, names.job(kSavedJob));
}

TEST(SavedCheckpoint, KilledAtAnyInstantItIsTheOldOrTheNew) {
    constexpr int kKills = 60;
    test::TemporaryFolder folder;
    const std::string path = folder.path("shop.checkpoint");
    ASSERT_TRUE(save_checkpoint(saved_at(1), path));
    std::minstd_rand random{15};
    std::uint32_t least = 1;
    for (int i = 0; i < kKills; ++i) {
        test::ChildProcess writer{[&](const test::ChildProcess::Signal& has_begun) {
            has_begun.raise();
            for (std::uint32_t layer = least;; layer = layer % 399 + 1)
                if (!save_checkpoint(saved_at(layer), path)) ::_exit(1);
        }};
        ASSERT_TRUE(writer.wait_for_signal());
        std::this_thread::sleep_for(std::chrono::microseconds{random() % 4000});
        writer.kill();
        const auto sut = load_saved_checkpoint(path);
        ASSERT_TRUE(sut) << sut.error().message;
        EXPECT_EQ(sut->source_name, saved_at(1).source_name);
        least = sut->checkpoint.next_layer;
    }
    // What the dead have left goes with the next one, where there is anything at all.
    ASSERT_TRUE(save_checkpoint(saved_at(1), path));
    EXPECT_EQ(folder.file_count(), 1U);
}

/// Variables as they were, afterwards.
class StatePlace : public testing::Test {
protected:
    StatePlace() {
        for (const char* name : {"XDG_STATE_HOME", "HOME", "STATE_DIRECTORY"}) {
            const char* value = std::getenv(name);
            before_.emplace_back(name, value == nullptr ? std::string{} : std::string{value});
            unsetenv(name);
        }
        unsetenv("PSICARVE_STATE");
    }
    ~StatePlace() override {
        setenv("PSICARVE_STATE", "", 1);
        for (const auto& [name, value] : before_) {
            if (value.empty()) {
                unsetenv(name);
            } else {
                setenv(name, value.c_str(), 1);
            }
        }
    }
    std::vector<std::pair<const char*, std::string>> before_;
};

TEST_F(StatePlace, IsTheUsersOrTheSystems) {
    EXPECT_EQ(state_folder_of_core(true), "/var/lib/psicarve");
    EXPECT_EQ(state_folder_of_core(false), "");
    EXPECT_THAT(state_folders_to_read(), ElementsAre("/var/lib/psicarve"));
    setenv("HOME", "/home/ada", 1);
    EXPECT_EQ(state_folder_of_core(false), "/home/ada/.local/state/psicarve");
    setenv("XDG_STATE_HOME", "relative", 1);
    EXPECT_EQ(state_folder_of_core(false), "/home/ada/.local/state/psicarve");
    setenv("XDG_STATE_HOME", "/state", 1);
    EXPECT_EQ(state_folder_of_core(false), "/state/psicarve");
    EXPECT_EQ(state_folder_of_core(true), "/var/lib/psicarve");
    EXPECT_THAT(state_folders_to_read(), ElementsAre("/state/psicarve", "/var/lib/psicarve"));
}

TEST_F(StatePlace, IsWhereSystemdOrAVariableSays) {
    setenv("HOME", "/home/ada", 1);
    setenv("STATE_DIRECTORY", "/var/lib/shop:/var/lib/other", 1);
    EXPECT_EQ(state_folder_of_core(false), "/var/lib/shop");
    setenv("PSICARVE_STATE", "/srv", 1);
    EXPECT_EQ(state_folder_of_core(false), "/srv");
    EXPECT_EQ(state_folder_of_core(true), "/srv");
    EXPECT_THAT(state_folders_to_read(), ElementsAre("/srv"));
    setenv("PSICARVE_STATE", "", 1);
    EXPECT_EQ(state_folder_of_core(true), "");
    EXPECT_THAT(state_folders_to_read(), ElementsAre());
}

TEST(StateNames, TellOneJobsCopyFromEverythingElse) {
    const StateNames sut{"/srv", "/shop", false};
    EXPECT_EQ(sut.checkpoint(), "/srv/shop.checkpoint");
    EXPECT_EQ(sut.job(0xAB), "/srv/shop-00000000000000ab.job");
    EXPECT_TRUE(sut.is_job(sut.job(kSavedJob)));
    EXPECT_FALSE(sut.is_job("/srv/shop-a.job"));
    EXPECT_FALSE(sut.is_job("/srv/shop-my-favourite-jo.job"));
    EXPECT_FALSE(sut.is_job("/srv/shop-00000000000000ab.job2"));
    EXPECT_FALSE(sut.is_job("/srv/shop-00000000000000ab.bak"));
    const StateNames simulated{"/srv", "/shop", true};
    EXPECT_NE(StateNames("/srv", "/shop.sim", false).checkpoint(), simulated.checkpoint());
    EXPECT_NE(StateNames("/srv", "/shop.simulated", false).checkpoint(), simulated.checkpoint());
    EXPECT_FALSE(sut.is_job(simulated.job(0xAB)));
    EXPECT_FALSE(simulated.is_job(sut.job(0xAB)));
}

}  // namespace
}  // namespace psicarve
