// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/program_tube.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "rtcore/plan/curve_check.hpp"
#include "rtcore/plan/curve_fit.hpp"
#include "rtcore/plan/path_stretch.hpp"

namespace psicarve::plan {
namespace {

MachineLimits tube_limits(double tolerance_mm) {
    Profile profile;
    for (LinearAxisProfile* axis : {&profile.r1, &profile.r2, &profile.y}) axis->pulses_per_mm = 2000;
    profile.psi.pulses_per_rev = 640'000;
    MachineLimits limits = machine_limits(profile);
    limits.is_program = true;
    limits.path_tolerance_mm = tolerance_mm;
    return limits;
}

/// The corner of a span's box that is furthest from its chord, in one head's space [mm].
double furthest_corner_mm(const MachineLimits& limits, const PathSpan& span, std::size_t head) {
    const auto pulses_mm = space_pulses_mm(limits, span, head);
    const auto axes = space_axes(head);
    double furthest_mm = 0.0;
    for (unsigned signs = 0; signs < 8; ++signs) {
        double length2 = 0.0, along = 0.0, corner2 = 0.0;
        for (std::size_t i = 0; i < kSpaceAxisCount; ++i) {
            const double way = span.slope[axes[i]] * pulses_mm[i];
            const double is_free = span.band[axes[i]] > kLeastBandPulses ? 1.0 : 0.0;
            const double off =
                is_free * ((signs >> i & 1U) != 0 ? 1.0 : -1.0) * span.band[axes[i]] * pulses_mm[i];
            length2 += way * way;
            along += way * off;
            corner2 += off * off;
        }
        if (length2 > 0.0) corner2 -= along * along / length2;
        furthest_mm = std::max(furthest_mm, std::sqrt(std::max(corner2, 0.0)));
    }
    return furthest_mm;
}

TEST(ProgramTube, HasNoCornerFurtherFromTheChordThanTheTolerance) {
    const MachineLimits limits = tube_limits(0.2);
    std::mt19937_64 random{11};
    double furthest_mm = 0.0;
    for (int round = 0; round < 300; ++round) {
        std::vector<PathPoint> points{{{30'000, 30'000, 0, 20'000}, 0, 0, false}};
        const auto axes = static_cast<unsigned>(1 + random() % 15);
        for (int i = 0; i < 7; ++i) {
            PathPoint point = points.back();
            for (std::size_t k = 0; k < kAxisCount; ++k)
                if ((axes >> k & 1U) != 0)
                    point.pulses[k] += static_cast<std::int64_t>(random() % 4001) - 2000;
            if (point.pulses != points.back().pulses) points.push_back(point);
        }
        for (const PathSpan& span : path_spans(limits, points)) {
            for (std::size_t head = 0; head < kHeads; ++head)
                furthest_mm = std::max(furthest_mm, furthest_corner_mm(limits, span, head));
        }
    }
    EXPECT_LE(furthest_mm, limits.path_tolerance_mm);
    EXPECT_GE(furthest_mm, 0.9 * limits.path_tolerance_mm);
}

// A tube that is too wide for one axis about two spans: the fitted curve uses it.
TEST(ProgramTube, IsNarrowedWhereTheCurveLeavesThePolylineByOneAxis) {
    const MachineLimits limits = tube_limits(0.005);
    for (const std::size_t axis : {std::size_t{0}, std::size_t{1}, kPsi, kY}) {
        const std::size_t along = axis == kY ? kPsi : kY;
        std::vector<PathPoint> points;
        for (std::int64_t i = 0; i < 13; ++i) {
            Pulses4 at{30'000, 30'000, 100, 20'000};
            at[along] += 150 * i;
            at[axis] += i == 6 ? 150 : 0;
            points.push_back({at, 0, static_cast<std::uint32_t>(i), false});
        }
        std::vector<PathSpan> spans = path_spans(limits, points);
        for (const std::size_t span : {std::size_t{5}, std::size_t{6}}) {
            spans[span].band[axis] *= 30.0;
            spans[span].begin_band[axis] = spans[span].end_band[axis] = spans[span].band[axis];
        }
        spans[4].end_band[axis] = spans[4].band[axis];
        const auto corners = path_corners(limits, spans);
        const CurveNodes nodes = curve_nodes(limits, points, spans, corners, 0, points.size() - 1);
        CurveFit fit({1e6, 1e6, 1e6, 1e6});
        fit.solve(NodesView::of(nodes));
        std::vector<PathCell> cells;
        std::vector<Lanes> cell_at;
        cells_of(nodes, fit.control(), cells, cell_at);
        const std::vector<PathSpan> before = spans;
        std::vector<std::uint32_t> narrowed;
        std::vector<std::uint32_t> stuck;
        narrow_where_outside(limits, points, {nodes, cells, cell_at}, {0, cells.size() - 1}, spans, narrowed,
                             stuck);
        EXPECT_TRUE(stuck.empty());
        EXPECT_NE(std::find(narrowed.begin(), narrowed.end(), 5U), narrowed.end()) << "axis " << axis;
        EXPECT_LT(spans[5].band[axis], before[5].band[axis]) << "axis " << axis;
    }
}

/// Points along psi, after `last` ones with a corner of R1 in the one behind.
std::vector<PathPoint> joined_points(std::size_t last, std::int64_t corner_pulses) {
    std::vector<PathPoint> points;
    for (std::size_t i = 0; i < 80; ++i) {
        const std::int64_t out = i > last + 1 ? corner_pulses : 0;
        points.push_back({{30'000 + out, 30'000, static_cast<std::int64_t>(400 * i), 20'000},
                          0,
                          static_cast<std::uint32_t>(i),
                          false});
    }
    return points;
}

// Decided control points make the same curve of the same nodes alone.
TEST(CurvePart, IsNotGoneOnFromWhereItsNodesAreOthersThanTheyWere) {
    constexpr std::size_t kTo = 40;
    const MachineLimits limits = tube_limits(0.02);
    const auto is_gone_on = [&limits](std::int64_t corner_pulses) {
        StretchPlanner sut(limits);
        const auto decide = [&](std::int64_t corner, std::size_t from, std::size_t to) {
            const auto points = joined_points(kTo, corner);
            const auto spans = path_spans(limits, points);
            CurvePart part;
            return sut.decide(points, spans, path_corners(limits, spans), {from, to, points.size() - 1},
                              part);
        };
        EXPECT_TRUE(decide(0, 0, kTo));
        return decide(corner_pulses, kTo, kTo + 20);
    };
    EXPECT_TRUE(is_gone_on(0));
    EXPECT_FALSE(is_gone_on(100));
}

}  // namespace
}  // namespace psicarve::plan
