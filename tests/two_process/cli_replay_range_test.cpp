// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/two_process/commanded_core.hpp"

namespace psicarve::test {
namespace {

/// A box of five layers of nine points, which a core has begun where it was told to; then the recording is
/// repeated and judged.
class ReplayRange : public CommandedCore {
protected:
    void SetUp() override {
        start_core();
        ASSERT_EQ(run({"publish", sliced_box("5", "9")}).exit_code, 0);
        ASSERT_EQ(run({"home"}).exit_code, 0);
    }
    void carve(std::vector<std::string> begin) {
        begin.insert(begin.begin(), "start");
        begin.emplace_back("--carve");
        ASSERT_EQ(run(begin).exit_code, 0);
        ASSERT_TRUE(eventually([&] { return status().job_end_tick != 0; }));
        ASSERT_TRUE(reaches(MachineState::ready));
    }
    Outcome replayed(const std::vector<std::string>& more = {"--json"}) {
        EXPECT_EQ(run({"snapshot", "save", file("a.snap")}).exit_code, 0);
        std::vector<std::string> words{"replay", file("a.snap"), "--trace", file("a.trace")};
        words.insert(words.end(), more.begin(), more.end());
        return run(words);
    }
    static void expect_judged(const Outcome& outcome, std::uint32_t first_layer, std::uint32_t layers,
                              std::uint32_t points) {
        ASSERT_EQ(outcome.exit_code, 0) << outcome.out << outcome.error;
        const auto report = outcome.json();
        EXPECT_EQ(report["verified"], true);
        EXPECT_EQ(report["verification"]["first_layer"], first_layer);
        EXPECT_EQ(report["verification"]["layers"], layers);
        EXPECT_EQ(report["verification"]["points_visited"], points);
    }
};

TEST_F(ReplayRange, OfLayersIsJudgedByThem) {
    carve({"--from-layer", "1", "--layers", "2"});
    expect_judged(replayed(), 1, 2, 2 * 9);
    const Outcome text = replayed({});
    EXPECT_NE(text.out.find("verified   yes: 18 points visited exactly in layers 1 to 2, largest"),
              std::string::npos)
        << text.out;
    EXPECT_EQ(text.out.find("not finished"), std::string::npos) << text.out;
    const Outcome named = run({"verify", file("a.snap"), file("a.trace")});
    EXPECT_EQ(named.exit_code, 0) << named.out << named.error;
    EXPECT_EQ(run({"verify", file("a.snap"), file("a.trace"), "--layers", "3"}).exit_code, 6)
        << "what the command line asks for counts";
}

TEST_F(ReplayRange, WithinALayerIsJudgedFromItsPointOn) {
    carve({"--from-layer", "2", "--from-point", "5"});
    const Outcome outcome = replayed();
    expect_judged(outcome, 2, 3, 3 * 9 - 5);
    EXPECT_EQ(outcome.json()["verification"]["first_point"], 5);
    const Outcome text = replayed({});
    EXPECT_NE(text.out.find("in layers 2 to 4, from point 5 of layer 2 on, largest"), std::string::npos)
        << text.out;
}

TEST_F(ReplayRange, OfSeveralStartsIsWhatTheyCoverTogether) {
    carve({"--from-layer", "1", "--layers", "1"});
    carve({"--from-layer", "2", "--layers", "1"});
    carve({"--from-layer", "3", "--from-point", "0", "--layers", "1"});
    expect_judged(replayed(), 1, 3, 3 * 9);
    carve({"--layers", "1"});
    expect_judged(replayed(), 0, 1, 9);
    carve({"--from-layer", "4"});
    expect_judged(replayed(), 4, 1, 9);
}

TEST_F(ReplayRange, OfOneThatWasStoppedIsJudgedAsFarAsItWasRecorded) {
    // Takes long enough to be stopped in the middle.
    constexpr std::uint32_t kLongLayers = 200;
    constexpr std::uint32_t kLongPoints = 200;
    ASSERT_EQ(
        run({"publish", sliced_box(std::to_string(kLongLayers), std::to_string(kLongPoints))}).exit_code, 0);
    ASSERT_EQ(run({"start", "--from-layer", "1", "--from-point", "2"}).exit_code, 0);
    ASSERT_EQ(run({"stop"}).exit_code, 0);
    ASSERT_TRUE(reaches(MachineState::ready));
    ASSERT_EQ(run({"start", "--from-layer", "2"}).exit_code, 0);
    RunningProgram carving{"psicarve", {"start-interpolation", "--segment", segment_}};
    ASSERT_TRUE(eventually([&] { return status().layer >= 3; }));
    ASSERT_EQ(run({"stop"}).exit_code, 0);
    ASSERT_TRUE(reaches(MachineState::ready));
    const CoreStatus at = status();
    ASSERT_LT(at.points_done, at.points_total) << "it was carved before it could be stopped";
    const Outcome outcome = replayed();
    expect_judged(outcome, 2, kLongLayers - 2, static_cast<std::uint32_t>(at.points_done) - 2 * kLongPoints);
    const auto report = outcome.json();
    EXPECT_EQ(report["verification"]["cut_short"], true);
    EXPECT_EQ(report["max_deviation_pulses"], 0);
    EXPECT_EQ(report["carve_seconds"], nullptr) << "the last point was not reached";
    EXPECT_GT(report["verification"]["carve_seconds"].get<double>(), 0.0);
    const std::string text = replayed({}).out;
    EXPECT_NE(text.find("up to where it was recorded, largest deviation 0 pulses"), std::string::npos)
        << text;
    EXPECT_NE(text.find("carving    not finished: "), std::string::npos) << text;
    carve({"--from-layer", std::to_string(at.layer), "--from-point", std::to_string(at.point), "--layers",
           "2"});
    const Outcome both = replayed();
    // The first start asked for the job to its end.
    expect_judged(both, 2, kLongLayers - 2, at.layer * kLongPoints);
    EXPECT_EQ(both.json()["verification"]["cut_short"], true);
}

TEST_F(ReplayRange, OfADryRunIsJudgedByItsPulsesAlone) {
    carve({"--dry-run", "--from-layer", "1", "--layers", "2"});
    const Outcome outcome = replayed();
    ASSERT_EQ(outcome.exit_code, 0) << outcome.out << outcome.error;
    EXPECT_EQ(outcome.json()["verified"], true);
    EXPECT_EQ(outcome.json()["verification"]["dry_run"], true);
    EXPECT_EQ(outcome.json()["verification"]["rules"][0]["ok"], nullptr);
    EXPECT_EQ(outcome.json()["verification"]["rules"][1]["ok"], true);
    EXPECT_NE(replayed({}).out.find("verified   yes: a dry run"), std::string::npos);
}

}  // namespace
}  // namespace psicarve::test
