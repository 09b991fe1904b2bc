// SPDX-License-Identifier: GPL-3.0-or-later
// The second curve of a stretch: what it gains, and what it leaves as it is.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "rtcore/plan/bending_weights.hpp"
#include "rtcore/plan/curve_fit.hpp"
#include "rtcore/plan/path_stretch.hpp"
#include "shared/base/units.hpp"
#include "shared/profile/profile.hpp"
#include "tests/places.hpp"

namespace psicarve::plan {
namespace {

MachineLimits machine_of(const std::string& example_name) {
    return machine_limits(load_profile(example(example_name)).value());
}

/// Boundaries of a few points each, one way and the other, and noise of some pulses.
std::vector<PathPoint> jagged_points(std::uint64_t seed, std::int64_t psi_step) {
    std::mt19937_64 random{seed};
    std::vector<PathPoint> points;
    std::array<std::int64_t, 2> radius{40'000, 44'000};
    std::array<std::int64_t, 2> slope{};
    for (std::uint32_t i = 0; i < 90; ++i) {
        for (std::size_t head = 0; head < 2; ++head) {
            if (random() % 6 == 0) slope[head] = static_cast<std::int64_t>(random() % 161) - 80;
            radius[head] += slope[head] + static_cast<std::int64_t>(random() % 5) - 2;
        }
        points.push_back({{radius[0], radius[1], psi_step * i, 8'000}, 0, i, false});
    }
    return points;
}

/// The fastest timing of the curve of least bending, tube and limits being those of the planner.
double least_bending_seconds(const MachineLimits& limits, const std::vector<PathPoint>& points,
                             std::size_t timing_index = 0) {
    const std::vector<PathSpan> spans = path_spans(limits, points);
    const CurveNodes nodes =
        curve_nodes(limits, points, spans, path_corners(limits, spans), 0, points.size() - 1);
    Lanes accel;
    for (std::size_t k = 0; k < kAxisCount; ++k) accel[k] = 0.985 * limits.axes[k].accel_pps2;
    CurveFit fit{accel};
    fit.solve(NodesView::of(nodes));
    std::vector<PathCell> cells;
    std::vector<Lanes> cell_at;
    cells_of(nodes, fit.control(), cells, cell_at);
    const double feed_mm_s = kFeedFactor[timing_index] * limits.feed_mm_s;
    const auto greatest2 = [&](std::size_t cell, double share) {
        double inverse = 1e-9;
        const double along = share * cells[cell].length;
        Lanes slope;
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            slope[k] = cells[cell].slope_begin[k] + along * cells[cell].bend[k];
            inverse = std::max(inverse, std::abs(slope[k]) / (0.998 * limits.axes[k].speed_pps));
        }
        for (std::size_t head = 0; head < 2; ++head) {
            const double at =
                cell_at[cell][head] + 0.5 * along * (cells[cell].slope_begin[head] + slope[head]);
            const double scale = limits.axes[head].pulses_per_unit;
            const double turn = slope[kPsi] * rad_from_pulses(1, limits.pulses_per_rev);
            const double around_mm = (at / scale + limits.tip_offset_mm[head]) * turn;
            inverse = std::max(inverse, std::hypot(around_mm, slope[head] / scale) / feed_mm_s);
        }
        return 1.0 / (inverse * inverse);
    };
    std::vector<double> bound2;
    std::vector<InnerSpeeds2> inner2;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        bound2.push_back(greatest2(i, 0.0));
        inner2.push_back({greatest2(i, 0.25), greatest2(i, 0.5), greatest2(i, 0.75)});
    }
    bound2.push_back(greatest2(cells.size() - 1, 1.0));
    bound2.front() = std::min(stop_speed2(limits, spans.front().slope, nullptr),
                              stop_speed2(limits, cells.front().slope_begin, nullptr));
    bound2.back() = std::min(stop_speed2(limits, spans.back().slope, nullptr),
                             stop_speed2(limits, cells.back().slope_end, nullptr));
    SpeedProfile timing{accel};
    timing.set_path(cells);
    std::vector<double> speed2;
    timing.solve({bound2, inner2}, speed2);
    double seconds = 0.0;
    for (std::size_t i = 0; i < cells.size(); ++i)
        seconds += cell_seconds(cells[i].length, speed2[i], speed2[i + 1]);
    return seconds;
}

TEST(EvenBending, IsFasterThanLeastBendingAndNeverSlower) {
    MachineLimits limits = machine_of("fine.toml");
    limits.feed_mm_s = 1e6;
    double even_s = 0.0;
    double least_s = 0.0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        const std::vector<PathPoint> points =
            jagged_points(seed, 40 + 8 * static_cast<std::int64_t>(seed % 8));
        const std::vector<PathSpan> spans = path_spans(limits, points);
        const std::vector<PathCorner> corners = path_corners(limits, spans);
        StretchPlanner planner(limits);
        std::vector<PathPiece> pieces;
        const double seconds = planner.plan(points, spans, corners, 0, points.size() - 1, pieces);
        const double of_least_bending_s = least_bending_seconds(limits, points);
        // Where the tube had to be narrowed both curves are slower than the one that it was not narrowed for.
        EXPECT_LE(seconds, 1.005 * of_least_bending_s) << seed;
        even_s += seconds;
        least_s += of_least_bending_s;
    }
    EXPECT_LT(even_s, 0.99 * least_s);
}

struct PlannedStretch {
    double seconds = 0.0;
    std::vector<PathPiece> pieces;
};

/// All points as one stretch.
PlannedStretch planned_by(StretchPlanner& planner, const MachineLimits& limits,
                          const std::vector<PathPoint>& points) {
    const std::vector<PathSpan> spans = path_spans(limits, points);
    PlannedStretch planned;
    planned.seconds =
        planner.plan(points, spans, path_corners(limits, spans), 0, points.size() - 1, planned.pieces);
    return planned;
}

void expect_same(const PlannedStretch& planned, const PlannedStretch& expected) {
    EXPECT_EQ(planned.seconds, expected.seconds);
    ASSERT_EQ(planned.pieces.size(), expected.pieces.size());
    for (std::size_t i = 0; i < planned.pieces.size(); ++i) {
        const PathPiece& piece = planned.pieces[i];
        const PathPiece& other = expected.pieces[i];
        ASSERT_EQ(piece.delta_pulses, other.delta_pulses) << i;
        ASSERT_EQ(piece.length, other.length) << i;
        ASSERT_EQ(piece.begin_speed2, other.begin_speed2) << i;
        ASSERT_EQ(piece.end_speed2, other.end_speed2) << i;
        ASSERT_EQ(piece.point, other.point) << i;
    }
}

TEST(EvenBending, OfAPlannerThatIsUsedAgainIsThatOfANewOne) {
    const MachineLimits limits = machine_of("fine.toml");
    StretchPlanner used(limits);
    for (const std::uint64_t seed : {1U, 2U, 2U, 3U, 1U}) {
        std::vector<PathPoint> points = jagged_points(seed, 56);
        if (seed == 2) points.resize(30);
        StretchPlanner fresh(limits);
        expect_same(planned_by(used, limits, points), planned_by(fresh, limits, points));
    }
}

// Every way one between layers.
TEST(EvenBending, LeavesLinksAsTheyAre) {
    const MachineLimits limits = machine_of("fine.toml");
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        std::vector<PathPoint> points = jagged_points(seed, 56);
        for (std::size_t i = 0; i < points.size(); ++i) points[i].layer = static_cast<std::uint32_t>(i);
        StretchPlanner sut(limits);
        EXPECT_NEAR(planned_by(sut, limits, points).seconds, least_bending_seconds(limits, points), 1e-9);
    }
}

/// Heads that go in and out again smoothly, both at once.
std::vector<PathPoint> wavy_points(std::uint64_t seed) {
    std::mt19937_64 random{seed};
    const double waves = 3.0 + static_cast<double>(random() % 12);
    const double height_pulses = 200.0 + static_cast<double>(random() % 3000);
    std::vector<PathPoint> points;
    for (std::uint32_t i = 0; i < 90; ++i) {
        const auto out =
            static_cast<std::int64_t>(height_pulses * std::sin(waves * 2.0 * std::numbers::pi * i / 90.0));
        points.push_back({{40'000 + out, 44'000 - out / 2, 56 * std::int64_t{i}, 8'000}, 0, i, false});
    }
    return points;
}

// There bending more evenly takes as long or longer.
TEST(EvenBending, IsNotTakenWhereItIsSlower) {
    const MachineLimits limits = machine_of("fine.toml");
    int taken = 0;
    int left = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        const std::vector<PathPoint> points = wavy_points(seed);
        StretchPlanner sut(limits);
        const double share = planned_by(sut, limits, points).seconds / least_bending_seconds(limits, points);
        const bool is_left = std::abs(share - 1.0) <= 1e-9;
        EXPECT_TRUE(is_left || share <= 0.998) << seed << ": " << share;
        ++(is_left ? left : taken);
    }
    EXPECT_GE(taken, 10);
    EXPECT_GE(left, 10);
}

double seconds_at_twice_the_feed(const std::vector<PathPiece>& pieces) {
    double seconds = 0.0;
    for (const PathPiece& piece : pieces)
        seconds += cell_seconds(piece.length, piece.begin_speed2[1], piece.end_speed2[1]);
    return seconds;
}

TEST(EvenBending, IsNotTakenWhereItIsSlowerAtTwiceTheFeed) {
    MachineLimits limits = machine_of("fine.toml");
    limits.feed_mm_s = 4.0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        const std::vector<PathPoint> points =
            jagged_points(seed, 40 + 8 * static_cast<std::int64_t>(seed % 8));
        StretchPlanner sut(limits);
        const double seconds = seconds_at_twice_the_feed(planned_by(sut, limits, points).pieces);
        // Cuts may take a little longer than the curve.
        EXPECT_LE(seconds, 1.003 * least_bending_seconds(limits, points, 1)) << seed;
    }
}

/// A step so high that the curve cannot be within its tube there, however narrow the tube is made.
std::vector<PathPoint> points_with_a_cliff(std::uint64_t seed) {
    std::vector<PathPoint> points = jagged_points(seed, 56);
    for (std::size_t i = points.size() / 2; i < points.size(); ++i) points[i].pulses[0] += 10'000;
    return points;
}

TEST(EvenBending, GainsAlongTheRestOfAStretchThatIsStuckInOnePlace) {
    const MachineLimits limits = machine_of("fine.toml");
    double even_s = 0.0;
    double least_s = 0.0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        const std::vector<PathPoint> points = points_with_a_cliff(seed);
        StretchPlanner sut(limits);
        even_s += planned_by(sut, limits, points).seconds;
        least_s += least_bending_seconds(limits, points);
    }
    EXPECT_LT(even_s, least_s) << "though the tube is narrowed for it";
}

}  // namespace
}  // namespace psicarve::plan
