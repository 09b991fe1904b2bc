// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <vector>

#include "tests/rtcore/cycle/path_rig.hpp"

namespace psicarve::cycle {
namespace {

/// Ticks from a segment's begin until u = way, from the speeds alone.
long double ticks_to(const PathTiming& timing, long double way) {
    const long double start2 = timing.start_speed2[0];
    const long double end2 = timing.end_speed2[0];
    const long double there2 = start2 + (end2 - start2) * way / timing.length;
    return 2.0L * way / (std::sqrt(start2) + std::sqrt(there2)) / kPathTick_s;
}

std::int64_t iterations_of(const MotionBlock& block) {
    std::int64_t most = 0;
    for (const std::int64_t delta : block.delta_pulses) most = std::max(most, std::abs(delta));
    return most;
}

/// The instant at which each iteration of a run is due [ticks from its start].
std::vector<long double> due_ticks(const std::vector<MotionBlock>& run) {
    std::vector<long double> due;
    long double begin = 0.0L;
    for (const MotionBlock& block : run) {
        if (block.kind != BlockKind::path) break;
        const std::int64_t iterations = iterations_of(block);
        for (std::int64_t n = 1; n <= iterations; ++n) {
            const long double part = static_cast<long double>(n) / static_cast<long double>(iterations);
            due.push_back(begin + ticks_to(block.path, part * block.path.length));
        }
        begin += ticks_to(block.path, block.path.length);
    }
    return due;
}

/// Segments of any speed up to 0.4 iterations a tick, none pulse-free, all axes forwards.
std::vector<MotionBlock> random_run(std::uint64_t seed, int segments) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    std::vector<MotionBlock> run;
    double speed = 0.01;
    for (int i = 0; i < segments; ++i) {
        const Deltas delta{static_cast<std::int64_t>(random() % 30), static_cast<std::int64_t>(random() % 30),
                           static_cast<std::int64_t>(1 + random() % 30),
                           static_cast<std::int64_t>(random() % 3)};
        const auto pulses = static_cast<double>(std::max({delta[0], delta[1], delta[2], delta[3]}));
        const double end_speed = 0.01 + 0.37 * part(random);
        // One u is `scale` iterations: the parameter is not a length.
        const double scale = 0.8 + 0.2 * part(random);
        run.push_back(path_block(delta, pulses * scale, speed, end_speed));
        run.back().reaches_points = 1;
        run.back().point = static_cast<std::uint32_t>(i + 1);
        speed = end_speed;
    }
    return as_run(run);
}

TEST(PathSegments, EmitExactlyTheirPulsesEachIterationAtItsTick) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        PathRig sut;
        sut.program = random_run(seed, 200);
        ASSERT_TRUE(sut.run());
        const std::vector<long double> due = due_ticks(sut.program);
        ASSERT_EQ(sut.iterations.size(), due.size());
        for (std::size_t i = 0; i < due.size(); ++i) {
            const auto at = static_cast<long double>(sut.iterations[i].tick - sut.start_tick);
            ASSERT_GE(at, due[i] - 1e-6L) << "seed " << seed << " iteration " << i;
            ASSERT_LT(at, due[i] + 1.0L) << "seed " << seed << " iteration " << i;
        }
        Deltas total{};
        for (const MotionBlock& block : sut.program) {
            for (std::size_t k = 0; k < kAxisCount; ++k) total[k] += block.delta_pulses[k];
        }
        EXPECT_EQ(sut.pulses.positions(), total);
    }
}

TEST(PathSegments, ReportEachPointWithItsLastIteration) {
    PathRig sut;
    sut.program = random_run(7, 100);
    ASSERT_TRUE(sut.run());
    ASSERT_EQ(sut.points.size(), 100U);
    std::size_t last = 0;
    for (std::size_t i = 0; i < sut.points.size(); ++i) {
        last += static_cast<std::size_t>(iterations_of(sut.program[i]));
        EXPECT_EQ(sut.points[i].axes, i + 1);
        EXPECT_EQ(sut.points[i].tick, sut.iterations[last - 1].tick);
    }
    EXPECT_EQ(sut.executor.progress().points_reached(), 100U);
}

// Each lasts 2.37... ticks, a number that no double holds exactly.
TEST(PathSegments, DoNotAddUpWhatIsFinerThanATickOverAMillionOfThem) {
    PathRig sut;
    std::vector<MotionBlock> run(1'000'000, path_block({1, 0, 0, 0}, 0.71, 0.3, 0.3));
    const long double each = ticks_to(run.front().path, run.front().path.length);
    sut.program = as_run(std::move(run));
    ASSERT_TRUE(sut.run());
    ASSERT_EQ(sut.iterations.size(), 1'000'000U);
    for (std::size_t i = 0; i < sut.iterations.size(); ++i) {
        const auto at = static_cast<long double>(sut.iterations[i].tick - sut.start_tick);
        const long double due = each * static_cast<long double>(i + 1);
        ASSERT_GE(at, due - 1e-6L) << i;
        ASSERT_LT(at, due + 1.0L) << i;
    }
}

// 8 kHz at 50 us: a pulse every 2.5 ticks, now after two, now after three, and never further from an even
// beat than the tick that it waits for, whatever the other axes do meanwhile.
TEST(PathSegments, RunAnAxisAtEightKilohertzWithoutRipple) {
    std::mt19937_64 random(8);
    std::vector<MotionBlock> run;
    for (int i = 0; i < 2000; ++i) {
        const auto pulses = static_cast<std::int64_t>(1 + random() % 40);
        run.push_back(
            path_block({pulses, pulses - pulses / 7, pulses / 3, 0}, static_cast<double>(pulses), 0.4, 0.4));
    }
    PathRig sut;
    sut.program = as_run(std::move(run));
    ASSERT_TRUE(sut.run());
    for (std::size_t i = 1; i < sut.iterations.size(); ++i) {
        ASSERT_NE(sut.iterations[i].axes & 1U, 0U) << i;
        const std::uint64_t apart = sut.iterations[i].tick - sut.iterations[i - 1].tick;
        ASSERT_TRUE(apart == 2 || apart == 3) << i << ": " << apart;
        const double beat = 2.5 * static_cast<double>(i + 1);
        const auto at = static_cast<double>(sut.iterations[i].tick - sut.start_tick);
        ASSERT_GE(at, beat - 1e-6) << i;
        ASSERT_LT(at, beat + 1.0 + 1e-6) << i;
    }
}

TEST(PathSegments, WithoutAPulseTakeTheirTime) {
    PathRig sut;
    sut.program = as_run({path_block({5, 0, 0, 0}, 5.0, 0.25, 0.25), path_block({}, 3.3, 0.25, 0.5),
                          path_block({}, 0.1, 0.5, 0.5), path_block({}, 0.1, 0.5, 0.25),
                          path_block({5, 0, 0, 0}, 5.0, 0.25, 0.25)});
    ASSERT_TRUE(sut.run());
    // 20 ticks; then 3.3 / 0.375 = 8.8, 0.2 and 0.2667 ticks; then 4 ticks each.
    std::vector<std::uint64_t> ticks;
    for (const Iteration& iteration : sut.iterations) ticks.push_back(iteration.tick - sut.start_tick);
    EXPECT_EQ(ticks, (std::vector<std::uint64_t>{4, 8, 12, 16, 20, 34, 38, 42, 46, 50}));
}

TEST(PathSegments, StartWhenTheRunOrHalfTheRingIsQueued) {
    PathRig sut;
    std::vector<MotionBlock> run(20, path_block({2, 0, 0, 0}, 2.0, 0.2, 0.2));
    sut.program = as_run(run);
    sut.program.resize(19);
    for (int n = 0; n < 50; ++n) sut.tick();
    EXPECT_EQ(sut.seen, Executor::kNothing);
    sut.program.push_back(run.back());
    sut.tick();
    EXPECT_EQ(sut.seen, Executor::kGroupStarted);
}

TEST(PathSegments, AreAnAlarmWhenTheNextOneIsNotThere) {
    PathRig sut;
    std::vector<MotionBlock> run(kGroupStartBlocks, path_block({1, 0, 0, 0}, 1.0, 0.2, 0.2));
    run.front().group_blocks = kGroupStartBlocks + 1;
    sut.program = run;
    EXPECT_FALSE(sut.run(1'000'000));
    EXPECT_NE(sut.seen & Executor::kStarved, 0U);
    EXPECT_EQ(sut.pulses.positions()[0], static_cast<std::int64_t>(kGroupStartBlocks));
}

TEST(PathSegments, AreAnAlarmWhenOneWouldNeverEnd) {
    const MotionBlock good = path_block({3, 0, 0, 0}, 3.0, 0.2, 0.2);
    MotionBlock standing = good;
    standing.path.start_speed2[0] = standing.path.end_speed2[0] = 0.0;
    MotionBlock unknown = good;
    unknown.path.length = std::numeric_limits<double>::quiet_NaN();
    for (const MotionBlock& bad : {standing, unknown}) {
        for (const std::vector<MotionBlock>& run :
             {std::vector<MotionBlock>{bad, good}, std::vector<MotionBlock>{good, bad}}) {
            PathRig sut;
            sut.program = as_run(run);
            EXPECT_FALSE(sut.run(1000));
            EXPECT_NE(sut.seen & Executor::kStarved, 0U);
        }
    }
}

// Every segment turns R1 round, and its pin has to be set five ticks ahead: Psi's iterations wait for it.
TEST(PathSegments, MakeUpForTheirWaitsForADirection) {
    CycleConfig config;
    config.dir_setup_ticks = 5;
    PathRig sut(config);
    std::vector<MotionBlock> run;
    run.reserve(1000);
    for (int i = 0; i < 1000; ++i) {
        run.push_back(path_block({i % 2 == 0 ? 10 : -10, 0, 10, 0}, 10.0, 0.3, 0.3));
    }
    sut.program = as_run(run);
    ASSERT_TRUE(sut.run());
    EXPECT_EQ(sut.iterations.size(), 10'000U);
    const std::vector<long double> due = due_ticks(sut.program);
    const auto lateness = [&](std::size_t i) {
        return static_cast<long double>(sut.iterations[i].tick - sut.start_tick) - due[i];
    };
    EXPECT_GT(lateness(10), 1.0L);
    EXPECT_LT(lateness(9'999), 3.0L);
}

// R1 turns round after a segment in which it stands still: that is when its pin turns.
TEST(PathSegments, TurnAnAxisAheadWhileItStandsStill) {
    CycleConfig config;
    config.dir_setup_ticks = 5;
    PathRig sut(config);
    sut.program =
        as_run({path_block({10, 0, 10, 0}, 10.0, 0.3, 0.3), path_block({0, 0, 10, 0}, 10.0, 0.3, 0.3),
                path_block({-10, 0, 10, 0}, 10.0, 0.3, 0.3), path_block({0, 0, 10, 0}, 10.0, 0.3, 0.3),
                path_block({10, 0, 10, 0}, 10.0, 0.3, 0.3)});
    ASSERT_TRUE(sut.run());
    EXPECT_EQ(sut.pulses.positions(), (Deltas{10, 0, 50, 0}));
    // The first one waits for the pins as they stood before the run.
    EXPECT_LT(sut.executor.progress().waited_ticks(), 4U);
    const std::vector<long double> due = due_ticks(sut.program);
    for (std::size_t i = 10; i < due.size(); ++i) {
        EXPECT_LT(static_cast<long double>(sut.iterations[i].tick - sut.start_tick), due[i] + 1.0L) << i;
    }
}

TEST(PathSegments, FallBehindRatherThanBurstWhenAWaitIsLong) {
    CycleConfig config;
    config.dir_setup_ticks = 100;
    PathRig sut(config);
    sut.program =
        as_run({path_block({10, 0, 0, 0}, 10.0, 0.3, 0.3), path_block({-10, 0, 0, 0}, 10.0, 0.3, 0.3)});
    ASSERT_TRUE(sut.run());
    // Two waits of 100 ticks, at the start and at the turn; after each, one iteration is made up for.
    int close = 0;
    for (std::size_t i = 1; i < sut.iterations.size(); ++i) {
        close += sut.iterations[i].tick - sut.iterations[i - 1].tick <= 2 ? 1 : 0;
    }
    EXPECT_LE(close, 6);
    EXPECT_GT(sut.iterations.back().tick - sut.start_tick, 200U);
}

}  // namespace
}  // namespace psicarve::cycle
