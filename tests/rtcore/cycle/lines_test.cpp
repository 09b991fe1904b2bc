// SPDX-License-Identifier: GPL-3.0-or-later
// Groups of lines, as the executor walks them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "tests/rtcore/cycle/path_rig.hpp"

namespace psicarve::cycle {
namespace {

MotionBlock line_block(const Deltas& delta_pulses, std::uint32_t point = 0) {
    MotionBlock block{};
    block.kind = BlockKind::line;
    block.delta_pulses = delta_pulses;
    block.reaches_points = point > 0 ? 1 : 0;
    block.point = point;
    return block;
}

/// At one speed, an iteration every other tick.
std::vector<MotionBlock> as_group(std::vector<MotionBlock> blocks) {
    std::uint64_t iterations = 0;
    for (const MotionBlock& block : blocks) {
        std::int64_t longest = 0;
        for (const std::int64_t delta : block.delta_pulses) longest = std::max(longest, std::abs(delta));
        iterations += static_cast<std::uint64_t>(longest);
    }
    blocks = as_run(std::move(blocks));
    blocks.front().start_speed_per_s = 0.5 / kPathTick_s;
    blocks.front().max_speed_per_s = 0.5 / kPathTick_s;
    blocks.front().accel_per_s2 = 0.01 / (kPathTick_s * kPathTick_s);
    blocks.front().group_iterations = iterations;
    return blocks;
}

CycleConfig slow_to_turn() {
    CycleConfig config;
    config.dir_setup_ticks = 20;
    config.dir_hold_ticks = 20;
    return config;
}

TEST(Lines, EmitTheirPulsesAndReachTheirPoints) {
    PathRig sut;
    sut.program = as_group({line_block({3, 5, 0, 0}, 1), line_block({2, 0, 4, 1}, 2)});
    ASSERT_TRUE(sut.run());
    EXPECT_EQ(sut.pulses.positions(), (Deltas{5, 5, 4, 1}));
    ASSERT_EQ(sut.points.size(), 2U);
    EXPECT_EQ(sut.points[0].tick, sut.iterations[4].tick);
    EXPECT_EQ(sut.points[1].tick, sut.iterations[8].tick);
}

TEST(Lines, WithoutAPulseReachTheirPointsAndNoneTwice) {
    PathRig sut;
    std::vector<MotionBlock> blocks{line_block({1, 0, 0, 0}, 1)};
    for (std::uint32_t point = 2; point <= 21; ++point) blocks.push_back(line_block({0, 0, 0, 0}, point));
    sut.program = as_group(std::move(blocks));
    ASSERT_TRUE(sut.run());
    EXPECT_EQ(sut.executor.progress().points_reached(), 21U);
    EXPECT_EQ(sut.executor.progress().point(), 21U);
}

// The last iteration of a line may have to wait for the pins as any other. It was forgotten then: the line
// counted as done, its pulse went out within the next line or, at the group's end, never.
TEST(Lines, LoseNoPulseWhenThePinsKeepTheirLastIterationWaiting) {
    PathRig sut(slow_to_turn());
    sut.program = as_group({line_block({3, 0, 0, 0}, 1), line_block({-1, 0, 0, 0}, 2)});
    ASSERT_TRUE(sut.run());
    EXPECT_EQ(sut.pulses.positions()[0], 2);
    EXPECT_EQ(sut.pulses.emitted()[0], 4U);
    ASSERT_EQ(sut.iterations.size(), 4U);
    EXPECT_EQ(sut.points[1].tick, sut.iterations[3].tick) << "reached with its pulse, not before";
    EXPECT_GT(sut.executor.progress().waited_ticks(), 10U);
}

TEST(Lines, SendEachPulseTheWayOfItsOwnLine) {
    PathRig sut(slow_to_turn());
    sut.program =
        as_group({line_block({2, 0, 0, 0}, 1), line_block({-1, 0, 0, 0}, 2), line_block({4, 0, 0, 0}, 3)});
    ASSERT_TRUE(sut.run());
    EXPECT_EQ(sut.pulses.positions()[0], 5);
    EXPECT_EQ(sut.pulses.emitted()[0], 7U);
}

TEST(Lines, StarveWhenTheirGroupBreaksOff) {
    PathRig sut;
    sut.program = as_group({line_block({3, 0, 0, 0}, 1), line_block({1, 0, 0, 0}, 2)});
    sut.program[1].kind = BlockKind::path;
    EXPECT_FALSE(sut.run());
    EXPECT_NE(sut.seen & Executor::kStarved, 0U);
    EXPECT_EQ(sut.executor.axes_in_motion(), 0U);
}

}  // namespace
}  // namespace psicarve::cycle
