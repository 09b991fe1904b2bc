// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/homed_axes.hpp"

#include <gtest/gtest.h>

namespace psicarve::cycle {
namespace {

TEST(HomedAxes, KnowNoPositionAtFirst) {
    const HomedAxes sut;
    EXPECT_EQ(sut.mask(), 0);
    EXPECT_FALSE(sut.has_all());
    EXPECT_FALSE(sut.has_heads());
}

TEST(HomedAxes, AreAllOnceEachOfThemIsHomed) {
    HomedAxes sut;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        EXPECT_FALSE(sut.has_all()) << axis;
        EXPECT_FALSE(sut.has(axis)) << axis;
        sut.add(axis);
        EXPECT_TRUE(sut.has(axis)) << axis;
        EXPECT_EQ(sut.has_heads(), axis > 0) << axis;
    }
    EXPECT_TRUE(sut.has_all());
    EXPECT_EQ(sut.mask(), 0b1111);
}

TEST(HomedAxes, LoseThoseThatAreNamedAndNoOther) {
    HomedAxes sut;
    sut.add_all();
    sut.lose(0b0101);
    EXPECT_EQ(sut.mask(), 0b1010);
    EXPECT_FALSE(sut.has_heads());
    sut.lose(0b0001);
    EXPECT_EQ(sut.mask(), 0b1010);
    sut.lose_all();
    EXPECT_EQ(sut.mask(), 0);
}

TEST(HomedAxes, LetTableAndHeightBeHomedWithTheHeadsOrAfterThem) {
    for (std::uint32_t homed = 0; homed <= HomedAxes::kAll; ++homed) {
        HomedAxes sut;
        sut.add_all();
        sut.lose(~homed);
        for (std::uint32_t axes = 1; axes <= HomedAxes::kAll; ++axes) {
            const bool only_heads = axes <= 0b11;
            const bool are_heads_known = ((homed | axes) & 0b11U) == 0b11U;
            EXPECT_EQ(sut.may_home(axes), only_heads || are_heads_known) << homed << ' ' << axes;
        }
    }
}

}  // namespace
}  // namespace psicarve::cycle
