// SPDX-License-Identifier: GPL-3.0-or-later
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

}  // namespace
}  // namespace psicarve::test
