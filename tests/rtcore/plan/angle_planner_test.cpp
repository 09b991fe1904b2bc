// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/angle_planner.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <vector>

#include "shared/base/units.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::plan {
namespace {

TableLine line(std::int64_t r1, std::int64_t r2, std::int64_t psi, double radius_mm = 10.0) {
    return {.delta_pulses = {r1, r2, psi, 0}, .radius_mm = {radius_mm, radius_mm}, .layer = 0, .step = 0};
}

/// The corner rule with libm, as the specification words it.
double least_turn_deg(const TableLine& a, const TableLine& b, std::size_t head) {
    const Profile profile;
    const auto x = [&](const TableLine& l) {
        return l.radius_mm[head] * rad_from_pulses(std::abs(l.delta_pulses[2]), profile.psi.pulses_per_rev);
    };
    double least = 180.0;
    for (const double move : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
        const double ya = (static_cast<double>(a.delta_pulses[head]) + move) / 400.0;
        const double yb = (static_cast<double>(b.delta_pulses[head]) - move) / 400.0;
        const double turn = std::atan2(yb, x(b)) - std::atan2(ya, x(a));
        least = std::min(least, std::fabs(deg_from_rad(turn)));
        // A turn of the other sign somewhere means that none is possible too.
        const double straight = std::atan2(static_cast<double>(b.delta_pulses[head]) / 400.0, x(b)) -
                                std::atan2(static_cast<double>(a.delta_pulses[head]) / 400.0, x(a));
        if (turn * straight <= 0.0) least = 0.0;
    }
    return least;
}

TEST(AnglePlanner, CornersAreThoseThatStayFiveDegreesWhenPointsMoveByHalfAPulse) {
    const MachineLimits limits = machine_limits(Profile{});
    std::mt19937_64 random(17);
    int corners = 0;
    for (int round = 0; round < 20000; ++round) {
        const auto delta = [&] { return static_cast<std::int64_t>(random() % 61) - 30; };
        const TableLine a = line(delta(), 0, 1 + static_cast<std::int64_t>(random() % 40));
        const TableLine b = line(delta(), 0, 1 + static_cast<std::int64_t>(random() % 40));
        const double least = least_turn_deg(a, b, 0);
        if (std::fabs(least - 5.0) < 1e-6) continue;
        EXPECT_EQ(is_corner(limits, a, b, 0), least >= 5.0) << least;
        corners += least >= 5.0 ? 1 : 0;
    }
    EXPECT_GT(corners, 5000);
}

TEST(AnglePlanner, OnePulseOfRoundingIsNoCorner) {
    const MachineLimits limits = machine_limits(Profile{});
    // 2.5 mm radius, 6 pulses of psi: one pulse of R is 9 degrees.
    EXPECT_FALSE(is_corner(limits, line(0, 0, 6, 2.5), line(1, 0, 6, 2.5), 0));
    EXPECT_TRUE(is_corner(limits, line(0, 0, 6, 2.5), line(4, 0, 6, 2.5), 0));
}

TEST(AnglePlanner, TurnsTheSameBothWays) {
    const MachineLimits limits = machine_limits(Profile{});
    std::mt19937_64 random(18);
    for (int round = 0; round < 2000; ++round) {
        const auto delta = [&] { return static_cast<std::int64_t>(random() % 21) - 10; };
        const TableLine a = line(delta(), 0, 7);
        const TableLine b = line(delta(), 0, 9);
        TableLine back_a = a;
        TableLine back_b = b;
        for (auto* l : {&back_a, &back_b}) l->delta_pulses[2] = -l->delta_pulses[2];
        EXPECT_EQ(is_corner(limits, a, b, 0), is_corner(limits, back_a, back_b, 0));
    }
}

TEST(AnglePlanner, GroupsObeyEveryAxisFeedAndJumpLimit) {
    const Profile profile;
    const MachineLimits limits = machine_limits(profile);
    std::mt19937_64 random(19);
    for (int round = 0; round < 300; ++round) {
        std::vector<TableLine> lines;
        for (int i = 0; i < 100; ++i) {
            lines.push_back(line(static_cast<std::int64_t>(random() % 9) - 4,
                                 static_cast<std::int64_t>(random() % 5) - 2,
                                 5 + static_cast<std::int64_t>(random() % 3), 20.0));
        }
        std::size_t next = 0;
        for (const LineGroup& group : plan_by_angle(limits, lines)) {
            ASSERT_EQ(group.first, next);
            next += group.count;
            ASSERT_LE(group.limits.start_per_s, group.limits.max_per_s);
            for (std::size_t i = group.first; i < next; ++i) {
                const auto& d = lines[i].delta_pulses;
                const auto s =
                    static_cast<double>(std::max({std::abs(d[0]), std::abs(d[1]), std::abs(d[2])}));
                for (std::size_t k = 0; k < 3; ++k) {
                    const double ratio = static_cast<double>(d[k]) / s;
                    const AxisMotion& axis = limits.axes[k];
                    ASSERT_LE(std::fabs(ratio) * group.limits.max_per_s, axis.speed_pps * (1 + 1e-12));
                    ASSERT_LE(std::fabs(ratio) * group.limits.accel_per_s2, axis.accel_pps2 * (1 + 1e-12));
                    ASSERT_LE(std::fabs(ratio) * group.limits.start_per_s, axis.start_stop_pps * (1 + 1e-12));
                    if (i == group.first) continue;
                    const auto& e = lines[i - 1].delta_pulses;
                    const auto before =
                        static_cast<double>(std::max({std::abs(e[0]), std::abs(e[1]), std::abs(e[2])}));
                    const double jump = std::fabs(ratio - static_cast<double>(e[k]) / before);
                    ASSERT_LE(jump * group.limits.max_per_s, axis.start_stop_pps * (1 + 1e-12));
                }
                const double x = 20.0 * rad_from_pulses(d[2], 6400) / s * group.limits.max_per_s;
                for (std::size_t head = 0; head < 2; ++head) {
                    const double y = static_cast<double>(d[head]) / 400.0 / s * group.limits.max_per_s;
                    ASSERT_LE(std::sqrt(x * x + y * y), profile.job.feed_mm_s * (1 + 1e-9));
                }
            }
        }
        ASSERT_EQ(next, lines.size());
    }
}

TEST(AnglePlanner, ASmoothLayerIsOneGroup) {
    const MachineLimits limits = machine_limits(Profile{});
    const std::vector<TableLine> lines(200, line(0, 0, 16));
    EXPECT_EQ(plan_by_angle(limits, lines).size(), 1U);
}

TEST(MachineLimits, NeverAsksAnAxisForMoreThanItsTicksAllow) {
    Profile profile;
    profile.psi.speed_deg_s = 100000.0;
    const MachineLimits limits = machine_limits(profile);
    EXPECT_DOUBLE_EQ(line_limits(limits, {0, 0, 1000, 0}).max_per_s, 10000.0);  // two ticks of 50 us
}

TEST(MachineLimits, EstimatesAGroupsTime) {
    const GroupLimits limits{.start_per_s = 100.0, .max_per_s = 1000.0, .accel_per_s2 = 10000.0};
    EXPECT_NEAR(group_seconds(limits, 1099), 2 * 0.09 + 1.0, 1e-9);  // ramps of 49.5 each
    EXPECT_NEAR(group_seconds(limits, 24), 2 * (std::sqrt(10000.0 + 240000.0) - 100.0) / 10000.0, 1e-12);
}

}  // namespace
}  // namespace psicarve::plan
