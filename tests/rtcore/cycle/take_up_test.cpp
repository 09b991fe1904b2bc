// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/take_up.hpp"

#include <gtest/gtest.h>

namespace psicarve::cycle {
namespace {

constexpr std::int64_t kTakeUpGap_pulses = 12;

/// R1 and psi have gaps, R2 and Y none.
CycleConfig gap_config() {
    CycleConfig config;
    for (AxisConfig& axis : config.axes) {
        axis.start_stop_per_tick = 0.05;
        axis.speed_per_tick = 0.2;
        axis.accel_per_tick2 = 0.01;
    }
    config.axes[0].backlash_pulses = kTakeUpGap_pulses;
    config.axes[2].backlash_pulses = 5;
    return config;
}

MotionBlock block_along(const std::array<std::int64_t, kAxisCount>& delta_pulses) {
    MotionBlock block{};
    block.delta_pulses = delta_pulses;
    return block;
}

struct TakeUpRig {
    explicit TakeUpRig(const CycleConfig& cycle_config = gap_config()) : config(cycle_config) {}

    bool begin(const MotionBlock& block, std::uint32_t still_axes = 0) {
        return sut.begin(block, still_axes, now);
    }
    /// Ticks until the gaps are crossed.
    int cross() {
        int ticks = 0;
        for (; sut.is_on() && ticks < 100'000; ++ticks) {
            pulses.begin_tick(++now);
            sut.step(now, false);
        }
        return ticks;
    }

    CycleConfig config;
    PulseStage pulses{config};
    TakeUp sut{config, pulses};
    std::uint64_t now = 0;
};

// At first the tips rest against the flank that pushes them up: slack 0.
TEST(TakeUp, CrossesTheGapOfAnAxisThatTurnsRoundWhileNoTipMoves) {
    TakeUpRig rig;
    EXPECT_FALSE(rig.begin(block_along({5, 5, 5, 5})));
    EXPECT_FALSE(rig.sut.is_on());
    ASSERT_TRUE(rig.begin(block_along({-5, 0, 0, 0})));
    EXPECT_TRUE(rig.sut.is_on());
    EXPECT_GT(rig.cross(), 0);
    const std::array<std::uint64_t, kAxisCount> emitted{kTakeUpGap_pulses, 0, 0, 0};
    EXPECT_EQ(rig.pulses.emitted(), emitted);
    EXPECT_EQ(rig.pulses.positions(), (std::array<std::int64_t, kAxisCount>{}));
    EXPECT_FALSE(rig.begin(block_along({-5, 0, 0, 0}))) << "it is crossed";
    ASSERT_TRUE(rig.begin(block_along({5, 0, 0, 0}))) << "and must be again the other way";
    rig.cross();
    EXPECT_EQ(rig.pulses.positions(), (std::array<std::int64_t, kAxisCount>{}));
    EXPECT_EQ(rig.pulses.take_up_pulses(0, true), 0);
}

TEST(TakeUp, LeavesScrewsWithoutAGapAlone) {
    TakeUpRig rig;
    EXPECT_FALSE(rig.begin(block_along({0, -5, 0, -5})));
    TakeUpRig none(CycleConfig{});
    EXPECT_FALSE(none.begin(block_along({-5, -5, -5, -5})));
}

// A run's first block names axes that turn later in it: those gaps are crossed before the run, at rest.
TEST(TakeUp, CrossesGapsThatABlockAnnounces) {
    TakeUpRig rig;
    MotionBlock block = block_along({0, 0, -3, 0});
    block.down_axes = 0b0001;
    ASSERT_TRUE(rig.begin(block));
    rig.cross();
    EXPECT_EQ(rig.pulses.emitted()[0], static_cast<std::uint64_t>(kTakeUpGap_pulses));
    EXPECT_EQ(rig.pulses.emitted()[2], 5U);
    block = block_along({0, 0, 0, 0});
    block.up_axes = 0b0001;
    EXPECT_TRUE(rig.begin(block));
}

TEST(TakeUp, CrossesNoGapOfAnAxisThatGoesBothWaysOrStandsStill) {
    TakeUpRig rig;
    MotionBlock block = block_along({-3, 0, 0, 0});
    block.up_axes = 0b0001;
    EXPECT_FALSE(rig.begin(block)) << "which of both is not known";
    EXPECT_FALSE(rig.begin(block_along({-3, 0, 0, 0}), 0b0001));
    EXPECT_TRUE(rig.begin(block_along({-3, 0, -3, 0}), 0b0001));
    rig.cross();
    EXPECT_EQ(rig.pulses.emitted()[0], 0U);
    EXPECT_EQ(rig.pulses.emitted()[2], 5U);
}

TEST(TakeUp, SaysOnceThatTheGapsAreCrossed) {
    TakeUpRig rig;
    ASSERT_TRUE(rig.begin(block_along({-1, 0, 0, 0})));
    int said = 0;
    for (int tick = 0; tick < 1000 && rig.sut.is_on(); ++tick) {
        rig.pulses.begin_tick(++rig.now);
        said += rig.sut.step(rig.now, false) ? 1 : 0;
        EXPECT_EQ(rig.sut.is_on(), said == 0);
    }
    EXPECT_EQ(said, 1);
}

TEST(TakeUp, TakesLongerWithASmallerShareOfItsSpeed) {
    TakeUpRig planned;
    planned.begin(block_along({-1, 0, 0, 0}));
    TakeUpRig slow;
    slow.sut.set_ratio(0.25);
    slow.begin(block_along({-1, 0, 0, 0}));
    EXPECT_GT(slow.cross(), 2 * planned.cross());
}

TEST(TakeUp, EndsWhereItIsWhenThePlanIsDropped) {
    TakeUpRig rig;
    rig.begin(block_along({-1, 0, 0, 0}));
    rig.sut.end();
    EXPECT_FALSE(rig.sut.is_on());
    EXPECT_EQ(rig.cross(), 0);
}

TEST(TakeUp, ShowsItsOwnWayAgainAfterAnother) {
    TakeUpRig rig;
    rig.begin(block_along({-1, 0, 0, 0}));
    rig.pulses.begin_tick(rig.now = 10);
    EXPECT_FALSE(rig.pulses.is_positive(0));
    rig.pulses.want_directions({1, 0, 0, 0}, 20);
    rig.pulses.begin_tick(30);
    ASSERT_TRUE(rig.pulses.is_positive(0));
    rig.sut.want_directions(40);
    rig.pulses.begin_tick(50);
    EXPECT_FALSE(rig.pulses.is_positive(0));
}

TEST(TakeUp, TellsByHowMuchAWayBecomesLonger) {
    TakeUpRig rig;
    EXPECT_EQ(rig.sut.extra_pulses(0, 7), 0);
    EXPECT_EQ(rig.sut.extra_pulses(0, -7), -kTakeUpGap_pulses);
    EXPECT_EQ(rig.sut.extra_pulses(0, 0), 0);
    EXPECT_EQ(rig.sut.extra_pulses(1, -7), 0);
    rig.begin(block_along({-1, 0, 0, 0}));
    rig.cross();
    EXPECT_EQ(rig.sut.extra_pulses(0, 7), kTakeUpGap_pulses);
}

}  // namespace
}  // namespace psicarve::cycle
