// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "shared/profile/profile.hpp"

namespace psicarve::plan {
namespace {

PathPoint at(std::int64_t r1, std::int64_t psi, std::int64_t y = 0) {
    return {{r1, 5000, psi, y}, 0, 0, false};
}

TEST(Path, ASpanIsAsLongAsTheMotorsNeedForIt) {
    const MachineLimits limits = machine_limits(Profile{});
    const std::vector<PathPoint> points{at(6000, 0), at(6000, 40)};
    const auto spans = path_spans(limits, points);
    EXPECT_DOUBLE_EQ(spans[0].length, 40.0 / limits.axes[2].speed_pps);
    EXPECT_DOUBLE_EQ(spans[0].slope[2], limits.axes[2].speed_pps);
    EXPECT_EQ(spans[0].slope[0], 0.0);
}

TEST(Path, TheTubeIsTheToleranceSquareToTheChord) {
    const MachineLimits limits = machine_limits(Profile{});
    const double tolerance_pulses = limits.path_tolerance_mm * limits.axes[0].pulses_per_unit;
    const auto flat = path_spans(limits, std::vector<PathPoint>{at(6000, 0), at(6000, 40)});
    EXPECT_LE(flat[0].band[0], tolerance_pulses);
    EXPECT_GE(flat[0].band[0], 0.7 * tolerance_pulses);
    const auto steep = path_spans(limits, std::vector<PathPoint>{at(6000, 0), at(6400, 7)});
    EXPECT_GT(steep[0].band[0], tolerance_pulses) << "along a flank R hardly leaves the chord";
    EXPECT_LT(steep[0].band[0], 400.0);
}

TEST(Path, AFlatRunHasNoCorner) {
    const MachineLimits limits = machine_limits(Profile{});
    const auto spans =
        path_spans(limits, std::vector<PathPoint>{at(6000, 0), at(6003, 7), at(6006, 14), at(6009, 21)});
    for (const PathCorner& corner : path_corners(limits, spans)) {
        EXPECT_FALSE(corner.is_stop);
        EXPECT_FALSE(corner.is_tight);
    }
}

// Three lobes over half a turn, at whole-pulse angles: with more points the pulses' rounding turns the way at
// every one.
TEST(Path, RoundingInADenseTableIsNoReasonToStop) {
    const MachineLimits limits = machine_limits(Profile{});
    constexpr std::int64_t kSweep = 3200;
    for (const std::int64_t steps : {500, 1600, 2000, 2400, 2900, 3200}) {
        std::vector<PathPoint> points;
        for (std::int64_t i = 0; i <= steps; ++i) {
            const std::int64_t psi = (i * kSweep + steps / 2) / steps;
            const double angle_rad = std::numbers::pi * static_cast<double>(psi) / kSweep;
            points.push_back(at(std::lround(6000.0 + 800.0 * std::cos(6.0 * angle_rad)), psi));
        }
        int stops = 0;
        for (const PathCorner& corner : path_corners(limits, path_spans(limits, points))) {
            stops += corner.is_stop ? 1 : 0;
        }
        EXPECT_EQ(stops, 0) << steps << " spans";
    }
}

TEST(Path, TurningTheTableBackIsAStop) {
    const MachineLimits limits = machine_limits(Profile{});
    const auto spans = path_spans(limits, std::vector<PathPoint>{at(6000, 0), at(6000, 40), at(6000, 0)});
    EXPECT_TRUE(path_corners(limits, spans)[0].is_stop);
}

TEST(Path, AStopIsLeftAtTheStartStopSpeedAndAtHalfOfItBackwards) {
    const MachineLimits limits = machine_limits(Profile{});
    const auto spans = path_spans(limits, std::vector<PathPoint>{at(6000, 0), at(6000, 40), at(6000, 0)});
    const double share = limits.axes[2].start_stop_pps / limits.axes[2].speed_pps;
    EXPECT_NEAR(stop_speed2(limits, spans[0].slope, nullptr), share * share, 1e-12);
    EXPECT_NEAR(stop_speed2(limits, spans[0].slope, &spans[1].slope), 0.25 * share * share, 1e-12);
}

}  // namespace
}  // namespace psicarve::plan
