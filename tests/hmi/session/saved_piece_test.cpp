// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/saved_piece.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "hmi/session/going_on.hpp"
#include "tests/hmi/session/sights.hpp"

namespace psicarve::session {
namespace {

FoundCheckpoint found_after(std::uint32_t layers, std::uint32_t earlier = 0) {
    FoundCheckpoint found;
    found.saved.checkpoint = checkpoint_at(1, layers, 200, earlier);
    found.saved.written_s = 1'764'185'000;
    found.saved.source_name = "vase.stl";
    found.saved.tool = "ball, 3 mm";
    found.job_path = "/srv/a.job";
    return found;
}

std::vector<std::string> said_of(const FoundCheckpoint& found, const MachineView& machine) {
    std::vector<std::string> said{in_english(saved_title(found.saved))};
    for (const Phrase& each : saved_details(found, machine)) said.push_back(in_english(each));
    return said;
}

TEST(SavedPieceWords, SayWhichPieceHowFarSinceWhenAndWhatToDo) {
    EXPECT_EQ(said_of(found_after(131), test::machine_in(MachineState::off)),
              (std::vector<std::string>{"Unfinished: 131 of 200 layers of vase.stl are carved",
                                        "Since 2025-11-26 19:23 UTC, tool ball, 3 mm.",
                                        "Open its job, publish it, Home all, then go on from layer 132."}));
    FoundCheckpoint without_copy = found_after(0, 50);
    without_copy.job_path.clear();
    without_copy.saved.tool.clear();
    MachineView dead;
    EXPECT_EQ(
        said_of(without_copy, dead),
        (std::vector<std::string>{"Begun anew: none of 200 layers of vase.stl is finished",
                                  "Since 2025-11-26 19:23 UTC.", "First start psicarve-rtcore.",
                                  "No copy of its job is there: open that very job, publish it, Home all, "
                                  "then go on from layer 51.",
                                  "Run before: to layer 50 (From layer 51)."}));
}

TEST(SavedPieceWords, AreFewWhereThereIsNoRoom) {
    const auto needs = saved_needs(found_after(3, 50), MachineView{});
    ASSERT_EQ(needs.size(), 2U);
    EXPECT_EQ(in_english(needs[0]), "Open its job, then go on from layer 4.");
    EXPECT_EQ(in_english(needs[1]), "Run before: to layer 50 (From layer 51).");
}

TEST(SavedPieceWords, SayThatThePieceWasBegunWithAnotherProfile) {
    MachineView machine = test::machine_in(MachineState::off);
    FoundCheckpoint found = found_after(131);
    found.saved.profile_hash = 5;
    const std::string words = "It was begun with another profile of the machine.";
    machine.core_profile_hash = 5;
    EXPECT_THAT(said_of(found, machine), testing::Not(testing::Contains(words)));
    machine.core_profile_hash = 6;
    EXPECT_THAT(said_of(found, machine), testing::Contains(words));
    EXPECT_EQ(in_english(saved_needs(found, machine).front()), words);
    EXPECT_THAT(said_of(found, MachineView{}), testing::Not(testing::Contains(words))) << "nobody knows it";
}

TEST(SavedPieceWords, SayThatItMayBeAnotherPiece) {
    const MachineView machine = test::machine_in(MachineState::off);
    FoundCheckpoint found = found_after(131);
    found.keeper = Keeper::this_core;
    EXPECT_EQ(said_of(found, machine).size(), 3U);
    found.keeper = Keeper::other_core;
    found.other_paths = {"/srv/psicarve.checkpoint"};
    EXPECT_THAT(
        said_of(found, machine),
        testing::IsSupersetOf({"This core keeps pieces elsewhere, or nowhere: it is another core's.",
                               "/srv/psicarve.checkpoint tells of another piece: see which of them is "
                               "mounted."}));
    EXPECT_EQ(saved_needs(found, machine).size(), 3U);
}

TEST(SavedPieceWords, AskBeforeADisksWordIsTaken) {
    MachineView machine = test::machine_in(MachineState::ready);
    machine.resumable_layer = 131;
    EXPECT_FALSE(is_from_disk_alone(machine, 131));
    machine.is_checkpoint_from_disk = true;
    EXPECT_TRUE(is_from_disk_alone(machine, 131));
    EXPECT_FALSE(is_from_disk_alone(machine, 0)) << "the whole job, or another layer, is another question";
    const auto asked = [&] {
        std::vector<std::string> said;
        for (const Phrase& each : disk_question(machine)) said.push_back(in_english(each));
        return said;
    };
    machine.earlier_layer = 140;
    EXPECT_TRUE(is_from_disk_alone(machine, 140)) << "so far the run before came, says the disk";
    machine.earlier_layer.reset();
    machine.checkpoint_job_checksum = 1;
    machine.checkpoint_layer_count = 200;
    EXPECT_EQ(asked().front(), "Since when, and with which tool, is not known: no disk tells of it.");
    machine.saved_piece = found_after(131);
    EXPECT_EQ(asked()[0], "Unfinished: 131 of 200 layers of vase.stl are carved");
    EXPECT_EQ(asked()[1], "Since 2025-11-26 19:23 UTC, tool ball, 3 mm.");
    // Date and tool of another record are not this one's, though it is of the same job.
    const std::string other =
        "Since when, and with which tool, is not known: the disk tells of another piece or layer by now.";
    machine.saved_piece = found_after(132);
    EXPECT_EQ(asked().front(), other);
    machine.saved_piece = found_after(131, 150);
    EXPECT_EQ(asked().front(), other);
    machine.saved_piece->saved.checkpoint = checkpoint_at(2, 131, 200);
    EXPECT_EQ(asked().front(), other);
    machine.saved_piece->saved.checkpoint = checkpoint_at(1, 131, 300);
    EXPECT_EQ(asked().front(), other);
}

TEST(SavedPieceWords, SayThatMemoryAndDiskDisagreed) {
    MachineView machine = test::machine_in(MachineState::ready);
    EXPECT_FALSE(disagreement(machine));
    machine.job_remarks = {
        message_of(MessageId::blank_beside, mm_argument(1.0)),
        message_of(MessageId::segment_and_disk_disagree, count_argument(3), count_argument(0)),
        message_of(MessageId::begun_with_other_profile)};
    machine.earlier_layer = 5;
    machine.is_checkpoint_from_disk = true;
    const std::string words = "The computer's memory says 3 layers, its disk 0: the lower number is taken.";
    ASSERT_TRUE(disagreement(machine));
    EXPECT_EQ(in_english(*disagreement(machine)), words);
    std::vector<std::string> asked;
    for (const Phrase& each : disk_question(machine)) asked.push_back(in_english(each));
    EXPECT_THAT(asked, testing::Contains(words));
    std::vector<std::string> details;
    for (const Phrase& each : unfinished_details({0, 5, 40}, machine, nullptr))
        details.push_back(in_english(each));
    EXPECT_THAT(details, testing::Contains(words));
    machine.status->points_done = 7;
    machine.status->is_dry = 1;
    EXPECT_TRUE(disagreement(machine)) << "a dry run carves nothing";
    machine.status->is_dry = 0;
    EXPECT_FALSE(disagreement(machine)) << "it was carved since";
}

TEST(SavedPieceWords, AreForAMachineThatHasNoJob) {
    MachineView machine = test::machine_in(MachineState::off);
    machine.status->job_generation = 0;
    EXPECT_TRUE(may_be_saved(machine));
    machine.status->job_generation = 1;
    EXPECT_FALSE(may_be_saved(machine));
    machine.life = CoreLife::none;
    EXPECT_TRUE(may_be_saved(machine));
    EXPECT_TRUE(may_be_saved(MachineView{}));
}

}  // namespace
}  // namespace psicarve::session
