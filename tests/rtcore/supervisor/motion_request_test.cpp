// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/motion_request.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "rtcore/cycle/layer_range.hpp"
#include "rtcore/cycle/pin_trial.hpp"
#include "shared/machine/jog_lease.hpp"

namespace psicarve::supervisor {
namespace {

using cycle::RequestKind;

Command jog(double distance) {
    Command command{};
    command.kind = CommandKind::jog;
    command.axis = index_of(Axis::y);
    command.value = distance;
    command.lease_token = 9;
    command.lease_ms = 200;
    return command;
}

Command move(std::uint32_t axes, double target) {
    Command command{};
    command.kind = CommandKind::move;
    command.axis = axes;
    for (double& position : command.target) position = target;
    return command;
}

std::string refusal(const Command& command, RequestKind kind) {
    const auto request = motion_request(command, kind, Profile{}, false);
    return request ? std::string{} : request.error().message;
}

TEST(MotionRequest, LeavesAPointThatNoLayerHasToTheTick) {
    Command start{};
    start.kind = CommandKind::start;
    start.value = 3;
    for (const std::uint32_t point : {999'999U, 1'000'000U, 1'048'576U, 0xFFFF'FFFEU}) {
        start.value2 = 0;
        set_start_point(start, point);
        const auto sut = motion_request(start, RequestKind::start, Profile{}, false);
        ASSERT_TRUE(sut) << point;
        EXPECT_GE(cycle::layer_range(sut->value).point_number, 1'000'000U) << "no_such_point, with the count";
        EXPECT_EQ(cycle::layer_range(sut->value).first, 3U);
    }
}

TEST(MotionRequest, PutsJogsIntoPulsesAndTicks) {
    const auto sut = motion_request(jog(-2.5), RequestKind::jog, Profile{}, false);
    ASSERT_TRUE(sut);
    EXPECT_EQ(sut->order.axes, 0b1000U);
    EXPECT_EQ(sut->order.target_pulses[3], -1000);
    EXPECT_EQ(sut->order.speed_pps, 2000.0) << "home speed";
    EXPECT_EQ(sut->lease_ticks, 4000U);
    EXPECT_EQ(sut->lease_token, 9U);
    EXPECT_EQ(sut->order.drops_turns, 0U);
}

TEST(MotionRequest, CutsLeasesThatAreTooLong) {
    Command command = jog(1.0);
    command.lease_ms = 3'600'000;
    EXPECT_EQ(motion_request(command, RequestKind::jog, Profile{}, false)->lease_ticks, 40'000U);
}

// There a tick says nothing about how long somebody has been silent.
TEST(MotionRequest, CountsNoTicksOfALeaseOnTheVirtualClock) {
    EXPECT_EQ(motion_request(jog(1.0), RequestKind::jog, Profile{}, true)->lease_ticks, 0U);
}

TEST(MotionRequest, PutsPositionsIntoPulsesByAxis) {
    const auto sut = motion_request(move(0b0110, 90.0), RequestKind::move, Profile{}, false);
    ASSERT_TRUE(sut);
    EXPECT_EQ(sut->order.axes, 0b0110U);
    EXPECT_EQ(sut->order.target_pulses, (std::array<std::int64_t, kAxisCount>{0, 36'000, 1600, 0}));
    EXPECT_EQ(sut->order.drops_turns, 1U);
}

TEST(MotionRequest, PutsAnArcsCentreIntoPulsesOfItsTwoAxes) {
    Command command = move(0b1010, 30.0);
    command.shape = MoveShape::clockwise;
    command.centre[1] = 25.0;
    command.centre[3] = -2.5;
    const auto sut = motion_request(command, RequestKind::move, Profile{}, false);
    ASSERT_TRUE(sut) << sut.error().message;
    EXPECT_EQ(sut->order.shape, cycle::OrderShape::clockwise);
    EXPECT_EQ(sut->order.centre_pulses, (std::array<std::int64_t, 2>{10'000, -1000}));
}

TEST(MotionRequest, RefusesShapesThatTheseAxesDoNotHave) {
    const auto refusal_of = [](std::uint32_t axes, MoveShape shape, const Profile& profile = Profile{}) {
        Command command = move(axes, 30.0);
        command.shape = shape;
        const auto request = motion_request(command, RequestKind::move, profile, false);
        return request ? std::string{} : request.error().message;
    };
    EXPECT_EQ(refusal_of(0b1001, MoveShape::arc), "");
    EXPECT_EQ(refusal_of(0b0011, MoveShape::stepped), "");
    EXPECT_NE(refusal_of(0b0011, MoveShape::arc).find("takes r1 and y, or r2 and y"), std::string::npos);
    EXPECT_NE(refusal_of(0b1100, MoveShape::arc).find("takes r1 and y"), std::string::npos);
    EXPECT_NE(refusal_of(0b1011, MoveShape::stepped).find("one or two"), std::string::npos);
    EXPECT_NE(refusal_of(0b0101, MoveShape::stepped).find("one or two"), std::string::npos);
    EXPECT_NE(refusal_of(0b1001, static_cast<MoveShape>(9)).find("unknown shape"), std::string::npos);
    Profile uneven;
    uneven.y.pulses_per_mm = 200.0;
    EXPECT_NE(refusal_of(0b1001, MoveShape::arc, uneven).find("pulses_per_mm"), std::string::npos);
}

TEST(MotionRequest, RefusesWhatMakesNoSenseByName) {
    Command no_axis = jog(1.0);
    no_axis.axis = kBothHeads + 1;
    EXPECT_NE(refusal(no_axis, RequestKind::jog).find("no such axis"), std::string::npos);
    Command no_lease = jog(1.0);
    no_lease.lease_token = 0;
    EXPECT_NE(refusal(no_lease, RequestKind::jog_on).find("lease"), std::string::npos);
    no_lease = jog(1.0);
    no_lease.lease_ms = 0;
    EXPECT_NE(refusal(no_lease, RequestKind::jog).find("lease"), std::string::npos);
    for (const double wild :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1e300, 1e12}) {
        EXPECT_NE(refusal(jog(wild), RequestKind::jog).find("(y)"), std::string::npos) << wild;
        EXPECT_NE(refusal(move(0b1, wild), RequestKind::move).find("(r1)"), std::string::npos) << wild;
        if (wild > 0.0 && wild < 1e13) continue;
        Command speed = jog(1.0);
        speed.speed = wild;
        EXPECT_NE(refusal(speed, RequestKind::jog_on).find("speed"), std::string::npos) << wild;
    }
    EXPECT_NE(refusal(move(0, 1.0), RequestKind::move).find("no axis"), std::string::npos);
    EXPECT_NE(refusal(move(0b10001, 1.0), RequestKind::move).find("no axis"), std::string::npos);
}

TEST(MotionRequest, OfARecordingNeedsAFormAndAReader) {
    Command command{};
    command.kind = CommandKind::record;
    command.lease_token = 9;
    command.value = 2.0;
    const auto sut = motion_request(command, RequestKind::record, Profile{}, false);
    ASSERT_TRUE(sut);
    EXPECT_EQ(sut->value, 2U);
    EXPECT_EQ(sut->lease_token, 9U);
    for (const double form : {-1.0, 3.0, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
        command.value = form;
        EXPECT_NE(refusal(command, RequestKind::record), "") << form;
    }
    command.value = 1.0;
    command.lease_token = 0;
    EXPECT_NE(refusal(command, RequestKind::record), "");
}

Command pin_test(Signal signal) {
    Command command{};
    command.kind = CommandKind::test_pin;
    command.axis = static_cast<std::uint32_t>(index_of(signal));
    command.value = 1.0;
    command.lease_token = 9;
    command.lease_ms = 200;
    return command;
}

TEST(MotionRequest, TestsOnlyOutputsThatAreWiredAndHeld) {
    EXPECT_EQ(refusal(pin_test(Signal::spindle), RequestKind::test_pin), "");
    EXPECT_NE(refusal(pin_test(Signal::y_limit), RequestKind::test_pin), "");
    Profile profile;
    profile.port.pins[index_of(Signal::spindle)] = 0;
    const auto unwired = motion_request(pin_test(Signal::spindle), RequestKind::test_pin, profile, false);
    ASSERT_FALSE(unwired);
    EXPECT_EQ(unwired.error().message, "pins: spindle is not wired to any pin");
    Command nobody = pin_test(Signal::spindle);
    nobody.lease_ms = 0;
    EXPECT_NE(refusal(nobody, RequestKind::test_pin), "");
    nobody.value = 0.0;
    EXPECT_EQ(refusal(nobody, RequestKind::test_pin), "") << "the end of a test";
}

TEST(MotionRequest, BoundsThePulsesOfATest) {
    Command command = pin_test(Signal::r1_step);
    command.value2 = 200;
    command.speed = 50.0;
    const auto sut = motion_request(command, RequestKind::test_pin, Profile{}, false);
    ASSERT_TRUE(sut);
    const cycle::PinOrder order = cycle::pin_order(sut->value);
    EXPECT_EQ(order.signal, index_of(Signal::r1_step));
    EXPECT_TRUE(order.is_on);
    EXPECT_EQ(order.pulses, 200U);
    EXPECT_EQ(order.half_ms, 10U);
    EXPECT_EQ(sut->lease_ticks, 4000U);
    for (const double rate_hz : {0.0, 0.5, 501.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
        command.speed = rate_hz;
        EXPECT_NE(refusal(command, RequestKind::test_pin), "") << rate_hz;
    }
    command.speed = 50.0;
    command.value2 = 10'001;
    EXPECT_NE(refusal(command, RequestKind::test_pin), "");
}

TEST(MotionRequest, HomesTheAxesThatAreNamed) {
    Command command{};
    command.kind = CommandKind::home;
    command.axis = 0b0110;
    EXPECT_EQ(motion_request(command, RequestKind::home, Profile{}, false)->value, 0b0110U);
}

TEST(MotionRequest, JogsBothHeadsEachInItsOwnPulses) {
    Profile profile;
    profile.r2.pulses_per_mm = 200.0;
    Command command = jog(-1.0);
    command.axis = kBothHeads;
    const auto sut = motion_request(command, RequestKind::jog, profile, false);
    ASSERT_TRUE(sut);
    EXPECT_EQ(sut->order.axes, 0b0011U);
    EXPECT_EQ(sut->order.target_pulses[0], -400);
    EXPECT_EQ(sut->order.target_pulses[1], -200);
    EXPECT_EQ(sut->order.speed_pps, 1000.0) << "the slower one's";
    command.axis = kBothHeads + 1;
    EXPECT_NE(refusal(command, RequestKind::jog), "");
}

TEST(MotionRequest, OfAProgramNamesItsNumberAndWhetherItGoesBlockByBlock) {
    Command command{};
    command.kind = CommandKind::program;
    command.value2 = 41;
    command.axis = kProgramIsSingle | 0x80U;
    const auto request = motion_request(command, RequestKind::run_program, Profile{}, false);
    ASSERT_TRUE(request);
    EXPECT_EQ(request->value, 41U);
    EXPECT_EQ(request->axis, 1U);
    command.axis = kProgramIsSingle | kProgramStopsAtOptional | 0x40U;
    EXPECT_EQ(motion_request(command, RequestKind::run_program, Profile{}, false)->axis, 3U);
}

// Limits that in pulses and back are a little less than they were.
TEST(MotionRequest, RemarksOnlyOnASpeedBeyondTheLimit) {
    for (int limit_deg_s = 1; limit_deg_s <= 1000; ++limit_deg_s) {
        Profile profile;
        profile.psi.speed_deg_s = limit_deg_s;
        Command command = jog(90.0);
        command.axis = index_of(Axis::psi);
        command.speed = limit_deg_s;
        EXPECT_TRUE(speed_remark(command, profile).is_none());
        command.speed = limit_deg_s + 1e-3;
        EXPECT_EQ(speed_remark(command, profile).id, MessageId::speed_limited_turning) << limit_deg_s;
    }
}

}  // namespace
}  // namespace psicarve::supervisor
