// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/keyboard_jog.hpp"

#include <gtest/gtest.h>

namespace psicarve::session {
namespace {

using Kind = KeyboardJog::Order::Kind;
constexpr KeyboardJog::Clock::time_point kNow{std::chrono::hours{1}};

class ArmedKeys : public ::testing::Test {
protected:
    ArmedKeys() { sut.arm(kNow); }
    Kind press(JogKey key) { return sut.press({key}, kNow).kind; }
    KeyboardJog sut;
};

TEST(JogKeys, EachHasItsAxisAndWay) {
    EXPECT_EQ(way_of(JogKey::left, false), (JogWay{Axis::psi, false}));
    EXPECT_EQ(way_of(JogKey::right, true), (JogWay{Axis::psi, true}));
    EXPECT_EQ(way_of(JogKey::up, false), (JogWay{Axis::y, true}));
    EXPECT_EQ(way_of(JogKey::down, false), (JogWay{Axis::y, false}));
    EXPECT_EQ(way_of(JogKey::page_up, false), (JogWay{Axis::r1, true}));
    EXPECT_EQ(way_of(JogKey::page_down, false), (JogWay{Axis::r1, false}));
    EXPECT_EQ(way_of(JogKey::page_up, true), (JogWay{Axis::r2, true}));
    EXPECT_EQ(way_of(JogKey::page_down, true), (JogWay{Axis::r2, false}));
}

TEST(KeyboardJog, DoesNothingUnlessItIsArmed) {
    KeyboardJog sut;
    EXPECT_EQ(sut.press({JogKey::up}, kNow).kind, Kind::none);
    EXPECT_EQ(sut.release(JogKey::up, false, kNow).kind, Kind::none);
    EXPECT_FALSE(sut.is_over(kNow + std::chrono::hours{1}));
}

TEST_F(ArmedKeys, HoldUntilTheKeyIsLetGo) {
    const auto order = sut.press({JogKey::up}, kNow);
    EXPECT_EQ(order.kind, Kind::hold);
    EXPECT_EQ(order.way, (JogWay{Axis::y, true}));
    EXPECT_EQ(sut.release(JogKey::up, false, kNow).kind, Kind::release);
    EXPECT_EQ(sut.release(JogKey::up, false, kNow).kind, Kind::none);
}

TEST_F(ArmedKeys, IgnoreTheKeyboardsOwnRepeats) {
    EXPECT_EQ(sut.press({JogKey::up, false, false, true}, kNow).kind, Kind::none);
    EXPECT_EQ(press(JogKey::up), Kind::hold);
    for (int i = 0; i < 5; ++i) {
        EXPECT_EQ(sut.release(JogKey::up, true, kNow).kind, Kind::none);
        EXPECT_EQ(sut.press({JogKey::up, false, false, true}, kNow).kind, Kind::none);
    }
    EXPECT_TRUE(sut.is_held());
    EXPECT_EQ(sut.release(JogKey::up, false, kNow).kind, Kind::release);
}

TEST_F(ArmedKeys, ASecondKeyEndsTheMotionAndBeginsNone) {
    EXPECT_EQ(press(JogKey::left), Kind::hold);
    EXPECT_EQ(press(JogKey::up), Kind::release);
    EXPECT_EQ(sut.release(JogKey::left, false, kNow).kind, Kind::none);
    EXPECT_EQ(sut.release(JogKey::up, false, kNow).kind, Kind::none);
    EXPECT_EQ(press(JogKey::up), Kind::hold);
}

TEST_F(ArmedKeys, GoOnAfterCtrlIsLetGoAndEndWithTheKey) {
    EXPECT_EQ(sut.press({JogKey::page_up, true}, kNow).way, (JogWay{Axis::r2, true}));
    EXPECT_EQ(sut.release(JogKey::page_up, false, kNow).kind, Kind::release);
}

TEST_F(ArmedKeys, StepWithShift) {
    const auto order = sut.press({JogKey::right, false, true}, kNow);
    EXPECT_EQ(order.kind, Kind::step);
    EXPECT_FALSE(sut.is_held());
}

TEST_F(ArmedKeys, AreDisarmedWithAReleaseOnlyWhenSomethingIsHeld) {
    EXPECT_EQ(sut.disarm().kind, Kind::none);
    sut.arm(kNow);
    (void)press(JogKey::down);
    EXPECT_EQ(sut.disarm().kind, Kind::release);
    EXPECT_FALSE(sut.is_armed());
    EXPECT_EQ(press(JogKey::down), Kind::none);
}

TEST_F(ArmedKeys, AreOverWhenNobodyPressesOneForHalfAMinute) {
    EXPECT_FALSE(sut.is_over(kNow + std::chrono::seconds{29}));
    EXPECT_TRUE(sut.is_over(kNow + std::chrono::seconds{30}));
    (void)sut.press({JogKey::up, false, true}, kNow + std::chrono::seconds{29});
    EXPECT_FALSE(sut.is_over(kNow + std::chrono::seconds{58}));
    (void)sut.press({JogKey::up}, kNow + std::chrono::seconds{58});
    EXPECT_FALSE(sut.is_over(kNow + std::chrono::seconds{300})) << "a key is held";
}

}  // namespace
}  // namespace psicarve::session
