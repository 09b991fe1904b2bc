// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "rtcore/cycle/point_by_point.hpp"
#include "tests/rtcore/cycle/machine_rig.hpp"
#include "tests/rtcore/cycle/move_requests.hpp"

namespace psicarve::cycle {
namespace {

MachineRig rig_at(std::int64_t r1, std::int64_t y, const Profile& profile = quick_profile()) {
    MachineRig rig(profile);
    EXPECT_TRUE(rig.home());
    EXPECT_EQ(rig.ask(move_request({{Axis::r1, r1}, {Axis::y, y}})), Refusal::none);
    EXPECT_TRUE(rig.run_until(MachineState::ready));
    return rig;
}

Request stepped(std::int64_t r1, std::int64_t y) {
    Request request = move_request({{Axis::r1, r1}, {Axis::y, y}});
    request.order.shape = OrderShape::stepped;
    return request;
}

Request arc(std::int64_t r1, std::int64_t y, std::int64_t centre_r1, std::int64_t centre_y,
            OrderShape shape = OrderShape::arc) {
    Request request = stepped(r1, y);
    request.order.shape = shape;
    request.order.centre_pulses = {centre_r1, centre_y};
    return request;
}

/// The pulses of r1 (X) and y (Y) in the order in which they left the pins, from this write on.
std::string steps_since(const MachineRig& rig, std::size_t first_write) {
    std::string text;
    SignalWord before = first_write > 0 ? rig.port->writes[first_write - 1].levels : 0;
    for (std::size_t i = first_write; i < rig.port->writes.size(); ++i) {
        const SignalWord levels = rig.port->writes[i].levels;
        const SignalWord rising = levels & ~before & kStepMask;
        before = levels;
        for (const Axis axis : {Axis::r1, Axis::y}) {
            if ((rising & bit_of(step_of(axis))) == 0) continue;
            text += text.empty() ? "" : " ";
            text += (levels & bit_of(dir_of(axis))) != 0 ? "+" : "-";
            text += axis == Axis::r1 ? "X" : "Y";
        }
    }
    return text;
}

TEST(SteppedMove, TheTextbooksLineComesOutOfThePins) {
    MachineRig sut = rig_at(2000, 2000);
    const std::size_t before = sut.port->writes.size();
    ASSERT_EQ(sut.ask(stepped(2006, 2004)), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(steps_since(sut, before), "+X +Y +X +Y +X +X +Y +X +Y +X");
}

TEST(SteppedMove, TheTextbooksArcComesOutOfThePins) {
    MachineRig sut = rig_at(2004, 2000);
    const std::size_t before = sut.port->writes.size();
    ASSERT_EQ(sut.ask(arc(2000, 2004, 2000, 2000)), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(steps_since(sut, before), "-X +Y +Y +Y -X +Y -X -X");
}

TEST(SteppedMove, LongLinesEndExactlyAndNothingStalls) {
    MachineRig sut = rig_at(3000, 3000);
    for (const auto& [r1, y] : {std::pair{7000, 3001}, {900, 6500}, {900, 900}, {900, 900}, {5000, 900}}) {
        ASSERT_EQ(sut.ask(stepped(r1, y)), Refusal::none);
        ASSERT_TRUE(sut.run_until(MachineState::ready));
        EXPECT_EQ(sut.positions()[0], r1);
        EXPECT_EQ(sut.positions()[3], y);
    }
    for (const Axis axis : kAllAxes) EXPECT_EQ(sut.machine->report().axis(axis).stalls, 0U) << name_of(axis);
}

TEST(SteppedMove, AWholeCircleStaysOnItAndNothingStalls) {
    for (const OrderShape shape : {OrderShape::arc, OrderShape::clockwise}) {
        MachineRig sut = rig_at(4000 + 1500, 4000);
        ASSERT_EQ(sut.ask(arc(5500, 4000, 4000, 4000, shape)), Refusal::none);
        sut.run_while([&] {
            const auto x = static_cast<double>(sut.positions()[0] - 4000);
            const auto y = static_cast<double>(sut.positions()[3] - 4000);
            EXPECT_NEAR(std::hypot(x, y), 1500.0, 1.0 + 1e-9);
            return sut.cycle->state() == MachineState::moving;
        });
        EXPECT_EQ(sut.positions()[0], 5500);
        EXPECT_EQ(sut.positions()[3], 4000);
        EXPECT_EQ(sut.machine->position_pulses(Axis::r1), 5500);
        for (const Axis axis : {Axis::r1, Axis::y}) EXPECT_EQ(sut.machine->report().axis(axis).stalls, 0U);
    }
}

TEST(SteppedMove, AnArcIsRefusedWhereItReachesOutBeyondASoftLimit) {
    MachineRig sut = rig_at(1000, 2000);
    // Half a circle from (1000, 2000) to (1000, 4000): by r1 = 2000 one way, by r1 = 0 the other.
    EXPECT_EQ(sut.ask(arc(1000, 4000, 1000, 3000, OrderShape::clockwise)), Refusal::inside_core_radius);
    EXPECT_EQ(sut.reports.back().record.axis, index_of(Axis::r1));
    EXPECT_EQ(sut.ask(arc(1000, 4000, 1000, 3000)), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(sut.positions()[3], 4000);
}

TEST(SteppedMove, WhatIsNoArcIsRefused) {
    MachineRig sut = rig_at(2000, 2000);
    EXPECT_EQ(sut.ask(arc(2000, 3000, 2000, 2400)), Refusal::not_an_arc);
    EXPECT_EQ(sut.ask(arc(2001, 2000, 2000, 2000)), Refusal::not_an_arc);
    EXPECT_EQ(sut.cycle->state(), MachineState::ready);
}

TEST(SteppedMove, AStopOnTheWayKeepsThePosition) {
    MachineRig sut = rig_at(5500, 4000);
    sut.ask(arc(5500, 4000, 4000, 4000));
    sut.run(9000);
    sut.stop();
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(sut.machine->position_pulses(Axis::y), sut.positions()[3]);
    EXPECT_GT(sut.positions()[3], 4000);
    for (const Axis axis : {Axis::r1, Axis::y}) EXPECT_EQ(sut.machine->report().axis(axis).stalls, 0U);
}

TEST(SteppedMove, BacklashIsTakenUpWhereAnAxisTurnsRound) {
    Profile profile = quick_profile();
    profile.r1.backlash_mm = 0.05;
    profile.y.backlash_mm = 0.1;
    MachineRig sut = rig_at(5500, 4000, profile);
    ASSERT_EQ(sut.ask(arc(5500, 4000, 4000, 4000)), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(sut.machine->position_pulses(Axis::r1), 5500);
    EXPECT_EQ(sut.machine->position_pulses(Axis::y), 4000);
    for (const Axis axis : {Axis::r1, Axis::y}) EXPECT_EQ(sut.machine->report().axis(axis).stalls, 0U);
}

}  // namespace
}  // namespace psicarve::cycle
