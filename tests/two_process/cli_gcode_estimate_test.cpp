// SPDX-License-Identifier: GPL-3.0-or-later
// `psicarve gcode estimate` beside runs of the same programs.
#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "shared/segment/segment_program.hpp"
#include "tests/places.hpp"
#include "tests/two_process/cli_machine_rig.hpp"

namespace psicarve::test {
namespace {

const std::string kMixed =
    "G21 G90 F300\nG0 X40 Z41 Y5 C0\nG1 X39.5 C90\nG4 P1.5\nG64 P0.1\nG1 X39 C180\nG1 X39.2 Z40 C300 F9000\n"
    "M3\nG17 G3 X40.2 Y6 I1 J0\nM5\nG0 X50\nM2\n";

class EstimateOfAProgram : public Machine {
protected:
    std::string program(const std::string& text) const {
        write("a.ngc", text);
        return file("a.ngc");
    }
    nlohmann::json estimate(const std::string& path, std::vector<std::string> more = {}) const {
        more.insert(more.begin(), {"gcode", "estimate", path, "--json"});
        const Outcome outcome = run(more);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
        return outcome.json();
    }
    bool comes_to_hold(ProgramHold hold) const {
        return eventually([&] {
            const auto segment = Segment::attach(segment_);
            return state() == MachineState::held && segment && program_report(*segment).status.hold == hold;
        });
    }
};

TEST_F(EstimateOfAProgram, IsTheTimeOfItsSimulatedRun) {
    const std::string path = program(kMixed);
    const auto estimated = estimate(path);
    const auto done = run({"gcode", "run", path, "--simulate", "--json"}).json();
    EXPECT_EQ(estimated["seconds"], done["seconds"]);
    EXPECT_EQ(estimated["lowered"], done["lowered"]);
    EXPECT_EQ(estimated["dwell_seconds"], 1.5);
    EXPECT_EQ(estimated["stop_count"], 0);
    const double moved_s = estimated["feed_seconds"].get<double>() + estimated["rapid_seconds"].get<double>();
    EXPECT_NEAR(moved_s + estimated["rest_seconds"].get<double>(), estimated["seconds"].get<double>(), 1e-9);
    EXPECT_GE(estimated["rest_seconds"].get<double>(), 1.5);
    EXPECT_LT(estimated["rest_seconds"].get<double>(), 3.0);
}

TEST_F(EstimateOfAProgram, TellsTimesOfEachKindBoundsAndLoweredFeeds) {
    // 10 mm at 100 mm/min are 6 s, and more for speeding up; no axis comes near 9000 mm/min.
    const auto slow = estimate(program("G21 G90 F100 G61\nG1 X49.7475 Z49.7475\nG1 X39.7475\nM2\n"));
    EXPECT_NEAR(slow["feed_seconds"].get<double>(), 6.0 * (1.0 + std::sqrt(2.0)), 0.4);
    EXPECT_EQ(slow["rapid_seconds"], 0.0);
    EXPECT_NEAR(slow["bounds"]["r1_mm"][0].get<double>(), 39.7475, 0.003);
    EXPECT_NEAR(slow["bounds"]["r2_mm"][0].get<double>(), 49.7475, 0.003);
    EXPECT_EQ(slow["bounds"]["psi_deg"][0], slow["bounds"]["psi_deg"][1]);
    const auto fast = estimate(program("G21 G90 F9000 G61\nG1 C360\nG1 X39\nG0 X50\nG1 X40\nM2\n"));
    EXPECT_GT(fast["lowered_count"], 1);
    EXPECT_EQ(fast["lowered"].size(), fast["lowered_count"].get<std::size_t>());
    EXPECT_GT(fast["lowered"][0]["share"], 0.5);
    EXPECT_GT(fast["rapid_seconds"], 0.0);
    EXPECT_GT(fast["lowered_seconds"], 0.0);
}

TEST_F(EstimateOfAProgram, WaitsForNobodyAndSaysWhereItWouldHaveTo) {
    const std::string path = program("G21 G90 F300\nG0 X40\nM0\nG0 X41\nM1\nT1 M6\nG0 X42\nM60\nM2\n");
    const auto estimated = estimate(path);
    EXPECT_EQ(estimated["stop_count"], 3);
    EXPECT_EQ(estimated["stops"][0]["line"], 3);
    EXPECT_EQ(estimated["stops"][1]["why"], "tool change");
    EXPECT_EQ(estimated["stops"][2]["why"], "pallet");
    EXPECT_EQ(estimate(path, {"--optional-stop"})["stop_count"], 4);
    start_core();
    ASSERT_EQ(run({"home"}).exit_code, 0);
    RunningProgram running{"psicarve", {"gcode", "run", path, "--json", "--segment", segment_}};
    for (const ProgramHold hold : {ProgramHold::program, ProgramHold::tool_change, ProgramHold::program}) {
        ASSERT_TRUE(comes_to_hold(hold));
        ASSERT_EQ(run({"resume"}).exit_code, 0);
    }
    const auto done = running.outcome().json();
    EXPECT_NEAR(done["seconds"].get<double>(), estimated["seconds"].get<double>(), 0.05);
}

TEST_F(EstimateOfAProgram, DisturbsNoCoreAndLeavesNothingBehind) {
    start_core();
    const auto before = files_in_folder();
    const std::string path = program(kMixed);
    EXPECT_GT(estimate(path)["seconds"], 1.0);
    EXPECT_EQ(state(), MachineState::off);
    EXPECT_EQ(files_in_folder().size(), before.size() + 1);
}

TEST_F(EstimateOfAProgram, IsRefusedWhereTheProgramIsWrong) {
    const std::string path = program("G21 G90\nG1 X40\nM2\n");
    const Outcome refused = run({"gcode", "estimate", path});
    EXPECT_EQ(refused.exit_code, 3);
    EXPECT_NE(refused.error.find(":2:4: feed_missing"), std::string::npos) << refused.error;
    EXPECT_EQ(refused.out, "");
    EXPECT_EQ(run({"gcode", "estimate", path, "--json"}).json()["ok"], false);
    EXPECT_EQ(run({"gcode", "estimate", file("none.ngc")}).exit_code, 3);
}

TEST_F(EstimateOfAProgram, IsForPeopleAndOfStandardInputToo) {
    const std::string path = program(kMixed);
    const Outcome text = run({"gcode", "estimate", path});
    for (const char* row :
         {"program    ", "time       0:", "of that    feed ", "bounds     r1 ", "feed       lowered"})
        EXPECT_NE(text.out.find(row), std::string::npos) << row << text.out;
    EXPECT_EQ(text.error, "");
    const std::string command =
        in_build("bin/psicarve") + " gcode estimate - --json < " + path + " > " + file("out");
    ASSERT_EQ(std::system(command.c_str()), 0);
    EXPECT_EQ(nlohmann::json::parse(text_of(file("out")))["seconds"], estimate(path)["seconds"]);
}

}  // namespace
}  // namespace psicarve::test
