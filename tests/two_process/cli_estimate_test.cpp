// SPDX-License-Identifier: GPL-3.0-or-later
#include <numbers>

#include "tests/hmi/cli/program_run.hpp"

namespace psicarve::test {
namespace {

using Json = nlohmann::json;

class Estimate : public CliTest {
protected:
    std::vector<std::string> sliced(const std::string& command, const std::vector<std::string>& more) const {
        std::vector<std::string> arguments{command, box_stl("box.stl"), "--layers", "6",      "--points",
                                           "41",    "--height",         "3",        "--tool", "ball:2"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return arguments;
    }
};

TEST_F(Estimate, IsWhatCarvingComesTo) {
    const Outcome outcome = psicarve(sliced("estimate", {"--json"}));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
    const Json estimate = outcome.json();
    const Outcome carved =
        psicarve(sliced("carve", {"--json", "--segment", segment_, "--deviation", file("a.png")}));
    ASSERT_EQ(carved.exit_code, 0) << carved.error;
    const Json report = carved.json();
    const double carve_seconds = report["carve_seconds"].get<double>();
    EXPECT_NEAR(estimate["carve_seconds"].get<double>(), carve_seconds, 0.01 * carve_seconds);
    EXPECT_EQ(estimate["reference_seconds"], report["reference_seconds"]);
    EXPECT_LE(estimate["least_seconds"].get<double>(), carve_seconds);
    EXPECT_EQ(estimate["layers"], 6);
    EXPECT_EQ(estimate["points"], 41);
    const double removed_mm3 = report["deviation"]["removed_mm3"].get<double>();
    EXPECT_NEAR(estimate["removed_mm3"].get<double>(), removed_mm3, 0.02 * removed_mm3);
    double bound = 0.0;
    for (const auto& share : estimate["bound_by"]) bound += share.get<double>();
    EXPECT_NEAR(bound, 1.0, 1e-9) << estimate["bound_by"];
    // Approach and retraction are not in it.
    for (const char* axis : {"r1", "r2", "psi", "y"}) {
        EXPECT_GT(estimate["pulses"][axis].get<int>(), 0) << axis;
        EXPECT_LE(estimate["pulses"][axis].get<int>(), report["pulses"][axis].get<int>()) << axis;
    }
    EXPECT_GT(estimate["path_mm"]["r1"].get<double>(), 0.0);
}

TEST_F(Estimate, OfAJobIsForAPersonAndLeavesNoCoreBehind) {
    ASSERT_EQ(psicarve(sliced("slice", {"-o", file("box.job")})).exit_code, 0);
    const Outcome outcome = psicarve({"estimate", file("box.job"), "--segment", segment_});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
    for (const char* word : {"carving ", "reference ", "bound by ", "path ", "removed "})
        EXPECT_NE(outcome.out.find(word), std::string::npos) << word << outcome.out;
    EXPECT_EQ(psicarve({"status", "--segment", segment_}).exit_code, 5);
    EXPECT_EQ(psicarve({"estimate", file("box.job"), "--layers", "3"}).exit_code, 2);
    EXPECT_EQ(psicarve({"estimate", file("none.stl")}).exit_code, 3);
}

/// A table by hand: 400 pulses a mm, half a turn of three points a layer. Two roughing layers of 10 mm, 1 and
/// 4 mm high, and two of 8 and 9.5 mm for R1, 7 mm for R2, in a blank of 12 mm.
TEST_F(Estimate, AddsUpThePathOfEachPassWithItsLinks) {
    std::string table =
        "layer,point,y_pulses,psi_pulses,r_left_pulses,r_right_pulses,run,pass,allowance_mm,depth_mm,clear_"
        "mm\n";
    const auto add = [&table](int layer, int y, int r1, int r2, const char* pass) {
        for (int point = 0; point < 3; ++point) {
            const int psi = 3200 * layer + 1600 * point;
            for (const int number : {layer, point, y, psi, r1, r2}) table += std::to_string(number) + ",";
            table += std::string{pass} + "\n";
        }
    };
    add(0, 400, 4000, 4000, "1,1,0.3,10,12");
    add(1, 1600, 4000, 4000, "1,1,0.3,10,12");
    add(2, 400, 3200, 2800, "2,2,0,0,12");
    add(3, 800, 3800, 2800, "2,2,0,0,12");
    write("passes.csv", table);
    const std::vector<std::string> command{"estimate", file("passes.csv"), "--tool",
                                           "ball:2",   "--blank",          "12x20"};
    std::vector<std::string> with_json = command;
    with_json.push_back("--json");
    const Outcome outcome = psicarve(with_json);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
    const Json estimate = outcome.json();
    const auto expect = [](const Json& said, const char* what, double r1_mm, double r2_mm) {
        EXPECT_NEAR(said[what]["r1"].get<double>(), r1_mm, 1e-9) << what;
        EXPECT_NEAR(said[what]["r2"].get<double>(), r2_mm, 1e-9) << what;
    };
    ASSERT_EQ(estimate["passes"].size(), 2U);
    constexpr double kHalf = std::numbers::pi;
    expect(estimate["passes"][0], "cutting_mm", kHalf * 20.0, kHalf * 20.0);
    expect(estimate["passes"][0], "links_mm", 3.0, 3.0);
    expect(estimate["passes"][0], "total_mm", kHalf * 20.0 + 3.0, kHalf * 20.0 + 3.0);
    // From 10 mm out to 14, the blank and the clearance of 2; 3 mm down; in. Then 1 mm up, R1 1.5 mm out.
    expect(estimate["passes"][1], "cutting_mm", kHalf * 17.5, kHalf * 14.0);
    expect(estimate["passes"][1], "links_mm", 4.0 + 3.0 + 6.0 + 2.5, 4.0 + 3.0 + 7.0 + 1.0);
    expect(estimate, "path_mm", kHalf * 37.5, kHalf * 34.0);
    expect(estimate, "links_mm", 18.5, 18.0);
    expect(estimate, "total_mm", kHalf * 37.5 + 18.5, kHalf * 34.0 + 18.0);
    const std::string told = psicarve(command).out;
    for (const char* line : {"path R1 63 mm, R2 63 mm, links R1 3 mm, R2 3 mm\n",
                             "path       R1 118 mm, R2 107 mm over the surface\n",
                             "links      R1 19 mm, R2 18 mm between layers and passes\n",
                             "total      R1 136 mm, R2 125 mm, without approach and retraction\n"})
        EXPECT_NE(told.find(line), std::string::npos) << line << told;
}

}  // namespace
}  // namespace psicarve::test
