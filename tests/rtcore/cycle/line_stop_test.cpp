// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/line_stop.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "tests/rtcore/cycle/path_rig.hpp"

namespace psicarve::cycle {
namespace {

/// A feed whose block at hand is the first of these.
class LineStopOf : public ::testing::Test {
protected:
    void queue(std::vector<MotionBlock> run) {
        for (const MotionBlock& block : as_run(std::move(run))) ASSERT_TRUE(ring_->push(block));
        ASSERT_TRUE(feed_.take_first());
    }
    static MotionBlock block(double speed, bool ends_line = false) {
        MotionBlock made = path_block({0, 0, 4, 0}, 1.0, speed, speed);
        made.marks = ends_line ? kEndsLine : 0;
        return made;
    }
    /// Looks until it finds an end, or for long.
    bool finds() {
        for (int tick = 0; tick < 100; ++tick)
            if (sut_->look(feed_, LineStop::kBlocksPerTick)) return true;
        return false;
    }

    std::unique_ptr<BlockRing> ring_ = std::make_unique<BlockRing>();
    BlockFeed feed_{*ring_};
    std::unique_ptr<LineStop> sut_ = std::make_unique<LineStop>();
};

// x = 2as: at 1e-4 u/tick^2 from 0.2 u/tick in 200 segments of 1, at 97 %.
TEST_F(LineStopOf, BoundsWhatABrakeFromThePlanGoesThrough) {
    std::vector<MotionBlock> run(300, block(0.1));
    run[250].marks = kEndsLine;
    queue(run);
    ASSERT_TRUE(finds());
    const std::uint64_t first = feed_.number();
    EXPECT_FALSE(sut_->holds(first));
    EXPECT_TRUE(sut_->ends_at(first + 250));
    EXPECT_FALSE(sut_->holds(first + 251));
    const double per_tick2 = kPathTick_s * kPathTick_s;
    const auto bounds = sut_->bounds(first + 250);
    EXPECT_NEAR(bounds.end2 * per_tick2, 0.98 * 0.02 * 0.02, 1e-9);
    EXPECT_NEAR((bounds.begin2 - bounds.end2) * per_tick2, 0.97 * 2.0 * 1e-4, 1e-9);
    EXPECT_TRUE(sut_->holds(first + 60));
    EXPECT_FALSE(sut_->holds(first + 40)) << "200 % is 0.2 u a tick";
    EXPECT_EQ(sut_->bounds(first + 100).end2, sut_->bounds(first + 101).begin2);
}

TEST_F(LineStopOf, FindsTheNextEndWhereThatIsTooNear) {
    std::vector<MotionBlock> run(300, block(0.1));
    run[10].marks = kEndsLine;
    run[280].marks = kEndsLine;
    queue(run);
    ASSERT_TRUE(finds());
    EXPECT_TRUE(sut_->ends_at(feed_.number() + 10));
    EXPECT_TRUE(sut_->holds(feed_.number())) << "it has to brake already";
    sut_->seek_next(feed_);
    ASSERT_TRUE(finds());
    EXPECT_TRUE(sut_->ends_at(feed_.number() + 280));
}

// A brake from 0.2 u/tick takes 206 segments, and each look goes over all of them: an end that is one line
// further would be passed before it is known.
TEST_F(LineStopOf, CatchesUpWithAnEndHoweverShortTheLinesAre) {
    std::vector<MotionBlock> run(2000, block(0.1));
    for (std::size_t i = 2; i < run.size(); i += 3) run[i].marks = kEndsLine;
    queue(run);
    const double fastest2 = 0.2 * 0.2 / (kPathTick_s * kPathTick_s);
    const std::uint64_t first = feed_.number();
    for (int tick = 0; feed_.number() < first + 100; ++tick) {
        if (tick % 5 == 4 && !feed_.take_next_of_group()) break;
        if (!sut_->look(feed_, LineStop::kBlocksPerTick)) continue;
        if (!sut_->holds(feed_.number()) || sut_->bounds(feed_.number()).begin2 >= fastest2) break;
        sut_->seek_next(feed_);
    }
    std::uint64_t end = feed_.number();
    while (!sut_->ends_at(end) && end < first + 2000) ++end;
    EXPECT_GT(end - feed_.number(), 200U);
    EXPECT_LT(end - feed_.number(), 2 * 206U);
}

TEST_F(LineStopOf, LeavesTheEndOfARunToItsOwnRest) {
    std::vector<MotionBlock> run(20, block(0.1));
    run.back().marks = kEndsLine;
    queue(run);
    EXPECT_FALSE(finds());
    EXPECT_FALSE(sut_->holds(feed_.number()));
}

TEST_F(LineStopOf, LooksAtFewBlocksATick) {
    std::vector<MotionBlock> run(200, block(0.1));
    run[100].marks = kEndsLine;
    queue(run);
    int ticks = 1;
    while (!sut_->look(feed_, LineStop::kBlocksPerTick)) ++ticks;
    EXPECT_GE(ticks, 2 * 100 / LineStop::kBlocksPerTick);
    EXPECT_LE(ticks, 2 * 100 / LineStop::kBlocksPerTick + 2);
}

}  // namespace
}  // namespace psicarve::cycle
