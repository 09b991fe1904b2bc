// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/replay/replay_clock.hpp"

#include <gtest/gtest.h>

namespace psicarve::replay {
namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;

TEST(ReplayClock, GoesOnAtTheChosenSpeedWhileItPlays) {
    ReplayClock sut;
    sut.begin(100 * kSecond_ns);
    sut.advance(kSecond_ns);
    EXPECT_EQ(sut.now_ns(), 0);
    sut.play();
    sut.advance(kSecond_ns);
    EXPECT_EQ(sut.now_ns(), kSecond_ns);
    sut.set_speed(10.0);
    sut.advance(kSecond_ns);
    EXPECT_EQ(sut.now_ns(), 11 * kSecond_ns);
    sut.pause();
    sut.advance(kSecond_ns);
    EXPECT_EQ(sut.now_ns(), 11 * kSecond_ns);
}

TEST(ReplayClock, RestsAtTheEndAndBeginsAnewFromThere) {
    ReplayClock sut;
    sut.begin(kSecond_ns);
    sut.set_speed(100.0);
    sut.play();
    sut.advance(kSecond_ns);
    EXPECT_EQ(sut.now_ns(), kSecond_ns);
    EXPECT_FALSE(sut.is_playing());
    sut.play();
    EXPECT_EQ(sut.now_ns(), 0);
    EXPECT_TRUE(sut.is_playing());
}

TEST(ReplayClock, StaysWithinTheRecording) {
    ReplayClock sut;
    sut.begin(kSecond_ns);
    sut.seek(5 * kSecond_ns);
    EXPECT_EQ(sut.now_ns(), kSecond_ns);
    sut.seek(-1);
    EXPECT_EQ(sut.now_ns(), 0);
    sut.begin(0);
    sut.play();
    EXPECT_FALSE(sut.is_playing());
}

TEST(ReplayClock, StepsThroughTheSpeedsAndStopsAtTheirEnds) {
    ReplayClock sut;
    for (int i = 0; i < 9; ++i) sut.faster();
    EXPECT_EQ(sut.speed(), kReplaySpeeds.back());
    sut.slower();
    EXPECT_EQ(sut.speed(), 10.0);
    for (int i = 0; i < 9; ++i) sut.slower();
    EXPECT_EQ(sut.speed(), kReplaySpeeds.front());
}

}  // namespace
}  // namespace psicarve::replay
