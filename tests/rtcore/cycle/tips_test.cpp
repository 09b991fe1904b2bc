// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/tips.hpp"

#include <gtest/gtest.h>

namespace psicarve::cycle {
namespace {

Tips tips_with_gap(std::int64_t backlash_pulses) {
    CycleConfig config;
    config.axes[1].backlash_pulses = backlash_pulses;
    return Tips(config);
}

TEST(Tips, FollowEveryPulseOfAScrewWithoutAGap) {
    Tips sut(CycleConfig{});
    EXPECT_FALSE(sut.has_backlash());
    for (int n = 0; n < 5; ++n) sut.count_pulse(0, true);
    sut.count_pulse(0, false);
    sut.count_pulse(3, false);
    EXPECT_EQ(sut.positions(), (std::array<std::int64_t, kAxisCount>{4, 0, 0, -1}));
    EXPECT_EQ(sut.take_up_pulses(0, false), 0);
}

TEST(Tips, StayWhileAPulseOnlyCrossesTheGap) {
    Tips sut = tips_with_gap(3);
    EXPECT_TRUE(sut.has_backlash());
    sut.count_pulse(1, true);
    EXPECT_EQ(sut.positions()[1], 1) << "at first the flank that pushes up touches";
    for (std::int64_t left = 3; left > 0; --left) {
        EXPECT_EQ(sut.take_up_pulses(1, false), left);
        EXPECT_EQ(sut.take_up_pulses(1, true), 3 - left);
        sut.count_pulse(1, false);
        EXPECT_EQ(sut.positions()[1], 1);
    }
    sut.count_pulse(1, false);
    EXPECT_EQ(sut.positions()[1], 0);
}

TEST(Tips, GoBackWithinTheGapByAsManyPulsesAsTheyCameIn) {
    Tips sut = tips_with_gap(3);
    sut.count_pulse(1, false);
    sut.count_pulse(1, false);
    EXPECT_EQ(sut.take_up_pulses(1, true), 2);
    EXPECT_EQ(sut.take_up_pulses(1, false), 1);
    sut.count_pulse(1, true);
    sut.count_pulse(1, true);
    EXPECT_EQ(sut.positions()[1], 0);
    sut.count_pulse(1, true);
    EXPECT_EQ(sut.positions()[1], 1);
}

TEST(Tips, KeepTheirGapWhenTheirPositionIsDefinedAnew) {
    Tips sut = tips_with_gap(3);
    sut.count_pulse(1, false);
    sut.set_position(1, 500);
    EXPECT_EQ(sut.positions()[1], 500);
    EXPECT_EQ(sut.take_up_pulses(1, false), 2);
    EXPECT_EQ(sut.positions()[0], 0);
}

TEST(Tips, TellHowMuchOfEachGapIsCrossedDownwards) {
    Tips sut = tips_with_gap(3);
    EXPECT_EQ(sut.crossed_pulses(), (std::array<std::int64_t, kAxisCount>{}));
    sut.count_pulse(1, false);
    sut.count_pulse(1, false);
    EXPECT_EQ(sut.crossed_pulses(), (std::array<std::int64_t, kAxisCount>{0, 2, 0, 0}));
    for (int n = 0; n < 9; ++n) sut.count_pulse(1, false);
    EXPECT_EQ(sut.crossed_pulses(), (std::array<std::int64_t, kAxisCount>{0, 3, 0, 0}));
    for (std::size_t k = 0; k < kAxisCount; ++k) sut.rest_before(k, true, 0);
    EXPECT_EQ(sut.crossed_pulses(), (std::array<std::int64_t, kAxisCount>{}));
    for (std::size_t k = 0; k < kAxisCount; ++k) sut.rest_before(k, false, 0);
    EXPECT_EQ(sut.crossed_pulses(), (std::array<std::int64_t, kAxisCount>{0, 3, 0, 0}));
}

}  // namespace
}  // namespace psicarve::cycle
