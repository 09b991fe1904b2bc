// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "tests/rtcore/cycle/machine_rig.hpp"

namespace psicarve::cycle {
namespace {

/// Carves with a hold at each of these ticks after the start.
std::vector<std::uint32_t> carved_order(const std::vector<std::uint64_t>& hold_after) {
    MachineRig rig(quick_profile());
    EXPECT_TRUE(rig.prepare(random_job(2, 60, 77)));
    rig.port->writes.clear();
    EXPECT_EQ(rig.ask(RequestKind::start_interpolation), Refusal::none);
    for (const std::uint64_t ticks : hold_after) {
        rig.run(ticks);
        if (rig.ask(RequestKind::hold) != Refusal::none) break;
        EXPECT_TRUE(rig.run_until(MachineState::held));
        const std::size_t written = rig.port->writes.size();
        rig.run(500);
        EXPECT_LE(rig.port->writes.size(), written + 1);  // the last pulse may still fall
        EXPECT_EQ(rig.ask(RequestKind::resume), Refusal::none);
    }
    EXPECT_TRUE(rig.run_until(MachineState::finishing));
    return order_of(rig.port->writes);
}

TEST(Hold, LeavesTheMergedOrderOfIterationsAsItWas) {
    const std::vector<std::uint32_t> undisturbed = carved_order({});
    std::mt19937_64 random(3);
    for (int round = 0; round < 8; ++round) {
        std::vector<std::uint64_t> ticks;
        for (int i = 0; i < 6; ++i) ticks.push_back(1 + random() % 4000);
        EXPECT_EQ(carved_order(ticks), undisturbed);
    }
}

TEST(EmergencyStop, LetsNoPulseOutFromTheNextTickOnAndSwitchesEverythingOff) {
    std::mt19937_64 random(9);
    for (int round = 0; round < 20; ++round) {
        MachineRig sut(quick_profile());
        sut.ask(RequestKind::home);
        sut.run(random() % 60000);
        const bool by_switch = round % 2 == 0;
        if (by_switch) {
            sut.machine->hold_input(Signal::estop, true);
        } else {
            sut.emergency_stop();
        }
        sut.port->writes.clear();
        sut.run(200);
        EXPECT_EQ(sut.cycle->state(), MachineState::alarm);
        for (const PortWrite& write : sut.port->writes) {
            EXPECT_EQ(write.levels & (kStepMask | kEnableMask | bit_of(Signal::spindle)), 0U);
        }
        EXPECT_LE(sut.port->writes.size(), 1U);
        EXPECT_EQ(sut.ask(RequestKind::reset_alarm), by_switch ? Refusal::still_tripped : Refusal::none);
    }
}

TEST(EmergencyStop, UnhomesOfDrivesThatStayOnTheAxesThatMovedAndNoOther) {
    MachineRig sut(always_on_profile());
    JobTable job = random_job(1, 60, 5);
    std::fill(job.r_right_pulses.begin(), job.r_right_pulses.end(), 3600);
    ASSERT_TRUE(sut.prepare(job));
    sut.ask(RequestKind::start_interpolation);
    sut.run(3000);
    sut.emergency_stop();
    sut.tick();
    const std::uint8_t homed = sut.cycle->sample().homed_mask;
    EXPECT_EQ(homed >> index_of(Axis::psi) & 1, 0);
    EXPECT_EQ(homed >> index_of(Axis::r2) & 1, 1);
    EXPECT_EQ(homed >> index_of(Axis::y) & 1, 1);
    EXPECT_EQ(sut.ask(RequestKind::reset_alarm), Refusal::none);
    EXPECT_EQ(sut.cycle->state(), MachineState::off);
}

TEST(EmergencyStop, AtRestKeepsThePositionOfDrivesThatStayOn) {
    MachineRig sut(always_on_profile());
    ASSERT_TRUE(sut.home());
    sut.run(1000);
    sut.emergency_stop();
    sut.tick();
    EXPECT_EQ(sut.cycle->state(), MachineState::alarm);
    EXPECT_EQ(sut.ask(RequestKind::reset_alarm), Refusal::none);
    EXPECT_EQ(sut.cycle->state(), MachineState::ready);
}

// A rotor without current may be turned by hand or by weight.
TEST(EmergencyStop, AtRestUnhomesWhateverItSwitchesOff) {
    for (const Axis kept : kAllAxes) {
        Profile profile = quick_profile();
        profile.port.pins[index_of(enable_of(kept))] = 0;
        MachineRig sut(profile);
        ASSERT_TRUE(sut.home());
        sut.run(20'000);
        sut.emergency_stop();
        sut.tick();
        EXPECT_EQ(sut.cycle->sample().homed_mask, 1U << index_of(kept));
        EXPECT_EQ(sut.cycle->pulses().levels() & kEnableMask, 0U);
        ASSERT_EQ(sut.ask(RequestKind::reset_alarm), Refusal::none);
        EXPECT_EQ(sut.cycle->state(), MachineState::off);
        sut.run(100);
        EXPECT_EQ(sut.cycle->pulses().levels() & kEnableMask, 0U) << "the next command does that";
        EXPECT_EQ(sut.ask(RequestKind::start), Refusal::not_homed);
        EXPECT_TRUE(sut.home());
        EXPECT_EQ(sut.cycle->pulses().levels() & kEnableMask, kEnableMask);
    }
}

TEST(Stop, AnywhereInAJobRetractsAndEndsReady) {
    std::mt19937_64 random(21);
    for (int round = 0; round < 12; ++round) {
        MachineRig sut(quick_profile());
        ASSERT_TRUE(sut.home());
        sut.load(random_job(2, 60, 8));
        sut.ask(RequestKind::start);
        if (round % 3 != 0) {
            ASSERT_TRUE(sut.run_until(MachineState::waiting));
            if (round % 3 == 1) sut.ask(RequestKind::start_interpolation);
        }
        sut.run(random() % 8000);
        const MachineState before = sut.cycle->state();
        sut.stop();
        ASSERT_TRUE(sut.run_until(MachineState::ready)) << "from state " << static_cast<int>(before);
        EXPECT_EQ(sut.cycle->pulses().levels() & bit_of(Signal::spindle), 0U);
        EXPECT_EQ(sut.cycle->sample().homed_mask, 0xF);
        for (const Axis axis : kAllAxes) {
            EXPECT_EQ(sut.machine->position_pulses(axis), sut.positions()[index_of(axis)]);
        }
        EXPECT_EQ(sut.ask(RequestKind::start), Refusal::none);
        EXPECT_TRUE(sut.run_until(MachineState::waiting));
    }
}

TEST(Stop, DuringHomingEndsOff) {
    MachineRig sut(quick_profile());
    sut.ask(RequestKind::home);
    sut.run(5000);
    sut.stop();
    EXPECT_TRUE(sut.run_until(MachineState::off));
    EXPECT_EQ(sut.cycle->pulses().levels() & kEnableMask, 0U);
    EXPECT_TRUE(sut.home());
}

// Which others may be counted with it depends on what turned at the time.
TEST(Missed, TicksAreToldGapByGapWithWhatWouldBeHarmless) {
    MachineRig sut(quick_profile());
    ASSERT_TRUE(sut.prepare(random_job(1, 60, 5)));
    sut.run(3000);
    sut.cycle->advance_missed(500);
    sut.ask(RequestKind::start_interpolation);
    sut.run(3000);
    sut.cycle->advance_missed(2);
    sut.run(5);
    const auto told = sut.records_of(RecordKind::gap);
    ASSERT_EQ(told.size(), 2U);
    EXPECT_EQ(told[0].value, 500);
    EXPECT_EQ(told[0].answer, kAnyGap) << "nothing turned";
    EXPECT_EQ(told[1].value, 2);
    EXPECT_EQ(told[1].code, 1);
    const std::uint32_t longest = told[1].answer;
    ASSERT_GE(longest, 2U);
    sut.cycle->advance_missed(longest);
    EXPECT_EQ(sut.cycle->state(), MachineState::carving);
    sut.run(1000);
    sut.cycle->advance_missed(longest + 1);
    sut.run(5);
    EXPECT_EQ(sut.cycle->sample().alarm_cause, AlarmCause::tick_gap);
    const auto gaps = sut.records_of(RecordKind::gap);
    ASSERT_EQ(gaps.size(), 4U);
    EXPECT_EQ(gaps[2].answer, longest);
    EXPECT_EQ(gaps[3].answer, kAlarmingGap);
    const auto place = [&](RecordKind kind) {
        return std::ranges::find_if(sut.reports, [&](const Report& r) { return r.record.kind == kind; });
    };
    EXPECT_LT(place(RecordKind::gap), place(RecordKind::alarm));
}

TEST(Missed, TicksAreCountedAndALongGapIsAnAlarm) {
    MachineRig sut(quick_profile());
    ASSERT_TRUE(sut.prepare(random_job(1, 60, 5)));
    sut.ask(RequestKind::start_interpolation);
    sut.run(3000);
    sut.cycle->advance_missed(3);
    sut.tick();
    EXPECT_EQ(sut.cycle->state(), MachineState::carving);
    EXPECT_EQ(sut.cycle->sample().missed_ticks, 3U);
    sut.cycle->advance_missed(60);
    EXPECT_EQ(sut.cycle->state(), MachineState::alarm);
    EXPECT_EQ(sut.cycle->sample().alarm_cause, AlarmCause::tick_gap);
}

}  // namespace
}  // namespace psicarve::cycle
