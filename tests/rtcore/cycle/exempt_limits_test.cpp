// SPDX-License-Identifier: GPL-3.0-or-later
// Limits that do not count for a while: whose, and until when.
#include <gtest/gtest.h>

#include <cstdint>

#include "tests/rtcore/cycle/machine_rig.hpp"

namespace psicarve::cycle {
namespace {

constexpr std::uint64_t kFilterAndMore_ticks = 10;

void expect_limit_alarm(MachineRig& rig, Axis axis) {
    rig.run(kFilterAndMore_ticks);
    ASSERT_EQ(rig.cycle->state(), MachineState::alarm);
    EXPECT_EQ(rig.cycle->sample().alarm_cause, AlarmCause::limit);
    EXPECT_EQ(rig.cycle->sample().alarm_axis, index_of(axis));
}

/// Ready, with all axes homed, and then in alarm by R1's limit.
void trip_at_rest(MachineRig& rig) {
    ASSERT_TRUE(rig.home());
    rig.run(20'000);
    rig.machine->hold_input(Signal::r1_limit, true);
    expect_limit_alarm(rig, Axis::r1);
}

TEST(ExemptLimit, CountsAgainOnceItHasCleared) {
    MachineRig sut(quick_profile(), [](sim::SimConfig& config) {
        config.axis(Axis::r1).start_pulses = 8010;  // on its sensor
    });
    sut.run(kFilterAndMore_ticks);
    ASSERT_NE(sut.cycle->sample().signals & bit_of(Signal::r1_limit), 0U);
    ASSERT_TRUE(sut.home());
    sut.machine->hold_input(Signal::r1_limit, true);
    expect_limit_alarm(sut, Axis::r1);
}

TEST(ExemptLimit, IsThatOfTheAxisThatIsHomedAndNoOther) {
    for (const Axis other : {Axis::r2, Axis::y}) {
        MachineRig sut(quick_profile());
        ASSERT_EQ(sut.ask(RequestKind::home, 0, 0b0001), Refusal::none);
        sut.run(200);
        sut.machine->hold_input(Signal::r1_limit, true);
        sut.run(kFilterAndMore_ticks);
        ASSERT_EQ(sut.cycle->state(), MachineState::homing) << "its own";
        sut.machine->hold_input(other == Axis::y ? Signal::y_limit : Signal::r2_limit, true);
        expect_limit_alarm(sut, other);
    }
}

TEST(BackOff, IsRefusedWithTheEmergencyStopPressedAndEndedByIt) {
    MachineRig sut(quick_profile());
    trip_at_rest(sut);
    sut.machine->hold_input(Signal::estop, true);
    sut.tick();
    sut.port->writes.clear();
    EXPECT_EQ(sut.ask(RequestKind::back_off, 0), Refusal::still_tripped);
    sut.run(2000);
    EXPECT_EQ(sut.cycle->state(), MachineState::alarm);
    EXPECT_TRUE(sut.port->writes.empty()) << "no drive, no pulse";

    sut.machine->release_input(Signal::estop);
    sut.tick();
    ASSERT_EQ(sut.ask(RequestKind::back_off, 0), Refusal::none);
    sut.run(500);
    ASSERT_EQ(sut.cycle->state(), MachineState::backing_off);
    sut.machine->hold_input(Signal::estop, true);
    sut.tick();
    EXPECT_EQ(sut.cycle->state(), MachineState::alarm);
    EXPECT_EQ(sut.cycle->sample().alarm_cause, AlarmCause::emergency_stop);
    EXPECT_EQ(sut.cycle->pulses().levels() & (kStepMask | kEnableMask), 0U);
}

TEST(BackOff, UnhomesItsAxisAndNoOther) {
    MachineRig sut(always_on_profile());
    trip_at_rest(sut);
    ASSERT_EQ(sut.cycle->sample().homed_mask, 0xF) << "nothing moved";
    ASSERT_EQ(sut.ask(RequestKind::back_off, 0), Refusal::none);
    EXPECT_EQ(sut.cycle->sample().homed_mask, 0b1110);
    sut.run(2000);
    sut.machine->release_input(Signal::r1_limit);
    ASSERT_TRUE(sut.run_while([&] { return sut.cycle->state() == MachineState::backing_off; }));
    EXPECT_EQ(sut.cycle->sample().homed_mask, 0b1110);
    ASSERT_EQ(sut.ask(RequestKind::reset_alarm), Refusal::none);
    EXPECT_EQ(sut.cycle->state(), MachineState::off);
}

// Its plan goes on when it is resumed, but no axis moves.
TEST(EmergencyStop, OnHoldKeepsThePositionOfDrivesThatStayOn) {
    MachineRig sut(always_on_profile());
    ASSERT_TRUE(sut.prepare(random_job(1, 60, 5)));
    ASSERT_EQ(sut.ask(RequestKind::start_interpolation), Refusal::none);
    sut.run(3000);
    ASSERT_EQ(sut.ask(RequestKind::hold), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::held));
    sut.run(20'000);
    sut.emergency_stop();
    sut.tick();
    EXPECT_EQ(sut.cycle->state(), MachineState::alarm);
    EXPECT_EQ(sut.cycle->sample().homed_mask, 0xF);
    EXPECT_EQ(sut.ask(RequestKind::reset_alarm), Refusal::none);
    EXPECT_EQ(sut.cycle->state(), MachineState::ready);
}

/// A machine whose R1 has rested for so long after a jog, and then gets no tick for so long.
AlarmCause alarm_after(std::int64_t rested_ticks, std::int64_t gap_ticks) {
    MachineRig rig(quick_profile());
    EXPECT_TRUE(rig.home());
    Request jog{};
    jog.kind = RequestKind::jog;
    jog.order.axes = 0b0001;
    jog.order.target_pulses[0] = -400;
    EXPECT_EQ(rig.ask(jog), Refusal::none);
    std::uint64_t last_step_tick = 0;
    rig.run_while([&] {
        if ((rig.cycle->pulses().levels() & bit_of(Signal::r1_step)) != 0) {
            if (rig.cycle->pulses().stepped_within(0, 0, rig.cycle->next_tick() - 1))
                last_step_tick = rig.cycle->next_tick() - 1;
        }
        return rig.cycle->state() == MachineState::moving;
    });
    const std::uint64_t from = last_step_tick + static_cast<std::uint64_t>(rested_ticks);
    EXPECT_LE(rig.cycle->next_tick(), from) << "the case is one";
    while (rig.cycle->next_tick() < from) rig.tick();
    rig.cycle->advance_missed(static_cast<std::uint64_t>(gap_ticks - 1));
    return rig.cycle->sample().alarm_cause;
}

TEST(TickGap, CountsFromTheTickOnInWhichARotorMayStillHaveTurned) {
    const std::int64_t coast_ticks = plan::cycle_config_from_profile(quick_profile()).axes[0].coast_ticks;
    ASSERT_GT(coast_ticks, 10);
    EXPECT_EQ(alarm_after(coast_ticks, coast_ticks), AlarmCause::none);
    EXPECT_EQ(alarm_after(coast_ticks, coast_ticks + 1), AlarmCause::tick_gap);
    EXPECT_EQ(alarm_after(coast_ticks + 1, coast_ticks + 1), AlarmCause::none);
    EXPECT_EQ(alarm_after(coast_ticks + 1, 100 * coast_ticks), AlarmCause::none) << "it rested before";
}

/// What homing R1 came to with its sensor so many pulses from where it starts, and no ends in the way.
MachineState homed_with_sensor_at(std::int64_t away_pulses, AlarmCause& cause) {
    MachineRig rig(quick_profile(), [&](sim::SimConfig& config) {
        sim::AxisConfig& axis = config.axis(Axis::r1);
        axis.has_ends = false;
        axis.start_pulses = 100;
        axis.sensor.edge_pulses = 100 + away_pulses;
    });
    EXPECT_EQ(rig.ask(RequestKind::home, 0, 0b0001), Refusal::none);
    rig.run_while([&] { return rig.cycle->state() == MachineState::homing; });
    cause = rig.cycle->sample().alarm_cause;
    return rig.cycle->state();
}

// The last pulse's answer comes when the way is over.
TEST(HomingSearch, FindsASensorUpToItsLastPulseAndNoneBeyond) {
    const Profile profile = quick_profile();
    const AxisMotion motion = axis_motion(profile, Axis::r1);
    const std::int64_t way_pulses = motion.home_position_pulses - motion.travel_min_pulses +
                                    2 * motion.overtravel_pulses + 16;  // 16: homing.cpp's spare
    AlarmCause cause{};
    EXPECT_EQ(homed_with_sensor_at(way_pulses - 1, cause), MachineState::off) << name_of(cause);
    EXPECT_EQ(homed_with_sensor_at(way_pulses, cause), MachineState::alarm);
    EXPECT_EQ(cause, AlarmCause::home_failed);
}

}  // namespace
}  // namespace psicarve::cycle
