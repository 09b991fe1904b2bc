// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/missed_ticks.hpp"

#include <gtest/gtest.h>

namespace psicarve::supervisor {
namespace {

using Time = std::chrono::steady_clock::time_point;
constexpr Time kStart{std::chrono::hours{1}};

TEST(MissedTicks, TellsOnceWhenMoreThanAllowedAreMissedInASecond) {
    MissedTicks sut{50};
    EXPECT_FALSE(sut.is_too_many(0, kStart));
    EXPECT_FALSE(sut.is_too_many(50, kStart + std::chrono::milliseconds{500}));
    EXPECT_TRUE(sut.is_too_many(51, kStart + std::chrono::milliseconds{600}));
    EXPECT_FALSE(sut.is_too_many(80, kStart + std::chrono::milliseconds{700}));
}

TEST(MissedTicks, CountsEachSecondAnew) {
    MissedTicks sut{50};
    EXPECT_FALSE(sut.is_too_many(0, kStart));
    EXPECT_FALSE(sut.is_too_many(40, kStart + std::chrono::milliseconds{900}));
    EXPECT_FALSE(sut.is_too_many(40, kStart + std::chrono::milliseconds{1100}));
    EXPECT_FALSE(sut.is_too_many(80, kStart + std::chrono::milliseconds{1200}));
    EXPECT_TRUE(sut.is_too_many(91, kStart + std::chrono::milliseconds{1300}));
}

TEST(MissedTicks, TellsOfAGapThatHeldUpTheWatcherAsWell) {
    MissedTicks sut{50};
    EXPECT_FALSE(sut.is_too_many(10, kStart));
    EXPECT_TRUE(sut.is_too_many(300, kStart + std::chrono::milliseconds{1500}));
}

TEST(MissedTicks, NeverTellsWhenNoneAreTooMany) {
    MissedTicks sut{0};
    EXPECT_FALSE(sut.is_too_many(0, kStart));
    EXPECT_FALSE(sut.is_too_many(1'000'000, kStart + std::chrono::milliseconds{1}));
}

}  // namespace
}  // namespace psicarve::supervisor
