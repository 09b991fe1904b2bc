// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/index_check.hpp"

#include <gtest/gtest.h>

namespace psicarve::cycle {
namespace {

CycleConfig index_at(std::int64_t position_pulses) {
    CycleConfig config;
    config.pulses_per_rev = 100;
    config.index_position_pulses = position_pulses;
    config.index_tolerance_pulses = 2;
    return config;
}

TEST(IndexCheck, FindsTheIndexInEveryTurn) {
    for (const std::int64_t turn : {-300, 0, 500}) {
        const IndexCheck up = check_index(index_at(30), turn + 30, true);
        EXPECT_EQ(up.off_pulses, 0) << turn;
        EXPECT_EQ(up.seen_pulses, turn + 30);
        const IndexCheck down = check_index(index_at(30), turn + 29, false);
        EXPECT_EQ(down.off_pulses, 0) << turn;
        EXPECT_EQ(down.seen_pulses, turn + 30);
    }
}

TEST(IndexCheck, IsRightWithinTheToleranceEitherWay) {
    for (std::int64_t off = -5; off <= 5; ++off) {
        const IndexCheck sut = check_index(index_at(30), 30 + off, true);
        EXPECT_EQ(sut.off_pulses, off);
        EXPECT_EQ(sut.is_right, off >= -2 && off <= 2) << off;
    }
}

TEST(IndexCheck, TakesTheShorterWayRound) {
    EXPECT_EQ(check_index(index_at(90), 10, true).off_pulses, 20);
    EXPECT_EQ(check_index(index_at(10), 90, true).off_pulses, -20);
    EXPECT_EQ(check_index(index_at(0), 50, true).off_pulses, 50);
    EXPECT_EQ(check_index(index_at(0), -51, true).off_pulses, 49);
}

}  // namespace
}  // namespace psicarve::cycle
