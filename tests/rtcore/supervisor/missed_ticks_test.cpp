// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/realtime/missed_ticks.hpp"

#include <gtest/gtest.h>

namespace psicarve::supervisor {
namespace {

using std::chrono::milliseconds;
constexpr MissedTicks::Time kStart{std::chrono::hours{1}};

TEST(MissedTicks, TellsOnceWhenMoreThanAllowedAreMissedInASecond) {
    MissedTicks sut{50};
    EXPECT_FALSE(sut.is_too_many(0, true, kStart));
    EXPECT_FALSE(sut.is_too_many(50, true, kStart + milliseconds{500}));
    EXPECT_TRUE(sut.is_too_many(51, true, kStart + milliseconds{600}));
    EXPECT_FALSE(sut.is_too_many(80, true, kStart + milliseconds{700}));
}

TEST(MissedTicks, FitIntoNoSecondIfTheyAreFarEnoughApart) {
    MissedTicks sut{50};
    EXPECT_FALSE(sut.is_too_many(0, true, kStart));
    for (int n = 1; n < 20; ++n) {
        EXPECT_FALSE(
            sut.is_too_many(static_cast<std::uint64_t>(n) * 50, true, kStart + n * milliseconds{1000}));
    }
}

TEST(MissedTicks, CountsTheSecondFromAnyMomentOn) {
    for (int begin_ms = 0; begin_ms < 1000; begin_ms += 50) {
        MissedTicks sut{50};
        EXPECT_FALSE(sut.is_too_many(0, true, kStart));
        EXPECT_FALSE(sut.is_too_many(40, true, kStart + milliseconds{begin_ms}));
        EXPECT_TRUE(sut.is_too_many(80, true, kStart + milliseconds{begin_ms + 900})) << begin_ms;
    }
}

TEST(MissedTicks, TellsOfAGapThatHeldUpTheWatcherAsWell) {
    MissedTicks sut{50};
    EXPECT_FALSE(sut.is_too_many(10, true, kStart));
    EXPECT_TRUE(sut.is_too_many(300, true, kStart + milliseconds{1500}));
}

TEST(MissedTicks, AtRestHarmNothingAndHideNothingThatFollows) {
    MissedTicks sut{50};
    EXPECT_FALSE(sut.is_too_many(0, false, kStart));
    EXPECT_FALSE(sut.is_too_many(1000, false, kStart + milliseconds{100}));
    EXPECT_FALSE(sut.is_too_many(1050, true, kStart + milliseconds{200}));
    EXPECT_TRUE(sut.is_too_many(1051, true, kStart + milliseconds{300}));
}

TEST(MissedTicks, NeverTellsWhenNoneAreTooMany) {
    MissedTicks sut{0};
    EXPECT_FALSE(sut.is_too_many(0, true, kStart));
    EXPECT_FALSE(sut.is_too_many(1'000'000, true, kStart + milliseconds{1}));
}

}  // namespace
}  // namespace psicarve::supervisor
