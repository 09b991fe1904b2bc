// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/hmi/cli/program_run.hpp"

namespace psicarve::test {
namespace {

std::uint64_t ticks_in(const nlohmann::json& histogram) {
    std::uint64_t sum = 0;
    for (const auto& bin : histogram) sum += bin.at(1).get<std::uint64_t>();
    return sum;
}

TEST(LatencyCommand, CountsEachTickOnce) {
    const Outcome outcome = psicarve({"latency", "--seconds", "1", "--period", "1000", "--json"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
    const auto json = outcome.json();
    EXPECT_GT(json.at("ticks"), 0);
    EXPECT_EQ(ticks_in(json.at("histogram_us")), json.at("ticks").get<std::uint64_t>());
    EXPECT_LE(json.at("late_us").at("p50"), json.at("late_us").at("p99"));
    EXPECT_EQ(json.at("period_us"), 1000);
    // Where nothing was refused, memory is locked.
    if (json.at("refused").empty()) {
        EXPECT_EQ(json.at("page_faults"), 0);
    }
}

TEST(LatencyCommand, ShowsWhatItMeasuredWhenInterrupted) {
    RunningProgram sut{"psicarve", {"latency", "--seconds", "100000", "--period", "1000"}};
    const std::string pid = std::to_string(sut.pid());
    const auto has_child = [&] {
        std::ifstream file{"/proc/" + pid + "/task/" + pid + "/children"};
        std::string child;
        return static_cast<bool>(file >> child);
    };
    while (!has_child() && !sut.has_ended()) std::this_thread::sleep_for(std::chrono::milliseconds{1});
    sut.send(SIGINT);
    ASSERT_EQ(sut.wait(), 0) << sut.error();
    EXPECT_NE(sut.out().find("late       median"), std::string::npos) << sut.out();
    EXPECT_NE(sut.out().find("us late   ticks   (bars are logarithmic)"), std::string::npos) << sut.out();
}

TEST(LatencyCommand, LooksAtWhatItIsGivenBeforeItMeasures) {
    const Outcome no_folder =
        psicarve({"latency", "--seconds", "100000", "--csv", "/no/such/folder/late.csv"});
    EXPECT_EQ(no_folder.exit_code, 3) << no_folder.error;
    EXPECT_NE(no_folder.error.find("/no/such/folder/late.csv"), std::string::npos);
    const Outcome no_cpu = psicarve({"latency", "--seconds", "100000", "--cpu", "5000"});
    EXPECT_EQ(no_cpu.exit_code, 2);
    EXPECT_NE(no_cpu.error.find("no processor"), std::string::npos) << no_cpu.error;
}

TEST(DoctorCommand, ReportsEveryFindingAndTheLatency) {
    const Outcome outcome = psicarve({"doctor", "--seconds", "1", "--json"});
    const auto json = outcome.json();
    EXPECT_EQ(outcome.exit_code, json.at("verdict") == "problem" ? 4 : 0) << outcome.error;
    EXPECT_GE(json.at("findings").size(), 11U);
    for (const auto& finding : json.at("findings")) {
        EXPECT_EQ(finding.at("verdict") == "ok", finding.at("remedy") == "") << finding;
    }
    EXPECT_GT(json.at("latency").at("ticks"), 0);
}

TEST(DoctorCommand, MeasuresNothingWhenToldSo) {
    const Outcome outcome = psicarve({"doctor", "--no-latency"});
    EXPECT_NE(outcome.out.find("shared memory"), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.out.find("us late"), std::string::npos);
}

}  // namespace
}  // namespace psicarve::test
