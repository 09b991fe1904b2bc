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

/// As it is planned bit by bit: to the points reached so far.
std::vector<PlannedSoFar> marks_of(const MachineLimits& limits, const std::shared_ptr<const JobView>& job) {
    const auto program = carving_of(limits, job);
    std::vector<PlannedSoFar> marks{PlannedSoFar{.points = 1}};
    cycle::MotionBlock block{};
    for (bool goes_on = true; goes_on;) {
        goes_on = program->next(block);
        PlannedSoFar planned = program->planned();
        ++planned.points;
        if (!goes_on || planned.points != marks.back().points) marks.push_back(planned);
    }
    return marks;
}

double planned_of(const MachineLimits& limits, const std::shared_ptr<const JobView>& job) {
    return marks_of(limits, job).back().seconds;
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
        // All are samples, each of some rows; the ends of rows within one are not known so well.
        for (const PlannedSoFar& mark : marks_of(limits, job)) {
            if (mark.points % kForecastPoints != 0) continue;
            const double end_s = ends_s[mark.points / kForecastPoints - 1];
            EXPECT_NEAR(end_s, mark.seconds, 0.001 * mark.seconds) << layers << ' ' << mark.points;
        }
        EXPECT_NEAR(ends_s.back(), planned_of(limits, job), 0.001 * ends_s.back()) << layers;
    }
}

/// What is told first and while the job is planned; never much less than before.
void expect_hardly_falls(const MachineLimits& limits, const std::shared_ptr<const JobView>& job) {
    const std::uint64_t total = std::uint64_t{job->layer_count()} * job->point_count();
    JobEstimate estimate;
    estimate.forecast(forecast_of(limits, job), job->point_count());
    double greatest_s = estimate.left(1, total).seconds;
    for (const PlannedSoFar& mark : marks_of(limits, job)) {
        estimate.add(mark);
        const TimeLeft left = estimate.left(estimate.points(), total);
        ASSERT_EQ(left.is_planned, estimate.points() == total);
        const double told_s = estimate.seconds() + left.seconds;
        ASSERT_GE(told_s, 0.9 * greatest_s) << estimate.points();
        greatest_s = std::max(greatest_s, told_s);
    }
    EXPECT_NEAR(greatest_s, estimate.seconds(), 0.1 * greatest_s);
}

// Each layer smooth or rough: a forecast by those planned so far would be far off for long.
TEST(TimeForecast, WhatIsToldOfAnUnevenJobHardlyFallsWhileItIsPlanned) {
    expect_hardly_falls(limits_by(psicarve::Planner::lookahead),
                        test::job_of(waves(120, [](double at) { return at < 0.3 ? 400.0 : 5.0; })));
}

// Ribs and threads come back after so many layers, as evenly spaced samples would.
TEST(TimeForecast, IsNotDeceivedByRibs) {
    for (const psicarve::Planner planner : {psicarve::Planner::lookahead, psicarve::Planner::angle}) {
        const MachineLimits limits = limits_by(planner);
        for (const std::uint32_t layers : {160U, 320U}) {
            for (const std::uint32_t period : {2U, 5U, 10U, 20U, 40U}) {
                for (const std::uint32_t shift : {0U, period / 2}) {
                    SCOPED_TRACE(::testing::Message() << layers << " by " << period << " from " << shift);
                    const auto is_rib = [&](double at) {
                        const auto layer = static_cast<std::uint32_t>(std::lround(at * (layers - 1)));
                        return 2 * ((layer + shift) % period) < period;
                    };
                    const auto height = [&](double at) { return is_rib(at) ? 400.0 : 5.0; };
                    expect_hardly_falls(limits, test::job_of(waves(layers, height)));
                }
            }
        }
    }
}

// Where a body ends and its neck begins, both may be between the same two samples.
TEST(TimeForecast, FindsWhereLayersChangeAtOnce) {
    const MachineLimits limits = limits_by(psicarve::Planner::lookahead);
    constexpr std::uint32_t kLayers = 200;
    for (std::uint32_t edge = 165; edge <= 180; ++edge) {
        const auto height = [&](double at) { return at * (kLayers - 1) < edge - 0.5 ? 400.0 : 5.0; };
        const auto job = test::job_of(waves(kLayers, height));
        const std::vector<double> ends_s = forecast_of(limits, job);
        const std::vector<PlannedSoFar> marks = marks_of(limits, job);
        const auto at_edge =
            std::ranges::find(marks, std::uint64_t{edge} * kForecastPoints, &PlannedSoFar::points);
        ASSERT_NE(at_edge, marks.end());
        const double planned_s = marks.back().seconds - at_edge->seconds;
        EXPECT_NEAR(ends_s.back() - ends_s[edge - 1], planned_s, 0.1 * planned_s) << edge;
    }
}

}  // namespace
}  // namespace psicarve::plan
