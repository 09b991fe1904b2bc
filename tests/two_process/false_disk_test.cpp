// SPDX-License-Identifier: GPL-3.0-or-later
// Disks that hang, refuse, or are watched: what a core keeps there, and which programs look for it.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "shared/record/saved_checkpoint.hpp"
#include "shared/segment/checkpoint.hpp"
#include "tests/hmi/cli/program_run.hpp"
#include "tests/places.hpp"
#include "tests/two_process/core_rig.hpp"

namespace psicarve::two_process {
namespace {

namespace fs = std::filesystem;

constexpr const char* kVariables[] = {"LD_PRELOAD", "ASAN_OPTIONS", "PSICARVE_DISK", "PSICARVE_DISK_LOG",
                                      "PSICARVE_DISK_RULES"};

/// Processes that are started meanwhile find this disk.
class FalseDisk {
public:
    FalseDisk(const std::string& folder, const std::string& log, const std::string& rules) {
        for (const char* name : kVariables) {
            const char* const value = std::getenv(name);
            before_.emplace_back(value == nullptr ? "" : value);
        }
        setenv("LD_PRELOAD", in_build("tests/disk_preload.so").c_str(), 1);
        setenv("ASAN_OPTIONS", (before_[1] + ":verify_asan_link_order=0").c_str(), 1);
        setenv("PSICARVE_DISK", folder.c_str(), 1);
        setenv("PSICARVE_DISK_LOG", log.c_str(), 1);
        setenv("PSICARVE_DISK_RULES", rules.c_str(), 1);
    }
    ~FalseDisk() {
        for (std::size_t i = 0; i < std::size(kVariables); ++i) {
            if (before_[i].empty()) {
                unsetenv(kVariables[i]);
            } else {
                setenv(kVariables[i], before_[i].c_str(), 1);
            }
        }
    }
    FalseDisk(const FalseDisk&) = delete;
    FalseDisk& operator=(const FalseDisk&) = delete;

private:
    std::vector<std::string> before_;
};

struct DiskStep {
    std::string what;
    std::string path;
};

class FalseDiskTest : public CoreRig {
protected:
    std::string state() const { return file("state"); }
    StateNames names() const { return {state(), segment_name_, true}; }
    void disk_is(const std::string& rules) const { std::ofstream{file("rules")} << rules; }
    void start_core_on_it() {
        const FalseDisk disk{state(), file("log"), file("rules")};
        start_core({"--state", state()});
    }
    std::uint32_t layer_on_disk() const {
        const auto saved = load_saved_checkpoint(names().checkpoint());
        return saved ? saved->checkpoint.next_layer : 999;
    }
    void carve_layers(std::uint64_t layers) {
        Command some{};
        some.kind = CommandKind::start;
        some.value2 = layers;
        ASSERT_EQ(refusal_of(some), "");
        ASSERT_TRUE(reaches(MachineState::waiting));
        ASSERT_EQ(refusal_of(CommandKind::start_interpolation), "");
        ASSERT_TRUE(reaches(MachineState::ready));
    }
    std::string said() const { return text_of(file("core.err")); }
    /// What one thread did after the other, of the thread that gave this name.
    std::vector<DiskStep> steps_of_namer(const std::string& path) const {
        std::vector<DiskStep> all;
        std::vector<long> threads;
        long namer = 0;
        std::ifstream log{file("log")};
        for (std::string line; std::getline(log, line);) {
            std::istringstream words{line};
            long thread = 0;
            DiskStep step;
            words >> thread >> step.what >> step.path;
            if (step.what == "name" && step.path == path) namer = thread;
            threads.push_back(thread);
            all.push_back(step);
        }
        std::vector<DiskStep> steps;
        for (std::size_t i = 0; i < all.size(); ++i)
            if (threads[i] == namer) steps.push_back(all[i]);
        return steps;
    }
    test::Outcome status_on_it(const std::vector<std::string>& more = {}) const {
        const FalseDisk disk{state(), file("log2"), file("rules")};
        std::vector<std::string> words{"status", "--state", state(), "--segment", segment_name_};
        words.insert(words.end(), more.begin(), more.end());
        return test::psicarve(words);
    }
};

TEST_F(FalseDiskTest, ContentsAreOnItBeforeTheirNameAndTheNameBeforeAnythingElse) {
    start_core_on_it();
    ASSERT_EQ(publish(lobed_job(8, 33)), "");
    home();
    ASSERT_NO_FATAL_FAILURE(carve_layers(4));
    ASSERT_TRUE(eventually([&] { return layer_on_disk() == 4; }));
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    ASSERT_EQ(core_->wait_for_exit(), 0);
    const auto steps = steps_of_namer(names().checkpoint());
    int names_given = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        if (steps[i].what != "name" || steps[i].path != names().checkpoint()) continue;
        ++names_given;
        // A file without a name is hidden before it replaces another.
        std::size_t before = i;
        while (before > 0 && steps[before - 1].what == "name") --before;
        ASSERT_GE(before, 2U);
        EXPECT_EQ(steps[before - 1].what, "fsync-file");
        EXPECT_EQ(steps[before - 2].what, "write");
        ASSERT_LT(i + 1, steps.size());
        EXPECT_EQ(steps[i + 1].what, "fsync-folder");
    }
    EXPECT_GE(names_given, 1);
}

TEST_F(FalseDiskTest, WhatTellsMoreThanIsCarvedIsEmptiedWhereItsNameStays) {
    start_core_on_it();
    ASSERT_EQ(publish(lobed_job(8, 33)), "");
    home();
    ASSERT_NO_FATAL_FAILURE(carve_layers(4));
    ASSERT_TRUE(eventually([&] { return layer_on_disk() == 4; }));
    EXPECT_EQ(segment_->core_keeping(), CoreKeeping::in(state()));
    disk_is("takes_nothing keeps_names");
    ASSERT_EQ(refusal_of(CommandKind::start), "");
    EXPECT_TRUE(eventually([&] { return layer_on_disk() == 999; }));
    EXPECT_TRUE(eventually([&] { return segment_->core_keeping().how == CoreKeeping::How::refused; }));
    EXPECT_EQ(fs::file_size(names().checkpoint()), 0U);
    EXPECT_TRUE(eventually([&] {
        return said().find("nobody knows how far the piece has come") != std::string::npos;
    })) << said();
}

TEST_F(FalseDiskTest, WhatTellsMoreThanIsCarvedAndCannotBeTakenAwayIsSaidToBeFalse) {
    start_core_on_it();
    ASSERT_EQ(publish(lobed_job(8, 33)), "");
    home();
    ASSERT_NO_FATAL_FAILURE(carve_layers(4));
    ASSERT_TRUE(eventually([&] { return layer_on_disk() == 4; }));
    disk_is("takes_nothing keeps_names keeps_contents");
    ASSERT_EQ(refusal_of(CommandKind::start), "");
    EXPECT_TRUE(eventually([&] { return said().find("do not go on by it") != std::string::npos; })) << said();
    EXPECT_EQ(said().find("nobody knows"), std::string::npos) << said();
    EXPECT_EQ(layer_on_disk(), 4U);
}

TEST_F(FalseDiskTest, WhatCannotBeReadIsToldOfOnce) {
    fs::create_directory(state());
    std::ofstream{names().checkpoint()} << "damaged";
    start_core_on_it();
    disk_is("takes_nothing keeps_names keeps_contents");
    ASSERT_EQ(publish(lobed_job(8, 33)), "");
    home();
    ASSERT_NO_FATAL_FAILURE(carve_layers(4));
    ASSERT_TRUE(eventually([&] { return said().find("do not go on by it") != std::string::npos; })) << said();
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    ASSERT_EQ(core_->wait_for_exit(), 0);
    const std::string once = "nothing is known of an unfinished piece";
    const auto first = said().find(once);
    EXPECT_NE(first, std::string::npos);
    EXPECT_EQ(said().find(once, first + 1), std::string::npos) << said();
}

TEST_F(FalseDiskTest, ANameThatAPowerCutMayBringBackLeavesNothingBehindIt) {
    start_core_on_it();
    ASSERT_EQ(publish(lobed_job(8, 33)), "");
    home();
    ASSERT_NO_FATAL_FAILURE(carve_layers(4));
    ASSERT_TRUE(eventually([&] { return layer_on_disk() == 4; }));
    // Another name of the same contents: what a power cut would bring back.
    fs::create_hard_link(names().checkpoint(), file("brought_back"));
    disk_is("takes_nothing forgets_names");
    ASSERT_EQ(refusal_of(CommandKind::start), "");
    EXPECT_TRUE(eventually([&] { return fs::file_size(file("brought_back")) == 0; })) << said();
}

TEST_F(FalseDiskTest, AFolderThatCannotBeReadEndsNoCore) {
    fs::create_directory(state());
    start_core_on_it();
    disk_is("lists_one");
    ASSERT_EQ(publish(lobed_job(8, 33)), "");
    home();
    ASSERT_NO_FATAL_FAILURE(carve_layers(4));
    ASSERT_TRUE(eventually([&] { return layer_on_disk() == 4; }));
    ASSERT_TRUE(eventually([&] { return text_of(file("log")).find(" list ") != std::string::npos; }));
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    EXPECT_EQ(core_->wait_for_exit(), 0);
}

TEST_F(FalseDiskTest, OneThatAnswersLateIsLookedAtAgainAndLosesNothing) {
    start_core_on_it();
    ASSERT_EQ(publish(lobed_job(8, 33)), "");
    home();
    ASSERT_NO_FATAL_FAILURE(carve_layers(4));
    ASSERT_TRUE(eventually([&] { return layer_on_disk() == 4; }));
    const std::string copy = names().job(job_checksum(job_blob_from_table(lobed_job(8, 33))));
    ASSERT_TRUE(eventually([&] { return fs::exists(copy); }));
    core_->send_signal(SIGKILL);
    core_->wait_for_exit();
    segment_.reset();
    ASSERT_TRUE(Segment::remove(segment_name_));

    disk_is("hangs");
    start_core_on_it();
    EXPECT_EQ(segment_->core_keeping().how, CoreKeeping::How::refused);
    ASSERT_EQ(publish(lobed_job(8, 33)), "");
    home();
    ASSERT_EQ(refusal_of(CommandKind::start), "");
    ASSERT_TRUE(reaches(MachineState::waiting));
    request_stop(*segment_);
    ASSERT_TRUE(reaches(MachineState::ready));
    disk_is("");
    const auto in_segment = [&] { return read_record(segment_->header().checkpoint).value_or(Checkpoint{}); };
    EXPECT_TRUE(eventually([&] { return in_segment().next_layer == 4; })) << said();
    EXPECT_TRUE(in_segment().is_from_disk());
    EXPECT_TRUE(eventually([&] { return segment_->core_keeping().how == CoreKeeping::How::kept; }));
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    ASSERT_EQ(core_->wait_for_exit(), 0);
    EXPECT_EQ(layer_on_disk(), 4U);
    EXPECT_TRUE(fs::exists(copy));
}

TEST_F(FalseDiskTest, StatusWaitsForNoneThatHangs) {
    fs::create_directory(state());
    start_core();
    disk_is("hangs");
    const auto told = status_on_it();
    EXPECT_EQ(told.exit_code, 0) << told.error;
    EXPECT_TRUE(told.out.starts_with("segment ")) << told.out;
    EXPECT_TRUE(
        told.out.ends_with("unfinished not known: the disk that keeps unfinished pieces does not "
                           "answer\n"))
        << told.out;
    const auto as_json = status_on_it({"--json"}).json();
    EXPECT_EQ(as_json["unfinished"], nullptr);
    EXPECT_EQ(as_json["is_disk_silent"], true);
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    ASSERT_EQ(core_->wait_for_exit(), 0);
    const auto without = status_on_it();
    EXPECT_EQ(without.exit_code, 5);
    EXPECT_TRUE(without.out.starts_with("unfinished not known")) << without.out;
    EXPECT_EQ(without.error_lines(), 1U) << without.error;
}

}  // namespace
}  // namespace psicarve::two_process
