// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/coasting.hpp"

#include <gtest/gtest.h>

namespace psicarve::cycle {
namespace {

struct CoastingRig {
    CoastingRig() {
        for (std::size_t k = 0; k < kAxisCount; ++k)
            config.axes[k].coast_ticks = 10 * (1 + static_cast<int>(k));
    }
    CycleConfig config;
    PulseStage pulses{config};
    Coasting sut{config, pulses};
};

TEST(Coasting, NoRotorTurnsBeforeItsFirstPulse) {
    const CoastingRig rig;
    EXPECT_EQ(rig.sut.axes(5), 0U);
    EXPECT_EQ(rig.sut.axis_lost_in(1'000'000, 5), kNoAxis);
    EXPECT_EQ(rig.sut.longest_harmless_gap(5), kAnyGap);
}

TEST(Coasting, ARotorTurnsForItsCoastTicks) {
    CoastingRig rig;
    rig.pulses.step(0b0010, 100);
    EXPECT_EQ(rig.sut.axes(100), 0b0010U);
    EXPECT_EQ(rig.sut.axes(120), 0b0010U);
    EXPECT_EQ(rig.sut.axes(121), 0U);
}

TEST(Coasting, AGapThatIsLongerThanARotorCoastsLosesItsSteps) {
    CoastingRig rig;
    rig.pulses.step(0b1010, 100);
    EXPECT_EQ(rig.sut.axis_lost_in(20, 101), kNoAxis);
    EXPECT_EQ(rig.sut.axis_lost_in(21, 101), 1);
    EXPECT_EQ(rig.sut.axis_lost_in(41, 101), 1) << "the first of them";
    EXPECT_EQ(rig.sut.axis_lost_in(41, 121), 3) << "axis 1 has come to rest";
}

TEST(Coasting, TheLongestHarmlessGapIsTheLongestThatLosesNoSteps) {
    for (const std::int64_t io_ticks : {0, 3}) {
        CoastingRig rig;
        rig.config.io_ticks = io_ticks;
        rig.pulses.step(0b1100, 100);
        const std::int64_t step_ticks = io_ticks > 0 ? io_ticks : 1;
        const auto gap = std::int64_t{rig.sut.longest_harmless_gap(100)};
        EXPECT_EQ(rig.sut.axis_lost_in((gap + 1) * step_ticks, 100), kNoAxis) << io_ticks;
        EXPECT_EQ(rig.sut.axis_lost_in((gap + 2) * step_ticks, 100), 2) << io_ticks;
    }
}

TEST(Coasting, NoGapIsHarmlessForARotorThatHardlyCoasts) {
    CoastingRig rig;
    rig.config.axes[0].coast_ticks = 0;
    rig.pulses.step(0b0001, 100);
    EXPECT_EQ(rig.sut.longest_harmless_gap(100), 0U);
}

}  // namespace
}  // namespace psicarve::cycle
