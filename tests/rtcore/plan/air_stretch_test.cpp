// SPDX-License-Identifier: GPL-3.0-or-later
// Curves that lead through air in part, planned by look-ahead.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "rtcore/plan/path_stretch.hpp"
#include "shared/profile.hpp"
#include "shared/units.hpp"

namespace psicarve::plan {
namespace {

/// Half a turn of points far out, some runs of which are air.
std::vector<PathPoint> random_points(std::mt19937_64& random, std::size_t count, bool has_air) {
    const auto share = [&random] { return static_cast<double>(random() % 1000) / 1000.0; };
    const double wave_pulses = 60.0 * share();
    const double waves = 1.0 + std::floor(6.0 * share());
    std::vector<PathPoint> points;
    bool is_air = random() % 2 == 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(count - 1);
        if (random() % 8 == 0) is_air = !is_air;
        PathPoint point{};
        for (const std::size_t head : {std::size_t{0}, std::size_t{1}}) {
            const double turned = 2.0 * kPi * waves * part + static_cast<double>(head);
            point.pulses[head] = 12'000 + std::llround(wave_pulses * std::sin(turned));
        }
        point.pulses[kPsi] =
            point_angle_pulses(static_cast<std::int64_t>(i), 3200, static_cast<std::int64_t>(count));
        point.pulses[kY] = 400;
        point.point = static_cast<std::uint32_t>(i);
        point.is_air = has_air && is_air;
        points.push_back(point);
    }
    return points;
}

struct Planned {
    std::vector<PathSpan> spans;
    std::vector<PathPiece> pieces;
    double seconds = 0.0;
};

Planned planned(const MachineLimits& limits, const std::vector<PathPoint>& points) {
    Planned result;
    result.spans = path_spans(limits, points);
    const auto corners = path_corners(limits, result.spans);
    StretchPlanner planner(limits);
    std::size_t first = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (i + 1 < points.size() && !corners[i - 1].is_stop) continue;
        result.seconds += planner.plan(points, result.spans, corners, first, i, result.pieces);
        first = i;
    }
    return result;
}

/// The fastest that the faster tip can go in a piece, over the surface, and what the square of du/dt is then.
double surface_mm_s(const MachineLimits& limits, const PathPiece& piece, const Pulses4& from,
                    std::size_t timing) {
    double most = 0.0;
    for (std::size_t head = 0; head < 2; ++head) {
        const auto at = static_cast<double>(from[head] + std::max<std::int64_t>(0, piece.delta_pulses[head]));
        const double radius_mm = at / limits.axes[head].pulses_per_unit + limits.tip_offset_mm[head];
        const double around = radius_mm * piece.slope[kPsi] * rad_from_pulses(1, limits.pulses_per_rev);
        const double out = piece.slope[head] / limits.axes[head].pulses_per_unit;
        most = std::max(most, std::hypot(around, out));
    }
    return most * std::sqrt(std::max(piece.begin_speed2[timing], piece.end_speed2[timing]));
}

/// The longer one of two tips' straight ways over the surface.
double chord_mm(const MachineLimits& limits, const Pulses4& from, const Pulses4& to) {
    double most = 0.0;
    const double turn = rad_from_pulses(to[kPsi] - from[kPsi], limits.pulses_per_rev);
    for (std::size_t head = 0; head < 2; ++head) {
        const double scale = limits.axes[head].pulses_per_unit;
        const double radius_mm = static_cast<double>(std::min(from[head], to[head])) / scale;
        most =
            std::max(most, std::hypot(radius_mm * turn, static_cast<double>(to[head] - from[head]) / scale));
    }
    return most;
}

TEST(AirStretch, GoesNoFasterThanTheFeedWhereAHeadCutsAndAsFastAsTheAxesElsewhere) {
    MachineLimits limits = machine_limits(Profile{});
    std::mt19937_64 random(67);
    const double pulse_mm = 31.0 * rad_from_pulses(1, limits.pulses_per_rev);
    int sooner = 0;
    for (int round = 0; round < 60; ++round) {
        limits.feed_mm_s = 3.0 + static_cast<double>(random() % 15);
        const auto points = random_points(random, 20 + random() % 200, true);
        const Planned plan = planned(limits, points);
        Pulses4 at = points[0].pulses;
        std::size_t span = 0;
        double most_in_air = 0.0;
        double cut_s = 0.0;  // of a run of spans that are cut
        double cut_mm = 0.0;
        for (const PathPiece& piece : plan.pieces) {
            for (std::size_t timing = 0; timing < kTimingCount; ++timing) {
                const double fastest = surface_mm_s(limits, piece, at, timing);
                if (plan.spans[span].is_air) {
                    most_in_air = std::max(most_in_air, fastest / kFeedFactor[timing]);
                } else {
                    // A piece's greatest slopes need not be its fastest place's: flat waves tell little of
                    // that.
                    ASSERT_LE(fastest, 1.04 * limits.feed_mm_s * kFeedFactor[timing])
                        << "round " << round << ", span " << span << ", timing " << timing;
                }
            }
            ASSERT_LE(piece.begin_speed2[0], piece.begin_speed2[1] * (1 + 1e-12));
            ASSERT_LE(piece.end_speed2[0], piece.end_speed2[1] * (1 + 1e-12));
            for (std::size_t k = 0; k < kAxisCount; ++k) {
                at[k] += piece.delta_pulses[k];
                const double fastest2 = std::max(piece.begin_speed2[1], piece.end_speed2[1]);
                ASSERT_LE(piece.slope[k] * std::sqrt(fastest2), 1.02 * limits.axes[k].speed_pps);
            }
            cut_s += cell_seconds(piece.length, piece.begin_speed2[0], piece.end_speed2[0]);
            if (piece.point == PathPiece::kNoPoint) continue;
            ASSERT_EQ(at, points[piece.point].pulses);
            cut_mm += chord_mm(limits, points[span].pulses, at);
            if (plan.spans[span].is_air) cut_s = cut_mm = 0.0;
            // The curve is within half a pulse of the points at both its ends.
            ASSERT_LE(cut_mm, 1.005 * limits.feed_mm_s * cut_s + pulse_mm)
                << "round " << round << ", span " << span;
            span = piece.point;
        }
        std::vector<PathPoint> cut = points;
        for (PathPoint& point : cut) point.is_air = false;
        const double at_feed_s = planned(limits, cut).seconds;
        ASSERT_LE(plan.seconds, at_feed_s * 1.0001);
        sooner += plan.seconds < 0.95 * at_feed_s && most_in_air > 1.2 * limits.feed_mm_s ? 1 : 0;
    }
    EXPECT_GT(sooner, 25);
}

TEST(AirStretch, WhollyInAirIsTimedAsWithoutAFeed) {
    MachineLimits limits = machine_limits(Profile{});
    std::mt19937_64 random(68);
    for (int round = 0; round < 10; ++round) {
        auto points = random_points(random, 150, true);
        for (PathPoint& point : points) point.is_air = true;
        limits.feed_mm_s = 3.0;
        const Planned slow = planned(limits, points);
        limits.feed_mm_s = 1e6;
        for (PathPoint& point : points) point.is_air = false;
        const Planned fast = planned(limits, points);
        EXPECT_DOUBLE_EQ(slow.seconds, fast.seconds);
        ASSERT_EQ(slow.pieces.size(), fast.pieces.size());
        for (std::size_t i = 0; i < slow.pieces.size(); ++i) {
            EXPECT_EQ(slow.pieces[i].delta_pulses, fast.pieces[i].delta_pulses);
            // Nothing that an override of more than 100 % could add.
            EXPECT_EQ(slow.pieces[i].begin_speed2[0], slow.pieces[i].begin_speed2[1]);
        }
    }
}

}  // namespace
}  // namespace psicarve::plan
