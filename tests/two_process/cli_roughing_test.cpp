// SPDX-License-Identifier: GPL-3.0-or-later
// Jobs of several passes as users make, estimate, carve, verify and resume them.
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>

#include "tests/places.hpp"
#include "tests/thoroughness.hpp"
#include "tests/two_process/commanded_core.hpp"

namespace psicarve::test {
namespace {

using Json = nlohmann::json;

class Roughing : public CommandedCore {
protected:
    /// A box 10 mm wide and 3 mm high, out of a blank of 9 mm radius: 7 and 5 mm deep, and the allowance.
    std::vector<std::string> words(const std::string& command, const std::vector<std::string>& more = {},
                                   const std::vector<std::string>& without = {}) const {
        std::vector<std::string> arguments{
            command,  box_stl("box.stl"), "--layers", "6",    "--points",   "31", "--height",   "3",
            "--tool", "flat:2",           "--blank",  "9x10", "--stepdown", "2",  "--stepover", "1"};
        for (const std::string& option : without) {
            const auto at = std::find(arguments.begin(), arguments.end(), option);
            arguments.erase(at, at + 2);
        }
        arguments.insert(arguments.end(), more.begin(), more.end());
        return arguments;
    }
    static std::uint32_t layers_of(const Json& passes) {
        std::uint32_t layers = 0;
        for (const Json& pass : passes) layers += pass["layers"].get<std::uint32_t>();
        return layers;
    }
};

TEST_F(Roughing, IsSlicedEstimatedCarvedAndVerified) {
    const Outcome sliced = psicarve(words("slice", {"-o", file("a.job"), "--json"}));
    ASSERT_EQ(sliced.exit_code, 0) << sliced.error;
    const Json passes = sliced.json()["passes"];
    ASSERT_GE(passes.size(), 3U) << sliced.out;
    EXPECT_EQ(passes[0]["pass"], "roughing pass 1");
    EXPECT_EQ(passes[0]["depth_mm"], 7.0);
    EXPECT_EQ(passes[0]["layers"], 4);
    EXPECT_EQ(passes.back()["pass"], "finishing pass");
    EXPECT_EQ(passes.back()["layers"], 6);
    EXPECT_EQ(layers_of(passes), sliced.json()["layers"]);
    EXPECT_EQ(sliced.json()["report"]["roughing"]["pass_count"], passes.size() - 1);
    EXPECT_GT(sliced.json()["report"]["roughing"]["air_share"], 0.0);

    const Outcome estimated = psicarve({"estimate", file("a.job"), "--json"});
    ASSERT_EQ(estimated.exit_code, 0) << estimated.error;
    const Outcome carved =
        psicarve({"carve", file("a.job"), "--segment", segment_, "--trace", file("a.bin"), "--json"});
    ASSERT_EQ(carved.exit_code, 0) << carved.error;
    const Json report = carved.json();
    EXPECT_EQ(report["verified"], true);
    EXPECT_EQ(report["max_deviation_pulses"], 0);
    ASSERT_EQ(report["passes"].size(), passes.size());
    double sum_s = 0.0;
    for (std::size_t i = 0; i < passes.size(); ++i) {
        EXPECT_EQ(report["passes"][i]["pass"], passes[i]["pass"]);
        EXPECT_EQ(report["passes"][i]["layers"], passes[i]["layers"]);
        const double seconds = report["passes"][i]["seconds"].get<double>();
        sum_s += seconds;
        EXPECT_NEAR(estimated.json()["passes"][i]["seconds"].get<double>(), seconds, 0.02 * seconds + 0.02)
            << i;
    }
    EXPECT_NEAR(sum_s, report["carve_seconds"].get<double>(), 0.01);
    EXPECT_NEAR(estimated.json()["carve_seconds"].get<double>(), sum_s, 0.02 * sum_s);

    const Outcome verified = psicarve({"verify", file("a.job"), file("a.bin")});
    EXPECT_EQ(verified.exit_code, 0) << verified.error;
    EXPECT_NE(verified.out.find("roughing pass 1: 4 layers in "), std::string::npos) << verified.out;
    EXPECT_NE(verified.out.find("finishing pass: 6 layers in "), std::string::npos) << verified.out;
    const Outcome info = psicarve({"snapshot", "info", file("a.job")});
    EXPECT_NE(info.out.find(" layers, leaving 0.3 mm, and the finishing pass of 6"), std::string::npos)
        << info.out;
}

// What stands on the table is another piece of wood for each job: no core is started anew for it.
TEST_F(Roughing, IsCarvedByACoreThatKnowsNoBlankFromTheJobsOwn) {
    start_core();
    const Outcome carved = run(words("carve", {"--trace", file("a.bin"), "--json"}));
    ASSERT_EQ(carved.exit_code, 0) << carved.error;
    EXPECT_EQ(carved.json()["verified"], true);
    // Waiting before the first layer both heads stand outside of the 9 mm and their clearance of 2 mm.
    ASSERT_EQ(
        psicarve(words("slice", {"-o", file("fine.job"), "--finish-only"}, {"--stepdown", "--stepover"}))
            .exit_code,
        0);
    ASSERT_EQ(run({"publish", file("fine.job")}).exit_code, 0);
    ASSERT_EQ(run({"start", "--dry-run"}).exit_code, 0);
    ASSERT_TRUE(reaches(MachineState::waiting));
    const double r1_per_mm = axis_motion(Profile{}, Axis::r1).pulses_per_unit;
    for (const Axis head : {Axis::r1, Axis::r2})
        EXPECT_EQ(status().position_pulses[index_of(head)], std::llround(11.0 * r1_per_mm));
}

TEST_F(Roughing, AJobThatKnowsNoBlankIsRefusedByAMachineThatHasOne) {
    std::ofstream(file("shop.toml")) << "[blank]\nradius_mm = 20\n";
    start_core({"--profile", file("shop.toml")});
    ASSERT_EQ(psicarve({"slice", box_stl("box.stl"), "-o", file("a.job"), "--layers", "3", "--points", "9"})
                  .exit_code,
              0);
    const Outcome refused = run({"publish", file("a.job")});
    EXPECT_EQ(refused.exit_code, 4);
    EXPECT_NE(refused.error.find("blank.radius_mm differ"), std::string::npos) << refused.error;
    const Outcome known = run(words("carve", {"--json"}));
    EXPECT_EQ(known.exit_code, 0) << known.error;
}

TEST_F(Roughing, AnotherBlankThanTheMachinesIsToldWhereverItMatters) {
    const std::string larger =
        "blank of 9.00 mm radius, the machine's profile tells of 20.00 mm; what is larger";
    std::ofstream(file("shop.toml")) << "[blank]\nradius_mm = 20\n";
    ASSERT_EQ(psicarve(words("slice", {"-o", file("a.job")})).exit_code, 0);
    start_core({"--profile", file("shop.toml")});
    const auto expect_told = [&larger](const Outcome& outcome) {
        EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
        const std::size_t at = outcome.error.find(larger);
        EXPECT_NE(at, std::string::npos) << outcome.error;
        EXPECT_EQ(outcome.error.find(larger, at + 1), std::string::npos) << "once is enough";
    };
    expect_told(run({"publish", file("a.job")}));
    expect_told(run(words("carve", {"--json", "--trace", file("a.bin")})));
    expect_told(run({"start", "--dry-run"}));
    expect_told(psicarve({"verify", file("a.job"), file("a.bin"), "--profile", file("shop.toml")}));
    expect_told(psicarve({"estimate", file("a.job"), "--profile", file("shop.toml")}));
    // Another job that is accepted takes its place.
    ASSERT_EQ(run({"stop"}).exit_code, 0);
    ASSERT_TRUE(reaches(MachineState::ready));
    Outcome fits = run(
        {"publish", box_stl("box.stl"), "--profile", file("shop.toml"), "--layers", "3", "--points", "9"});
    EXPECT_EQ(fits.exit_code, 0) << fits.error;
    EXPECT_EQ(fits.error.find("made for a blank"), std::string::npos) << fits.error;
    // And what no head gets out of is no job at all.
    const Outcome wide = psicarve({"slice", box_stl("box.stl"), "-o", file("b.job"), "--blank", "61x10"});
    EXPECT_EQ(wide.exit_code, 3);
    EXPECT_NE(wide.error.find("it would stand in the blank before the carving begins"), std::string::npos)
        << wide.error;
}

TEST_F(Roughing, HasItsLayersTimesToldByTheCore) {
    ASSERT_EQ(psicarve(words("slice", {"-o", file("a.job")})).exit_code, 0);
    const auto lines_of = [this](const std::string& name) {
        std::ifstream in(file(name));
        std::vector<std::string> lines;
        for (std::string line; std::getline(in, line);) lines.push_back(line);
        return lines;
    };
    start_core({"--profile", file("a.job"), "--layer-times", file("times.csv")});
    ASSERT_EQ(run({"publish", file("a.job")}).exit_code, 0);
    ASSERT_TRUE(eventually([&] { return status().seconds_left >= 0.0; }));
    const std::vector<std::string> lines = lines_of("times.csv");
    const Json job = psicarve({"snapshot", "info", file("a.job"), "--json"}).json();
    ASSERT_EQ(lines.size(), job["job"]["layers"].get<std::size_t>() + 1);
    EXPECT_EQ(lines.front(), "layer,seconds");
    double before_s = 0.0;
    for (std::size_t layer = 0; layer + 1 < lines.size(); ++layer) {
        const std::string head = std::to_string(layer) + ",";
        ASSERT_EQ(lines[layer + 1].substr(0, head.size()), head);
        const double until_s = std::stod(lines[layer + 1].substr(head.size()));
        EXPECT_GT(until_s, before_s);
        before_s = until_s;
    }
    EXPECT_NEAR(before_s, status().seconds_left, 1e-6);
    // Another job, and its times take the place of these.
    ASSERT_EQ(psicarve(words("slice", {"-o", file("b.job"), "--allowance", "0.5"})).exit_code, 0);
    ASSERT_EQ(run({"publish", file("b.job")}).exit_code, 0);
    ASSERT_TRUE(eventually([&] { return status().seconds_left >= 0.0; }));
    EXPECT_NE(lines_of("times.csv"), lines);
}

TEST_F(Roughing, LeavesTheSamePieceAsTheFinishingPassAlone) {
    const auto removed = [](const std::vector<std::string>& arguments) {
        const Outcome outcome = psicarve(arguments);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
        return outcome.json()["removed_mm3"].get<double>();
    };
    const double roughed_mm3 = removed(words("estimate", {"--json"}));
    EXPECT_NEAR(roughed_mm3,
                removed({"estimate", box_stl("box.stl"), "--layers", "6", "--points", "31", "--height", "3",
                         "--tool", "flat:2", "--blank", "9x10", "--finish-only", "--json"}),
                0.01 * roughed_mm3);
}

TEST_F(Roughing, GoesOnInTheMiddleOfASecondPass) {
    ASSERT_EQ(psicarve(words("slice", {"-o", file("a.job"), "--joining", "spiral"})).exit_code, 0);
    start_core({"--profile", file("a.job")});
    ASSERT_EQ(run({"publish", file("a.job")}).exit_code, 0);
    ASSERT_EQ(run({"home"}).exit_code, 0);
    ASSERT_EQ(run({"start", "--layers", "6", "--carve"}).exit_code, 0);
    ASSERT_TRUE(reaches(MachineState::ready));
    const auto checkpoint = run({"status", "--json"}).json()["checkpoint"];
    EXPECT_EQ(checkpoint["next_layer"], 6);
    EXPECT_TRUE(run({"status", "--json"}).json()["pass"].is_null()) << "no job runs";
    ASSERT_EQ(run({"start", "--resume", "--carve"}).exit_code, 0);
    ASSERT_TRUE(
        eventually([&] { return status().job_end_tick != 0 && status().state == MachineState::ready; }));
    EXPECT_EQ(status().points_done, status().points_total);
    EXPECT_EQ(status().sim_stalls[0] + status().sim_stalls[1] + status().sim_stalls[2], 0U);
}

TEST_F(Roughing, StatusNamesThePassThatIsCarved) {
    const auto layers_before_finishing = [this] {
        const Json job = psicarve({"snapshot", "info", file("a.job"), "--json"}).json();
        return job["job"]["layers"].get<int>() - 6;
    };
    ASSERT_EQ(psicarve(words("slice", {"-o", file("a.job")})).exit_code, 0);
    start_core({"--profile", file("a.job")});
    ASSERT_EQ(run({"publish", file("a.job")}).exit_code, 0);
    ASSERT_EQ(run({"home"}).exit_code, 0);
    const auto waits_at = [this](int layer) {
        EXPECT_EQ(run({"start", "--from-layer", std::to_string(layer)}).exit_code, 0);
        EXPECT_TRUE(reaches(MachineState::waiting));
        const Json told = run({"status", "--json"}).json()["pass"];
        // The last words of the line, or before the time that is left, once that is known.
        EXPECT_THAT(run({"status"}).out, testing::ContainsRegex(", " + told.get<std::string>() + "[,\n]"));
        EXPECT_EQ(run({"stop"}).exit_code, 0);
        EXPECT_TRUE(reaches(MachineState::ready));
        return told;
    };
    EXPECT_EQ(waits_at(0), "roughing pass 1");
    EXPECT_EQ(waits_at(layers_before_finishing()), "finishing pass");
}

TEST_F(Roughing, RefusesWhatMakesNoSense) {
    const auto refused = [this](const std::vector<std::string>& more, const std::string& why,
                                int exit_code = 2) {
        std::vector<std::string> arguments{"slice", box_stl("box.stl"), "-o", file("b.job"), "--layers", "3"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = psicarve(arguments);
        EXPECT_EQ(outcome.exit_code, exit_code) << outcome.error;
        EXPECT_NE(outcome.error.find(why), std::string::npos) << outcome.error;
        EXPECT_EQ(outcome.error_lines(), 1U) << outcome.error;
        EXPECT_FALSE(std::filesystem::exists(file("b.job")));
    };
    refused({"--blank", "30x60", "--stepdown", "0"}, "--stepdown: '0' is not a number greater than 0");
    refused({"--blank", "30x60", "--stepdown", "-2"}, "--stepdown: '-2' is not a number greater than 0");
    refused({"--blank", "30x60", "--stepdown", "2", "--allowance", "-0.1"},
            "--allowance: '-0.1' is not a number from 0 on");
    refused({"--blank", "30x60", "--stepdown", "2", "--tool", "ball:3", "--stepover", "0"},
            "--stepover: '0' is not a number greater than 0");
    refused({"--blank", "30x60", "--stepdown", "2", "--tool", "ball:3", "--stepover", "4"},
            "more than the tool is wide");
    refused({"--stepdown", "2"}, "--blank RADIUSxHEIGHT");
    refused({"--blank", "30x60", "--stepdown", "2", "--stepover", "1"}, "a point carves every layer");
    refused({"--blank", "30x60", "--stepdown", "2e4"}, "the stepdown must be more than 0 mm, and 10000 mm");
    refused({"--blank", "30x60", "--allowance", "0.2"}, "needs --stepdown MM or the profile's");
    refused({"--blank", "30x60", "--stepdown", "2", "--finish-only"}, "--finish-only excludes");
    const Outcome word = psicarve({"slice", box_stl("box.stl"), "-o", file("b.job"), "--stepdown", "deep"});
    EXPECT_EQ(word.exit_code, 2) << word.error;
}

TEST_F(Roughing, IsWhatTheProfileSaysUnlessAnOptionSaysElse) {
    std::ofstream(file("shop.toml")) << "[tool]\nshape = \"flat\"\ndiameter_mm = 2\n[blank]\nradius_mm = 9\n"
                                        "[roughing]\nstepdown_mm = 2\nallowance_mm = 0.5\nstepover_mm = 1\n";
    const auto sliced = [this](const std::string& profile, const std::vector<std::string>& more) {
        // Not over the job whose profile is meant.
        const std::string output = file(profile == "p.job" ? "again.job" : "p.job");
        std::vector<std::string> arguments{"slice",     box_stl("box.stl"), "-o",    output,     "--layers",
                                           "6",         "--points",         "31",    "--height", "3",
                                           "--profile", file(profile),      "--json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = psicarve(arguments);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
        return outcome.exit_code == 0 ? outcome.json() : Json{};
    };
    const auto asked = [](const Json& job, double stepdown_mm, double allowance_mm, double stepover_mm) {
        const Json& roughing = job["report"]["roughing"];
        EXPECT_EQ(roughing["stepdown_mm"], stepdown_mm);
        EXPECT_EQ(roughing["allowance_mm"], allowance_mm);
        EXPECT_EQ(roughing["stepover_mm"], stepover_mm);
    };
    asked(sliced("shop.toml", {}), 2.0, 0.5, 1.0);
    asked(sliced("shop.toml", {"--stepdown", "1.5"}), 1.5, 0.5, 1.0);
    asked(sliced("shop.toml", {"--allowance", "0"}), 2.0, 0.0, 1.0);
    asked(sliced("shop.toml", {"--stepover", "1.5"}), 2.0, 0.5, 1.5);
    asked(sliced("shop.toml", {"--tool", "point"}), 2.0, 0.5, 0.0);
    // The job carries the stepdown that was used, from the option or the profile.
    asked(sliced("p.job", {"--tool", "flat:2"}), 2.0, 0.5, 1.0);
    EXPECT_EQ(sliced("shop.toml", {"--finish-only"})["passes"].size(), 1U);
    EXPECT_EQ(sliced("p.job", {})["passes"].size(), 1U);
    const Outcome narrow = psicarve({"slice", box_stl("box.stl"), "-o", file("n.job"), "--profile",
                                     file("shop.toml"), "--tool", "ball:0.5"});
    EXPECT_EQ(narrow.exit_code, 2);
    EXPECT_NE(narrow.error.find("a stepover of 1 mm is more than the tool is wide, 0.5 mm"),
              std::string::npos)
        << narrow.error;
}

/// Three lobes that turn as they rise, with waists: what stands a little higher is another radius altogether.
std::string twisted_stl() {
    constexpr int kSides = 36;
    constexpr int kRows = 18;
    const auto corner = [](int row, int side) {
        const double angle = 2.0 * std::numbers::pi * side / kSides;
        const double height = 0.5 * row;
        const double radius = 10.0 + 2.0 * std::cos(3.0 * angle) + 1.5 * std::sin(0.7 * height + angle);
        std::ostringstream text;
        text << "vertex " << radius * std::cos(angle) << ' ' << radius * std::sin(angle) << ' ' << height
             << '\n';
        return text.str();
    };
    std::string stl = "solid twisted\n";
    const auto facet = [&stl](const std::string& a, const std::string& b, const std::string& c) {
        stl += "facet normal 0 0 0\nouter loop\n" + a + b + c + "endloop\nendfacet\n";
    };
    for (int side = 0; side < kSides; ++side) {
        const int next = (side + 1) % kSides;
        for (int row = 0; row < kRows; ++row) {
            facet(corner(row, side), corner(row, next), corner(row + 1, next));
            facet(corner(row, side), corner(row + 1, next), corner(row + 1, side));
        }
        facet("vertex 0 0 0\n", corner(0, next), corner(0, side));
        facet("vertex 0 0 9\n", corner(kRows, side), corner(kRows, next));
    }
    return stl + "endsolid twisted\n";
}

// Roughing layers are level; a spiral's rows rise, and a head that stands askew has them at heights of its
// own.
TEST_F(Roughing, OfASpiralWithHeadsAskewIsVerified) {
    write("twisted.stl", twisted_stl());
    for (const auto& [height_mm, angle_deg] :
         {std::pair{0.35, 0.0}, std::pair{0.0, 7.3}, std::pair{1.3, 7.3}}) {
        if (!is_thorough() && height_mm != 1.3) continue;
        std::ostringstream profile;
        profile << "[head.r2]\nangle_error_deg = " << angle_deg << "\nheight_error_mm = " << height_mm
                << '\n';
        write("askew.toml", profile.str());
        const Outcome carved = psicarve({"carve",       file("twisted.stl"),
                                         "--profile",   file("askew.toml"),
                                         "--layers",    "13",
                                         "--points",    "25",
                                         "--tool",      "ball:3",
                                         "--blank",     "16x11",
                                         "--joining",   "spiral",
                                         "--stepdown",  "3",
                                         "--allowance", "0",
                                         "--segment",   segment_,
                                         "--json"});
        ASSERT_EQ(carved.exit_code, 0) << profile.str() << carved.error;
        EXPECT_EQ(carved.json()["verified"], true) << profile.str();
    }
}

TEST_F(Roughing, OfATableTakesItsLayersAsTheyStand) {
    std::ofstream(file("t.csv")) << "y_mm,r_mm\n1,5,5,5,6,6,6\n1.5,5,5,5,6,6,6\n2,5,5,5,6,6,6\n";
    const Outcome sliced = psicarve({"slice", file("t.csv"), "-o", file("t.job"), "--blank", "9x10",
                                     "--stepdown", "1.5", "--allowance", "0", "--json"});
    ASSERT_EQ(sliced.exit_code, 0) << sliced.error;
    // 7.5, 6 and 5 mm, three layers each, and the finishing pass.
    ASSERT_EQ(sliced.json()["passes"].size(), 4U) << sliced.out;
    EXPECT_EQ(sliced.json()["layers"], 12);
    const Outcome carved = psicarve({"carve", file("t.job"), "--segment", segment_, "--json"});
    ASSERT_EQ(carved.exit_code, 0) << carved.error;
    EXPECT_EQ(carved.json()["verified"], true);
}

// Its last roughing passes leave out layers, past which Y takes the heads.
TEST_F(Roughing, GoesPastTheLayersThatAPassLeavesOut) {
    std::vector<std::string> carve{"carve",      example("figurine.stl"),
                                   "--segment",  segment_,
                                   "--layers",   "30",
                                   "--points",   "30",
                                   "--tool",     "ball:3",
                                   "--blank",    "22x70",
                                   "--stepdown", "4",
                                   "--json"};
    // The comparison of the piece, which is another test's, is most of it.
    if (!is_thorough()) carve.emplace_back("--no-deviation");
    const Outcome carved = psicarve(carve);
    ASSERT_EQ(carved.exit_code, 0) << carved.error;
    EXPECT_EQ(carved.json()["verified"], true);
}

}  // namespace
}  // namespace psicarve::test
