// SPDX-License-Identifier: GPL-3.0-or-later
#include <pty.h>

#include "shared/job/job.hpp"
#include "shared/record/snapshot_file.hpp"
#include "tests/hmi/cli/program_run.hpp"
#include "tests/places.hpp"

namespace psicarve::test {
namespace {

class SliceCommand : public CliTest {};

/// What psicarve writes to standard error when that is a terminal.
std::string text_on_terminal(const std::vector<std::string>& arguments) {
    std::vector<std::string> words{in_build("bin/psicarve")};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    int terminal = -1;
    const pid_t pid = forkpty(&terminal, nullptr, nullptr, nullptr);
    if (pid == 0) {
        execv(argv[0], argv.data());
        _exit(127);
    }
    std::string text;
    std::array<char, 4096> bytes;
    for (ssize_t got; (got = read(terminal, bytes.data(), bytes.size())) > 0;) {
        text.append(bytes.data(), static_cast<std::size_t>(got));
    }
    int status = -1;
    waitpid(pid, &status, 0);
    close(terminal);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << text;
    return text;
}

TEST_F(SliceCommand, WritesAJobThatHoldsTheWholeProfile) {
    const std::string job_path = file("box.job");
    const Outcome outcome =
        psicarve({"slice", box_stl("box.stl"), "-o", job_path, "--layers", "4", "--points", "9"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
    EXPECT_NE(outcome.out.find("4 layers x 9 points"), std::string::npos) << outcome.out;
    const auto file_read = load_snapshot(job_path);
    ASSERT_TRUE(file_read.has_value()) << file_read.error().message;
    EXPECT_FALSE(file_read->status.has_value());
    const auto job = JobView::check(file_read->job_blob);
    ASSERT_TRUE(job.has_value());
    EXPECT_EQ(job->layer_count(), 4U);
    EXPECT_EQ(job->point_count(), 9U);
    EXPECT_EQ(job->profile_toml(), profile_to_toml(Profile{}));
    // Direction 0 looks along x, where the box ends at 10 mm: 4000 pulses.
    EXPECT_EQ(job->r_left_pulses(0)[0], 4000);
}

TEST_F(SliceCommand, ReportsInJsonWithNothingElseOnStandardOutput) {
    const Outcome outcome = psicarve(
        {"slice", box_stl("box.stl"), "-o", file("box.job"), "--layers", "4", "--points", "9", "--json"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
    const auto report = outcome.json();
    ASSERT_TRUE(report.is_object()) << outcome.out;
    EXPECT_EQ(report["layers"], 4);
    EXPECT_EQ(report["points"], 9);
    EXPECT_TRUE(report["undercut_share"].is_number());
    EXPECT_TRUE(report["open_points"].is_number_integer());
    EXPECT_EQ(outcome.error.find('\r'), std::string::npos) << "a progress bar into a pipe";
}

TEST_F(SliceCommand, ATerminalSeesTheSearchForTheBestAxis) {
    const std::string drawn = text_on_terminal({"slice", box_stl("box.stl"), "-o", file("box.job"),
                                                "--layers", "4", "--points", "9", "--axis-at", "best"});
    EXPECT_NE(drawn.find("finding the best axis  ["), std::string::npos) << drawn;
}

TEST_F(SliceCommand, GivesTheSameBytesForAnyNumberOfThreads) {
    const std::string model = box_stl("box.stl");
    for (const std::string threads : {"1", "3"}) {
        ASSERT_EQ(psicarve({"slice", model, "-o", file(threads), "--layers", "20", "--points", "50",
                            "--threads", threads})
                      .exit_code,
                  0);
    }
    EXPECT_EQ(text_of(file("1")), text_of(file("3")));
}

TEST_F(SliceCommand, OptionsReachTheSlicer) {
    const std::string model = box_stl("box.stl");
    const auto first_radius = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments{"slice",    model, "-o",       file("box.job"),
                                           "--layers", "2",   "--points", "5"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = psicarve(arguments);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
        const auto read = load_snapshot(file("box.job"));
        return JobView::check(read->job_blob)->r_left_pulses(0)[0];
    };
    EXPECT_EQ(first_radius({"--scale", "0.5"}), 2000);
    EXPECT_EQ(first_radius({"--height", "12"}), 8000);
    EXPECT_EQ(first_radius({"--axis-at", "-1.5,0"}), 4600);
    EXPECT_EQ(first_radius({"--axis-at=origin"}), 4000);
    EXPECT_EQ(first_radius({"--up", "x"}), 2800);  // (x, y, z) to (y, z, x): 7 mm of y along direction 0
    EXPECT_EQ(first_radius({"--up", "y"}), 1200);  // to (z, x, y): 3 mm of z
    EXPECT_EQ(first_radius({"--joining", "zigzag"}), 4000);
    EXPECT_EQ(JobView::check(load_snapshot(file("box.job"))->job_blob)->joining(), Joining::zigzag);
}

TEST_F(SliceCommand, ToolAndBlankReachTheJob) {
    const Outcome outcome = psicarve({"slice", box_stl("box.stl"), "-o", file("box.job"), "--layers", "2",
                                      "--points", "5", "--tool", "vee:2.5:90", "--blank", "8x2", "--json"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
    EXPECT_EQ(outcome.json()["report"]["tool"], "vee 2.5 mm 90 deg");
    EXPECT_NE(outcome.error.find("the blank's radius of 8.00 mm is less than the model's"), std::string::npos)
        << outcome.error;
    const auto read = load_snapshot(file("box.job"));
    const auto profile = job_profile(JobView::check(read->job_blob).value());
    ASSERT_TRUE(profile);
    EXPECT_EQ(profile->tool, (ToolProfile{ToolShape::vee, 2.5, 90.0, 0.0}));
    EXPECT_EQ(profile->blank, (BlankProfile{8.0, 2.0}));
}

TEST_F(SliceCommand, TheFluteLengthIsSaidBesideTheTool) {
    const std::string profile = file("machine.toml");
    write("machine.toml", "[tool]\nshape = \"ball\"\ndiameter_mm = 2.0\nflute_mm = 3.0\n");
    const std::string box = box_stl("box.stl");
    const auto flute_of = [&](const std::vector<std::string>& more, double said_mm) {
        std::vector<std::string> arguments{"slice", box,        "-o", file("box.job"), "--layers",
                                           "2",     "--points", "5",  "--blank",       "14x8"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = psicarve(arguments);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
        // The box's nearest faces are 7 mm from its axis: 7 mm into the blank.
        const bool is_short = said_mm > 0.0 && said_mm < 7.0;
        const std::string warning =
            "the tool cuts " + std::to_string(static_cast<int>(said_mm)) + ".00 mm deep, but the job goes ";
        EXPECT_EQ(outcome.error.find(warning) != std::string::npos, is_short) << outcome.error;
        const auto read = load_snapshot(file("box.job"));
        EXPECT_EQ(job_profile(JobView::check(read->job_blob).value())->tool.flute_mm, said_mm);
    };
    flute_of({"--profile", profile}, 3.0);
    flute_of({"--profile", profile, "--flute", "2"}, 2.0);
    flute_of({"--profile", profile, "--flute", "40"}, 40.0);
    flute_of({"--profile", profile, "--flute", "0"}, 0.0);
    flute_of({"--tool", "flat:2", "--flute", "5"}, 5.0);
    // The option is for a table, too; a job has its own.
    write("t.csv", "y_mm,r_mm\n2,6,6,6,6\n3,6,6,6,6\n");
    const Outcome table = psicarve(
        {"slice", file("t.csv"), "-o", file("t.job"), "--tool", "ball:2", "--blank", "14x8", "--flute", "3"});
    EXPECT_EQ(table.exit_code, 0) << table.error;
    EXPECT_NE(table.error.find("the tool cuts 3.00 mm deep, but the job goes 8.00 mm into the blank"),
              std::string::npos)
        << table.error;
    EXPECT_EQ(psicarve({"estimate", file("t.job"), "--flute", "3"}).exit_code, 2);
}

TEST_F(SliceCommand, ASpiralOfTwoLayersHasThreeRows) {
    const Outcome outcome = psicarve({"slice", box_stl("box.stl"), "-o", file("box.job"), "--layers", "2",
                                      "--points", "5", "--joining", "spiral", "--json"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
    EXPECT_EQ(outcome.json()["joining"], "spiral");
    EXPECT_EQ(outcome.json()["layers"], 3);
    EXPECT_EQ(outcome.json()["report"]["layers"], 3);
    const auto read = load_snapshot(file("box.job"));
    const JobView job = JobView::check(read->job_blob).value();
    EXPECT_EQ(job.layer_count(), 3U);
    EXPECT_EQ(job.layer_heights_pulses()[2], job.layer_heights_pulses()[1]);
}

TEST_F(SliceCommand, WarningsGoToStandardErrorAndTheJobIsMade) {
    std::string open_box = text_of(box_stl("box.stl"));
    open_box.erase(open_box.rfind("facet normal"));
    write("open.stl", open_box + "endsolid box\n");
    const Outcome outcome = psicarve(
        {"slice", file("open.stl"), "-o", file("open.job"), "--layers", "2", "--points", "5", "--json"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
    EXPECT_NE(outcome.error.find("psicarve: warning: "), std::string::npos) << outcome.error;
    EXPECT_TRUE(outcome.json().is_object()) << outcome.out;
}

TEST_F(SliceCommand, TurnsMirrorsAndFitsTheModel) {
    const std::string model = box_stl("box.stl");  // 20 x 14 x 6
    const auto report = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments{"slice", model,      "-o", file("a.job"), "--layers",
                                           "4",     "--points", "9",  "--json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = psicarve(arguments);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
        return outcome.json()["report"];
    };
    const auto quarter = report({"--rotate", "90"})["bounding_box_mm"];
    EXPECT_NEAR(quarter[0].get<double>(), 14.0, 1e-6);
    EXPECT_NEAR(quarter[1].get<double>(), 20.0, 1e-6);
    // About the axis that stands upright: the box on its side is 20 high.
    const auto on_side = report({"--rotate", "90", "--up", "x"})["bounding_box_mm"];
    EXPECT_NEAR(on_side[0].get<double>(), 6.0, 1e-6);
    EXPECT_NEAR(on_side[2].get<double>(), 20.0, 1e-6);
    const auto tipped = report({"--rotate", "90,0,0", "--mirror", "x"});
    EXPECT_NEAR(tipped["bounding_box_mm"][2].get<double>(), 14.0, 1e-6);
    EXPECT_EQ(tipped["turn"]["mirror"], "x");
    const auto fitted = report({"--fit", "--blank", "10x60"});
    const auto box = fitted["bounding_box_mm"];
    EXPECT_NEAR(std::hypot(box[0].get<double>(), box[1].get<double>()), 20.0, 1e-3);
}

TEST_F(SliceCommand, MakesLayersNoHigherThanAsked) {
    const std::string model = box_stl("box.stl", 10.0);
    const auto layers_of = [&](const std::string& height) {
        const Outcome outcome = psicarve(
            {"slice", model, "-o", file("h.job"), "--layer-height", height, "--points", "9", "--json"});
        EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
        return outcome.json()["layers"].get<int>();
    };
    EXPECT_EQ(layers_of("0.1"), 100) << "ten layers of 0.1 mm are 1 mm";
    EXPECT_EQ(layers_of("0.3"), 34);
    EXPECT_EQ(layers_of("20"), 1);
    const Outcome thin = psicarve({"slice", model, "-o", file("h.job"), "--layer-height", "0.001"});
    EXPECT_EQ(thin.exit_code, 3);
    EXPECT_NE(thin.error.find("at least --layer-height 0.0025"), std::string::npos) << thin.error;
}

TEST_F(SliceCommand, ScalesAMeshToADiameter) {
    const std::string model = box_stl("box.stl", 10.0);
    const Outcome outcome = psicarve({"slice", model, "-o", file("d.job"), "--diameter", "30", "--layers",
                                      "3", "--points", "400", "--json"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
    // Its corners stand furthest from the axis: 12.2 mm, that is 24.4 across.
    EXPECT_NEAR(outcome.json()["report"]["scale"].get<double>(), 30.0 / std::hypot(20.0, 14.0), 1e-6);
    EXPECT_NEAR(outcome.json()["size"]["radius_mm"][1].get<double>(), 15.0, 0.05);
    for (const std::string other : {"--height", "--scale"}) {
        const Outcome both = psicarve({"slice", model, "-o", file("d.job"), "--diameter", "30", other, "2"});
        EXPECT_EQ(both.exit_code, 2) << other;
    }
    EXPECT_EQ(psicarve({"slice", model, "-o", file("d.job"), "--diameter", "30", "--fit"}).exit_code, 2);
}

TEST_F(SliceCommand, TellsSizeAndTimeAndDraws) {
    const std::string model = box_stl("box.stl", 10.0);
    const Outcome outcome = psicarve({"slice", model, "-o", file("t.job"), "--layers", "3", "--points", "9",
                                      "--time", "--picture", file("t.png")});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
    EXPECT_NE(outcome.out.find("size: radii "), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("carving: 0:"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("T_ref 0:"), std::string::npos) << outcome.out;
    EXPECT_EQ(text_of(file("t.png")).substr(1, 3), "PNG");
    const Outcome estimate = psicarve({"estimate", file("t.job"), "--json"});
    const Outcome info = psicarve({"snapshot", "info", file("t.job"), "--json", "--time"});
    for (const char* key : {"carve_seconds", "reference_seconds"})
        EXPECT_EQ(info.json()["job"][key], estimate.json()[key]) << info.out;
    const Outcome shown = psicarve({"snapshot", "info", file("t.job"), "--time", "--picture", file("i.png")});
    ASSERT_EQ(shown.exit_code, 0) << shown.error;
    EXPECT_NE(shown.out.find("size       radii "), std::string::npos) << shown.out;
    EXPECT_NE(shown.out.find("carving    0:"), std::string::npos) << shown.out;
    EXPECT_NE(shown.out.find("model      20.00 x 14.00 x 10.00 mm"), std::string::npos) << shown.out;
    EXPECT_EQ(shown.out.find("{"), std::string::npos) << "JSON is for --json";
    EXPECT_EQ(text_of(file("i.png")).substr(1, 3), "PNG");
}

TEST_F(SliceCommand, TakesAPipeAndGivesOne) {
    const std::string model = box_stl("box.stl", 10.0);
    const std::string program = in_build("bin/psicarve");
    const std::string common = " --layers 3 --points 9 ";
    const auto shell = [](const std::string& line) { return WEXITSTATUS(std::system(line.c_str())); };
    ASSERT_EQ(psicarve({"slice", model, "-o", file("file.job"), "--layers", "3", "--points", "9"}).exit_code,
              0);
    ASSERT_EQ(shell("cat " + model + " | " + program + " slice - -o -" + common + "2>" + file("err") +
                    " | cat >" + file("pipe.job")),
              0);
    EXPECT_NE(text_of(file("err")).find("3 layers x 9 points"), std::string::npos) << text_of(file("err"));
    const Outcome diff = psicarve({"snapshot", "diff", file("file.job"), file("pipe.job"), "--json"});
    EXPECT_EQ(text_of(file("pipe.job")).size() > 1000, true);
    EXPECT_EQ(psicarve({"snapshot", "info", file("pipe.job"), "--json"}).json()["job"]["source"],
              "standard input")
        << diff.out;
    ASSERT_EQ(shell(program + " snapshot info - --json <" + file("pipe.job") + " >" + file("info.json")), 0);
    ASSERT_EQ(shell("cat " + file("pipe.job") + " | " + program + " replay - --json >" + file("replay.json") +
                    " 2>&1"),
              0)
        << text_of(file("replay.json"));
    EXPECT_EQ(shell("echo nonsense | " + program + " slice - -o " + file("x.job") + " 2>" + file("err")), 3);
    EXPECT_NE(text_of(file("err")).find("psicarve: standard input: "), std::string::npos)
        << text_of(file("err"));
    EXPECT_FALSE(std::filesystem::exists("-"));
}

TEST_F(SliceCommand, RefusesAFileInAFolderWhereNoneCanBeMadeBeforeItSlices) {
    const std::string model = box_stl("box.stl", 10.0);
    for (const char* output : {"/proc/a.job", "/proc/self/a.job"}) {
        const Outcome outcome = psicarve({"slice", model, "-o", output, "--layers", "3", "--points", "3"});
        EXPECT_EQ(outcome.exit_code, 3);
        EXPECT_EQ(outcome.error_lines(), 1U) << "no word of a model that was sliced: " << outcome.error;
    }
}

TEST_F(SliceCommand, RefusesTurnsAndFitsThatSayNothing) {
    const std::string model = box_stl("box.stl");
    const std::vector<std::vector<std::string>> wrong{{"--rotate", "left"},        {"--rotate", "1,2"},
                                                      {"--rotate", "1,2,"},        {"--rotate", "1,2,3,4"},
                                                      {"--mirror", "xy"},          {"--rotate", "nan,0,0"},
                                                      {"--fit", "--height", "20"}, {"--fit", "--scale", "2"}};
    for (const auto& more : wrong) {
        std::vector<std::string> arguments{"slice", model, "-o", file("a.job")};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = psicarve(arguments);
        EXPECT_EQ(outcome.exit_code, 2) << more.back() << outcome.error;
        EXPECT_EQ(outcome.error_lines(), 1U) << outcome.error;
    }
}

}  // namespace
}  // namespace psicarve::test
