// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/latency_trial.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "tests/hmi/session/sights.hpp"

namespace psicarve::session {
namespace {

using machine::LatencyOptions;
using machine::LatencyProgress;
using machine::LatencyResult;
using test::machine_in;
using S = MachineState;

LatencyResult measured() {
    LatencyResult result;
    result.ticks = 10'000;
    result.missed = 2;
    result.max_ns = 70'400;
    result.page_faults = 1;
    result.preemptions = 4;
    result.cpu = 3;
    result.priority = 80;
    result.bins = {{0, 9'000}, {1, 900}, {7, 98}, {70, 2}};
    return result;
}

template <typename Condition>
void wait_for(LatencyTrial& desk, Condition condition) {
    while (!condition()) {
        desk.poll();
        std::this_thread::sleep_for(std::chrono::milliseconds{1});
    }
}

TEST(LatencyTrial, ShowsHowFarItIsAndEndsWhenItIsTold) {
    MessageLog log;
    LatencyTrial sut{log, [](const LatencyOptions& options, const auto& progress, const auto& must_end) {
                         EXPECT_EQ(options.seconds, 3600U);
                         progress(LatencyProgress{5, 100'000, 1, 61'000});
                         while (!must_end()) std::this_thread::sleep_for(std::chrono::milliseconds{1});
                         return Result<LatencyResult>{measured()};
                     }};
    LatencyOptions options;
    options.seconds = 3600;
    sut.begin(options);
    sut.begin(LatencyOptions{});  // one is under way
    wait_for(sut, [&] { return sut.progress().seconds == 5; });
    EXPECT_TRUE(sut.is_measuring());
    EXPECT_FALSE(sut.last());
    sut.end();
    wait_for(sut, [&] { return !sut.is_measuring(); });
    ASSERT_TRUE(sut.last());
    EXPECT_EQ(sut.last()->options.seconds, 3600U);
    EXPECT_EQ(in_english(log.messages().back().what),
              "Measured 10\u2009000 ticks: 99.9 % at most 7.9 \u00B5s late, 2 missed");
}

TEST(LatencyTrial, SaysWhyItCouldNotMeasure) {
    MessageLog log;
    LatencyTrial sut{log, [](const LatencyOptions&, const auto&, const auto&) {
                         return Result<LatencyResult>{Error{ErrorCode::no_core, "no program"}};
                     }};
    sut.begin({});
    wait_for(sut, [&] { return !sut.is_measuring(); });
    EXPECT_FALSE(sut.last());
    EXPECT_EQ(in_english(log.messages().back().what), "Measure: no program");
}

TEST(LatencyTrial, LeavesAMachineAtWorkAlone) {
    EXPECT_FALSE(latency_lock(machine_in(S::ready)));
    EXPECT_FALSE(latency_lock(MachineView{}));
    ASSERT_TRUE(latency_lock(machine_in(S::carving)));
    EXPECT_TRUE(latency_lock(machine_in(S::moving)));
}

TEST(LatencyHealth, HasABarForEachDoublingAndThePeriodInItsPlace) {
    const TickHealth health = latency_health({LatencyOptions{}, measured()});
    EXPECT_EQ(health.ticks, 10'000U);
    EXPECT_EQ(health.missed, 2U);
    EXPECT_EQ(health.period_bar, 6U) << "50 us lie between 32 and 64";
    ASSERT_EQ(health.bars.size(), 8U);
    EXPECT_EQ(health.bars[0].ticks, 9'000U);
    EXPECT_EQ(health.bars[0].label, "\u2264 1.0 \u00B5s");
    EXPECT_EQ(health.bars[1].ticks, 900U);
    EXPECT_EQ(health.bars[3].ticks, 98U);
    EXPECT_EQ(health.bars[3].label, "\u2264 8.0 \u00B5s");
    EXPECT_EQ(health.bars[7].ticks, 2U);
    EXPECT_EQ(health.bars[7].label, "\u2264 128 \u00B5s");
    EXPECT_EQ(health.bars[4].height, 0.0);
}

TEST(LatencyHealth, TellsTheFiguresAndWhatWasRefused) {
    LatencyResult result = measured();
    result.refused = {"locked memory"};
    result.priority = 0;
    std::vector<std::string> lines;
    for (const LatencyRow& row : latency_rows({LatencyOptions{}, result}))
        lines.push_back(in_english(row.name) + "|" + in_english(row.value));
    EXPECT_EQ(lines, (std::vector<std::string>{
                         "Ticks measured, missed|10\u2009000, 2",
                         "Late: median, 99 %, 99.9 %|556 ns, 2.0 \u00B5s, 7.9 \u00B5s",
                         "Latest of all|70 \u00B5s", "Thread|ordinary scheduling", "Processor|processor 3",
                         "Page faults, preemptions of the tick|1, 4", "locked memory|refused"}));
}

}  // namespace
}  // namespace psicarve::session
