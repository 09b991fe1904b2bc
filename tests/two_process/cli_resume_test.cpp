// SPDX-License-Identifier: GPL-3.0-or-later
#include <csignal>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "shared/profile/profile.hpp"
#include "shared/record/saved_checkpoint.hpp"
#include "tests/two_process/commanded_core.hpp"

namespace psicarve::test {
namespace {

class ResumeCommand : public CommandedCore {
protected:
    /// Of a machine for which the sliced box's job is not made.
    std::string other_profile() const {
        Profile profile;
        profile.r1.pulses_per_mm = profile.r1.pulses_per_mm / 2;
        write("other.toml", profile_to_toml(profile));
        return file("other.toml");
    }
    /// Of a sliced box's carving, layers of 361 points, that goes on. Where a stop falls is the computer's to
    /// say, now and then between two layers: then it goes on, and is stopped again.
    void stop_within_a_layer() {
        std::uint64_t enough = 3 * 361 + 20;
        for (;;) {
            ASSERT_TRUE(eventually([&] { return status().points_done > enough; }));
            ASSERT_EQ(run({"stop"}).exit_code, 0);
            ASSERT_TRUE(reaches(MachineState::ready));
            const CoreStatus ended = status();
            ASSERT_LT(ended.points_done, ended.points_total);
            if (ended.points_done % 361 > 1) return;
            enough = ended.points_done + 20;
            ASSERT_EQ(run({"start", "--resume", "--carve"}).exit_code, 0);
        }
    }
};

TEST_F(ResumeCommand, ResumesBehindTheLastFinishedLayer) {
    start_core();
    ASSERT_EQ(run({"publish", sliced_box("5", "9")}).exit_code, 0);
    ASSERT_EQ(run({"home"}).exit_code, 0);
    const Outcome nothing = run({"start", "--resume"});
    EXPECT_EQ(nothing.exit_code, 4);
    EXPECT_NE(nothing.error.find("nothing was carved"), std::string::npos) << nothing.error;
    EXPECT_EQ(run({"start", "--resume", "--from-layer", "2"}).exit_code, 2);
    EXPECT_EQ(run({"status", "--json"}).json()["checkpoint"], nullptr);
    ASSERT_EQ(run({"start", "--layers", "2", "--carve"}).exit_code, 0);
    ASSERT_TRUE(reaches(MachineState::ready));
    const auto checkpoint = run({"status", "--json"}).json()["checkpoint"];
    EXPECT_EQ(checkpoint["next_layer"], 2);
    EXPECT_EQ(checkpoint["layer_count"], 5);
    EXPECT_EQ(checkpoint["is_of_job"], true);
    EXPECT_NE(run({"status"}).out.find("2 of 5 layers"), std::string::npos);
    ASSERT_EQ(run({"snapshot", "save", file("a.snap")}).exit_code, 0);
    const Outcome info = run({"snapshot", "info", file("a.snap"), "--json"});
    EXPECT_EQ(info.json()["checkpoint"], checkpoint) << info.out;
    EXPECT_FALSE(checkpoint.contains("earlier_layer"));
    ASSERT_EQ(run({"start", "--layers", "1", "--carve"}).exit_code, 0);
    ASSERT_TRUE(eventually([&] {
        return run({"status", "--json"}).json()["checkpoint"]["next_layer"] == 1;
    }));
    ASSERT_TRUE(reaches(MachineState::ready));
    EXPECT_EQ(run({"status", "--json"}).json()["checkpoint"]["earlier_layer"], 2);
    const Outcome text = run({"status"});
    EXPECT_NE(text.out.find("1 of 5 layers; the run before it came to 2 (start --from-layer 2)"),
              std::string::npos)
        << text.out;
    ASSERT_EQ(run({"start", "--from-layer", "1", "--layers", "1", "--carve"}).exit_code, 0);
    ASSERT_TRUE(eventually([&] {
        return run({"status", "--json"}).json()["checkpoint"]["next_layer"] == 2;
    }));
    ASSERT_TRUE(reaches(MachineState::ready));
    EXPECT_FALSE(run({"status", "--json"}).json()["checkpoint"].contains("earlier_layer"));
    ASSERT_EQ(run({"start", "--resume", "--layers", "1"}).exit_code, 0);
    EXPECT_EQ(run({"status", "--json"}).json()["layer"], 2);
}

TEST_F(ResumeCommand, GoesOnWithinALayerWhereItIsToldTo) {
    start_core();
    ASSERT_EQ(run({"publish", sliced_box("5", "9")}).exit_code, 0);
    ASSERT_EQ(run({"home"}).exit_code, 0);
    for (const char* point : {"8", "9", "999999"}) {
        const Outcome beyond = run({"start", "--from-layer", "2", "--from-point", point});
        EXPECT_EQ(beyond.exit_code, 4) << point;
        EXPECT_NE(beyond.error.find("a layer has 9 points"), std::string::npos) << beyond.error;
    }
    EXPECT_EQ(run({"start", "--from-layer", "2", "--from-point", "1000000"}).exit_code, 2);
    EXPECT_EQ(run({"start", "--resume", "--from-point", "2"}).exit_code, 2);
    ASSERT_EQ(run({"start", "--from-point", "4"}).exit_code, 0);
    EXPECT_EQ(status().layer, 0U) << "without a layer it is the first";
    EXPECT_EQ(status().point, 4U);
    ASSERT_EQ(run({"stop"}).exit_code, 0);
    ASSERT_TRUE(reaches(MachineState::ready));
    ASSERT_EQ(run({"start", "--from-layer", "2", "--from-point", "5"}).exit_code, 0);
    EXPECT_EQ(status().layer, 2U);
    EXPECT_EQ(status().point, 5U);
    EXPECT_EQ(status().points_done, 2U * 9U + 6U);
    ASSERT_EQ(run({"start-interpolation"}).exit_code, 0);
    ASSERT_TRUE(eventually([&] { return status().points_done == 5U * 9U; }));
    ASSERT_TRUE(reaches(MachineState::ready));
    ASSERT_EQ(run({"snapshot", "save", file("a.snap")}).exit_code, 0);
    // The same again from the flight recorder, judged by its pins.
    (void)run({"replay", file("a.snap"), "--trace", file("a.trace")});
    const Outcome judged =
        run({"verify", file("a.trace"), "--from-layer", "2", "--from-point", "5", "--json"});
    EXPECT_EQ(judged.exit_code, 0) << judged.out << judged.error;
    EXPECT_EQ(judged.json()["points_visited"], 3 * 9 - 5);
    const Outcome earlier = run({"verify", file("a.trace"), "--from-layer", "2", "--from-point", "4"});
    EXPECT_EQ(earlier.exit_code, 6);
    EXPECT_NE(earlier.out.find("behind 5 points of layer 2"), std::string::npos) << earlier.out;
}

TEST_F(ResumeCommand, StatusTellsWithWhichPointAnEndedCarvingGoesOn) {
    start_core();
    ASSERT_EQ(run({"publish", sliced_box("1500", "361", {"--joining", "zigzag"})}).exit_code, 0);
    ASSERT_EQ(run({"home"}).exit_code, 0);
    EXPECT_EQ(run({"status", "--json"}).json()["go_on"], nullptr);
    ASSERT_EQ(run({"start", "--carve"}).exit_code, 0);
    ASSERT_TRUE(eventually([&] { return status().points_done > 3 * 361 + 20; }));
    EXPECT_EQ(run({"status"}).out.find("go on "), std::string::npos) << "it is being carved";
    ASSERT_NO_FATAL_FAILURE(stop_within_a_layer());
    const CoreStatus ended = status();
    const std::string command = "psicarve start --resume --segment " + segment_;
    const std::string place = " (within layer " + std::to_string(ended.layer) + ", with its point " +
                              std::to_string(ended.point) + ")";
    EXPECT_NE(run({"status"}).out.find("go on      " + command + place + "\n"), std::string::npos)
        << run({"status"}).out;
    const auto go_on = run({"status", "--json"}).json()["go_on"];
    EXPECT_EQ(go_on["layer"], ended.layer);
    EXPECT_EQ(go_on["point"], ended.point);
    EXPECT_EQ(go_on["command"], command);
    const Outcome resumed = run({"start", "--resume", "--layers", "2"});
    ASSERT_EQ(resumed.exit_code, 0) << resumed.error;
    EXPECT_NE(resumed.error.find("within layer " + std::to_string(ended.layer) + ", with its point " +
                                 std::to_string(ended.point)),
              std::string::npos)
        << resumed.error;
    EXPECT_EQ(status().layer, ended.layer);
    EXPECT_EQ(status().point, ended.point);
    ASSERT_EQ(run({"start-interpolation"}).exit_code, 0);
    ASSERT_TRUE(eventually([&] { return status().points_done == (ended.layer + 2) * 361U; }));
    ASSERT_TRUE(reaches(MachineState::ready));
    EXPECT_EQ(run({"status", "--json"}).json()["checkpoint"]["next_layer"], ended.layer + 2) << "no gap";
    EXPECT_EQ(run({"status", "--json"}).json()["go_on"], nullptr);
}

// The segment has it, whoever wrote it.
TEST_F(ResumeCommand, GoesOnWithinALayerAfterTheCoreWasKilledAtAnyPoint) {
    std::minstd_rand random{20261128};
    start_core();
    ASSERT_EQ(run({"publish", sliced_box("1500", "361")}).exit_code, 0);
    int within = 0;
    for (int death = 0; death < 3; ++death) {
        ASSERT_TRUE(eventually([&] { return status().job_generation != 0; }));
        ASSERT_EQ(run({"home"}).exit_code, 0);
        const std::uint64_t before = status().points_done;
        const Outcome started =
            death == 0 ? run({"start", "--carve"}) : run({"start", "--resume", "--carve"});
        ASSERT_EQ(started.exit_code, 0) << started.error;
        const std::uint64_t enough = before + 361 + random() % 3000;
        ASSERT_TRUE(eventually([&] { return status().points_done > enough; }));
        core_->send(SIGKILL);
        core_->wait();
        const Outcome told = run({"status", "--json"});
        EXPECT_EQ(told.exit_code, 5) << told.error;
        const auto go_on = told.out.empty() ? nlohmann::json{} : told.json()["go_on"];
        start_core({"--trace", file("rest.trace")});
        ASSERT_TRUE(eventually([&] { return status().job_generation != 0; }));
        if (go_on.is_null()) continue;
        ++within;
        EXPECT_NE(run({"status"}).out.find(go_on["command"].get<std::string>()), std::string::npos);
    }
    EXPECT_GT(within, 1);
    ASSERT_EQ(run({"home"}).exit_code, 0);
    ASSERT_EQ(run({"start", "--resume", "--layers", "2"}).exit_code, 0);
    const CoreStatus begun = status();
    ASSERT_EQ(run({"start-interpolation"}).exit_code, 0);
    ASSERT_TRUE(eventually([&] { return status().points_done == (begun.layer + 2) * 361U; }));
    ASSERT_TRUE(reaches(MachineState::ready));
    EXPECT_EQ(run({"status", "--json"}).json()["checkpoint"]["next_layer"], begun.layer + 2);
    core_->send(SIGTERM);
    core_->wait();
    std::vector<std::string> words{
        "verify", file("rest.trace"), "--from-layer", std::to_string(begun.layer), "--layers", "2"};
    if (begun.points_done % 361 > 1) words.insert(words.end(), {"--from-point", std::to_string(begun.point)});
    const Outcome judged = psicarve(words);
    EXPECT_EQ(judged.exit_code, 0) << judged.out << judged.error;
}

// A new blank may be on the table: with --from-layer and --from-point a core would check nothing.
TEST_F(ResumeCommand, OffersNoPointOfThePieceBeforeARunThatWasBegunAnew) {
    start_core({"--state", file("state")});
    ASSERT_EQ(run({"publish", sliced_box("1500", "361")}).exit_code, 0);
    ASSERT_EQ(run({"home"}).exit_code, 0);
    ASSERT_EQ(run({"start", "--carve"}).exit_code, 0);
    ASSERT_NO_FATAL_FAILURE(stop_within_a_layer());
    const auto told = [&] { return run({"status", "--json", "--state", file("state")}).json(); };
    ASSERT_FALSE(told()["go_on"].is_null());
    ASSERT_EQ(run({"start"}).exit_code, 0);
    core_->send(SIGKILL);
    core_->wait();
    EXPECT_EQ(told()["go_on"], nullptr);
    const std::string text = run({"status", "--state", file("state")}).out;
    EXPECT_EQ(text.find("--from-point"), std::string::npos) << text;
    EXPECT_EQ(text.find("within layer"), std::string::npos) << text;
}

TEST_F(ResumeCommand, OffersThePointOnlyWhereDiskAndSegmentAgreeAndACoreTakesIt) {
    start_core({"--state", file("state")});
    ASSERT_EQ(run({"publish", sliced_box("1500", "361")}).exit_code, 0);
    ASSERT_EQ(run({"home"}).exit_code, 0);
    ASSERT_EQ(run({"start", "--carve"}).exit_code, 0);
    ASSERT_NO_FATAL_FAILURE(stop_within_a_layer());
    core_->send(SIGTERM);
    core_->wait();
    const auto go_on = [&] { return run({"status", "--json", "--state", file("state")}).json()["go_on"]; };
    EXPECT_FALSE(go_on().is_null());
    auto found = find_unfinished(segment_, {}, file("state"));
    ASSERT_TRUE(found);
    Checkpoint& kept = found->saved.checkpoint;
    const Checkpoint agreed = kept;
    kept = checkpoint_at(kept.job_checksum, kept.next_layer - 1, kept.layer_count, 0, kept.origin);
    ASSERT_TRUE(save_checkpoint(found->saved, found->path));
    EXPECT_EQ(go_on(), nullptr) << "the next core takes the lower layer";
    kept = agreed;
    ASSERT_TRUE(save_checkpoint(found->saved, found->path));
    EXPECT_FALSE(go_on().is_null());
    // One that refuses the published job takes no start.
    start_core({"--state", file("state"), "--profile", other_profile()});
    ASSERT_TRUE(eventually([&] { return status().heartbeat != 0 && status().job_generation == 0; }));
    EXPECT_EQ(go_on(), nullptr);
    EXPECT_EQ(run({"status"}).out.find("within layer"), std::string::npos);
}

TEST_F(ResumeCommand, ADryRunCarvesNothingAndLeavesNoCheckpoint) {
    start_core();
    ASSERT_EQ(run({"publish", sliced_box("5", "9")}).exit_code, 0);
    ASSERT_EQ(run({"home"}).exit_code, 0);
    ASSERT_EQ(run({"start", "--dry-run", "--from-layer", "1", "--layers", "2"}).exit_code, 0);
    EXPECT_EQ(status().signals & bit_of(Signal::spindle), 0U);
    EXPECT_EQ(run({"status", "--json"}).json()["dry_run"], true);
    EXPECT_NE(run({"status"}).out.find("dry run"), std::string::npos);
    const CoreStatus before = status();
    ASSERT_EQ(run({"start-interpolation"}).exit_code, 0);
    ASSERT_TRUE(eventually([&] { return status().job_end_tick != 0; }));
    EXPECT_EQ(status().points_done, 3U * 9U);
    EXPECT_GT(status().emitted_pulses[2], before.emitted_pulses[2]);
    EXPECT_EQ(run({"status", "--json"}).json()["checkpoint"], nullptr);
}

}  // namespace
}  // namespace psicarve::test
