// SPDX-License-Identifier: GPL-3.0-or-later
// What psicarve says of the pieces that a disk knows.
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "shared/record/saved_checkpoint.hpp"
#include "shared/segment/checkpoint.hpp"
#include "shared/segment/shared_record.hpp"
#include "tests/hmi/cli/program_run.hpp"
#include "tests/two_process/core_rig.hpp"

namespace psicarve::two_process {
namespace {

constexpr std::uint32_t kReadLayers = 40;

class DiskReaders : public CoreRig {
protected:
    std::string state() const { return file("state"); }
    StateNames names() const { return {state(), segment_name_, true}; }
    std::vector<std::string> words(std::vector<std::string> some) const {
        some.insert(some.end(), {"--segment", segment_name_});
        return some;
    }
    test::Outcome psicarve(const std::vector<std::string>& some) const { return test::psicarve(words(some)); }
    void write_on_disk(std::uint32_t next_layer, std::uint32_t earlier_layer) const {
        auto saved = load_saved_checkpoint(names().checkpoint());
        ASSERT_TRUE(saved);
        saved->checkpoint = checkpoint_at(saved->checkpoint.job_checksum, next_layer, kReadLayers,
                                          earlier_layer, kCheckpointSimulated);
        ++saved->sequence;
        ASSERT_TRUE(save_checkpoint(*saved, names().checkpoint()));
    }
    void carve_some(std::uint64_t layers) {
        start_core({"--state", state()});
        ASSERT_EQ(publish(lobed_job(kReadLayers, 40)), "");
        home();
        Command some{};
        some.kind = CommandKind::start;
        some.value2 = layers;
        ASSERT_EQ(refusal_of(some), "");
        ASSERT_TRUE(reaches(MachineState::waiting));
        ASSERT_EQ(refusal_of(CommandKind::start_interpolation), "");
        ASSERT_TRUE(reaches(MachineState::ready));
        ASSERT_TRUE(eventually([&] {
            const auto found = find_unfinished(segment_name_, {}, state());
            return found && found->saved.checkpoint.next_layer == layers && !found->job_path.empty();
        }));
    }
    void kill_core() {
        core_->send_signal(SIGKILL);
        core_->wait_for_exit();
        segment_.reset();
    }
    void cut_power() {
        kill_core();
        ASSERT_TRUE(Segment::remove(segment_name_));
    }
};

TEST_F(DiskReaders, TheFirstLineOfAWatchHasAskedTheDisk) {
    ASSERT_NO_FATAL_FAILURE(carve_some(6));
    cut_power();
    start_core({"--state", state()});
    test::RunningProgram watch{"psicarve", words({"status", "--watch", "--json", "--state", state()})};
    ASSERT_TRUE(eventually([&] { return watch.out_so_far().find('\n') != std::string::npos; }));
    watch.send(SIGTERM);
    watch.wait();
    const auto first = nlohmann::json::parse(watch.out().substr(0, watch.out().find('\n')));
    EXPECT_FALSE(first.contains("is_disk_silent")) << first;
    ASSERT_TRUE(first["unfinished"].is_object()) << first;
    EXPECT_EQ(first["unfinished"]["next_layer"], 6);
}

TEST_F(DiskReaders, WhereMemoryAndDiskDisagreeEverybodySaysSo) {
    ASSERT_NO_FATAL_FAILURE(carve_some(3));
    kill_core();
    write_on_disk(0, 5);
    start_core({"--state", state()});
    ASSERT_TRUE(eventually([&] { return status().job_generation != 0; }));
    const std::string both =
        "segment: layer 3, disk: 0; where this piece goes on the two disagree, the lower one is taken";
    const auto told = psicarve({"status", "--state", state()});
    EXPECT_NE(told.out.find("mind       " + both), std::string::npos) << told.out;
    EXPECT_NE(told.out.find("checkpoint 0 of 40 layers, from a disk; the run before it came to 5"),
              std::string::npos)
        << told.out;
    EXPECT_EQ(psicarve({"status", "--json", "--state", state()}).json()["job_remark"], both);
    ASSERT_EQ(psicarve({"home"}).exit_code, 0);
    EXPECT_NE(psicarve({"start", "--resume", "--state", state()}).error.find("--from-layer 5"),
              std::string::npos);
    const auto gone_back = psicarve({"start", "--from-layer", "5", "--state", state()});
    EXPECT_EQ(gone_back.exit_code, 0) << gone_back.error;
    EXPECT_NE(gone_back.error.find(both), std::string::npos) << gone_back.error;
    EXPECT_NE(gone_back.error.find("goes on by " + names().checkpoint()), std::string::npos)
        << gone_back.error;
    ASSERT_EQ(refusal_of(CommandKind::start_interpolation), "");
    ASSERT_TRUE(reaches(MachineState::ready));
    const auto carved = psicarve({"status", "--state", state()});
    EXPECT_EQ(carved.out.find("segment: layer 3"), std::string::npos) << carved.out;
}

TEST_F(DiskReaders, AnotherRecordsDateIsNotTaken) {
    ASSERT_NO_FATAL_FAILURE(carve_some(6));
    cut_power();
    start_core({"--state", state()});
    ASSERT_EQ(publish(lobed_job(kReadLayers, 40)), "");
    home();
    write_on_disk(9, 0);
    const auto resumed = psicarve({"start", "--resume", "--state", state()});
    EXPECT_EQ(resumed.exit_code, 0) << resumed.error;
    EXPECT_EQ(resumed.error.find("goes on by"), std::string::npos) << resumed.error;
    EXPECT_NE(resumed.error.find("a disk that tells of another piece or layer by now"), std::string::npos)
        << resumed.error;
}

TEST_F(DiskReaders, AnotherCoresDateIsNotTaken) {
    ASSERT_NO_FATAL_FAILURE(carve_some(6));
    cut_power();
    start_core({"--state", state()});
    ASSERT_EQ(publish(lobed_job(kReadLayers, 40)), "");
    home();
    // The same place in a folder that is not the core's.
    std::filesystem::create_directory(file("other"));
    const StateNames others{file("other"), segment_name_, true};
    std::filesystem::copy_file(names().checkpoint(), others.checkpoint());
    const auto resumed = psicarve({"start", "--resume", "--state", file("other")});
    EXPECT_EQ(resumed.exit_code, 0) << resumed.error;
    EXPECT_EQ(resumed.error.find(others.checkpoint()), std::string::npos) << resumed.error;
    EXPECT_NE(resumed.error.find("was not looked at"), std::string::npos) << resumed.error;
    EXPECT_EQ(resumed.error.find("does not answer"), std::string::npos) << resumed.error;
}

TEST_F(DiskReaders, WhoForgetsWhereThereIsNothingIsToldSo) {
    const auto without_core = psicarve({"forget", "--state", state()});
    EXPECT_EQ(without_core.exit_code, 3);
    EXPECT_EQ(without_core.error_lines(), 1U) << without_core.error;
    start_core({"--state", state()});
    const auto with_core = psicarve({"forget", "--state", state()});
    EXPECT_EQ(with_core.exit_code, 3) << with_core.out;
    EXPECT_EQ(with_core.error_lines(), 1U) << with_core.error;
    EXPECT_NE(with_core.error.find("no unfinished piece is known of segment"), std::string::npos);
}

TEST_F(DiskReaders, ForgettingAsksForTheFolderWhereTheCoreKeepsItsPieceElsewhere) {
    ASSERT_NO_FATAL_FAILURE(carve_some(6));
    const auto refused = psicarve({"forget", "--state", file("elsewhere")});
    EXPECT_NE(refused.exit_code, 0) << refused.out;
    EXPECT_NE(refused.error.find("give --state FOLDER"), std::string::npos) << refused.error;
    EXPECT_TRUE(find_unfinished(segment_name_, {}, state()));
    EXPECT_EQ(read_record(segment_->header().checkpoint).value_or(Checkpoint{}).next_layer, 6U);
    const auto done = psicarve({"forget", "--state", state()});
    EXPECT_EQ(done.exit_code, 0) << done.error;
    EXPECT_NE(done.out.find("6 of 40 layers of lobed, kept in " + names().checkpoint()), std::string::npos)
        << done.out;
    EXPECT_FALSE(find_unfinished(segment_name_, {}, state()));
}

TEST_F(DiskReaders, ForgettingTakesTheSegmentsPieceAndNotAnotherCores) {
    ASSERT_NO_FATAL_FAILURE(carve_some(6));
    kill_core();
    start_core();  // keeps nothing; the segment knows its piece
    write_on_disk(9, 0);
    const auto done = psicarve({"forget", "--state", state()});
    EXPECT_EQ(done.exit_code, 0) << done.error;
    EXPECT_NE(done.out.find("known to the segment alone"), std::string::npos) << done.out;
    EXPECT_TRUE(find_unfinished(segment_name_, {}, state())) << "it is another core's";
    EXPECT_EQ(read_record(segment_->header().checkpoint).value_or(Checkpoint{}).next_layer, 0U);
}

TEST_F(DiskReaders, NamesInOtherLettersAreNoReasonToSayNothing) {
    ASSERT_NO_FATAL_FAILURE(carve_some(6));
    cut_power();
    auto saved = load_saved_checkpoint(names().checkpoint());
    ASSERT_TRUE(saved);
    saved->source_name = "caf\xE9";
    ++saved->sequence;
    ASSERT_TRUE(save_checkpoint(*saved, names().checkpoint()));
    const auto without_core = psicarve({"status", "--json", "--state", state()});
    EXPECT_EQ(without_core.exit_code, 5) << without_core.error;
    EXPECT_EQ(without_core.json()["unfinished"]["next_layer"], 6);
    start_core({"--state", state()});
    const auto with_core = psicarve({"status", "--json", "--state", state()});
    EXPECT_EQ(with_core.exit_code, 0) << with_core.error;
    EXPECT_EQ(with_core.json()["unfinished"]["next_layer"], 6);
}

TEST_F(DiskReaders, AnotherCoresPieceIsSaidToBeItsOwn) {
    ASSERT_NO_FATAL_FAILURE(carve_some(6));
    cut_power();
    start_core();  // which keeps nothing
    const auto told = psicarve({"status", "--state", state()});
    EXPECT_NE(told.out.find("unfinished lobed: 6 of 40"), std::string::npos) << told.out;
    EXPECT_NE(told.out.find("mind       this core keeps pieces elsewhere, or nowhere"), std::string::npos)
        << told.out;
    EXPECT_EQ(psicarve({"status", "--json", "--state", state()}).json()["unfinished"]["is_other_cores"],
              true);
}

TEST_F(DiskReaders, ADiskThatTakesNothingIsSaid) {
    ASSERT_NO_FATAL_FAILURE(carve_some(4));
    EXPECT_EQ(psicarve({"status", "--state", state()}).out.find("mind "), std::string::npos);
    // No folder is a file.
    std::filesystem::rename(state(), file("moved"));
    { std::ofstream{state()} << "a file"; }
    ASSERT_EQ(refusal_of(CommandKind::start), "");
    ASSERT_TRUE(eventually([&] { return segment_->core_keeping().how == CoreKeeping::How::refused; }));
    EXPECT_NE(psicarve({"status", "--state", state()}).out.find("mind       the disk does not take"),
              std::string::npos);
    EXPECT_EQ(psicarve({"status", "--json", "--state", state()}).json()["is_disk_refusing"], true);
}

}  // namespace
}  // namespace psicarve::two_process
