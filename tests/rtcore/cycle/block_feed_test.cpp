// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/block_feed.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace psicarve::cycle {
namespace {

MotionBlock feed_block(BlockKind kind, std::uint32_t epoch, std::uint32_t group_blocks = 0) {
    MotionBlock block{};
    block.kind = kind;
    block.epoch = epoch;
    block.group_blocks = group_blocks;
    return block;
}

struct FeedRig {
    std::unique_ptr<BlockRing> ring = std::make_unique<BlockRing>();
    BlockFeed sut{*ring};
};

TEST(BlockFeed, HandsOutTheBlocksOfItsEpochInTheirOrder) {
    FeedRig rig;
    rig.sut.reset(7);
    for (const std::int64_t ticks : {11, 12}) {
        MotionBlock block = feed_block(BlockKind::dwell, 7);
        block.ticks = ticks;
        ASSERT_TRUE(rig.ring->push(block));
    }
    ASSERT_TRUE(rig.sut.take_first());
    EXPECT_EQ(rig.sut.block().ticks, 11);
    ASSERT_TRUE(rig.sut.take_first());
    EXPECT_EQ(rig.sut.block().ticks, 12);
    EXPECT_FALSE(rig.sut.take_first());
    EXPECT_EQ(rig.sut.block().ticks, 12);
}

TEST(BlockFeed, DropsBlocksOfOtherEpochsAndNoMoreThanSixtyFourATick) {
    FeedRig rig;
    rig.sut.reset(2);
    for (int i = 0; i < 64; ++i) ASSERT_TRUE(rig.ring->push(feed_block(BlockKind::move, 1)));
    ASSERT_TRUE(rig.ring->push(feed_block(BlockKind::outputs, 2)));
    EXPECT_FALSE(rig.sut.take_first());
    EXPECT_EQ(rig.ring->size(), 1U);
    ASSERT_TRUE(rig.sut.take_first());
    EXPECT_EQ(rig.sut.block().kind, BlockKind::outputs);
}

TEST(BlockFeed, WaitsForTheWholeGroupOfLinesOrSegments) {
    for (const BlockKind kind : {BlockKind::line, BlockKind::path}) {
        FeedRig rig;
        ASSERT_TRUE(rig.ring->push(feed_block(kind, 0, 3)));
        ASSERT_TRUE(rig.ring->push(feed_block(kind, 0)));
        EXPECT_FALSE(rig.sut.take_first());
        ASSERT_TRUE(rig.ring->push(feed_block(kind, 0)));
        EXPECT_TRUE(rig.sut.take_first());
    }
}

TEST(BlockFeed, WaitsForHalfAQueueOfALongerGroupAndForNoMove) {
    FeedRig rig;
    ASSERT_TRUE(rig.ring->push(feed_block(BlockKind::path, 0, 2 * kBlockRingEntries)));
    while (rig.ring->size() < kGroupStartBlocks - 1) rig.ring->push(feed_block(BlockKind::path, 0));
    EXPECT_FALSE(rig.sut.take_first());
    ASSERT_TRUE(rig.ring->push(feed_block(BlockKind::path, 0)));
    EXPECT_TRUE(rig.sut.take_first());

    FeedRig moves;
    ASSERT_TRUE(moves.ring->push(feed_block(BlockKind::move, 0, 3)));
    EXPECT_TRUE(moves.sut.take_first());
}

TEST(BlockFeed, TakesTheRestOfAGroupOneByOne) {
    FeedRig rig;
    for (std::uint32_t k = 0; k < 3; ++k) {
        MotionBlock block = feed_block(BlockKind::path, 0, k == 0 ? 3 : 0);
        block.point = k;
        ASSERT_TRUE(rig.ring->push(block));
    }
    ASSERT_TRUE(rig.sut.take_first());
    for (std::uint32_t k = 1; k < 3; ++k) {
        EXPECT_FALSE(rig.sut.is_last_of_group());
        ASSERT_NE(rig.sut.next_of_group(), nullptr);
        EXPECT_EQ(rig.sut.next_of_group()->point, k);
        ASSERT_TRUE(rig.sut.take_next_of_group());
        EXPECT_EQ(rig.sut.block().point, k);
    }
    EXPECT_TRUE(rig.sut.is_last_of_group());
}

// The block behind a group's end belongs to another: no axis turns for it ahead of time.
TEST(BlockFeed, ShowsNothingBehindTheGroup) {
    FeedRig rig;
    ASSERT_TRUE(rig.ring->push(feed_block(BlockKind::path, 0, 1)));
    ASSERT_TRUE(rig.ring->push(feed_block(BlockKind::path, 0, 1)));
    ASSERT_TRUE(rig.sut.take_first());
    EXPECT_TRUE(rig.sut.is_last_of_group());
    EXPECT_EQ(rig.sut.next_of_group(), nullptr);
}

/// A group of two that goes on, and of one that carries it on, all of it `next_blocks` long.
void push_joined(FeedRig& rig, std::uint32_t next_blocks, std::uint32_t next_epoch = 0) {
    for (const std::uint32_t group_blocks : {2U, 0U}) {
        MotionBlock block = feed_block(BlockKind::path, 0, group_blocks);
        block.joints = kGoesOn;
        ASSERT_TRUE(rig.ring->push(block));
    }
    MotionBlock next = feed_block(BlockKind::path, next_epoch, next_blocks);
    next.joints = kCarriesOn;
    next.point = 9;
    ASSERT_TRUE(rig.ring->push(next));
}

TEST(BlockFeed, GoesOnInTheNextGroupOnceAllOfItIsQueued) {
    FeedRig rig;
    push_joined(rig, 2);
    ASSERT_TRUE(rig.sut.take_first());
    EXPECT_TRUE(rig.sut.goes_on());
    EXPECT_FALSE(rig.sut.carries_on());
    EXPECT_FALSE(rig.sut.has_next_group());
    ASSERT_TRUE(rig.sut.take_next_of_group());
    EXPECT_EQ(rig.sut.next_of_group(), nullptr);
    EXPECT_FALSE(rig.sut.take_next_group());
    ASSERT_TRUE(rig.ring->push(feed_block(BlockKind::path, 0)));
    EXPECT_TRUE(rig.sut.has_next_group());
    ASSERT_NE(rig.sut.next_of_group(), nullptr);
    EXPECT_EQ(rig.sut.next_of_group()->point, 9U);
    ASSERT_TRUE(rig.sut.take_next_group());
    EXPECT_EQ(rig.sut.block().point, 9U);
    EXPECT_TRUE(rig.sut.carries_on());
    EXPECT_FALSE(rig.sut.goes_on());
    EXPECT_TRUE(rig.sut.take_next_of_group());
    EXPECT_TRUE(rig.sut.is_last_of_group());
}

TEST(BlockFeed, GoesOnInNoGroupOfAnotherPlan) {
    FeedRig rig;
    push_joined(rig, 1, 1);
    ASSERT_TRUE(rig.sut.take_first());
    EXPECT_FALSE(rig.sut.has_next_group());
}

TEST(BlockFeed, BreaksAGroupOffAtAnEmptyQueueAnotherEpochOrAnotherKind) {
    const MotionBlock others[] = {feed_block(BlockKind::path, 1), feed_block(BlockKind::line, 0)};
    for (const MotionBlock& other : others) {
        FeedRig rig;
        ASSERT_TRUE(rig.ring->push(feed_block(BlockKind::path, 0, 2)));
        ASSERT_TRUE(rig.ring->push(other));
        ASSERT_TRUE(rig.sut.take_first());
        EXPECT_EQ(rig.sut.next_of_group(), nullptr);
        EXPECT_FALSE(rig.sut.take_next_of_group());
        EXPECT_EQ(rig.sut.block().group_blocks, 2U) << "the block at hand stays";
        EXPECT_EQ(rig.ring->size(), 1U);
        rig.ring->pop();
        EXPECT_FALSE(rig.sut.take_next_of_group());
    }
}

TEST(BlockFeed, PausesForSoManyTicks) {
    FeedRig rig;
    ASSERT_TRUE(rig.ring->push(feed_block(BlockKind::move, 0)));
    rig.sut.pause(3);
    for (int tick = 0; tick < 3; ++tick) EXPECT_FALSE(rig.sut.take_first()) << tick;
    EXPECT_TRUE(rig.sut.take_first());
}

TEST(BlockFeed, LeavesNothingOfAPauseOrAGroupWhenThePlanIsDropped) {
    FeedRig rig;
    ASSERT_TRUE(rig.ring->push(feed_block(BlockKind::path, 0, 2)));
    ASSERT_TRUE(rig.ring->push(feed_block(BlockKind::path, 0)));
    ASSERT_TRUE(rig.ring->push(feed_block(BlockKind::move, 1)));
    ASSERT_TRUE(rig.sut.take_first());
    rig.sut.pause(1000);
    rig.sut.reset(1);
    EXPECT_TRUE(rig.sut.is_last_of_group());
    ASSERT_TRUE(rig.sut.take_first());
    EXPECT_EQ(rig.sut.block().epoch, 1U);
}

TEST(BlockFeed, TellsPointsOnceAndLengthensOneAxis) {
    FeedRig rig;
    MotionBlock block = feed_block(BlockKind::move, 0);
    block.reaches_points = 2;
    block.delta_pulses = {10, -10, 0, 0};
    ASSERT_TRUE(rig.ring->push(block));
    ASSERT_TRUE(rig.sut.take_first());
    EXPECT_EQ(rig.sut.take_points(), 2U);
    EXPECT_EQ(rig.sut.take_points(), 0U);
    rig.sut.lengthen(1, -5);
    const std::array<std::int64_t, kAxisCount> expected{10, -15, 0, 0};
    EXPECT_EQ(rig.sut.block().delta_pulses, expected);
}

}  // namespace
}  // namespace psicarve::cycle
