// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/alarm.hpp"

#include <gtest/gtest.h>

namespace psicarve::cycle {
namespace {

TEST(Alarm, IsNoneUntilOneIsRaisedAndAfterItIsReset) {
    Alarm sut;
    EXPECT_EQ(sut.cause(), AlarmCause::none);
    EXPECT_EQ(sut.axis(), kNoAxis);
    sut.raise(AlarmCause::limit, 3);
    EXPECT_EQ(sut.cause(), AlarmCause::limit);
    EXPECT_EQ(sut.axis(), 3);
    sut.reset();
    EXPECT_EQ(sut.cause(), AlarmCause::none);
    EXPECT_EQ(sut.axis(), kNoAxis);
}

TEST(Alarm, IsNotRaisedWhileItIsAwaited) {
    Alarm sut;
    sut.await_rest(AlarmCause::supervisor_stalled);
    EXPECT_EQ(sut.awaited(), AlarmCause::supervisor_stalled);
    EXPECT_EQ(sut.cause(), AlarmCause::none);
}

TEST(Alarm, AwaitsNothingOnceOneIsRaisedOrThePlanIsDropped) {
    Alarm sut;
    sut.await_rest(AlarmCause::supervisor_stalled);
    sut.forget_awaited();
    EXPECT_EQ(sut.awaited(), AlarmCause::none);
    sut.await_rest(AlarmCause::supervisor_stalled);
    sut.raise(AlarmCause::emergency_stop, kNoAxis);
    EXPECT_EQ(sut.awaited(), AlarmCause::none);
    EXPECT_EQ(sut.cause(), AlarmCause::emergency_stop);
}

}  // namespace
}  // namespace psicarve::cycle
