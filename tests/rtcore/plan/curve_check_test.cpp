// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/curve_check.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "rtcore/plan/curve_fit.hpp"
#include "rtcore/plan/path_stretch.hpp"

namespace psicarve::plan {
namespace {

MachineLimits fine_limits() {
    Profile profile;
    profile.tick.period_us = 10;
    for (LinearAxisProfile* axis : {&profile.r1, &profile.r2, &profile.y}) {
        axis->pulses_per_mm = 4000;
        axis->speed_mm_s = 12.0;
    }
    profile.psi.pulses_per_rev = 128'000;
    profile.job.path_tolerance_mm = 0.005;
    return machine_limits(profile);
}

std::vector<PathPoint> points_of(const std::vector<std::array<std::int64_t, 2>>& psi_and_radius) {
    std::vector<PathPoint> points;
    points.reserve(psi_and_radius.size());
    for (const auto& [psi, radius] : psi_and_radius) {
        points.push_back({{radius, 40'000, psi, 8'000}, 0, static_cast<std::uint32_t>(points.size()), false});
    }
    return points;
}

/// Greatest distance of the ends of all pieces from the chord that they lie on, and of psi's turns back.
struct Way {
    double off_mm = 0.0;
    std::int64_t turn_pulses = 0;
    std::int64_t head_turn_pulses = 0;  ///< of R1 against the span's way
    std::vector<Pulses4> points;
};

Way way_of(const MachineLimits& limits, const std::vector<PathPoint>& points) {
    const std::vector<PathSpan> spans = path_spans(limits, points);
    const std::vector<PathCorner> corners = path_corners(limits, spans);
    StretchPlanner planner(limits);
    std::vector<PathPiece> pieces;
    std::size_t first = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (i + 1 < points.size() && !corners[i - 1].is_stop) continue;
        planner.plan(points, spans, corners, first, i, pieces);
        first = i;
    }
    Way way;
    Pulses4 at = points[0].pulses;
    std::size_t span = 0;
    for (const PathPiece& piece : pieces) {
        way.turn_pulses = std::max(way.turn_pulses, -piece.delta_pulses[2]);
        for (std::size_t k = 0; k < kAxisCount; ++k) at[k] += piece.delta_pulses[k];
        const Pulses4& from = points[span].pulses;
        const Pulses4& to = points[span + 1].pulses;
        const std::int64_t way_of_head = to[0] < from[0] ? -piece.delta_pulses[0] : piece.delta_pulses[0];
        way.head_turn_pulses = std::max(way.head_turn_pulses, -way_of_head);
        const double psi_mm = spans[span].radius_mm[0] * 2.0 * std::numbers::pi / 128'000.0;
        const double x_mm = static_cast<double>(to[2] - from[2]) * psi_mm;
        const double y_mm = static_cast<double>(to[0] - from[0]) / 4000.0;
        const double along_mm = static_cast<double>(at[2] - from[2]) * psi_mm;
        const double out_mm = static_cast<double>(at[0] - from[0]) / 4000.0;
        way.off_mm = std::max(way.off_mm, std::abs(x_mm * out_mm - y_mm * along_mm) / std::hypot(x_mm, y_mm));
        if (piece.point == PathPiece::kNoPoint) continue;
        way.points.push_back(at);
        ++span;
    }
    return way;
}

std::vector<PathPoint> cliff_points() {
    std::vector<std::array<std::int64_t, 2>> ways;
    for (std::int64_t i = 0; i < 60; ++i) ways.push_back({128 * i, i < 30 ? 24'000 : 60'000 + 40 * i});
    return points_of(ways);
}

TEST(CurveCheck, DownACliffTheTableNeverTurnsBackAndTheCutsStayInTheTube) {
    const MachineLimits limits = fine_limits();
    const auto points = cliff_points();
    const Way way = way_of(limits, points);
    EXPECT_EQ(way.turn_pulses, 0);
    EXPECT_LE(way.off_mm, limits.path_tolerance_mm + 0.5 * 0.00075);
    ASSERT_EQ(way.points.size(), points.size() - 1);
    for (std::size_t i = 1; i < points.size(); ++i) EXPECT_EQ(way.points[i - 1], points[i].pulses);
}

// The gap would have to be crossed for each turn.
TEST(CurveCheck, DownACliffNoAxisThatHasBacklashTurnsBackBetweenTwoPoints) {
    MachineLimits limits = fine_limits();
    for (const std::size_t axis : {std::size_t{0}, index_of(Axis::psi)})
        limits.tick.axes[axis].backlash_pulses = 200;
    const auto points = cliff_points();
    const Way way = way_of(limits, points);
    EXPECT_EQ(way.turn_pulses, 0);
    EXPECT_EQ(way.head_turn_pulses, 0);
    EXPECT_LE(way.off_mm, limits.path_tolerance_mm + 0.5 * 0.00075);
    ASSERT_EQ(way.points.size(), points.size() - 1);
    for (std::size_t i = 1; i < points.size(); ++i) EXPECT_EQ(way.points[i - 1], points[i].pulses);
}

TEST(CurveCheck, NarrowsOnlyTheSpansInWhichTheCurveIsOutside) {
    const MachineLimits limits = fine_limits();
    std::vector<std::array<std::int64_t, 2>> ways;
    for (std::int64_t i = 0; i < 12; ++i) ways.push_back({128 * i, 40'000 + (i == 6 ? 300 : 0)});
    const auto points = points_of(ways);
    const std::vector<PathSpan> spans = path_spans(limits, points);
    const std::vector<PathCorner> corners = path_corners(limits, spans);
    // A tube ten times too wide about one span: the fitted curve uses it.
    std::vector<PathSpan> wide = spans;
    for (const std::size_t span : {5U, 6U}) wide[span].band[0] *= 10.0;
    const CurveNodes nodes = curve_nodes(limits, points, wide, corners, 0, points.size() - 1);
    CurveFit fit({1e6, 1e6, 1e6, 1e6});
    fit.solve(NodesView::of(nodes));
    std::vector<PathCell> cells;
    std::vector<Lanes> cell_at;
    cells_of(nodes, fit.control(), cells, cell_at);
    const std::vector<PathSpan> before = wide;
    std::vector<std::uint32_t> narrowed;
    std::vector<std::uint32_t> stuck;
    narrow_where_outside(limits, points, {nodes, cells, cell_at}, {0, cells.size() - 1}, wide, narrowed,
                         stuck);
    EXPECT_EQ(narrowed, (std::vector<std::uint32_t>{5, 6}));
    EXPECT_TRUE(stuck.empty());
    // Bands that are as narrow as they may be make nothing of it but that the curve is outside.
    std::vector<PathSpan> least = spans;
    for (const std::size_t span : {5U, 6U}) least[span].band[0] = kLeastBandPulses;
    narrowed.clear();
    narrow_where_outside(limits, points, {nodes, cells, cell_at}, {0, cells.size() - 1}, least, narrowed,
                         stuck);
    EXPECT_TRUE(narrowed.empty());
    EXPECT_EQ(stuck, (std::vector<std::uint32_t>{5, 6}));
    for (std::size_t span = 0; span < spans.size(); ++span) {
        if (span == 5 || span == 6) {
            EXPECT_LT(wide[span].band[0], before[span].band[0]) << span;
        } else {
            EXPECT_EQ(wide[span].band[0], before[span].band[0]) << span;
        }
        EXPECT_EQ(wide[span].band[1], before[span].band[1]) << span;
    }
}

TEST(CurveNodes, AreFourASpanBesideASharpCornerAndTwoElsewhere) {
    const MachineLimits limits = fine_limits();
    std::vector<std::array<std::int64_t, 2>> ways;
    for (std::int64_t i = 0; i < 7; ++i) ways.push_back({128 * i, 40'000});
    const auto points = points_of(ways);
    const std::vector<PathSpan> spans = path_spans(limits, points);
    std::vector<PathCorner> corners(5, PathCorner{false, false, false, 1.0});
    corners[2].is_sharp = true;
    const CurveNodes nodes = curve_nodes(limits, points, spans, corners, 0, 6);
    std::array<int, 6> count{};
    for (std::size_t j = 0; j + 1 < nodes.span_at.size(); ++j) ++count.at(nodes.span_at[j]);
    EXPECT_EQ(count, (std::array{2, 2, 4, 4, 2, 2}));
}

// One axis needs three times the iterations of the table: the table's own must not be driven on meanwhile
// until nothing of them can be represented.
TEST(CurveCheck, OfAxesThatTakeUnequalEffortNoneIsLost) {
    const MachineLimits limits = machine_limits(Profile{});
    std::vector<PathPoint> points;
    for (std::int64_t i = 0; i <= 1460; ++i) {
        const std::int64_t r2 = 3400 + std::llround(10.0 * std::sin(0.05 * static_cast<double>(i)));
        const auto point = static_cast<std::uint32_t>(i);
        points.push_back({{i < 1460 ? 600 : 3521, r2, i, 100}, 0, point, false});
    }
    const std::vector<PathSpan> spans = path_spans(limits, points);
    const std::vector<PathCorner> corners = path_corners(limits, spans);
    const CurveNodes nodes = curve_nodes(limits, points, spans, corners, 0, 1460);
    CurveFit fit({4e5, 4e5, 4e5, 4e5});
    fit.solve(NodesView::of(nodes));
    EXPECT_LT(fit.iterations(), 40);
    for (std::size_t j = 0; j < nodes.step.size(); ++j) {
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            ASSERT_NEAR(fit.control()[j][k], 0.5 * (nodes.low[j][k] + nodes.high[j][k]), 3000.0)
                << j << ' ' << k;
        }
    }
}

}  // namespace
}  // namespace psicarve::plan
