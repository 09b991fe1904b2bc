// SPDX-License-Identifier: GPL-3.0-or-later
// What the way to each point of a job takes, and what bounds it.
#include "rtcore/plan/point_times.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "rtcore/plan/approach.hpp"
#include "rtcore/plan/carving.hpp"
#include "tests/rtcore/plan/estimated_jobs.hpp"
#include "tests/shared/spiral_fixture.hpp"

namespace psicarve::plan {
namespace {

/// Of the time: what is planned counts whole ticks.
constexpr double kTickShare = 2e-3;

struct Planned {
    PointPlan points;
    double seconds = 0.0;
};

Planned planned(const Profile& profile, const JobTable& table) {
    const auto job = owned(table);
    const MachineLimits limits = limits_for(machine_limits(profile), *job);
    const auto program = carving_of(limits, job);
    PointTimes sut{limits, *job};
    cycle::MotionBlock block{};
    while (program->next(block)) sut.add(block);
    return {sut.take(), program->planned().seconds};
}

double sum(const PointPlan& plan, std::size_t first, std::size_t count) {
    const auto begin = plan.seconds.begin() + static_cast<std::ptrdiff_t>(first);
    return std::accumulate(begin, begin + static_cast<std::ptrdiff_t>(count), 0.0);
}

std::size_t count_of(const PointPlan& plan, WayBound bound, std::size_t first, std::size_t count) {
    const auto begin = plan.bounds.begin() + static_cast<std::ptrdiff_t>(first);
    return static_cast<std::size_t>(std::count(begin, begin + static_cast<std::ptrdiff_t>(count), bound));
}

/// Straight down, as a bar: only psi turns, and Y between layers.
JobTable bar(std::uint32_t layers, double feed_mm_s) {
    JobTable table = rougher_and_rougher(layers);
    std::ranges::fill(table.r_left_pulses, 5000);
    std::ranges::fill(table.r_right_pulses, 5300);
    table.feed_mm_s = feed_mm_s;
    return table;
}

TEST(PointTimes, AddUpToWhatIsPlanned) {
    for (const Joining joining : {Joining::continuous, Joining::zigzag, Joining::spiral}) {
        for (const Profile& profile : {Profile{}, by_angle()}) {
            JobTable table = rougher_and_rougher(7);
            if (joining == Joining::spiral) table = spiral_of(table);
            table.joining = joining;
            const Planned made = planned(profile, table);
            ASSERT_EQ(made.points.seconds.size(), 7U * 60U);
            EXPECT_NEAR(sum(made.points, 0, 7U * 60U) / made.seconds, 1.0, kTickShare)
                << static_cast<int>(joining) << " " << static_cast<int>(profile.job.planner);
            EXPECT_EQ(made.points.seconds[0], 0.0F);
            for (std::size_t point = 1; point < 60; ++point)
                EXPECT_GT(made.points.seconds[point], 0.0F) << point;
        }
    }
}

TEST(PointTimes, AreThoseOfEachLayer) {
    const Planned whole = planned(Profile{}, rougher_and_rougher(8));
    for (std::uint32_t layers = 1; layers < 8; ++layers) {
        const Planned part = planned(Profile{}, rougher_and_rougher(layers));
        EXPECT_NEAR(sum(whole.points, 0, layers * 60U), part.seconds, kTickShare * part.seconds) << layers;
    }
}

TEST(PointTimes, TellTheFeedWhereNoAxisIsAtItsLimit) {
    const Planned made = planned(Profile{}, bar(3, 1.0));
    EXPECT_GT(count_of(made.points, WayBound::feed, 0, 60), 50U);
    EXPECT_EQ(count_of(made.points, WayBound::r1, 0, 180), 0U);
    EXPECT_EQ(count_of(made.points, WayBound::r2, 0, 180), 0U);
}

// A group's lines go by the least limit of them all.
TEST(PointTimes, TellNoFeedOfLinesThatGoByAnotherOnesLimit) {
    for (const Profile& profile : {Profile{}, by_angle()}) {
        JobTable table = rougher_and_rougher(7);
        table.feed_mm_s = 9000.0;
        const Planned made = planned(profile, table);
        EXPECT_EQ(count_of(made.points, WayBound::feed, 0, 7U * 60U), 0U);
    }
}

TEST(PointTimes, TellTheTableWhereItTurnsAsFastAsItCan) {
    for (const Profile& profile : {Profile{}, by_angle()}) {
        const Planned made = planned(profile, bar(3, 1000.0));
        EXPECT_GT(count_of(made.points, WayBound::psi, 1, 59), 50U);
    }
}

TEST(PointTimes, TellYOnTheWayToALayerFarAbove) {
    JobTable table = bar(2, 1000.0);
    table.layer_height_pulses.back() = table.layer_height_pulses.front() + 8000;
    for (const Profile& profile : {Profile{}, by_angle()}) {
        const Planned made = planned(profile, table);
        EXPECT_EQ(made.points.bounds[60], WayBound::y);
        EXPECT_GT(made.points.seconds[60], 10.0F * made.points.seconds[30]);
    }
}

// One head goes in and out by much from point to point, the other hardly at all.
TEST(PointTimes, TellTheHeadThatIsTooSlow) {
    for (const bool is_r2 : {false, true}) {
        JobTable table = bar(2, 1000.0);
        auto& radii = is_r2 ? table.r_right_pulses : table.r_left_pulses;
        for (std::size_t i = 0; i < radii.size(); ++i) radii[i] += i % 2 == 0 ? 0 : 800;
        const Planned made = planned(Profile{}, table);
        EXPECT_GT(count_of(made.points, is_r2 ? WayBound::r2 : WayBound::r1, 1, 59), 50U) << is_r2;
    }
}

}  // namespace
}  // namespace psicarve::plan
