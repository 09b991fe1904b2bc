// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/time_forecast.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "rtcore/plan/approach.hpp"
#include "rtcore/plan/carving.hpp"
#include "rtcore/plan/job_estimate.hpp"
#include "tests/rtcore/plan/table_blocks.hpp"
#include "tests/shared/spiral_fixture.hpp"

namespace psicarve::plan {
namespace {

constexpr std::uint32_t kForecastPoints = 60;

/// Of waves whose height in pulses is a function of the layer's place, 0 to 1.
JobTable waves(std::uint32_t layers, const std::function<double(double)>& height) {
    JobTable table;
    table.layer_count = layers;
    table.point_count = kForecastPoints;
    table.psi_sweep_pulses = 3200;
    table.feed_mm_s = 20.0;
    table.profile_toml = profile_to_toml(Profile{});
    for (std::uint32_t layer = 0; layer < layers; ++layer) {
        table.layer_height_pulses.push_back(100 + 50 * layer);
        const double at = static_cast<double>(layer) / std::max(1.0, static_cast<double>(layers) - 1.0);
        for (std::uint32_t point = 0; point < table.point_count; ++point) {
            const auto wave = static_cast<std::int32_t>(height(at) * std::sin(0.8 * point));
            table.r_left_pulses.push_back(5000 + wave);
            table.r_right_pulses.push_back(5300 - wave);
        }
    }
    return table;
}

MachineLimits limits_by(psicarve::Planner planner) {
    Profile profile;
    profile.job.planner = planner;
    return machine_limits(profile);
}

std::vector<double> forecast_of(const MachineLimits& limits, const std::shared_ptr<const JobView>& job) {
    TimeForecast sut(limits, job);
    while (sut.next()) {
    }
    return sut.layer_ends_seconds();
}

double planned_of(const MachineLimits& limits, const std::shared_ptr<const JobView>& job) {
    const auto program = carving_of(limits, job);
    cycle::MotionBlock block{};
    while (program->next(block)) {
    }
    return program->planned().seconds;
}

TEST(TimeForecast, IsNearWhatIsPlannedWhereLayersChange) {
    const auto rising = [](double at) { return 300.0 * at; };
    const auto bulging = [](double at) { return 200.0 * std::sin(3.1 * at); };
    for (const psicarve::Planner planner : {psicarve::Planner::lookahead, psicarve::Planner::angle}) {
        const MachineLimits limits = limits_by(planner);
        for (const auto& shape :
             {std::function<double(double)>(rising), std::function<double(double)>(bulging)}) {
            for (const std::uint32_t layers : {1U, 2U, 7U, 60U, 300U}) {
                const auto job = test::job_of(waves(layers, shape));
                const std::vector<double> ends_s = forecast_of(limits, job);
                ASSERT_EQ(ends_s.size(), layers);
                EXPECT_TRUE(std::is_sorted(ends_s.begin(), ends_s.end()));
                const double planned_s = planned_of(limits, job);
                EXPECT_NEAR(ends_s.back(), planned_s, 0.05 * planned_s) << layers;
            }
        }
    }
}

TEST(TimeForecast, KnowsSpirals) {
    const MachineLimits limits = limits_by(psicarve::Planner::lookahead);
    for (const std::uint32_t layers : {1U, 5U, 400U}) {
        const auto job = test::job_of(spiral_of(waves(layers, [](double at) { return 100.0 + 100.0 * at; })));
        const std::vector<double> ends_s = forecast_of(limits, job);
        ASSERT_EQ(ends_s.size(), job->layer_count());
        const double planned_s = planned_of(limits, job);
        EXPECT_NEAR(ends_s.back(), planned_s, 0.05 * planned_s) << layers;
    }
}

// Each layer smooth or rough: a forecast by those planned so far would be far off for long.
TEST(TimeForecast, WhatIsToldOfAnUnevenJobHardlyFallsWhileItIsPlanned) {
    const MachineLimits limits = limits_by(psicarve::Planner::lookahead);
    const auto job = test::job_of(waves(120, [](double at) { return at < 0.3 ? 400.0 : 5.0; }));
    const std::uint64_t total = 120ULL * kForecastPoints;
    JobEstimate estimate;
    estimate.forecast(forecast_of(limits, job), kForecastPoints);
    const auto program = carving_of(limits, job);
    cycle::MotionBlock block{};
    double greatest_s = 0.0;
    while (program->next(block)) {
        PlannedSoFar planned = program->planned();
        ++planned.points;
        if (planned.points == estimate.points()) continue;
        estimate.add(planned);
        const TimeLeft left = estimate.left(estimate.points(), total);
        ASSERT_EQ(left.is_planned, estimate.points() == total);
        const double told_s = estimate.seconds() + left.seconds;
        ASSERT_GE(told_s, 0.9 * greatest_s) << estimate.points();
        greatest_s = std::max(greatest_s, told_s);
    }
    EXPECT_NEAR(greatest_s, estimate.seconds(), 0.1 * greatest_s);
}

}  // namespace
}  // namespace psicarve::plan
