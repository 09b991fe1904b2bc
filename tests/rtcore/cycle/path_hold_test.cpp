// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

#include "tests/rtcore/cycle/path_rig.hpp"
#include "tests/rtcore/cycle/timed_curve.hpp"

namespace psicarve::cycle {
namespace {

CurveLimits feed_bound() {
    CurveLimits limits;
    limits.feed = 0.12;
    return limits;
}

std::vector<std::uint32_t> order_of(const std::vector<Iteration>& iterations) {
    std::vector<std::uint32_t> order;
    order.reserve(iterations.size());
    for (const Iteration& iteration : iterations) order.push_back(iteration.axes);
    return order;
}

struct Course {
    std::vector<std::uint32_t> order;
    std::vector<std::uint32_t> points;
    Deltas positions;
    std::uint64_t ticks;
};

/// Runs the curve while hold, resume and override come at random; seed 0: undisturbed.
Course run_curve(const TimedCurve& curve, std::uint64_t seed) {
    PathRig rig;
    rig.program = curve.blocks();
    std::mt19937_64 random(seed);
    bool holds = false;
    std::uint64_t until = seed == 0 ? ~std::uint64_t{0} : random() % 3000;
    while ((rig.seen & Executor::kProgramEnd) == 0 && rig.now < 10'000'000) {
        rig.tick();
        if (rig.now < until) continue;
        until = rig.now + 1 + random() % 4000;
        holds = random() % 3 == 0;
        if (!holds) rig.executor.set_feed_ratio(static_cast<double>(10 + random() % 191) / 100.0);
        if (holds) {
            rig.executor.slow_down();
        } else {
            rig.executor.go_on();
        }
    }
    Course run{order_of(rig.iterations), {}, rig.pulses.positions(), rig.now};
    for (const Iteration& point : rig.points) run.points.push_back(point.axes);
    return run;
}

TEST(PathHold, LeavesTheMergedOrderOfIterationsAsItWas) {
    const TimedCurve curve(11, 600, feed_bound());
    const Course undisturbed = run_curve(curve, 0);
    ASSERT_GT(undisturbed.order.size(), 4800U);
    ASSERT_EQ(undisturbed.points.size(), 60U);
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        const Course disturbed = run_curve(curve, seed);
        ASSERT_EQ(disturbed.order, undisturbed.order) << "seed " << seed;
        EXPECT_EQ(disturbed.points, undisturbed.points) << "seed " << seed;
        EXPECT_EQ(disturbed.positions, undisturbed.positions) << "seed " << seed;
        EXPECT_NE(disturbed.ticks, undisturbed.ticks) << "seed " << seed;
    }
}

TEST(PathHold, StandsStillUntilItIsResumed) {
    const TimedCurve curve(12, 300, feed_bound());
    PathRig sut;
    sut.program = curve.blocks();
    while (sut.iterations.size() < 1000) sut.tick();
    sut.executor.slow_down();
    int ticks = 0;
    while ((sut.tick() & Executor::kAtRest) == 0 && ticks < 5000) ++ticks;
    ASSERT_LT(ticks, 2500);
    const std::size_t standing = sut.iterations.size();
    for (int n = 0; n < 1000; ++n) EXPECT_EQ(sut.tick(), Executor::kAtRest);
    EXPECT_EQ(sut.iterations.size(), standing);
    sut.executor.go_on();
    ASSERT_TRUE(sut.run());
    EXPECT_EQ(order_of(sut.iterations), run_curve(curve, 0).order);
}

TEST(PathHold, KeepsTheOverrideForTheTimeAfterIt) {
    const TimedCurve curve(13, 300, feed_bound());
    PathRig sut;
    sut.program = curve.blocks();
    while (sut.iterations.size() < 500) sut.tick();
    sut.executor.slow_down();
    while ((sut.tick() & Executor::kAtRest) == 0) {
    }
    sut.executor.set_feed_ratio(0.1);
    for (int n = 0; n < 100; ++n) EXPECT_EQ(sut.tick(), Executor::kAtRest);
    sut.executor.go_on();
    ASSERT_TRUE(sut.run());
    EXPECT_GT(sut.now, 5 * run_curve(curve, 0).ticks);
}

}  // namespace
}  // namespace psicarve::cycle
