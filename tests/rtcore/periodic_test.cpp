// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/realtime/periodic.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace psicarve::rtcore {
namespace {

constexpr std::int64_t kPeriod_ns = 50'000;

/// Time that only passes when the code sleeps or works; how late each wake-up comes is scripted.
class ScriptedClock {
public:
    explicit ScriptedClock(std::vector<std::int64_t> lateness_ns) : lateness_ns_(std::move(lateness_ns)) {}
    std::int64_t now_ns() const { return now_ns_; }
    void sleep_until_ns(std::int64_t deadline_ns) {
        if (deadline_ns > now_ns_) now_ns_ = deadline_ns;
        if (next_ < lateness_ns_.size()) now_ns_ += lateness_ns_[next_++];
    }
    void work_ns(std::int64_t time_ns) { now_ns_ += time_ns; }

private:
    std::vector<std::int64_t> lateness_ns_;
    std::size_t next_ = 0;
    std::int64_t now_ns_ = 1'000'000;
};

struct LoopRun {
    std::vector<PeriodicTick> ticks;
    std::vector<std::int64_t> times_ns;  ///< since the loop began
    PeriodicReport report;
};

LoopRun run(std::vector<std::int64_t> lateness_ns, std::size_t steps, std::int64_t work_ns = 0) {
    ScriptedClock clock(std::move(lateness_ns));
    PeriodicStats stats;
    LoopRun result;
    const std::int64_t start_ns = clock.now_ns();
    run_periodic(clock, {.period_ns = kPeriod_ns}, stats, [&](const PeriodicTick& tick) {
        result.ticks.push_back(tick);
        result.times_ns.push_back(clock.now_ns() - start_ns);
        clock.work_ns(work_ns);
        return result.ticks.size() < steps;
    });
    result.report = stats.report();
    return result;
}

std::vector<std::uint64_t> numbers(const LoopRun& run) {
    std::vector<std::uint64_t> result;
    for (const PeriodicTick& tick : run.ticks) result.push_back(tick.tick);
    return result;
}

TEST(Periodic, RunsEachTickAtItsDeadline) {
    const LoopRun sut = run({}, 4);
    EXPECT_EQ(numbers(sut), (std::vector<std::uint64_t>{0, 1, 2, 3}));
    EXPECT_EQ(sut.times_ns, (std::vector<std::int64_t>{0, 50'000, 100'000, 150'000}));
    EXPECT_EQ(sut.report.ticks_missed, 0U);
    EXPECT_EQ(sut.report.ticks_run, 4U);
}

TEST(Periodic, LatenessDoesNotAddUp) {
    const LoopRun sut = run({10'000, 10'000, 10'000, 0}, 4);
    EXPECT_EQ(sut.times_ns, (std::vector<std::int64_t>{10'000, 60'000, 110'000, 150'000}));
    EXPECT_EQ(sut.report.max_lateness_ns, 10'000);
}

TEST(Periodic, SkipsAndCountsWhatItMissedInsteadOfCatchingUp) {
    const LoopRun sut = run({0, 0, 3 * kPeriod_ns + 7}, 5);
    EXPECT_EQ(numbers(sut), (std::vector<std::uint64_t>{0, 1, 5, 6, 7}));
    EXPECT_EQ(sut.times_ns, (std::vector<std::int64_t>{0, 50'000, 250'007, 300'000, 350'000}));
    EXPECT_EQ(sut.ticks[2].missed_before, 3U);
    EXPECT_EQ(sut.ticks[3].missed_before, 0U);
    EXPECT_EQ(sut.report.ticks_missed, 3U);
    EXPECT_EQ(sut.report.ticks_run, 5U);
}

TEST(Periodic, ATickThatIsLessLateThanTheOneBeforeRuns) {
    const LoopRun sut = run({0, 45'000, 0, 30'000, 10'000}, 5);
    EXPECT_EQ(numbers(sut), (std::vector<std::uint64_t>{0, 1, 2, 3, 4}));
    EXPECT_EQ(sut.times_ns, (std::vector<std::int64_t>{0, 95'000, 100'000, 180'000, 210'000}));
    EXPECT_EQ(sut.report.ticks_missed, 0U);
}

TEST(Periodic, StepsThatTakeTooLongCostTicksAndNothingElse) {
    const LoopRun sut = run({}, 4, kPeriod_ns + 10'000);
    EXPECT_EQ(numbers(sut), (std::vector<std::uint64_t>{0, 1, 2, 3}));
    const LoopRun slower = run({}, 4, 2 * kPeriod_ns + 10'000);
    EXPECT_EQ(numbers(slower), (std::vector<std::uint64_t>{0, 2, 4, 6}));
}

TEST(Periodic, NeverBurstsWhateverTheLateness) {
    std::mt19937 random(5);
    for (int round = 0; round < 200; ++round) {
        std::vector<std::int64_t> lateness_ns;
        for (int i = 0; i < 200; ++i) {
            const auto scale = static_cast<std::int64_t>(1) << random() % 20;
            lateness_ns.push_back(static_cast<std::int64_t>(random()) % scale);
        }
        const LoopRun sut = run(lateness_ns, 150);
        std::uint64_t missed = 0;
        for (std::size_t i = 1; i < sut.ticks.size(); ++i) {
            ASSERT_GT(sut.times_ns[i] / kPeriod_ns, sut.times_ns[i - 1] / kPeriod_ns) << "one a period";
            missed += sut.ticks[i].missed_before;
            ASSERT_EQ(sut.ticks[i].tick, i + missed + sut.ticks[0].tick);
            // The tick that runs is the newest whose deadline has passed.
            ASSERT_EQ(sut.ticks[i].tick, static_cast<std::uint64_t>(sut.times_ns[i] / kPeriod_ns));
        }
        ASSERT_EQ(sut.report.ticks_missed, missed + sut.ticks[0].missed_before);
    }
}

TEST(PeriodicStats, BinsArePowersOfTwo) {
    EXPECT_EQ(PeriodicStats::bin_of(-5), 0U);
    EXPECT_EQ(PeriodicStats::bin_of(0), 0U);
    EXPECT_EQ(PeriodicStats::bin_of(1), 0U);
    EXPECT_EQ(PeriodicStats::bin_of(2), 1U);
    EXPECT_EQ(PeriodicStats::bin_of(3), 1U);
    EXPECT_EQ(PeriodicStats::bin_of(4), 2U);
    EXPECT_EQ(PeriodicStats::bin_of(65'535), 15U);
    EXPECT_EQ(PeriodicStats::bin_of(65'536), 16U);
    EXPECT_EQ(PeriodicStats::bin_of(std::int64_t{1} << 31), 31U);
    EXPECT_EQ(PeriodicStats::bin_of(std::int64_t{1} << 62), 31U);
}

TEST(PeriodicStats, CountEachTickThatRanOnce) {
    const LoopRun sut = run({0, 5, 1'000, 2 * kPeriod_ns}, 10);
    std::uint64_t sum = 0;
    for (const std::uint64_t count : sut.report.lateness_histogram) sum += count;
    EXPECT_EQ(sum, 10U);
    EXPECT_EQ(sut.report.lateness_histogram[2], 1U);
    EXPECT_EQ(sut.report.lateness_histogram[9], 1U);
    EXPECT_EQ(sut.report.lateness_histogram[16], 1U);
    EXPECT_EQ(sut.report.max_lateness_ns, 2 * kPeriod_ns);
}

}  // namespace
}  // namespace psicarve::rtcore
