// SPDX-License-Identifier: GPL-3.0-or-later
// The computer was switched off in mid-job: no process, no shared memory, only what stands on the disk.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "shared/record/saved_checkpoint.hpp"
#include "shared/segment/checkpoint.hpp"
#include "tests/hmi/cli/program_run.hpp"
#include "tests/two_process/carved_trace.hpp"
#include "tests/two_process/core_rig.hpp"

namespace psicarve::two_process {
namespace {

namespace fs = std::filesystem;

/// The layers of each job that is carved to its end.
constexpr std::uint32_t kPieceLayers = test::kIsSanitized ? 60 : 110;
/// A trace's end is lost with its core: so many layers are more than that.
constexpr std::uint32_t kLostLayers = test::kIsSanitized ? 35 : 40;
constexpr std::uint32_t kPiecePoints = 101;

class PowerCut : public CoreRig {
protected:
    std::string state() const { return file("state"); }
    StateNames names() const { return {state(), segment_name_, true}; }
    void start_core_with_state(const std::vector<std::string>& more = {}) {
        std::vector<std::string> arguments{"--state", state()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        start_core(arguments);
    }
    Checkpoint checkpoint() const {
        return read_record(segment_->header().checkpoint).value_or(Checkpoint{});
    }
    SavedCheckpoint on_disk() const {
        const auto saved = load_saved_checkpoint(names().checkpoint());
        return saved ? *saved : SavedCheckpoint{};
    }
    /// Everything loses its power, and only what had reached the disk by then is left.
    void cut_power() {
        core_->send_signal(SIGKILL);
        core_->wait_for_exit();
        segment_.reset();
        ASSERT_TRUE(Segment::remove(segment_name_));
    }
    test::Outcome psicarve(std::vector<std::string> words) const {
        words.insert(words.end(), {"--segment", segment_name_});
        setenv("PSICARVE_STATE", state().c_str(), 1);
        auto outcome = test::psicarve(words);
        setenv("PSICARVE_STATE", "", 1);
        return outcome;
    }
    void end_core() {
        ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
        ASSERT_EQ(core_->wait_for_exit(), 0);
    }
    bool is_carved_to_its_end() {
        return eventually([&] { return status().job_end_tick != 0; });
    }
};

class PowerCutAnywhere : public PowerCut, public testing::WithParamInterface<unsigned> {};

TEST_P(PowerCutAnywhere, ThePieceIsTheOneThatAnUndisturbedRunCarves) {
    const JobTable table = lobed_job(kPieceLayers, kPiecePoints);
    const auto blob = job_blob_from_table(table);
    std::minstd_rand random{GetParam()};
    const auto cut_layer = static_cast<std::uint32_t>(3 + random() % (kPieceLayers - kLostLayers - 6));

    start_core_with_state({"--trace", file("first.trace")});
    ASSERT_EQ(publish(table), "");
    home();
    start_carving();
    ASSERT_TRUE(eventually([&] { return checkpoint().next_layer >= cut_layer; }));
    // The machine waits for the disk here, or the piece might be finished first; and nothing is copied while
    // it is written.
    ASSERT_EQ(refusal_of(CommandKind::hold), "");
    ASSERT_TRUE(reaches(MachineState::held));
    const std::uint32_t held_layer = checkpoint().next_layer;
    ASSERT_TRUE(eventually([&] { return fs::exists(names().job(job_checksum(blob))); }));
    ASSERT_TRUE(eventually([&] { return on_disk().checkpoint.next_layer == held_layer; }));
    fs::copy(state(), file("disk"), fs::copy_options::recursive);
    ASSERT_EQ(refusal_of(CommandKind::resume), "");
    ASSERT_TRUE(eventually([&] { return checkpoint().next_layer >= cut_layer + kLostLayers; }));
    cut_power();
    // The disk as it was some time before: what is carved of these layers is carved again, in air.
    fs::remove_all(state());
    fs::rename(file("disk"), state());
    const std::uint32_t layer = on_disk().checkpoint.next_layer;
    ASSERT_GE(layer, 1U);
    ASSERT_LT(layer, kPieceLayers);

    start_core_with_state({"--trace", file("second.trace")});
    EXPECT_FALSE(is_checkpoint(checkpoint())) << "of no job that is here";
    const auto unfinished = psicarve({"status", "--json"}).json()["unfinished"];
    EXPECT_EQ(unfinished["next_layer"], layer);
    const auto published = psicarve({"publish", unfinished["job"].get<std::string>()});
    ASSERT_EQ(published.exit_code, 0) << published.error;
    EXPECT_EQ(checkpoint().next_layer, layer);
    EXPECT_TRUE(checkpoint().is_from_disk());
    EXPECT_EQ(psicarve({"status", "--json"}).json()["checkpoint"]["is_from_disk"], true);
    ASSERT_EQ(psicarve({"home"}).exit_code, 0);
    const auto resumed = psicarve({"start", "--resume", "--carve"});
    ASSERT_EQ(resumed.exit_code, 0) << resumed.error;
    EXPECT_NE(resumed.error.find("goes on by " + names().checkpoint() + " of 20"), std::string::npos)
        << resumed.error;
    EXPECT_NE(resumed.error.find(": lobed, " + std::to_string(layer) + " of "), std::string::npos)
        << resumed.error;
    EXPECT_NE(resumed.error.find(", tool point, simulated machine"), std::string::npos) << resumed.error;
    ASSERT_TRUE(is_carved_to_its_end());
    ASSERT_TRUE(eventually([&] { return on_disk().checkpoint.next_layer == kPieceLayers; }));
    end_core();
    EXPECT_FALSE(find_unfinished(segment_name_)) << "carved to its end";

    start_core({"--trace", file("whole.trace")});
    ASSERT_TRUE(eventually([&] { return status().job_generation != 0; }));
    home();
    start_carving();
    ASSERT_TRUE(is_carved_to_its_end());
    end_core();

    const Carved first{blob, file("first.trace")};
    const Carved second{blob, file("second.trace")};
    const Carved whole{blob, file("whole.trace")};
    for (std::uint32_t i = 0; i < kPieceLayers; ++i)
        ASSERT_EQ((i < layer ? first : second).layer(i), whole.layer(i))
            << "layer " << i << ", cut before " << layer;
    EXPECT_NE(second.layer(0), whole.layer(0)) << "what was carved before was not carved again";
}

INSTANTIATE_TEST_SUITE_P(Seeds, PowerCutAnywhere, testing::Range(1U, test::kIsSanitized ? 2U : 4U),
                         [](const auto& seed) { return "seed_" + std::to_string(seed.param); });

TEST_F(PowerCut, ACoreThatIsKilledAtAnyInstantLeavesALayerThatIsCarved) {
    constexpr int kKills = test::kIsSanitized ? 3 : 10;
    std::minstd_rand random{4711};
    std::uint32_t before = 0;
    for (int i = 0; i < kKills; ++i) {
        start_core_with_state();
        if (i == 0) {
            ASSERT_EQ(publish(long_job()), "");
        } else {
            ASSERT_TRUE(eventually([&] { return status().job_generation != 0; }));
        }
        home();
        ASSERT_EQ(refusal_of(CommandKind::start), "");
        ASSERT_TRUE(reaches(MachineState::waiting));
        // Before it is carved that it begins anew is on the disk.
        ASSERT_TRUE(eventually([&] { return on_disk().checkpoint.next_layer == 0; }));
        EXPECT_EQ(on_disk().checkpoint.earlier_layer, before);
        ASSERT_EQ(refusal_of(CommandKind::start_interpolation), "");
        const std::uint32_t layer = 1 + random() % 4;
        ASSERT_TRUE(eventually([&] { return on_disk().checkpoint.next_layer >= layer; }));
        core_->send_signal(SIGKILL);
        core_->wait_for_exit();
        const auto saved = load_saved_checkpoint(names().checkpoint());
        ASSERT_TRUE(saved) << saved.error().message;
        EXPECT_GE(saved->checkpoint.next_layer, 1U);
        EXPECT_LE(saved->checkpoint.next_layer, checkpoint().next_layer) << "never more than is carved";
        // Where segment and disk disagree it is the lower.
        before = saved->checkpoint.next_layer;
    }
}

TEST_F(PowerCut, AStartThatComesToNothingLeavesThePieceAsItWas) {
    start_core_with_state();
    ASSERT_EQ(publish(lobed_job(40, 40)), "");
    home();
    Command some{};
    some.kind = CommandKind::start;
    some.value2 = 6;
    ASSERT_EQ(refusal_of(some), "");
    ASSERT_TRUE(reaches(MachineState::waiting));
    ASSERT_EQ(refusal_of(CommandKind::start_interpolation), "");
    ASSERT_TRUE(eventually([&] { return on_disk().checkpoint.next_layer == 6; }));
    ASSERT_TRUE(reaches(MachineState::ready));
    ASSERT_EQ(refusal_of(CommandKind::start), "");
    ASSERT_TRUE(reaches(MachineState::waiting));
    ASSERT_TRUE(eventually([&] { return on_disk().checkpoint.next_layer == 0; }));
    EXPECT_EQ(on_disk().checkpoint.earlier_layer, 6U);
    EXPECT_EQ(checkpoint().next_layer, 6U);
    request_stop(*segment_);
    ASSERT_TRUE(reaches(MachineState::ready));
    EXPECT_TRUE(eventually([&] { return on_disk().checkpoint.next_layer == 6; }));
    EXPECT_EQ(on_disk().checkpoint.earlier_layer, 0U);
    Command resuming{};
    resuming.kind = CommandKind::start;
    resuming.axis = kStartResumes;
    ASSERT_EQ(refusal_of(resuming), "");
    ASSERT_TRUE(reaches(MachineState::waiting));
    request_stop(*segment_);
    ASSERT_TRUE(reaches(MachineState::ready));
    end_core();
    EXPECT_EQ(on_disk().checkpoint.next_layer, 6U);
}

TEST_F(PowerCut, AnotherJobThatIsOnlyPublishedForgetsNothing) {
    const JobTable table = lobed_job(40, 40);
    start_core_with_state();
    ASSERT_EQ(publish(table), "");
    home();
    Command some{};
    some.kind = CommandKind::start;
    some.value2 = 6;
    ASSERT_EQ(refusal_of(some), "");
    ASSERT_TRUE(reaches(MachineState::waiting));
    ASSERT_EQ(refusal_of(CommandKind::start_interpolation), "");
    ASSERT_TRUE(is_carved_to_its_end());
    ASSERT_TRUE(eventually([&] { return on_disk().checkpoint.next_layer == 6; }));
    cut_power();

    start_core_with_state();
    ASSERT_EQ(publish(lobed_job(3, 33)), "");
    EXPECT_FALSE(is_checkpoint(checkpoint()));
    ASSERT_EQ(publish(table), "");
    EXPECT_EQ(checkpoint().next_layer, 6U);
    // Once another is carved it is the other's.
    ASSERT_EQ(publish(lobed_job(3, 33)), "");
    home();
    start_carving();
    ASSERT_TRUE(is_carved_to_its_end());
    ASSERT_TRUE(eventually([&] { return on_disk().checkpoint.layer_count == 3; }));
    const std::string copy = names().job(job_checksum(job_blob_from_table(table)));
    EXPECT_TRUE(eventually([&] { return !fs::exists(copy); }));
}

TEST_F(PowerCut, APieceIsForgottenForGood) {
    for (const bool has_core : {true, false}) {
        start_core_with_state();
        ASSERT_EQ(publish(lobed_job(40, 40)), "");
        home();
        Command some{};
        some.kind = CommandKind::start;
        some.value2 = 6;
        ASSERT_EQ(refusal_of(some), "");
        ASSERT_TRUE(reaches(MachineState::waiting));
        EXPECT_NE(psicarve({"forget"}).error.find("not at rest"), std::string::npos);
        ASSERT_EQ(refusal_of(CommandKind::start_interpolation), "");
        ASSERT_TRUE(reaches(MachineState::ready));
        ASSERT_TRUE(eventually([&] { return on_disk().checkpoint.next_layer == 6; }));
        if (!has_core) cut_power();
        const auto forgotten = psicarve({"forget"});
        EXPECT_EQ(forgotten.exit_code, 0) << forgotten.error;
        EXPECT_FALSE(fs::exists(names().checkpoint()));
        if (has_core) {
            EXPECT_TRUE(checkpoint().is_empty());
            EXPECT_NE(psicarve({"start", "--resume"}).error.find("nothing was carved yet"),
                      std::string::npos);
            cut_power();
        }
        EXPECT_EQ(psicarve({"status", "--json"}).json()["unfinished"], nullptr);
        EXPECT_EQ(psicarve({"forget"}).exit_code, 3) << "there is none";
    }
}

TEST_F(PowerCut, ADiskThatTakesNothingIsAWarningAndTheJobIsCarved) {
    // No user can make a folder in a file.
    { std::ofstream{state()} << "a file"; }
    start_core({"--state", state() + "/deeper"});
    ASSERT_EQ(publish(lobed_job(5, 33)), "");
    home();
    start_carving();
    ASSERT_TRUE(is_carved_to_its_end());
    EXPECT_EQ(status().alarm_count, 0U);
    EXPECT_EQ(checkpoint().next_layer, 5U);
    end_core();
    EXPECT_NE(text_of(file("core.err")).find("nobody knows how far the piece has come"), std::string::npos)
        << text_of(file("core.err"));
}

TEST_F(PowerCut, CoresOnTheVirtualClockKeepNothingUnasked) {
    setenv("PSICARVE_STATE", state().c_str(), 1);
    start_core();
    setenv("PSICARVE_STATE", "", 1);
    ASSERT_EQ(publish(lobed_job(3, 33)), "");
    home();
    start_carving();
    ASSERT_TRUE(is_carved_to_its_end());
    end_core();
    EXPECT_FALSE(fs::exists(state()));
}

TEST_F(PowerCut, StatusTellsThePieceAndTheWayBack) {
    start_core_with_state();
    ASSERT_EQ(psicarve({"status", "--json"}).json()["unfinished"], nullptr);
    ASSERT_EQ(publish(long_job()), "");
    home();
    start_carving();
    ASSERT_TRUE(eventually([&] { return on_disk().checkpoint.next_layer >= 3; }));
    EXPECT_EQ(psicarve({"status", "--json"}).json()["unfinished"], nullptr) << "it is at work with it";
    const std::string job = names().job(job_checksum(job_blob_from_table(long_job())));
    ASSERT_TRUE(eventually([&] { return fs::exists(job); }));
    cut_power();
    const std::string layers = std::to_string(on_disk().checkpoint.next_layer) + " of " +
                               std::to_string(kLongLayers) + " layers are carved\n";
    const std::string segment = " --segment " + segment_name_ + "\n";

    const auto dead = psicarve({"status"});
    EXPECT_EQ(dead.exit_code, 5);
    EXPECT_EQ(dead.error_lines(), 1U) << dead.error;
    EXPECT_TRUE(dead.out.starts_with("unfinished lobed: " + layers + "since      20")) << dead.out;
    EXPECT_NE(dead.out.find(" UTC; tool point; simulated machine\n"), std::string::npos) << dead.out;
    EXPECT_NE(dead.out.find("go on      1. psicarve-rtcore"), std::string::npos) << dead.out;
    EXPECT_NE(dead.out.find("           2. psicarve publish " + job + segment), std::string::npos)
        << dead.out;
    EXPECT_TRUE(dead.out.ends_with("           3. psicarve home" + segment +
                                   "           4. psicarve start --resume" + segment))
        << dead.out;
    const auto as_json = psicarve({"status", "--json"});
    EXPECT_EQ(as_json.exit_code, 5);
    EXPECT_EQ(as_json.json()["error"]["exit_code"], 5) << as_json.out;
    EXPECT_EQ(as_json.json()["unfinished"]["job"], job);
    EXPECT_EQ(as_json.json()["unfinished"]["steps"].size(), 4U);

    start_core_with_state();
    const auto idle = psicarve({"status"});
    EXPECT_EQ(idle.exit_code, 0) << idle.error;
    EXPECT_NE(idle.out.find("unfinished lobed: " + layers), std::string::npos) << idle.out;
    EXPECT_NE(idle.out.find("go on      1. psicarve publish " + job), std::string::npos) << idle.out;
    EXPECT_EQ(idle.out.find("mind "), std::string::npos) << idle.out;
    fs::remove(job);
    EXPECT_NE(psicarve({"status"}).out.find("1. psicarve publish JOB"), std::string::npos);
    EXPECT_EQ(psicarve({"status", "--json"}).json()["unfinished"]["job"], nullptr);
    ASSERT_EQ(publish(long_job()), "");
    EXPECT_EQ(psicarve({"status"}).out.find("unfinished"), std::string::npos);
    EXPECT_NE(psicarve({"status"}).out.find("checkpoint "), std::string::npos);
}

}  // namespace
}  // namespace psicarve::two_process
