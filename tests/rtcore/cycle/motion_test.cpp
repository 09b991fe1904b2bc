// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/motion.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace psicarve::cycle {
namespace {

using MotionWay = std::array<std::int64_t, kAxisCount>;

CycleConfig motion_config() {
    CycleConfig config;
    for (AxisConfig& axis : config.axes) {
        axis.start_stop_per_tick = 0.02;
        axis.speed_per_tick = 0.2;
        axis.accel_per_tick2 = 0.002;
        axis.travel_max_pulses = 100'000;
        axis.coast_ticks = 50;
    }
    config.lift_pulses = {30, 30};
    config.lower_speed_per_tick = {0.1, 0.1};
    config.rest_ticks = 5;
    return config;
}

struct MotionRig {
    CycleConfig config = motion_config();
    std::unique_ptr<CycleIo> io = std::make_unique<CycleIo>();
    PulseStage pulses{config};
    Inputs inputs{config};
    Motion sut{config, *io, pulses, inputs};
    std::uint64_t now = 0;
    Motion::Progress seen = 0;

    /// A plan of one move, asked for and given.
    void plan(const MotionWay& way, double feed_ratio = 1.0, std::uint32_t still_axes = 0) {
        ASSERT_TRUE(sut.ask(PlanRequest{}, feed_ratio, still_axes));
        PlanRequest request{};
        ASSERT_TRUE(io->plan_requests.pop_into(request));
        give(way, request.epoch);
    }
    void give(const MotionWay& way, std::uint32_t epoch) {
        const double period_s = static_cast<double>(config.interpolation_ns()) * 1e-9;
        MotionBlock block{};
        block.kind = BlockKind::move;
        block.epoch = epoch;
        block.delta_pulses = way;
        block.start_speed_per_s = 0.02 / period_s;
        block.max_speed_per_s = 0.2 / period_s;
        block.accel_per_s2 = 0.002 / (period_s * period_s);
        ASSERT_TRUE(io->blocks.push(block));
        MotionBlock end{};
        end.kind = BlockKind::program_end;
        end.epoch = epoch;
        ASSERT_TRUE(io->blocks.push(end));
    }
    /// Ticks until this happens; false when it does not.
    bool run_until(Motion::Progress what, int most_ticks = 20'000) {
        for (int n = 0; n < most_ticks; ++n) {
            pulses.begin_tick(++now);
            const Motion::Progress progress = sut.step(now);
            seen |= progress;
            if ((progress & what) != 0) return true;
        }
        return false;
    }
    void run(int ticks) { run_until(0, ticks); }
};

TEST(Motion, AsksThePlannerFromWhereTheTipsAreAndFollowsTheAnswer) {
    MotionRig rig;
    rig.pulses.set_position(0, 1000);
    PlanRequest wanted{};
    wanted.kind = PlanKind::finish;
    ASSERT_TRUE(rig.sut.ask(wanted, 1.0, 0));
    PlanRequest request{};
    ASSERT_TRUE(rig.io->plan_requests.pop_into(request));
    EXPECT_EQ(request.kind, PlanKind::finish);
    EXPECT_EQ(request.position_pulses[0], 1000);
    rig.give({40, 0, 0, 0}, request.epoch);
    ASSERT_TRUE(rig.run_until(Executor::kGroupStarted));
    EXPECT_EQ(rig.sut.axes_on_their_way(), 0b0001U);
    ASSERT_TRUE(rig.run_until(Executor::kProgramEnd));
    EXPECT_EQ(rig.pulses.positions()[0], 1040);
    EXPECT_EQ(rig.sut.axes_on_their_way(), 0U);
}

TEST(Motion, SaysWhenThePlannerTakesNothingMore) {
    MotionRig rig;
    int asked = 0;
    while (asked < 1000 && rig.sut.ask(PlanRequest{}, 1.0, 0)) ++asked;
    EXPECT_EQ(asked, static_cast<int>(PlanRequestRing::capacity()));
}

TEST(Motion, ExecutesNothingOfADroppedPlan) {
    MotionRig rig;
    rig.plan({40, 0, 0, 0});
    ASSERT_TRUE(rig.run_until(Executor::kGroupStarted));
    rig.run(50);
    const MotionWay there = rig.pulses.positions();
    EXPECT_GT(there[0], 0);
    rig.sut.drop();
    rig.run(1000);
    EXPECT_EQ(rig.pulses.positions(), there);
    EXPECT_EQ(rig.seen & Executor::kProgramEnd, 0U);
    rig.plan({0, 7, 0, 0});
    ASSERT_TRUE(rig.run_until(Executor::kProgramEnd));
    EXPECT_EQ(rig.pulses.positions(), (MotionWay{there[0], 7, 0, 0}));
}

TEST(Motion, KeepsTheAxesStillThatAreToStandStillAndGoesAtTheFeedThatIsAsked) {
    MotionRig rig;
    rig.plan({40, 40, 40, 0}, 1.0, 0b0011);
    ASSERT_TRUE(rig.run_until(Executor::kProgramEnd));
    EXPECT_EQ(rig.pulses.positions(), (MotionWay{0, 0, 40, 0}));
    const std::uint64_t begin = rig.now;
    rig.plan({0, 0, 40, 0}, 1.0);
    ASSERT_TRUE(rig.run_until(Executor::kProgramEnd));
    const std::uint64_t planned = rig.now - begin;
    rig.plan({0, 0, 40, 0}, 0.25);
    ASSERT_TRUE(rig.run_until(Executor::kProgramEnd));
    EXPECT_GT(rig.now - begin - planned, planned * 3 / 2);
}

TEST(Motion, HoldsAtRestAndResumesTheSameWay) {
    MotionRig rig;
    rig.plan({400, 0, 0, 0});
    rig.run(300);
    rig.sut.hold();
    ASSERT_TRUE(rig.run_until(Executor::kAtRest));
    const MotionWay there = rig.pulses.positions();
    rig.run(100);
    EXPECT_EQ(rig.pulses.positions(), there);
    EXPECT_FALSE(rig.sut.are_heads_lifted());
    rig.sut.resume();
    ASSERT_TRUE(rig.run_until(Executor::kProgramEnd));
    EXPECT_EQ(rig.pulses.positions()[0], 400);
}

TEST(Motion, TakesTheHeadsOutAndBackBeforeItGoesOn) {
    MotionRig rig;
    rig.plan({400, 0, 0, 0});
    rig.run(300);
    rig.sut.hold();
    ASSERT_TRUE(rig.run_until(Executor::kAtRest));
    const MotionWay there = rig.pulses.positions();
    rig.sut.lift();
    EXPECT_TRUE(rig.sut.are_heads_lifted());
    ASSERT_TRUE(rig.run_until(Motion::kLifted));
    EXPECT_EQ(rig.pulses.positions(), (MotionWay{there[0] + 30, there[1] + 30, 0, 0}));
    rig.sut.resume();
    while (rig.sut.are_heads_lifted()) rig.run(1);
    EXPECT_EQ(rig.pulses.positions(), there);
    ASSERT_TRUE(rig.run_until(Executor::kProgramEnd));
    EXPECT_EQ(rig.pulses.positions()[0], 400);
}

TEST(Motion, TurnsHeadsRoundThatAreHeldOnTheirWayBack) {
    MotionRig rig;
    rig.plan({400, 0, 0, 0});
    rig.run(300);
    rig.sut.hold();
    ASSERT_TRUE(rig.run_until(Executor::kAtRest));
    const MotionWay there = rig.pulses.positions();
    rig.sut.lift();
    ASSERT_TRUE(rig.run_until(Motion::kLifted));
    rig.sut.resume();
    rig.run(150);
    ASSERT_LT(rig.pulses.positions()[0], there[0] + 30);
    rig.sut.hold();
    ASSERT_TRUE(rig.run_until(Motion::kLifted));
    EXPECT_EQ(rig.pulses.positions()[0], there[0] + 30);
}

TEST(Motion, SlowsDownForGoodWhereverTheHeadsAre) {
    MotionRig rig;
    rig.plan({400, 0, 0, 0});
    rig.run(300);
    rig.sut.hold();
    ASSERT_TRUE(rig.run_until(Executor::kAtRest));
    rig.sut.lift();
    rig.run(60);
    rig.sut.slow_down();
    ASSERT_TRUE(rig.run_until(Executor::kAtRest));
    EXPECT_FALSE(rig.sut.are_heads_lifted());
    const MotionWay there = rig.pulses.positions();
    rig.run(500);
    EXPECT_EQ(rig.pulses.positions(), there);
}

TEST(Motion, ForgetsLiftedHeadsWithThePlan) {
    MotionRig rig;
    rig.plan({400, 0, 0, 0});
    rig.run(300);
    rig.sut.hold();
    ASSERT_TRUE(rig.run_until(Executor::kAtRest));
    rig.sut.lift();
    rig.sut.drop();
    EXPECT_FALSE(rig.sut.are_heads_lifted());
}

TEST(Motion, TellsWhichRotorsMayStillTurn) {
    MotionRig rig;
    EXPECT_EQ(rig.sut.coasting().axes(1), 0U);
    rig.plan({0, 40, 0, 0});
    ASSERT_TRUE(rig.run_until(Executor::kProgramEnd));
    EXPECT_EQ(rig.sut.coasting().axes(rig.now), 0b0010U);
    rig.run(100);
    EXPECT_EQ(rig.sut.coasting().axes(rig.now), 0U);
}

}  // namespace
}  // namespace psicarve::cycle
