// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/curve_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "shared/base/units.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::plan {
namespace {

struct Fitted {
    MachineLimits limits;
    std::vector<PathPoint> points;
    std::vector<PathSpan> spans;
    std::vector<PathCorner> corners;
    CurveNodes nodes;
    CurveFit fit{Lanes{}};
};

Fitted fitted(std::vector<PathPoint> points, double tolerance_mm = 0.01) {
    Profile profile;
    profile.job.path_tolerance_mm = tolerance_mm;
    const MachineLimits limits = machine_limits(profile);
    Lanes accel;
    for (std::size_t k = 0; k < kAxisCount; ++k) accel[k] = limits.axes[k].accel_pps2;
    Fitted result{limits, std::move(points), {}, {}, {}, CurveFit{accel}};
    result.spans = path_spans(limits, result.points);
    result.corners = path_corners(limits, result.spans);
    result.nodes =
        curve_nodes(limits, result.points, result.spans, result.corners, 0, result.points.size() - 1);
    result.fit.solve(NodesView::of(result.nodes));
    return result;
}

std::vector<PathPoint> points_of(const std::vector<std::int64_t>& r1_pulses) {
    std::vector<PathPoint> points;
    for (std::size_t i = 0; i < r1_pulses.size(); ++i) {
        points.push_back({{r1_pulses[i], 5000, static_cast<std::int64_t>(7 * i), 0},
                          0,
                          static_cast<std::uint32_t>(i),
                          false});
    }
    return points;
}

/// The curve at node j, from its control points.
double value_at(const CurveNodes& nodes, const std::vector<Lanes>& control, std::size_t j, std::size_t k) {
    const double before = (control[j][k] - control[j - 1][k]) / nodes.control_step[j - 1];
    const double after = (control[j + 1][k] - control[j][k]) / nodes.control_step[j];
    const double bend = (after - before) / nodes.cell[j];
    const double d = nodes.offset[j];
    return control[j][k] + bend * (nodes.cell[j] * nodes.cell[j] / 8.0 + d * d / 2.0) +
           d * 0.5 * (before + after);
}

double bending(const CurveNodes& nodes, const std::vector<Lanes>& control, std::size_t k) {
    double sum = 0.0;
    for (std::size_t j = 1; j + 1 < control.size(); ++j) {
        const double before = (control[j][k] - control[j - 1][k]) / nodes.control_step[j - 1];
        const double after = (control[j + 1][k] - control[j][k]) / nodes.control_step[j];
        sum += (after - before) * (after - before) / nodes.cell[j];
    }
    return sum;
}

TEST(CurveFit, StaysWithinTheTubeAtEveryNode) {
    std::mt19937_64 random{17};
    for (int round = 0; round < 60; ++round) {
        std::vector<std::int64_t> radii;
        std::int64_t radius = 6000;
        const std::int64_t roughness = 1 + static_cast<std::int64_t>(random() % 60);
        for (int i = 0; i < 80; ++i) {
            radius += static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(2 * roughness + 1)) -
                      roughness;
            radii.push_back(radius);
        }
        const Fitted curve = fitted(points_of(radii));
        EXPECT_LT(curve.fit.iterations(), 40) << round;
        for (std::size_t j = 1; j + 1 < curve.nodes.step.size(); ++j) {
            for (std::size_t k = 0; k < kAxisCount; ++k) {
                const double value = value_at(curve.nodes, curve.fit.control(), j, k);
                ASSERT_GE(value, curve.nodes.low[j][k] - 0.03) << round << " " << j << " " << k;
                ASSERT_LE(value, curve.nodes.high[j][k] + 0.03) << round << " " << j << " " << k;
            }
        }
    }
}

TEST(CurveFit, PassesEveryPointWithinHalfAPulse) {
    std::vector<std::int64_t> radii;
    for (int i = 0; i < 200; ++i) {
        radii.push_back(round_to_pulse(6000.0 + 300.0 * std::sin(0.05 * i) + 40.0 * std::cos(0.31 * i)));
    }
    const Fitted curve = fitted(points_of(radii));
    int met = 0;
    for (std::size_t j = 1; j + 1 < curve.nodes.step.size(); ++j) {
        if (curve.nodes.point_at[j] == CurveNodes::kNoPoint) continue;
        const auto wanted = static_cast<double>(radii[curve.nodes.point_at[j]]);
        EXPECT_NEAR(value_at(curve.nodes, curve.fit.control(), j, 0), wanted, 0.5);
        ++met;
    }
    EXPECT_EQ(met, 198);
}

TEST(CurveFit, ASmoothTableLosesItsRounding) {
    // A wide arc, sampled and rounded: its own bending is 2e-4 of what the rounded points' polyline has.
    std::vector<std::int64_t> radii;
    for (int i = 0; i < 200; ++i) radii.push_back(round_to_pulse(6000.0 + 200.0 * std::sin(0.02 * i)));
    const Fitted curve = fitted(points_of(radii));
    double largest = 0.0;
    for (std::size_t j = 2; j + 2 < curve.nodes.step.size(); ++j) {
        const auto& control = curve.fit.control();
        const double before = (control[j][0] - control[j - 1][0]) / curve.nodes.control_step[j - 1];
        const double after = (control[j + 1][0] - control[j][0]) / curve.nodes.control_step[j];
        largest = std::max(largest, std::abs(after - before) / curve.nodes.cell[j]);
    }
    const double span = curve.spans[1].length;
    const double own = 200.0 * 0.02 * 0.02 / (span * span);
    EXPECT_LT(largest, 2.5 * own) << "rounding by half a pulse alone would be " << 1.0 / (span * span);
}

/// As bending(), each cell by its weight.
double weighted_bending(const CurveNodes& nodes, const std::vector<Lanes>& control, std::size_t k) {
    double sum = 0.0;
    for (std::size_t j = 1; j + 1 < control.size(); ++j) {
        const double before = (control[j][k] - control[j - 1][k]) / nodes.control_step[j - 1];
        const double after = (control[j + 1][k] - control[j][k]) / nodes.control_step[j];
        sum += nodes.weight[j][k] * (after - before) * (after - before) / nodes.cell[j];
    }
    return sum;
}

TEST(CurveFit, BendsWhereBendingWeighsLess) {
    std::mt19937_64 random{29};
    for (int round = 0; round < 20; ++round) {
        std::vector<std::int64_t> radii;
        radii.reserve(80);
        for (int i = 0; i < 80; ++i) radii.push_back(6000 + static_cast<std::int64_t>(random() % 40));
        Fitted curve = fitted(points_of(radii));
        const std::vector<Lanes> even = curve.fit.control();
        CurveNodes nodes = curve.nodes;
        for (Lanes& weight : nodes.weight) weight[0] = random() % 2 == 0 ? 0.25 : 1.0;
        curve.fit.solve(NodesView::of(nodes));
        const std::vector<Lanes>& weighted = curve.fit.control();
        EXPECT_LT(weighted_bending(nodes, weighted, 0), 0.99 * weighted_bending(nodes, even, 0)) << round;
        EXPECT_GT(bending(nodes, weighted, 0), bending(nodes, even, 0)) << round;
        // Other axes weigh what they did.
        EXPECT_NEAR(bending(nodes, weighted, 1), bending(nodes, even, 1), 1e-9);
        for (std::size_t j = 1; j + 1 < nodes.step.size(); ++j) {
            const double value = value_at(nodes, weighted, j, 0);
            ASSERT_GE(value, nodes.low[j][0] - 0.03) << round << " " << j;
            ASSERT_LE(value, nodes.high[j][0] + 0.03) << round << " " << j;
        }
    }
}

TEST(CurveFit, AWiderTubeNeverNeedsMoreBending) {
    std::mt19937_64 random{23};
    std::vector<std::int64_t> radii;
    for (int i = 0; i < 100; ++i) radii.push_back(6000 + static_cast<std::int64_t>(random() % 9));
    Fitted curve = fitted(points_of(radii));
    double last = 1e300;
    for (const double wider : {0.0, 0.5, 1.0, 2.0, 4.0}) {
        CurveNodes nodes = curve.nodes;
        for (std::size_t j = 1; j + 1 < nodes.step.size(); ++j) {
            nodes.low[j][0] -= wider;
            nodes.high[j][0] += wider;
        }
        curve.fit.solve(NodesView::of(nodes));
        const double now = bending(nodes, curve.fit.control(), 0);
        EXPECT_LE(now, last * 1.02) << wider;
        last = now;
    }
}

TEST(CurveFit, KeepsTheControlPointsThatAreDecided) {
    const Fitted curve = fitted(points_of({6000, 6010, 6015, 6013, 6007, 6004, 6009}));
    const std::vector<Lanes>& control = curve.fit.control();
    const std::vector<Lanes> first{control[0], control[1]};
    const std::vector<Lanes> last{control[control.size() - 2], control.back()};
    Lanes accel{};
    CurveFit again{accel};
    again.solve(NodesView::of(curve.nodes), {first, last});
    EXPECT_EQ(again.control()[0], first[0]);
    EXPECT_EQ(again.control()[1], first[1]);
    EXPECT_EQ(again.control()[control.size() - 2], last[0]);
    EXPECT_EQ(again.control().back(), last[1]);
    for (std::size_t j = 2; j + 2 < control.size(); ++j) {
        EXPECT_NEAR(again.control()[j][0], control[j][0], 0.5) << j;
    }
}

}  // namespace
}  // namespace psicarve::plan
