// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/linear_profile.hpp"
#include "tests/thoroughness.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace psicarve::cycle {
namespace {

struct Course {
    std::vector<double> speeds;
    std::uint64_t iterations = 0;
};

Course run(double start, double max, double accel, std::uint64_t iterations) {
    LinearProfile sut;
    sut.start(start, max, accel, iterations);
    Course result;
    const auto most_ticks = static_cast<std::uint64_t>(static_cast<double>(iterations) / start) + 10;
    while (sut.iterations_left() > 0 && result.speeds.size() < most_ticks) {
        sut.advance(false);
        result.speeds.push_back(sut.speed());
        while (sut.is_due()) {
            sut.take();
            ++result.iterations;
        }
    }
    return result;
}

TEST(LinearProfile, EmitsTheLastPulseOfEveryLengthBetweenStartAndTopSpeed) {
    const std::uint64_t longest = test::is_thorough() ? 4000 : 1000;
    for (std::uint64_t length = 1; length <= longest; ++length) {
        const Course sut = run(0.02, 0.2, 0.0001, length);
        ASSERT_EQ(sut.iterations, length);
        for (const double speed : sut.speeds) {
            ASSERT_GE(speed, 0.02) << "length " << length;
            ASSERT_LE(speed, 0.2) << "length " << length;
        }
    }
}

TEST(LinearProfile, ObeysItsLimitsForAnyParameters) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    const int rounds = test::is_thorough() ? 2000 : 200;
    for (int round = 0; round < rounds; ++round) {
        const double max = 0.001 + 0.499 * part(random);
        const double start = max * (0.01 + 0.99 * part(random));
        const double accel = max * (1e-4 + 0.2 * part(random));
        const std::uint64_t length = 1 + random() % 2000;
        const Course sut = run(start, max, accel, length);
        ASSERT_EQ(sut.iterations, length);
        double before = start;
        for (const double speed : sut.speeds) {
            ASSERT_GE(speed, start);
            ASSERT_LE(speed, max);
            ASSERT_LE(std::fabs(speed - before), accel * (1.0 + 1e-9));
            before = speed;
        }
    }
}

TEST(LinearProfile, SlowsDownAsLongAsItSpedUpAndEndsAtStartSpeed) {
    for (const std::uint64_t length : {50U, 333U, 2000U, 9999U}) {
        const Course sut = run(0.02, 0.2, 0.0001, length);
        const double top = *std::max_element(sut.speeds.begin(), sut.speeds.end());
        std::int64_t rising = 0;
        std::int64_t falling = 0;
        for (std::size_t i = 1; i < sut.speeds.size(); ++i) {
            rising += sut.speeds[i] > sut.speeds[i - 1] ? 1 : 0;
            falling += sut.speeds[i] < sut.speeds[i - 1] ? 1 : 0;
        }
        EXPECT_NEAR(static_cast<double>(rising), static_cast<double>(falling), 2.0) << "length " << length;
        EXPECT_GT(top, 0.02);
        EXPECT_NEAR(sut.speeds.back(), 0.02, 0.0002) << "length " << length;
    }
}

TEST(LinearProfile, TakesAsLongAsContinuousMotionWouldWithinATick) {
    // 4000 iterations: ramps of (0.2^2 - 0.02^2) / 2a = 198 each, 1800 ticks each.
    const Course sut = run(0.02, 0.2, 0.0001, 4000);
    EXPECT_NEAR(static_cast<double>(sut.speeds.size()), 2 * 1800.0 + (4000.0 - 2 * 198.0) / 0.2, 4.0);
}

TEST(LinearProfile, ReachesStartSpeedAfterAHoldAndClimbsAgain) {
    LinearProfile sut;
    sut.start(0.02, 0.2, 0.001, 1000);
    const auto pass = [&](bool must_slow) {
        sut.advance(must_slow);
        if (sut.is_due()) sut.take();
    };
    for (int tick = 0; tick < 150; ++tick) pass(false);
    for (int tick = 0; !sut.is_slowest() && tick < 1000; ++tick) pass(true);
    ASSERT_TRUE(sut.is_slowest());
    ASSERT_GT(sut.iterations_left(), 900U);
    for (int tick = 0; tick < 150; ++tick) pass(false);
    EXPECT_GT(sut.speed(), 0.15);
    for (int tick = 0; sut.iterations_left() > 0 && tick < 10000; ++tick) pass(false);
    EXPECT_EQ(sut.iterations_left(), 0U);
}

TEST(LinearProfile, KeepsToAPartOfItsTopSpeedAndStillEndsAtItsEnd) {
    std::mt19937_64 random(12);
    for (int round = 0; round < 300; ++round) {
        LinearProfile sut;
        sut.start(0.02, 0.2, 0.001, 200 + random() % 2000);
        const std::uint64_t length = sut.iterations_left();
        std::uint64_t iterations = 0;
        double ratio = 1.0;
        double before = sut.speed();
        for (int tick = 0; sut.iterations_left() > 0 && tick < 400'000; ++tick) {
            if (random() % 150 == 0) ratio = 0.1 + static_cast<double>(random() % 91) / 100.0;
            sut.set_ratio(ratio);
            // A ratio that allows V start again may be jumped to.
            before = std::max(before, std::min(0.02, 0.2 * ratio));
            sut.advance(false);
            ASSERT_LE(std::fabs(sut.speed() - before), 0.001 * (1.0 + 1e-9));
            ASSERT_LE(sut.speed(), std::max(0.2 * ratio, before));
            before = sut.speed();
            for (; sut.is_due(); ++iterations) sut.take();
        }
        ASSERT_EQ(iterations, length);
        ASSERT_LE(sut.speed(), 0.021);
    }
}

}  // namespace
}  // namespace psicarve::cycle
