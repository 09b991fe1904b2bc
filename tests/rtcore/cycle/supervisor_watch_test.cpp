// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/supervisor_watch.hpp"

#include <gtest/gtest.h>

namespace psicarve::cycle {
namespace {

constexpr std::int64_t kTick_ns = 1'000'000;
constexpr int kTicksOfSilence = 1000;

int ticks_until_silent(SupervisorWatch& sut, std::uint64_t rounds, int most_ticks) {
    for (int tick = 1; tick <= most_ticks; ++tick) {
        if (sut.falls_silent(rounds, kTick_ns)) return tick;
    }
    return 0;
}

TEST(SupervisorWatch, TellsASilenceOfMoreThanASecondOnce) {
    SupervisorWatch sut;
    ASSERT_FALSE(sut.falls_silent(7, kTick_ns));
    EXPECT_EQ(ticks_until_silent(sut, 7, 5 * kTicksOfSilence), kTicksOfSilence + 1);
    EXPECT_EQ(ticks_until_silent(sut, 7, 5 * kTicksOfSilence), 0);
}

TEST(SupervisorWatch, HearsEveryRoundAndCountsAnew) {
    SupervisorWatch sut;
    for (std::uint64_t rounds = 1; rounds < 5; ++rounds) {
        ASSERT_FALSE(sut.falls_silent(rounds, kTick_ns));
        ASSERT_EQ(ticks_until_silent(sut, rounds, kTicksOfSilence), 0);
    }
    EXPECT_TRUE(sut.falls_silent(4, kTick_ns));
    ASSERT_FALSE(sut.falls_silent(5, kTick_ns));
    EXPECT_EQ(ticks_until_silent(sut, 5, 5 * kTicksOfSilence), kTicksOfSilence + 1) << "and tells it again";
}

TEST(SupervisorWatch, MissesNoSupervisorThatCountsNoRounds) {
    SupervisorWatch sut;
    EXPECT_EQ(ticks_until_silent(sut, 0, 5 * kTicksOfSilence), 0);
}

}  // namespace
}  // namespace psicarve::cycle
