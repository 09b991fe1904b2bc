// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/job_run.hpp"

#include <gtest/gtest.h>

namespace psicarve::cycle {
namespace {

constexpr std::uint64_t kPointsPerLayer = 100;
constexpr std::uint64_t kLayers = 8;

JobRun loaded_run() {
    JobRun run;
    run.load(/*generation=*/7, kLayers * kPointsPerLayer, kPointsPerLayer);
    return run;
}

template <typename Shown>
Shown shown(const JobRun& run) {
    Shown shown{};
    run.show_in(shown);
    return shown;
}

TEST(JobRun, RefusesToRunWithoutAJob) {
    EXPECT_EQ(JobRun{}.judge({}), Refusal::no_job);
    JobRun without_points;
    without_points.load(1, 0, kPointsPerLayer);
    EXPECT_EQ(without_points.judge({}), Refusal::no_job);
    JobRun without_layers;
    without_layers.load(1, kLayers * kPointsPerLayer, 0);
    EXPECT_EQ(without_layers.judge({}), Refusal::no_job);
}

TEST(JobRun, RunsLayersThatTheJobHasAndNoOthers) {
    const JobRun sut = loaded_run();
    EXPECT_EQ(sut.judge({.first = 0, .count = 0}), Refusal::none);
    EXPECT_EQ(sut.judge({.first = 7, .count = 0}), Refusal::none);
    EXPECT_EQ(sut.judge({.first = 8, .count = 0}), Refusal::no_such_layer);
    EXPECT_EQ(sut.judge({.first = 0, .count = 8}), Refusal::none);
    EXPECT_EQ(sut.judge({.first = 5, .count = 3}), Refusal::none);
    EXPECT_EQ(sut.judge({.first = 5, .count = 4}), Refusal::no_such_layer);
    EXPECT_EQ(sut.judge({.first = 1, .count = 0x7FFF'FFFF}), Refusal::no_such_layer);
}

TEST(JobRun, BeginsWithAnyPointOfALayerButItsLast) {
    JobRun sut = loaded_run();
    EXPECT_EQ(sut.judge({.first = 3, .point_number = 1}), Refusal::none);
    EXPECT_EQ(sut.judge({.first = 3, .point_number = kPointsPerLayer - 1}), Refusal::none);
    EXPECT_EQ(sut.judge({.first = 3, .point_number = kPointsPerLayer}), Refusal::no_such_point);
    EXPECT_EQ(sut.judge({.first = 3, .point_number = kPointsPerLayer + 1}), Refusal::no_such_point);
    EXPECT_EQ(sut.judge({.first = 8, .point_number = 1}), Refusal::no_such_layer);
    sut.begin({.first = 3, .point_number = 41}, 1000);
    EXPECT_EQ(sut.points_before(), 3 * kPointsPerLayer + 40);
    EXPECT_EQ(shown<PlanRequest>(sut).first_step, 40U);
    EXPECT_EQ(shown<Sample>(sut).first_step, 40U);
    sut.begin({.first = 3}, 2000);
    EXPECT_EQ(sut.points_before(), 3 * kPointsPerLayer);
}

TEST(JobRun, CountsThePointsOfALayerThatRunsBackFromItsEnd) {
    JobRun sut;
    sut.load(7, kLayers * kPointsPerLayer, kPointsPerLayer, /*runs_back=*/true);
    EXPECT_EQ(sut.judge({.first = 3, .point_number = 1}), Refusal::no_such_point) << "it is carved last";
    EXPECT_EQ(sut.judge({.first = 3, .point_number = kPointsPerLayer}), Refusal::none);
    sut.begin({.first = 3, .point_number = 41}, 1000);
    EXPECT_EQ(sut.points_before(), 3 * kPointsPerLayer + 59);
    sut.begin({.first = 2, .point_number = 41}, 1000);
    EXPECT_EQ(sut.points_before(), 2 * kPointsPerLayer + 40);
    sut.begin({.first = 3}, 1000);
    EXPECT_EQ(sut.points_before(), 3 * kPointsPerLayer);
}

TEST(JobRun, TellsThePlannerWhichLayers) {
    JobRun sut = loaded_run();
    sut.begin({.first = 2, .count = 3, .is_dry = true}, 1000);
    auto request = shown<PlanRequest>(sut);
    EXPECT_EQ(request.job_generation, 7U);
    EXPECT_EQ(request.first_layer, 2U);
    EXPECT_EQ(request.end_layer, 5U);
    EXPECT_EQ(request.is_dry, 1);
    EXPECT_EQ(sut.points_before(), 2 * kPointsPerLayer);
    sut.begin({.first = 2, .count = 0}, 2000);
    request = shown<PlanRequest>(sut);
    EXPECT_EQ(request.end_layer, kLayers);
    EXPECT_EQ(request.is_dry, 0);
}

TEST(JobRun, RemembersTheFirstGroupTheFirstTickOfTheLastPointAndTheEnd) {
    JobRun sut = loaded_run();
    sut.begin({.first = 2, .count = 3}, 1000);
    sut.note_group(1200);
    sut.note_group(1300);
    sut.note_points(5 * kPointsPerLayer - 1, 1400);
    EXPECT_EQ(shown<Sample>(sut).carve_last_tick, 0U);
    sut.note_points(5 * kPointsPerLayer, 1500);
    sut.note_points(5 * kPointsPerLayer + 1, 1600);
    sut.end(1700);
    const auto sample = shown<Sample>(sut);
    EXPECT_EQ(sample.job_start_tick, 1000U);
    EXPECT_EQ(sample.carve_first_tick, 1200U);
    EXPECT_EQ(sample.carve_last_tick, 1500U);
    EXPECT_EQ(sample.job_end_tick, 1700U);
    EXPECT_EQ(sample.points_total, kLayers * kPointsPerLayer);
    EXPECT_EQ(sample.first_layer, 2U);
}

TEST(JobRun, ForgetsTheTicksOfTheRunBefore) {
    JobRun sut = loaded_run();
    sut.begin({}, 1000);
    sut.note_group(1100);
    sut.note_points(kLayers * kPointsPerLayer, 1200);
    sut.end(1300);
    sut.begin({}, 2000);
    const auto sample = shown<Sample>(sut);
    EXPECT_EQ(sample.job_start_tick, 2000U);
    EXPECT_EQ(sample.carve_first_tick, 0U);
    EXPECT_EQ(sample.carve_last_tick, 0U);
    EXPECT_EQ(sample.job_end_tick, 0U);
    EXPECT_FALSE(sut.has_begun_carving());
}

TEST(JobRun, CountsLayersAsAffectedFromTheLastWhoseIndexWasRight) {
    JobRun sut = loaded_run();
    sut.begin({.first = 2, .count = 0}, 1000);
    sut.note_index(1);  // on the way to the first point
    EXPECT_EQ(sut.affected(2).layer_count, 0) << "nothing is carved yet";
    sut.note_group(1100);
    EXPECT_EQ(sut.affected(4).first_layer, 2U);
    EXPECT_EQ(sut.affected(4).layer_count, 3);
    sut.note_index(4);
    EXPECT_EQ(sut.affected(4).first_layer, 4U);
    EXPECT_EQ(sut.affected(4).layer_count, 1);
    EXPECT_EQ(sut.affected(4 + 100'000).layer_count, 0xFFFF);
}

TEST(JobRun, AffectsNoLayerWhenItIsDry) {
    JobRun sut = loaded_run();
    sut.begin({.first = 0, .count = 0, .is_dry = true}, 1000);
    sut.note_group(1100);
    EXPECT_EQ(sut.affected(3).layer_count, 0);
}

TEST(JobRun, KeepsItsOverrideUntilTheNextJob) {
    JobRun sut = loaded_run();
    EXPECT_EQ(sut.feed_ratio(), 1.0);
    sut.set_override(40);
    sut.begin({}, 1000);
    EXPECT_EQ(sut.feed_ratio(), 0.4);
    EXPECT_EQ(shown<Sample>(sut).override_percent, 40U);
    sut.load(8, kPointsPerLayer, kPointsPerLayer);
    EXPECT_EQ(sut.feed_ratio(), 1.0);
}

}  // namespace
}  // namespace psicarve::cycle
