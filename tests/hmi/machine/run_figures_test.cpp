// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "hmi/machine/job_run.hpp"

namespace psicarve::machine {
namespace {

JobRun finished_run() {
    JobRun run;
    run.has_started = true;
    run.before.tick = 1'000;
    run.before.missed_ticks = 3;
    run.after.period_ns = 50'000;
    run.after.tick = 101'000;
    run.after.missed_ticks = 5;
    run.after.job_start_tick = 10'000;
    run.after.carve_first_tick = 20'000;
    run.after.carve_last_tick = 80'000;
    run.after.job_end_tick = 90'000;
    run.after.points_total = 100;
    run.after.points_done = 100;
    run.after.emitted_pulses[2] = 3200;
    return run;
}

TEST(RunFigures, TimesAreTicksOfTheMachine) {
    const RunFigures sut = figures_of(finished_run());
    EXPECT_DOUBLE_EQ(sut.carve_seconds.value_or(0.0), 3.0);
    EXPECT_DOUBLE_EQ(sut.total_seconds, 4.0);
    EXPECT_EQ(sut.ticks, 100'000U);
    EXPECT_EQ(sut.missed_ticks, 2U);
    EXPECT_EQ(sut.pulses[2], 3200U);
    EXPECT_TRUE(sut.is_complete);
}

TEST(RunFigures, AJobThatWasStoppedIsNotComplete) {
    JobRun run = finished_run();
    run.after.points_done = 99;
    EXPECT_FALSE(figures_of(run).is_complete);
    EXPECT_FALSE(figures_of(run).carve_seconds.has_value());
    EXPECT_DOUBLE_EQ(figures_of(run).total_seconds, 4.0);
    run = finished_run();
    run.after.job_end_tick = 0;
    EXPECT_FALSE(figures_of(run).is_complete);
    EXPECT_FALSE(figures_of(JobRun{}).is_complete);
}

TEST(RunFigures, AJobThatWasNotStartedHasNothingOfTheOneBefore) {
    JobRun run = finished_run();
    run.has_started = false;
    const RunFigures sut = figures_of(run);
    EXPECT_EQ(sut.pulses, (std::array<std::uint64_t, kAxisCount>{}));
    EXPECT_FALSE(sut.carve_seconds.has_value());
    EXPECT_EQ(sut.total_seconds, 0.0);
    EXPECT_FALSE(sut.is_complete);
    EXPECT_EQ(sut.ticks, 100'000U) << "time passes all the same";
}

TEST(RunFigures, AJobThatNeverLeftItsFirstPointCarvedNothing) {
    JobRun run = finished_run();
    run.after.carve_first_tick = 0;
    run.after.carve_last_tick = 0;
    EXPECT_FALSE(figures_of(run).carve_seconds.has_value());
}

TEST(RunFigures, OnlyAlarmsOfTheRunCountOldestFirst) {
    JobRun run = finished_run();
    run.before.alarm_count = 9;
    run.after.alarm_count = 11;
    for (std::uint64_t i = 3; i < 11; ++i) run.after.alarms[i % kAlarmHistory].tick = i;
    const RunFigures sut = figures_of(run);
    ASSERT_EQ(sut.alarms.size(), 2U);
    EXPECT_EQ(sut.alarms[0].tick, 9U);
    EXPECT_EQ(sut.alarms[1].tick, 10U);
}

TEST(RunFigures, NoMoreAlarmsThanTheCoreRemembers) {
    JobRun run = finished_run();
    run.after.alarm_count = 1'000;
    EXPECT_EQ(figures_of(run).alarms.size(), kAlarmHistory);
}

}  // namespace
}  // namespace psicarve::machine
