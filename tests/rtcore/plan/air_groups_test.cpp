// SPDX-License-Identifier: GPL-3.0-or-later
// Lines in air, planned by angles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <vector>

#include "rtcore/plan/angle_planner.hpp"
#include "shared/profile.hpp"
#include "shared/units.hpp"

namespace psicarve::plan {
namespace {

constexpr double kFar_mm = 40.0;

TableLine way(std::int64_t out, std::int64_t turn, bool is_air) {
    TableLine line{};
    line.delta_pulses = {out, 0, turn, 0};
    line.radius_mm = {kFar_mm, kFar_mm};
    line.is_air = is_air;
    return line;
}

/// Of the tip over the surface, where a group goes fastest.
double surface_mm_s(const MachineLimits& limits, const LineGroup& group, const TableLine& line) {
    const auto longest = static_cast<double>(
        std::max(std::abs(line.delta_pulses[index_of(Axis::r1)]), std::abs(line.delta_pulses[kPsi])));
    const double around = line.radius_mm[0] * rad_from_pulses(line.delta_pulses[kPsi], limits.pulses_per_rev);
    const double out = static_cast<double>(line.delta_pulses[0]) / limits.axes[0].pulses_per_unit;
    return std::hypot(around, out) / longest * group.limits.max_per_s;
}

double seconds_of(const std::vector<LineGroup>& groups) {
    double seconds = 0.0;
    for (const LineGroup& group : groups) seconds += group_seconds(group.limits, group.iterations);
    return seconds;
}

TEST(AirGroups, ALayerOfAirGoesAsFastAsItsAxes) {
    MachineLimits limits = machine_limits(Profile{});
    limits.feed_mm_s = 5.0;
    const std::vector<TableLine> lines(200, way(0, 16, true));
    const auto groups = plan_by_angle(limits, lines);
    ASSERT_EQ(groups.size(), 1U);
    EXPECT_DOUBLE_EQ(groups[0].limits.max_per_s, line_limits(limits, lines[0].delta_pulses).max_per_s);
    EXPECT_GT(surface_mm_s(limits, groups[0], lines[0]), 3.0 * limits.feed_mm_s);
}

TEST(AirGroups, EndWhereAirDoesIfThatIsSooner) {
    MachineLimits limits = machine_limits(Profile{});
    limits.feed_mm_s = 5.0;
    limits.axes[kPsi].start_stop_pps = 20.0;
    limits.axes[kPsi].accel_pps2 = 2000.0;
    std::vector<TableLine> lines(100, way(0, 16, true));
    lines.resize(200, way(0, 16, false));
    const auto groups = plan_by_angle(limits, lines);
    ASSERT_EQ(groups.size(), 2U);
    EXPECT_EQ(groups[1].first, 100U);
    // A moment of air is not worth a stop.
    std::vector<TableLine> few(100, way(0, 16, false));
    few[50].is_air = true;
    EXPECT_EQ(plan_by_angle(limits, few).size(), 1U);
}

TEST(AirGroups, OfRandomLinesKeepTheFeedWhereAHeadCutsAndTakeNoLonger) {
    MachineLimits limits = machine_limits(Profile{});
    std::mt19937_64 random(29);
    int sooner = 0;
    for (int round = 0; round < 300; ++round) {
        limits.feed_mm_s = 2.0 + static_cast<double>(random() % 20);
        std::vector<TableLine> lines;
        bool is_air = false;
        for (int i = 0; i < 100; ++i) {
            if (random() % 12 == 0) is_air = !is_air;
            lines.push_back(way(static_cast<std::int64_t>(random() % 5) - 2,
                                8 + static_cast<std::int64_t>(random() % 3), is_air));
        }
        const auto groups = plan_by_angle(limits, lines);
        std::size_t next = 0;
        for (const LineGroup& group : groups) {
            ASSERT_EQ(group.first, next);
            next += group.count;
            for (std::size_t i = group.first; i < next; ++i) {
                const GroupLimits own = line_limits(limits, lines[i].delta_pulses);
                ASSERT_LE(group.limits.max_per_s, own.max_per_s * (1 + 1e-12));
                if (lines[i].is_air) continue;
                ASSERT_LE(surface_mm_s(limits, group, lines[i]), limits.feed_mm_s * (1 + 1e-9));
            }
        }
        ASSERT_EQ(next, lines.size());
        for (TableLine& line : lines) line.is_air = false;
        const double at_feed_s = seconds_of(plan_by_angle(limits, lines));
        ASSERT_LE(seconds_of(groups), at_feed_s * (1 + 1e-12));
        sooner += seconds_of(groups) < 0.95 * at_feed_s ? 1 : 0;
    }
    EXPECT_GT(sooner, 100);
}

}  // namespace
}  // namespace psicarve::plan
