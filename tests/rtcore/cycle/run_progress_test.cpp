// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/run_progress.hpp"

#include <gtest/gtest.h>

namespace psicarve::cycle {
namespace {

TEST(RunProgress, CountsPointsAndShowsTheLast) {
    RunProgress sut;
    sut.reach(0, 1, 1);
    sut.reach(2, 5, 3);
    EXPECT_EQ(sut.layer(), 2U);
    EXPECT_EQ(sut.point(), 5U);
    EXPECT_EQ(sut.points_reached(), 4U);
}

TEST(RunProgress, BeginsARunBehindThePointsBeforeIt) {
    RunProgress sut;
    sut.reach(7, 8, 9);
    sut.note_wait();
    sut.begin(100);
    EXPECT_EQ(sut.layer(), 0U);
    EXPECT_EQ(sut.point(), 0U);
    EXPECT_EQ(sut.waited_ticks(), 0U);
    sut.reach(10, 1, 1);
    EXPECT_EQ(sut.points_reached(), 101U);
}

TEST(RunProgress, CountsTheTicksThatThePinsKeptItWaiting) {
    RunProgress sut;
    sut.note_wait();
    sut.note_wait();
    EXPECT_EQ(sut.waited_ticks(), 2U);
    EXPECT_EQ(sut.points_reached(), 0U);
}

}  // namespace
}  // namespace psicarve::cycle
