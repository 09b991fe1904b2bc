// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/limit_watch.hpp"

#include <gtest/gtest.h>

namespace psicarve::cycle {
namespace {

constexpr SignalWord kR1 = bit_of(Signal::r1_limit);
constexpr SignalWord kR2 = bit_of(Signal::r2_limit);
constexpr SignalWord kHeight = bit_of(Signal::y_limit);

TEST(LimitWatch, NamesTheFirstAxisWhoseLimitIsTripped) {
    const LimitWatch sut;
    EXPECT_EQ(sut.alarming_axis(0, kNoAxis), kNoAxis);
    EXPECT_EQ(sut.alarming_axis(kR1, kNoAxis), 0);
    EXPECT_EQ(sut.alarming_axis(kR2 | kHeight, kNoAxis), 1);
    EXPECT_EQ(sut.alarming_axis(kHeight, kNoAxis), 3);
}

TEST(LimitWatch, TakesIndexAndEmergencyStopForNoLimit) {
    const LimitWatch sut;
    EXPECT_EQ(sut.alarming_axis(kIndexBit | kEstopBit, kNoAxis), kNoAxis);
}

TEST(LimitWatch, LetsTheAxisThatIsHomedReachItsSensorAndNoOther) {
    const LimitWatch sut;
    EXPECT_EQ(sut.alarming_axis(kR2, 1), kNoAxis);
    EXPECT_EQ(sut.alarming_axis(kR2 | kHeight, 1), 3);
}

TEST(LimitWatch, ExemptsWhatIsTrippedAtTheBeginUntilItClears) {
    LimitWatch sut;
    sut.exempt(kR1 | kHeight | kEstopBit);
    EXPECT_EQ(sut.alarming_axis(kR1 | kHeight, kNoAxis), kNoAxis);
    EXPECT_EQ(sut.alarming_axis(kR1 | kR2, kNoAxis), 1);
    sut.note(kHeight);
    EXPECT_EQ(sut.alarming_axis(kR1, kNoAxis), 0) << "tripped anew";
    EXPECT_EQ(sut.alarming_axis(kHeight, kNoAxis), kNoAxis);
    sut.exempt(0);
    EXPECT_EQ(sut.alarming_axis(kHeight, kNoAxis), 3);
}

TEST(LimitWatch, ExemptsTheSensorOnWhichAnAxisWasStopped) {
    LimitWatch sut;
    sut.exempt(kR1);
    sut.exempt_axis(3, kR2 | kHeight);
    EXPECT_EQ(sut.alarming_axis(kR1 | kHeight, kNoAxis), kNoAxis);
    EXPECT_EQ(sut.alarming_axis(kR2, kNoAxis), 1);
    sut.exempt_axis(1, kR1);
    EXPECT_EQ(sut.alarming_axis(kR2, kNoAxis), 1) << "it was not tripped";
}

}  // namespace
}  // namespace psicarve::cycle
