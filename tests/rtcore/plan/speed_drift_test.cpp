// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/speed_drift.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "shared/profile/profile.hpp"

namespace psicarve::plan {
namespace {

TableLine line(std::int64_t r1, std::int64_t psi) {
    return {.delta_pulses = {r1, 0, psi, 0}, .radius_mm = {10.0, 10.0}, .layer = 0, .step = 0};
}

TEST(SpeedDrift, LeavesAnEvenRunAlone) {
    const MachineLimits limits = machine_limits(Profile{});
    const std::vector<TableLine> lines(200, line(3, 7));
    EXPECT_EQ(drift_limit_per_s(limits, lines), limits.max_iterations_per_s);
}

TEST(SpeedDrift, ASingleJointMayJumpByTheStartStopSpeed) {
    const MachineLimits limits = machine_limits(Profile{});
    const std::vector<TableLine> lines{line(0, 10), line(4, 10)};
    EXPECT_NEAR(drift_limit_per_s(limits, lines), limits.axes[0].start_stop_pps / 0.4, 1e-6);
}

// Each joint changes R1 by a tenth of the way's speed; ten of them in a row are a turn of the motor from rest
// to full.
TEST(SpeedDrift, ManySmallJointsThatGoOneWayAreAnAcceleration) {
    const MachineLimits limits = machine_limits(Profile{});
    std::vector<TableLine> lines;
    for (std::int64_t r = 0; r <= 8; ++r) lines.push_back(line(r, 10));
    const double speed = drift_limit_per_s(limits, lines);
    const double change_pps = speed * 0.8;
    const double seconds = 7.0 * 10.0 / speed;
    EXPECT_LE(change_pps, limits.axes[0].start_stop_pps + 0.5 * limits.axes[0].accel_pps2 * seconds + 1e-6);
    EXPECT_LT(speed, limits.axes[0].start_stop_pps / 0.1) << "slower than each joint by itself would ask";
}

TEST(SpeedDrift, HoldsForEveryPairItLooksAtInRandomRuns) {
    const MachineLimits limits = machine_limits(Profile{});
    std::mt19937_64 random{3};
    for (int round = 0; round < 200; ++round) {
        std::vector<TableLine> lines;
        for (int i = 0; i < 60; ++i) lines.push_back(line(static_cast<std::int64_t>(random() % 13) - 6, 7));
        const double speed = drift_limit_per_s(limits, lines);
        for (const std::size_t distance : {1U, 2U, 3U, 4U, 8U, 16U, 32U}) {
            for (std::size_t m = distance; m < lines.size(); ++m) {
                const auto& a = lines[m - distance].delta_pulses;
                const auto& b = lines[m].delta_pulses;
                const double change_pps = speed * std::fabs(static_cast<double>(b[0] - a[0])) / 7.0;
                const double seconds = 7.0 * static_cast<double>(distance - 1) / speed;
                ASSERT_LE(
                    change_pps,
                    (limits.axes[0].start_stop_pps + 0.5 * limits.axes[0].accel_pps2 * seconds) * 1.000001);
            }
        }
    }
}

TEST(SpeedDrift, IgnoresLinesWithoutAPulse) {
    const MachineLimits limits = machine_limits(Profile{});
    const std::vector<TableLine> lines{line(0, 0), line(3, 7), line(0, 0), line(3, 7)};
    EXPECT_EQ(drift_limit_per_s(limits, lines), limits.max_iterations_per_s);
}

}  // namespace
}  // namespace psicarve::plan
