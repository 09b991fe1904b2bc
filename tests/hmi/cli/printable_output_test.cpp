// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>

#include "shared/base/printable.hpp"
#include "tests/hmi/cli/program_run.hpp"
#include "tests/places.hpp"

namespace psicarve::test {
namespace {

/// Clears the screen, as DEL, C1 and a mark that turns the direction of writing do their part.
const std::string kHostile = "\033[2J\x7f\u009b2J\u202ex";

class PrintableOutput : public CliTest {
protected:
    PrintableOutput() {
        std::filesystem::copy_file(example("small.stl"), file(kHostile + ".stl"));
        const Outcome made = run({"slice", file(kHostile + ".stl"), "-o", file(kHostile + ".job"), "--layers",
                                  "4", "--points", "8"});
        EXPECT_EQ(made.exit_code, 0) << made.error;
        expect_printable(made, "slice");
        write(kHostile + ".toml", "\033[2J = \u202e");
        write(kHostile + ".csv", "\033[2Jy_mm,r_mm\n1,2\n");
        write(kHostile + ".svg", "<svg><path d=\"\u009b\"/></svg>");
    }
    /// Every byte that steers would have become others.
    static void expect_printable(const Outcome& outcome, const std::string& what) {
        EXPECT_EQ(printable(outcome.out), outcome.out) << what;
        EXPECT_EQ(printable(outcome.error), outcome.error) << what;
    }
};

TEST_F(PrintableOutput, IsAllThatCommandsSayOfHostileNames) {
    const std::string model = file(kHostile + ".stl");
    const std::string job = file(kHostile + ".job");
    const std::string none = file(kHostile + ".none");
    const std::string profile = file(kHostile + ".toml");
    const std::vector<std::vector<std::string>> commands{
        {"slice", none, "-o", file("x")},
        {"slice", model, "-o", none + "/x"},
        {"slice", model, "-o", model},
        {"slice", model, "-o", file("x"), "--layers", kHostile},
        {"slice", model, "-o", file("x"), "--tool", kHostile},
        {"slice", model, "-o", file("x"), "--axis-at", kHostile},
        {"slice", model, "-o", file("x"), "--profile", profile},
        {"slice", file(kHostile + ".csv"), "-o", file("x")},
        {"slice", file(kHostile + ".svg"), "-o", file("x")},
        {"inspect", none},
        {"inspect", model, "--layers", "4", "--points", "8"},
        {"inspect", model, "--preview", none},
        {"carve", none},
        {"carve", model, "--layers", "4", "--points", "8", "--picture", kHostile},
        {"carve", model, "--layers", "4", "--points", "8", "--trace", none + "/x"},
        {"estimate", none},
        {"estimate", job},
        {"publish", none},
        {"replay", none},
        {"replay", job},
        {"replay", model},
        {"verify", job, none},
        {"verify", job, model},
        {"snapshot", "info", job},
        {"snapshot", "info", model},
        {"snapshot", "diff", job, none},
        {"snapshot", "diff", job, job},
        {"snapshot", "export", job},
        {"snapshot", "export", job, "--format", "json"},
        {"snapshot", kHostile},
        {"profile", "check", profile},
        {"profile", "show", none},
        {"calibrate", "--profile", none, "--r1-wear", "1"},
        {"latency", "--csv", none + "/x"},
        {"status", "--segment", "/" + kHostile},
        {"status", "--segment", kHostile},
        {"status", "--group", kHostile},
        {"home", "--segment", "/" + kHostile},
        {kHostile},
        {"--" + kHostile},
        {"slice", "--" + kHostile + "=1"},
    };
    for (const auto& command : commands) {
        for (const bool as_json : {false, true}) {
            auto arguments = command;
            if (as_json) arguments.emplace_back("--json");
            const Outcome outcome = psicarve(arguments);
            expect_printable(outcome, testing::PrintToString(arguments));
            EXPECT_FALSE(outcome.out.empty() && outcome.error.empty()) << testing::PrintToString(arguments);
        }
    }
}

TEST_F(PrintableOutput, KeepsJsonWhole) {
    const Outcome told = psicarve({"slice", file(kHostile + ".stl"), "-o", file(kHostile + ".job"),
                                   "--layers", "4", "--points", "8", "--json"});
    ASSERT_EQ(told.exit_code, 0) << told.error;
    expect_printable(told, "slice");
    EXPECT_EQ(told.json()["job"], file(kHostile + ".job"));
}

TEST_F(PrintableOutput, LeavesLettersOfAllLanguages) {
    const std::string name = "齿轮 шестерня größer.stl";
    const Outcome told = psicarve({"inspect", file(name)});
    EXPECT_NE(told.error.find(name), std::string::npos) << told.error;
}

TEST_F(PrintableOutput, IsWhatTheCoreSays) {
    for (const std::vector<std::string>& arguments : {std::vector<std::string>{kHostile},
                                                      {"--profile", file(kHostile)},
                                                      {"--segment", kHostile},
                                                      {"--replay", file(kHostile), "--segment", segment_}}) {
        RunningProgram core{"psicarve-rtcore", arguments};
        core.wait();
        EXPECT_EQ(printable(core.error()), core.error());
        EXPECT_NE(core.error(), "");
    }
}

}  // namespace
}  // namespace psicarve::test
