// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/tick_clock.hpp"

#include <gtest/gtest.h>

namespace psicarve::cycle {
namespace {

TEST(TickClock, LetsTimePassInWholePeriods) {
    TickClock sut(50'000);
    EXPECT_EQ(sut.tick(), 0U);
    EXPECT_EQ(sut.time_ns(), 0);
    sut.advance(1);
    sut.advance(10);
    EXPECT_EQ(sut.tick(), 11U);
    EXPECT_EQ(sut.time_ns(), 550'000);
}

TEST(TickClock, TellsWhatItShowedAndGoesOnUntouched) {
    TickClock sut(100'000);
    sut.advance(5);
    sut.count_missed(1);
    const TickClock::Instant earlier = sut.before(3);
    EXPECT_EQ(earlier.tick, 2U);
    EXPECT_EQ(earlier.time_ns, 200'000);
    EXPECT_EQ(sut.tick(), 5U);
    EXPECT_EQ(sut.time_ns(), 500'000);
    EXPECT_EQ(sut.missed(), 1U);
}

TEST(TickClock, CountsMissedTicksAndLetsNoTimePassByIt) {
    TickClock sut(100'000);
    sut.count_missed(3);
    sut.count_missed(4);
    EXPECT_EQ(sut.missed(), 7U);
    EXPECT_EQ(sut.tick(), 0U);
}

}  // namespace
}  // namespace psicarve::cycle
