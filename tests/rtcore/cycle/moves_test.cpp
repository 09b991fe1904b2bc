// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

#include "tests/rtcore/cycle/machine_rig.hpp"
#include "tests/rtcore/cycle/move_requests.hpp"

namespace psicarve::cycle {
namespace {

void expect_true_positions(const MachineRig& rig) {
    for (const Axis axis : kAllAxes) {
        EXPECT_EQ((rig.machine->position_pulses(axis) - rig.positions()[index_of(axis)]) %
                      (axis == Axis::psi ? 6400 : 1'000'000),
                  0)
            << name_of(axis);
    }
}

MachineRig homed() {
    MachineRig rig(quick_profile());
    EXPECT_TRUE(rig.home());
    return rig;
}

TEST(Move, TakesEveryAxisExactlyToItsTarget) {
    std::mt19937_64 random{41};
    MachineRig sut = homed();
    for (int round = 0; round < 12; ++round) {
        const auto pick = [&](std::int64_t least, std::uint64_t span) {
            return least + static_cast<std::int64_t>(random() % span);
        };
        const Positions to{pick(600, 7000), pick(600, 7000), pick(-3100, 6200), pick(0, 7000)};
        ASSERT_EQ(sut.ask(move_request(
                      {{Axis::r1, to[0]}, {Axis::r2, to[1]}, {Axis::psi, to[2]}, {Axis::y, to[3]}})),
                  Refusal::none);
        EXPECT_EQ(sut.cycle->state(), MachineState::moving);
        ASSERT_TRUE(sut.run_until(MachineState::ready));
        EXPECT_EQ(sut.positions(), to);
        EXPECT_EQ(sut.cycle->sample().move_end, MoveEnd::reached);
        expect_true_positions(sut);
    }
}

TEST(Move, GoesStraight) {
    MachineRig sut = homed();
    sut.ask(move_request({{Axis::r1, 6000}, {Axis::y, 4000}}));
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    sut.ask(move_request({{Axis::r1, 2000}, {Axis::y, 1000}}));
    sut.run_while([&] {
        const Positions at = sut.positions();
        const double share = static_cast<double>(6000 - at[0]) / 4000.0;
        EXPECT_NEAR(static_cast<double>(at[3]), 4000.0 - 3000.0 * share, 1.01);
        return sut.cycle->state() == MachineState::moving;
    });
    EXPECT_EQ(sut.positions()[3], 1000);
}

TEST(Move, LeavesTheOtherAxesWhereTheyAre) {
    MachineRig sut = homed();
    Positions expected = sut.positions();
    sut.ask(move_request({{Axis::r2, 3000}}));
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    expected[1] = 3000;
    EXPECT_EQ(sut.positions(), expected);
}

TEST(Move, TurnsPsiTheShortWayAndDropsWholeTurns) {
    MachineRig sut = homed();
    ASSERT_EQ(sut.ask(jog_request(Axis::psi, 5 * 6400 + 100)), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    const std::uint64_t emitted = sut.cycle->pulses().emitted()[kPsi];
    sut.ask(move_request({{Axis::psi, -200}}));
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(sut.positions()[kPsi], -200);
    const auto left = static_cast<std::uint64_t>(std::abs(sut.positions()[kPsi]));
    EXPECT_LE(sut.cycle->pulses().emitted()[kPsi] - emitted, 3200U);
    EXPECT_GT(sut.cycle->pulses().emitted()[kPsi], emitted + left);
    expect_true_positions(sut);
}

/// Refused with this reason and axis, and not a pin moved.
void expect_refused(MachineRig& rig, const Request& request, Refusal reason, Axis axis) {
    const std::size_t writes = rig.port->writes.size();
    EXPECT_EQ(rig.ask(request), reason);
    rig.run(50);
    EXPECT_EQ(rig.port->writes.size(), writes);
    EXPECT_EQ(rig.cycle->state(), MachineState::ready);
    EXPECT_EQ(rig.reports.back().record.axis, index_of(axis));
}

TEST(Move, BeyondASoftLimitIsRefusedByNameBeforeAnyPulse) {
    MachineRig sut = homed();
    expect_refused(sut, move_request({{Axis::r2, 8001}}), Refusal::outside_travel, Axis::r2);
    expect_refused(sut, move_request({{Axis::r1, 3000}, {Axis::y, -1}}), Refusal::outside_travel, Axis::y);
    expect_refused(sut, move_request({{Axis::r1, 599}}), Refusal::inside_core_radius, Axis::r1);
    expect_refused(sut, jog_request(Axis::r1, 4000), Refusal::outside_travel, Axis::r1);
    expect_refused(sut, jog_request(Axis::y, -9000), Refusal::outside_travel, Axis::y);
}

TEST(Move, TheTipsKeepTheirClearance) {
    Profile profile = quick_profile();
    profile.head_clearance_mm = 10.0;
    MachineRig sut(profile);
    ASSERT_TRUE(sut.home());
    ASSERT_EQ(sut.ask(move_request({{Axis::r1, 2000}, {Axis::r2, 2000}})), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    expect_refused(sut, jog_request(Axis::r2, -2), Refusal::heads_too_close, Axis::r2);
    EXPECT_EQ(sut.ask(jog_request(Axis::r2, 2)), Refusal::none);
}

TEST(Move, NeedsAHomedMachineAtRest) {
    MachineRig sut(quick_profile());
    EXPECT_EQ(sut.ask(move_request({{Axis::r1, 3000}})), Refusal::not_homed);
    EXPECT_EQ(sut.ask(jog_request(Axis::r1, -10)), Refusal::not_homed);
    ASSERT_TRUE(sut.home());
    ASSERT_EQ(sut.ask(move_request({{Axis::r1, 3000}})), Refusal::none);
    sut.run(10);
    EXPECT_EQ(sut.ask(move_request({{Axis::r1, 4000}})), Refusal::not_in_this_state);
    EXPECT_EQ(sut.ask(jog_request(Axis::r1, 1)), Refusal::not_in_this_state);
    EXPECT_EQ(sut.ask(RequestKind::hold), Refusal::not_in_this_state);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(sut.positions()[0], 3000);
}

TEST(Move, AStopSlowsDownKeepsThePositionAndRetracts) {
    MachineRig sut = homed();
    sut.ask(move_request({{Axis::r1, 3000}, {Axis::r2, 3000}}));
    sut.run(4000);
    sut.stop();
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_GT(sut.positions()[0], 3000);
    EXPECT_EQ(sut.cycle->sample().move_end, MoveEnd::none);
    expect_true_positions(sut);
    EXPECT_EQ(sut.machine->report().axis(Axis::r1).stalls, 0U);
}

TEST(Move, ALimitOnTheWayIsAnAlarm) {
    MachineRig sut = homed();
    sut.ask(move_request({{Axis::r1, 3000}}));
    sut.run(3000);
    sut.machine->hold_input(Signal::r1_limit, true);
    sut.run(5);
    EXPECT_EQ(sut.cycle->state(), MachineState::alarm);
    EXPECT_EQ(sut.cycle->sample().alarm_cause, AlarmCause::limit);
}

TEST(Spindle, IsSwitchedByHandWhileReadyAndOffByStop) {
    MachineRig sut(quick_profile());
    EXPECT_EQ(sut.ask(RequestKind::spindle, 0, 1), Refusal::not_homed);
    ASSERT_TRUE(sut.home());
    const auto is_on = [&] { return (sut.port->writes.back().levels & bit_of(Signal::spindle)) != 0; };
    ASSERT_EQ(sut.ask(RequestKind::spindle, 0, 1), Refusal::none);
    EXPECT_TRUE(is_on());
    sut.ask(move_request({{Axis::r1, 3000}}));
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_TRUE(is_on());
    ASSERT_EQ(sut.ask(RequestKind::spindle, 0, 0), Refusal::none);
    EXPECT_FALSE(is_on());
    sut.ask(RequestKind::spindle, 0, 1);
    sut.stop();
    sut.run(2);
    EXPECT_EQ(sut.cycle->state(), MachineState::ready);
    EXPECT_FALSE(is_on());
}

}  // namespace
}  // namespace psicarve::cycle
