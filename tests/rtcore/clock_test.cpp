// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/realtime/clock.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "rtcore/realtime/periodic.hpp"

namespace psicarve::rtcore {
namespace {

TEST(RealClock, SleepsAtLeastUntilTheDeadline) {
    const RealClock sut;
    const std::int64_t deadline_ns = sut.now_ns() + 2'000'000;
    sut.sleep_until_ns(deadline_ns);
    EXPECT_GE(sut.now_ns(), deadline_ns);
}

TEST(RealClock, DoesNotWaitForAPastDeadline) {
    const RealClock sut;
    sut.sleep_until_ns(sut.now_ns() - 1'000'000'000);
    sut.sleep_until_ns(0);
}

TEST(RealClock, DrivesTheLoopWhileAnotherThreadReadsItsFigures) {
    RealClock clock;
    PeriodicStats stats;
    std::atomic<bool> done{false};
    std::uint64_t last_tick = 0;
    std::uint64_t missed = 0;
    std::thread tick([&] {
        run_periodic(clock, {.period_ns = 200'000}, stats, [&](const PeriodicTick& now) {
            last_tick = now.tick;
            missed += now.missed_before;
            return now.tick < 200;
        });
        done = true;
    });
    std::uint64_t seen = 0;
    while (!done) {
        const PeriodicReport report = stats.report();
        EXPECT_GE(report.ticks_run, seen);
        seen = report.ticks_run;
        std::this_thread::yield();
    }
    tick.join();
    const PeriodicReport report = stats.report();
    EXPECT_EQ(report.ticks_missed, missed);
    EXPECT_EQ(report.ticks_run + report.ticks_missed, last_tick + 1);
}

}  // namespace
}  // namespace psicarve::rtcore
