// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/stat.h>

#include <array>
#include <fstream>
#include <limits>
#include <map>

#include "shared/computer/process_identity.hpp"
#include "shared/profile/profile.hpp"
#include "tests/hmi/cli/program_run.hpp"
#include "tests/older_trace.hpp"
#include "tests/places.hpp"
#include "tests/thoroughness.hpp"

namespace psicarve::test {
namespace {

using Json = nlohmann::json;

// A sanitizer sees in two layers what it sees in four.
const std::uint32_t kLayers = is_thorough() ? 4 : 2;

class Carve : public CliTest {
protected:
    std::vector<std::string> carve_box(const std::vector<std::string>& more = {}) const {
        std::vector<std::string> arguments{"carve",    box_stl("box.stl"),      "--segment", segment_,
                                           "--layers", std::to_string(kLayers), "--points",  "17",
                                           "--json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return arguments;
    }
    std::string slice_box(const std::string& layers = std::to_string(kLayers)) const {
        const std::string job = file("box.job");
        const Outcome outcome =
            psicarve({"slice", box_stl("box.stl"), "-o", job, "--layers", layers, "--points", "17"});
        EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
        return job;
    }
};

/// Every promised field, with its type.
void expect_report(const Json& report) {
    ASSERT_TRUE(report.is_object());
    for (const char* field : {"layers", "points", "ticks", "missed_ticks", "open_points"}) {
        EXPECT_TRUE(report[field].is_number_integer()) << field << " " << report[field];
    }
    for (const char* field :
         {"carve_seconds", "total_seconds", "wall_seconds", "max_deviation_pulses", "undercut_share"}) {
        EXPECT_TRUE(report[field].is_number()) << field << " " << report[field];
    }
    ASSERT_TRUE(report.contains("reference_seconds"));
    EXPECT_TRUE(report["reference_seconds"].is_number() || report["reference_seconds"].is_null());
    EXPECT_TRUE(report["verified"].is_boolean() || report["verified"].is_null());
    ASSERT_TRUE(report["alarms"].is_array());
    for (const char* axis : {"r1", "r2", "psi", "y"})
        EXPECT_TRUE(report["pulses"][axis].is_number_integer()) << axis;
}

TEST_F(Carve, FromAModelToVerifiedPulses) {
    const Outcome outcome = psicarve(carve_box({"--picture", file("out.png"), "--trace", file("out.vcd")}));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.error << outcome.out;
    const Json report = outcome.json();
    expect_report(report);
    EXPECT_EQ(report["layers"], kLayers);
    EXPECT_EQ(report["points"], 17);
    EXPECT_EQ(report["verified"], true);
    EXPECT_LE(report["max_deviation_pulses"].get<int>(), 1);
    EXPECT_EQ(report["alarms"], Json::array());
    EXPECT_EQ(report["state"], "ready");
    // Half a turn of 3200 pulses each, and what it takes to get to the first point.
    EXPECT_GE(report["pulses"]["psi"].get<int>(), static_cast<int>(kLayers) * 3200);
    EXPECT_GT(report["carve_seconds"].get<double>(), 0.0);
    EXPECT_GT(report["total_seconds"].get<double>(), report["carve_seconds"].get<double>());
    EXPECT_EQ(outcome.error.find('\r'), std::string::npos) << "a progress bar into a pipe";
    EXPECT_TRUE(text_of(file("out.png")).starts_with("\x89PNG"));
    EXPECT_TRUE(text_of(file("out.vcd")).find("$enddefinitions") != std::string::npos);
}

TEST_F(Carve, ASpiralObeysAllFourRulesOnEveryMachine) {
    write("worn.toml",
          "[axis.r1]\nbacklash_mm = 0.05\n[axis.r2]\nbacklash_mm = 0.1\n[axis.y]\nbacklash_mm = 0.2\n"
          "[axis.psi]\nbacklash_deg = 0.5\n[head.r2]\nangle_error_deg = 0.4\nheight_error_mm = 0.05\n");
    const std::string model = example("small.stl");
    std::vector<std::string> profiles{"", "worn.toml"};
    if (test::is_thorough())
        profiles.insert(profiles.end(), {example("fine.toml"), example("original.toml")});
    for (const std::string& profile : profiles) {
        SCOPED_TRACE(profile);
        std::vector<std::string> arguments{"carve",    model, "--segment", segment_, "--layers", "6",
                                           "--points", "60",  "--joining", "spiral", "--json"};
        const std::string path = profile == "worn.toml" ? file("worn.toml") : profile;
        if (!path.empty()) arguments.insert(arguments.end(), {"--profile", path});
        const Outcome outcome = psicarve(arguments);
        ASSERT_EQ(outcome.exit_code, 0) << outcome.error << outcome.out;
        const Json report = outcome.json();
        EXPECT_EQ(report["layers"], 7);
        EXPECT_EQ(report["verified"], true);
        EXPECT_EQ(report["max_deviation_pulses"], 0);
        EXPECT_EQ(report["verification"]["points_visited"], 7 * 60);
        for (const Json& rule : report["verification"]["rules"]) EXPECT_EQ(rule["ok"], true) << rule;
    }
}

TEST_F(Carve, ASpiralsReplayIsTheSameEveryTime) {
    const std::string job = file("box.job");
    ASSERT_EQ(psicarve({"slice", box_stl("box.stl"), "-o", job, "--layers", std::to_string(kLayers),
                        "--points", "17", "--joining", "spiral"})
                  .exit_code,
              0);
    ASSERT_EQ(psicarve({"replay", job, "--trace", file("a.trace")}).exit_code, 0);
    ASSERT_EQ(psicarve({"replay", job, "--trace", file("b.trace")}).exit_code, 0);
    EXPECT_EQ(text_of(file("a.trace")), text_of(file("b.trace")));
    EXPECT_EQ(psicarve({"verify", job, file("a.trace"), "--picture", file("a.png")}).exit_code, 0);
    const Outcome piece = psicarve({"verify", job, file("a.trace"), "--piece", file("a.ply")});
    EXPECT_EQ(piece.exit_code, 0) << piece.error;
    EXPECT_NE(piece.out.find("mm3 taken off"), std::string::npos) << piece.out;
    EXPECT_EQ(text_of(file("a.ply")).rfind("ply\nformat binary_little_endian 1.0\n", 0), 0U);
    EXPECT_EQ(psicarve({"verify", job, file("a.trace"), "--piece", file("a.obj")}).exit_code, 3);
}

TEST_F(Carve, ATraceIsJudgedByTheLimitsOfAnotherMachineButNotByItsScales) {
    const std::string job = slice_box();
    ASSERT_EQ(psicarve({"replay", job, "--trace", file("pins.trace")}).exit_code, 0);
    const auto judged_by = [&](const Profile& machine) {
        std::ofstream{file("machine.toml")} << profile_to_toml(machine);
        return psicarve({"verify", job, file("pins.trace"), "--profile", file("machine.toml")});
    };
    Profile weak;
    weak.psi.accel_deg_s2 = 0.5 * weak.psi.accel_deg_s2;
    const Outcome judged = judged_by(weak);
    EXPECT_EQ(judged.exit_code, 6) << judged.error;
    EXPECT_NE(judged.out.find("psi asks its motor for more acceleration than it has"), std::string::npos)
        << judged.out;
    Profile coarse;
    coarse.y.pulses_per_mm = 200.0;
    const Outcome refused = judged_by(coarse);
    EXPECT_EQ(refused.exit_code, 3);
    EXPECT_NE(refused.error.find("axis.y.pulses_per_mm differ"), std::string::npos) << refused.error;
}

TEST_F(Carve, AJobAndItsTraceVerifyOnTheirOwn) {
    const std::string job = slice_box();
    const Outcome carved = psicarve({"carve", job, "--segment", segment_, "--trace", file("pins.trace")});
    ASSERT_EQ(carved.exit_code, 0) << carved.error;
    EXPECT_NE(carved.out.find("verified   yes"), std::string::npos) << carved.out;
    const Outcome verified = psicarve({"verify", job, file("pins.trace"), "--json"});
    EXPECT_EQ(verified.exit_code, 0) << verified.error << verified.out;
    EXPECT_TRUE(verified.json().is_object()) << verified.out;
}

// What other tools record knows nothing of positions.
TEST_F(Carve, ATraceThatDoesNotSayWhereItBeganIsWarnedAbout) {
    const std::string job = slice_box();
    ASSERT_EQ(psicarve({"replay", job, "--trace", file("pins.vcd")}).exit_code, 0);
    EXPECT_EQ(psicarve({"verify", job, file("pins.vcd")}).error, "");
    std::string text = text_of(file("pins.vcd"));
    const std::size_t begin = text.find("$comment position_pulses");
    ASSERT_NE(begin, std::string::npos);
    text.erase(begin, text.find("$end", begin) + 5 - begin);
    write("foreign.vcd", text);
    const Outcome outcome = psicarve({"verify", job, file("foreign.vcd")});
    EXPECT_EQ(outcome.exit_code, 6);
    EXPECT_NE(outcome.error.find("does not say where the axes stood"), std::string::npos) << outcome.error;
}

TEST_F(Carve, CountsThePulsesOfTheWholeRunAsTheTraceShowsThem) {
    const std::string job = slice_box();
    const Outcome carved =
        psicarve({"carve", job, "--segment", segment_, "--trace", file("pins.trace"), "--json"});
    ASSERT_EQ(carved.exit_code, 0) << carved.error;
    const Outcome verified = psicarve({"verify", job, file("pins.trace"), "--json"});
    ASSERT_EQ(verified.exit_code, 0) << verified.error;
    EXPECT_EQ(carved.json()["pulses"], verified.json()["pulses"]);
}

TEST_F(Carve, ScrewsWithBacklashCarveExactlyAndTheTraceShowsIt) {
    write("worn.toml",
          "[axis.r1]\nbacklash_mm = 0.05\n[axis.r2]\nbacklash_mm = 0.1\n[axis.y]\nbacklash_mm = 0.2\n"
          "[axis.psi]\nbacklash_deg = 0.5\n");
    const Outcome worn = psicarve(
        carve_box({"--profile", file("worn.toml"), "--trace", file("worn.vcd"), "--joining", "zigzag"}));
    ASSERT_EQ(worn.exit_code, 0) << worn.error << worn.out;
    EXPECT_EQ(worn.json()["verified"], true);
    EXPECT_EQ(worn.json()["max_deviation_pulses"], 0);
    const Json tight = psicarve(carve_box({"--joining", "zigzag"})).json();
    for (const char* axis : {"r1", "r2", "psi", "y"})
        EXPECT_GT(worn.json()["pulses"][axis], tight["pulses"][axis]) << axis;
}

TEST_F(Carve, ATraceOfAnotherJobIsADifference) {
    const std::string job = slice_box();
    ASSERT_EQ(psicarve({"carve", job, "--segment", segment_, "--trace", file("pins.vcd")}).exit_code, 0);
    ASSERT_EQ(psicarve({"carve", job, "--segment", segment_, "--trace", file("pins.trace")}).exit_code, 0);
    const std::string other = file("other.job");
    ASSERT_EQ(psicarve({"slice", box_stl("box.stl"), "-o", other, "--layers", std::to_string(kLayers),
                        "--points", "17", "--scale", "1.1"})
                  .exit_code,
              0);
    const Outcome verified = psicarve({"verify", other, file("pins.vcd"), "--picture", file("other.png")});
    EXPECT_EQ(verified.exit_code, 6) << verified.out;
    const Outcome refused = psicarve({"verify", other, file("pins.trace")});
    EXPECT_EQ(refused.exit_code, 3) << refused.out;
    EXPECT_EQ(refused.error, "psicarve: " + other + ": is not the job that " + file("pins.trace") +
                                 " carries; leave it out, or name the right one\n");
}

TEST_F(Carve, ATraceIsJudgedDrawnAndReplayedAlone) {
    const std::string job = slice_box();
    const std::string trace = file("pins.trace");
    ASSERT_EQ(psicarve({"carve", job, "--segment", segment_, "--trace", trace}).exit_code, 0);
    const Outcome alone = psicarve({"verify", trace, "--json", "--picture", file("alone.png")});
    EXPECT_EQ(alone.exit_code, 0) << alone.error;
    EXPECT_EQ(alone.out, psicarve({"verify", job, trace, "--json", "--picture", file("both.png")}).out);
    EXPECT_EQ(text_of(file("alone.png")), text_of(file("both.png")));
    ASSERT_EQ(psicarve({"replay", trace, "--trace", file("again.trace")}).exit_code, 0);
    ASSERT_EQ(psicarve({"replay", job, "--trace", file("of_job.trace")}).exit_code, 0);
    EXPECT_EQ(text_of(file("again.trace")), text_of(file("of_job.trace")));
    EXPECT_EQ(psicarve({"verify", file("again.trace")}).exit_code, 0);
}

TEST_F(Carve, ATraceWithoutItsJobSaysWhatToName) {
    const std::string job = slice_box();
    ASSERT_EQ(psicarve({"replay", job, "--trace", file("pins.trace")}).exit_code, 0);
    ASSERT_EQ(psicarve({"replay", job, "--trace", file("pins.vcd")}).exit_code, 0);
    write("old.trace", test::older_trace(text_of(file("pins.trace"))));
    for (const char* name : {"old.trace", "pins.vcd"}) {
        const Outcome alone = psicarve({"verify", file(name)});
        EXPECT_EQ(alone.exit_code, 3);
        EXPECT_EQ(alone.error, "psicarve: " + file(name) +
                                   ": carries no job; name it as well: psicarve verify JOB " + file(name) +
                                   "\n");
        EXPECT_EQ(psicarve({"verify", job, file(name)}).exit_code, 0) << name;
    }
    EXPECT_EQ(psicarve({"replay", file("old.trace")}).error,
              "psicarve: " + file("old.trace") + ": carries no job; name a job or snapshot file instead\n");
    const Outcome job_alone = psicarve({"verify", job});
    EXPECT_EQ(job_alone.exit_code, 2);
    EXPECT_EQ(job_alone.error,
              "psicarve: " + job + " is a job; name its trace, too: psicarve verify " + job + " TRACE\n");
}

TEST_F(Carve, TheSegmentKeepsTheJobForASnapshot) {
    ASSERT_EQ(psicarve(carve_box()).exit_code, 0);
    const Outcome saved = psicarve({"snapshot", "save", file("a.snap"), "--segment", segment_, "--json"});
    ASSERT_EQ(saved.exit_code, 0) << saved.error;
    const Json info = psicarve({"snapshot", "info", file("a.snap"), "--json"}).json();
    EXPECT_EQ(info["job"]["source"], "box.stl");
    EXPECT_EQ(info["status"]["points_done"], kLayers * 17);
    EXPECT_GT(info["record_count"].get<int>(), 0);
    const Outcome status = psicarve({"status", "--segment", segment_});
    EXPECT_EQ(status.exit_code, 5);
    EXPECT_NE(status.error.find("the last one left it"), std::string::npos) << status.error;
}

TEST_F(Carve, AJobForAnotherMachineIsRefusedWithItsKeys) {
    const std::string job = slice_box();
    write("other.toml", "[axis.r1]\nspeed_mm_s = 7.0\n");
    const Outcome outcome = psicarve({"carve", job, "--segment", segment_, "--profile", file("other.toml")});
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_NE(outcome.error.find("axis.r1.speed_mm_s"), std::string::npos) << outcome.error;
}

TEST_F(Carve, ReplayGivesTheSameReportAndLeavesNothingBehind) {
    const std::string job = slice_box();
    const Outcome outcome = psicarve({"replay", job, "--json", "--trace", file("a.trace")});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.error << outcome.out;
    expect_report(outcome.json());
    EXPECT_EQ(outcome.json()["verified"], true);
    EXPECT_EQ(psicarve({"verify", job, file("a.trace")}).exit_code, 0);
    ASSERT_EQ(psicarve({"replay", job, "--trace", file("b.trace")}).exit_code, 0);
    EXPECT_EQ(text_of(file("a.trace")), text_of(file("b.trace")));
}

/// A replay in the middle of its job that cannot end before the test lets it: its pins go into a pipe, and
/// time waits for the reader.
class HeldReplay {
public:
    HeldReplay(const std::string& job, const std::string& pipe, const std::vector<std::string>& more = {})
        : program_{"psicarve", arguments(job, pipe, more)}, pins_{pipe, std::ios::binary} {
        std::array<char, 4096> bytes;
        pins_.read(bytes.data(), bytes.size());
        EXPECT_TRUE(pins_.good());
    }
    RunningProgram& program() { return program_; }
    void let_go() { pins_.ignore(std::numeric_limits<std::streamsize>::max()); }

private:
    static std::vector<std::string> arguments(const std::string& job, const std::string& pipe,
                                              const std::vector<std::string>& more) {
        EXPECT_EQ(mkfifo(pipe.c_str(), 0600), 0);
        std::vector<std::string> all{"replay", job, "--trace", pipe};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    RunningProgram program_;
    std::ifstream pins_;
};

/// Where a replay's core is served. Of our own pid namespace, as every child of ours.
std::string segment_of(const RunningProgram& program) {
    const std::string own = named_after_this_process("psicarve-private-");
    return "/dev/shm/" + own.substr(0, own.rfind('-') + 1) + std::to_string(program.pid());
}

TEST_F(Carve, APrivateSegmentGoesWithItsReplayOrWithTheNextOne) {
    HeldReplay held{slice_box("400"), file("pins.trace")};
    RunningProgram& killed = held.program();
    EXPECT_TRUE(std::filesystem::exists(segment_of(killed)));
    killed.send(SIGKILL);
    killed.wait();
    RunningProgram next{"psicarve", {"replay", slice_box()}};
    EXPECT_EQ(next.wait(), 0) << next.error();
    EXPECT_FALSE(std::filesystem::exists(segment_of(killed)));
    EXPECT_FALSE(std::filesystem::exists(segment_of(next)));
}

TEST_F(Carve, AnInterruptedReplayIsNotASuccess) {
    HeldReplay held{slice_box("400"), file("pins.trace"), {"--json"}};
    RunningProgram& replay = held.program();
    replay.send(SIGINT);
    std::this_thread::sleep_for(std::chrono::milliseconds{100});
    held.let_go();
    EXPECT_EQ(replay.wait(), 4) << replay.error();
    EXPECT_NE(replay.error().find("stopped by the operator"), std::string::npos) << replay.error();
    EXPECT_EQ(nlohmann::json::parse(replay.out())["verified"], nullptr);
}

// Exit code 3 promises that nothing was changed: not so once the machine has moved.
TEST_F(Carve, ATraceOntoAFullDiskIsAnErrorAfterTheWork) {
    const std::string job = slice_box();
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"replay", job}, {"carve", job, "--segment", segment_}}) {
        std::vector<std::string> arguments = command;
        arguments.insert(arguments.end(), {"--trace", "/dev/full", "--json"});
        const Outcome outcome = psicarve(arguments);
        EXPECT_EQ(outcome.exit_code, 4) << outcome.error;
        const std::string said =
            "trace /dev/full: No space left on device; it ends there and is not complete";
        EXPECT_NE(outcome.error.find(said), std::string::npos) << outcome.error;
        EXPECT_EQ(outcome.error_lines(), 1U) << outcome.error;
        EXPECT_EQ(outcome.json()["error"]["exit_code"], 4) << outcome.out;
        EXPECT_EQ(outcome.json()["verified"], true);
    }
}

TEST_F(Carve, APictureThatCannotBeWrittenAfterTheWorkIsNotBadInput) {
    const std::string pictures = file("pictures");
    std::filesystem::create_directory(pictures);
    HeldReplay held{slice_box("40"), file("pins.trace"), {"--picture", pictures + "/out.png"}};
    RunningProgram& replay = held.program();
    std::filesystem::remove(pictures);
    held.let_go();
    EXPECT_EQ(replay.wait(), 4) << replay.error();
    EXPECT_NE(replay.error().find("out.png"), std::string::npos) << replay.error();
}

TEST_F(Carve, ATraceIntoAPipeThatNobodyReadsIsRefusedBeforeAnythingMoves) {
    const std::string job = slice_box();
    ASSERT_EQ(mkfifo(file("pipe").c_str(), 0600), 0);
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"replay", job}, {"carve", job, "--segment", segment_}}) {
        std::vector<std::string> arguments = command;
        arguments.insert(arguments.end(), {"--trace", file("pipe")});
        const Outcome outcome = psicarve(arguments);
        EXPECT_EQ(outcome.exit_code, 3) << outcome.error;
        EXPECT_EQ(outcome.error_lines(), 1U) << outcome.error;
        EXPECT_NE(outcome.error.find("pipe: nobody reads this pipe"), std::string::npos) << outcome.error;
    }
}

TEST_F(Carve, ATraceThatCannotBeOpenedIsRefusedBeforeAnythingMoves) {
    const std::string job = slice_box();
    std::filesystem::create_symlink(file("elsewhere"), file("link.vcd"));
    const Outcome outcome = psicarve({"carve", job, "--segment", segment_, "--trace", file("link.vcd")});
    EXPECT_EQ(outcome.exit_code, 3) << outcome.error;
    EXPECT_NE(outcome.error.find("link.vcd"), std::string::npos) << outcome.error;
}

}  // namespace
}  // namespace psicarve::test
