// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "rtcore/cycle/layer_range.hpp"
#include "tests/rtcore/cycle/machine_rig.hpp"

namespace psicarve::cycle {
namespace {

void expect_homed_truly(const MachineRig& rig) {
    for (const Axis axis : kAllAxes) {
        std::int64_t off = rig.machine->position_pulses(axis) - rig.positions()[index_of(axis)];
        if (axis == Axis::psi) off %= 6400;
        EXPECT_EQ(off, 0) << name_of(axis);
    }
}

TEST(Homing, FindsTheTruePositionFromAnyStart) {
    std::mt19937_64 random(31);
    for (int round = 0; round < 12; ++round) {
        MachineRig sut(quick_profile(), [&](sim::SimConfig& config) {
            for (const Axis axis : {Axis::r1, Axis::r2, Axis::y}) {
                sim::AxisConfig& one = config.axis(axis);
                const auto span = static_cast<std::uint64_t>(one.high_end_pulses - one.low_end_pulses + 1);
                one.start_pulses = one.low_end_pulses + static_cast<std::int64_t>(random() % span);
            }
            config.axis(Axis::psi).start_pulses = static_cast<std::int64_t>(random() % 6400);
        });
        ASSERT_TRUE(sut.home()) << "round " << round;
        expect_homed_truly(sut);
    }
}

TEST(Homing, StartsOnEverySensorAsWell) {
    MachineRig sut(quick_profile(), [](sim::SimConfig& config) {
        config.axis(Axis::r1).start_pulses = 8000;
        config.axis(Axis::r2).start_pulses = 8100;
        config.axis(Axis::y).start_pulses = -100;
        config.axis(Axis::psi).start_pulses = 3;
    });
    sut.run(10);
    ASSERT_TRUE(sut.home());
    expect_homed_truly(sut);
}

TEST(Homing, OfOneAxisLeavesTheOthersWhereTheyAre) {
    MachineRig sut(quick_profile());
    ASSERT_TRUE(sut.home());
    const Positions before = sut.positions();
    ASSERT_EQ(sut.ask(RequestKind::home, 0, 0b0010), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    expect_homed_truly(sut);
    EXPECT_EQ(sut.positions(), before);
    EXPECT_EQ(sut.cycle->sample().homed_mask, 0b1111);
}

TEST(Homing, OfOneAxisLeavesItsDriveOnUntilDrivesOff) {
    MachineRig sut(quick_profile());
    ASSERT_EQ(sut.ask(RequestKind::drives_off), Refusal::not_in_this_state) << "none is on";
    ASSERT_EQ(sut.ask(RequestKind::home, 0, 0b0001), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::off));
    ASSERT_EQ(sut.cycle->pulses().levels() & kEnableMask, bit_of(Signal::r1_enable));
    ASSERT_EQ(sut.ask(RequestKind::drives_off), Refusal::none);
    EXPECT_EQ(sut.cycle->state(), MachineState::off);
    EXPECT_EQ(sut.cycle->pulses().levels() & kEnableMask, 0U);
    EXPECT_EQ(sut.cycle->sample().homed_mask, 0);
    EXPECT_EQ(sut.ask(RequestKind::drives_off), Refusal::not_in_this_state);
}

TEST(Homing, AxisByAxisTheMachineIsReadyWithTheLast) {
    MachineRig sut(quick_profile());
    for (const std::uint64_t axes : {0b0100U, 0b1000U, 0b0101U}) {
        EXPECT_EQ(sut.ask(RequestKind::home, 0, axes), Refusal::heads_not_homed) << axes;
    }
    ASSERT_EQ(sut.ask(RequestKind::home, 0, 0b0001), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::off));
    EXPECT_EQ(sut.cycle->sample().homed_mask, 0b0001);
    EXPECT_EQ(sut.cycle->pulses().levels() & kEnableMask, bit_of(Signal::r1_enable))
        << "it holds its position";
    EXPECT_EQ(sut.machine->report().axes[1].pulses_ignored + sut.cycle->sample().emitted_pulses[1], 0U);
    ASSERT_EQ(sut.ask(RequestKind::home, 0, 0b0110), Refusal::none) << "with the other head first";
    ASSERT_TRUE(sut.run_until(MachineState::off));
    EXPECT_EQ(sut.cycle->sample().homed_mask, 0b0111);
    ASSERT_EQ(sut.ask(RequestKind::home, 0, 0b1000), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    expect_homed_truly(sut);
}

TEST(Homing, OverrunsASensorByNoMoreThanTheRampAndOnePulse) {
    MachineRig sut(quick_profile());
    sut.ask(RequestKind::home);
    std::int64_t furthest = 0;
    sut.run_while([&] {
        furthest = std::max(furthest, sut.machine->position_pulses(Axis::r1));
        return sut.cycle->state() == MachineState::homing;
    });
    // 5 mm/s = 2000 pulses/s, 100 mm/s2 = 40000: v2/2a = 50.
    EXPECT_GE(furthest, 8000);
    EXPECT_LE(furthest, 8000 + 51);
}

TEST(Homing, FailsByNameWhenASensorNeverTrips) {
    for (const Axis axis : kAllAxes) {
        MachineRig sut(quick_profile(), [&](sim::SimConfig& config) {
            config.axis(axis).sensor.fault = sim::SensorFault::never_trips;
        });
        sut.ask(RequestKind::home);
        EXPECT_FALSE(sut.run_until(MachineState::ready));
        EXPECT_EQ(sut.cycle->sample().alarm_cause, AlarmCause::home_failed);
        EXPECT_EQ(sut.cycle->sample().alarm_axis, static_cast<std::uint8_t>(axis));
    }
}

TEST(Homing, TakesThePresentPositionWhereThereIsNoSensor) {
    Profile profile = quick_profile();
    profile.y.home = HomeSensor::none;
    profile.y.home_position_mm = 3.0;
    MachineRig sut(profile);
    ASSERT_TRUE(sut.home());
    EXPECT_EQ(sut.positions()[index_of(Axis::y)], 1200);
    EXPECT_EQ(sut.ask(RequestKind::reset_height), Refusal::no_sensor);
}

TEST(Homing, SurvivesAContactThatChatters) {
    MachineRig sut(quick_profile(),
                   [](sim::SimConfig& config) { config.axis(Axis::r1).sensor.bounce_ns = 2'000'000; });
    ASSERT_TRUE(sut.home());
    EXPECT_NEAR(static_cast<double>(sut.machine->position_pulses(Axis::r1)),
                static_cast<double>(sut.positions()[0]), 1.0);
}

TEST(ResetHeight, DefinesYAgain) {
    MachineRig sut(quick_profile());
    ASSERT_TRUE(sut.home());
    sut.machine->slip(Axis::y, 57);
    ASSERT_EQ(sut.ask(RequestKind::reset_height), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    expect_homed_truly(sut);
}

TEST(Limit, TripsStopWithinTheTickAfterTheFilterAndBackOffFrees) {
    MachineRig sut(quick_profile());
    ASSERT_TRUE(sut.prepare(random_job(1, 60, 5)));
    sut.ask(RequestKind::start_interpolation);
    sut.run(3000);
    sut.machine->hold_input(Signal::r1_limit, true);
    sut.run(4);  // 100 us of filter at 50 us a tick
    EXPECT_EQ(sut.cycle->state(), MachineState::alarm);
    EXPECT_EQ(sut.cycle->sample().alarm_cause, AlarmCause::limit);
    EXPECT_EQ(sut.cycle->sample().alarm_axis, static_cast<std::uint8_t>(Axis::r1));
    EXPECT_EQ(sut.ask(RequestKind::reset_alarm), Refusal::still_tripped);
    EXPECT_EQ(sut.ask(RequestKind::back_off, 3), Refusal::sensor_not_tripped);
    EXPECT_EQ(sut.ask(RequestKind::back_off, 2), Refusal::no_sensor);
    const std::int64_t before = sut.machine->position_pulses(Axis::r1);
    ASSERT_EQ(sut.ask(RequestKind::back_off, 0), Refusal::none);
    sut.run(2000);
    sut.machine->release_input(Signal::r1_limit);
    ASSERT_TRUE(sut.run_while([&] { return sut.cycle->state() == MachineState::backing_off; }));
    EXPECT_LT(sut.machine->position_pulses(Axis::r1), before);
    EXPECT_EQ(sut.ask(RequestKind::reset_alarm), Refusal::none);
    EXPECT_EQ(sut.cycle->state(), MachineState::off);
}

TEST(Limit, GlitchesShorterThanTheFilterAreIgnored) {
    MachineRig sut(quick_profile());
    ASSERT_TRUE(sut.prepare(random_job(1, 60, 5)));
    sut.machine->hold_input(Signal::y_limit, true);
    sut.tick();
    sut.machine->release_input(Signal::y_limit);
    sut.run(100);
    EXPECT_EQ(sut.cycle->state(), MachineState::waiting);
}

/// Carves three layers with psi slipped before the start; whether the index noticed.
bool index_notices(std::int64_t slip_pulses, bool zigzag) {
    MachineRig rig(quick_profile());
    JobTable job = random_job(5, 30, 5, zigzag ? Joining::zigzag : Joining::continuous);
    EXPECT_TRUE(rig.prepare(job));
    rig.machine->slip(Axis::psi, slip_pulses);
    rig.ask(RequestKind::start_interpolation);
    rig.run_while([&] {
        return rig.cycle->state() == MachineState::carving || rig.cycle->state() == MachineState::finishing;
    });
    return rig.cycle->sample().alarm_cause == AlarmCause::steps_lost;
}

/// Carves eight layers of half a turn each, of which every second one ends at the index; psi slips in the
/// middle of layer 4. The alarm.
Report alarm_of_slip(std::int64_t slip_pulses, LayerRange layers) {
    MachineRig rig(quick_profile());
    EXPECT_TRUE(rig.home());
    rig.load(random_job(8, 30, 5, Joining::continuous));
    EXPECT_EQ(rig.ask(RequestKind::start, 0, packed(layers)), Refusal::none);
    EXPECT_TRUE(rig.run_until(MachineState::waiting));
    rig.ask(RequestKind::start_interpolation);
    rig.run_while([&] { return rig.cycle->sample().layer < 4 || rig.cycle->sample().point < 10; });
    rig.machine->slip(Axis::psi, slip_pulses);
    rig.run_while([&] { return rig.cycle->state() == MachineState::carving; });
    Report found{};
    for (const Report& report : rig.reports) {
        if (report.record.kind == RecordKind::alarm) found = report;
    }
    return found;
}

TEST(Index, NoticesLostStepsBeyondItsToleranceInBothDirections) {
    for (const std::int64_t slip : {-40, -3, 3, 40}) EXPECT_TRUE(index_notices(slip, false)) << slip;
    for (const std::int64_t slip : {-2, 0, 2}) EXPECT_FALSE(index_notices(slip, false)) << slip;
    // Every second layer turns back, and passes the index from above. A table that is ahead does not come to
    // it.
    for (const std::int64_t slip : {-40, -3}) EXPECT_TRUE(index_notices(slip, true)) << slip;
    for (const std::int64_t slip : {-2, 0, 2}) EXPECT_FALSE(index_notices(slip, true)) << slip;
}

TEST(Index, TellsByHowMuchAndWhichLayersThatAffects) {
    // Turned on by 40 pulses it comes so much too early: at the end of layer 5. It was right at that of
    // layer 3.
    const Report ahead = alarm_of_slip(40, {});
    EXPECT_EQ(ahead.record.code, static_cast<std::uint16_t>(AlarmCause::steps_lost));
    EXPECT_EQ(ahead.expected_pulses, 6 * 3200);
    EXPECT_EQ(ahead.record.value, 6 * 3200 - 40);
    EXPECT_EQ(ahead.first_layer, 3U);
    EXPECT_EQ(ahead.layer_count, 3U);
    // Held back it comes too late: in layer 6.
    const Report behind = alarm_of_slip(-40, {});
    EXPECT_EQ(behind.expected_pulses, 6 * 3200);
    EXPECT_EQ(behind.record.value, 6 * 3200 + 40);
    EXPECT_EQ(behind.first_layer, 3U);
    EXPECT_EQ(behind.layer_count, 4U);
}

TEST(Index, NothingIsKnownToBeRightBeforeTheFirstLayerThatIsCarved) {
    // Layer 4 begins at the index, before the slip.
    const Report late = alarm_of_slip(-40, {.first = 4});
    EXPECT_EQ(late.first_layer, 4U);
    EXPECT_EQ(late.layer_count, 3U);
}

TEST(Index, NoLayerIsAffectedWhereNoneIsCarved) {
    const Report dry = alarm_of_slip(-40, {.is_dry = true});
    EXPECT_EQ(dry.record.code, static_cast<std::uint16_t>(AlarmCause::steps_lost));
    EXPECT_EQ(dry.record.value, 6 * 3200 + 40);
    EXPECT_EQ(dry.layer_count, 0U);
}

}  // namespace
}  // namespace psicarve::cycle
