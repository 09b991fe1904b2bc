// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/braking.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

namespace psicarve::cycle {
namespace {

/// All axes alike; the plan is twice as fast at 200 %.
PathTiming timing_of(float free, float bend, double start2, double end2) {
    PathTiming timing{};
    timing.length = 1.0;
    timing.accel_free.fill(free);
    timing.accel_bend.fill(bend);
    timing.start_speed2 = {start2, 4.0 * start2};
    timing.end_speed2 = {end2, 4.0 * end2};
    return timing;
}

TEST(Braking, TakesWhatTheBendingLeaves) {
    const PathTiming timing = timing_of(100.0F, 4.0F, 2.0, 2.0);
    const double way = 2.0 * kSteeringShare;
    const double begin2 = braked_speed2(timing, 5.0);
    EXPECT_DOUBLE_EQ(begin2, (5.0 + way * 100.0) / (1.0 + way * 4.0));
    EXPECT_NEAR(begin2 - way * (100.0 - 4.0 * begin2), 5.0, 1e-9);
}

// Where the bending takes more than there is, as far as the bounds tell, what is known is the plan.
TEST(Braking, IsAlongThePlanWhereTheBendingLeavesNothing) {
    const PathTiming timing = timing_of(100.0F, 10.0F, 2.0, 7.5);
    EXPECT_DOUBLE_EQ(braked_speed2(timing, 20.0), 8.0 * (20.0 / 30.0));
    EXPECT_GT(braked_speed2(timing, 9.9), 9.9);
}

// An axis that may jump faster than the plan goes asks for no brake.
TEST(Braking, IsThePlanItselfWhereThatEndsSlowerThanAsked) {
    const PathTiming timing = timing_of(100.0F, 10.0F, 2.0, 7.5);
    EXPECT_GE(braked_speed2(timing, 50.0), 8.0);
    EXPECT_EQ(braked_speed2(timing, 50.0), braked_speed2(timing, 30.0));
}

TEST(Braking, AsksOfNoAxisMoreThanItHas) {
    std::mt19937_64 random(1);
    const auto between = [&](double least, double most) {
        return least + (most - least) * static_cast<double>(random() % 1'000'000) * 1e-6;
    };
    for (int n = 0; n < 200'000; ++n) {
        PathTiming timing = timing_of(0.0F, 0.0F, between(0.01, 1.0), between(0.01, 1.0));
        timing.length = between(1e-4, 0.1);
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            timing.accel_free[k] = static_cast<float>(std::pow(10.0, between(-1.0, 3.0)));
            timing.accel_bend[k] = static_cast<float>(random() % 3 == 0 ? 0.0 : between(0.0, 200.0));
        }
        const double end2 = between(0.0, 5.0);
        const double begin2 = braked_speed2(timing, end2);
        ASSERT_TRUE(std::isfinite(begin2) && begin2 >= 0.0);
        const double least2 = std::min(end2, timing.end_speed2[1]);
        const bool is_along_plan =
            std::any_of(timing.start_speed2.begin(), timing.start_speed2.end(), [&](const double& start2) {
                const double plan2 =
                    timing.end_speed2[static_cast<std::size_t>(&start2 - timing.start_speed2.data())];
                return std::abs(begin2 - start2 * least2 / plan2) <= 1e-12 * begin2;
            });
        if (is_along_plan) continue;
        ASSERT_GE(begin2, least2);
        const double slowing = (begin2 - least2) / (2.0 * timing.length);
        for (std::size_t k = 0; k < kAxisCount; ++k)
            ASSERT_LE(slowing + double{timing.accel_bend[k]} * begin2,
                      1.000001 * double{timing.accel_free[k]});
    }
}

}  // namespace
}  // namespace psicarve::cycle
