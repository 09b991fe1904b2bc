// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "rtcore/trace/trace_entry.hpp"
#include "tests/rtcore/cycle/machine_rig.hpp"

namespace psicarve::cycle {
namespace {

/// Its pin is one that the table's and the head's drives leave free by sharing theirs.
Profile pumped_profile() {
    Profile profile = quick_profile();
    profile.port.pins[index_of(Signal::y_enable)] = 6;
    profile.port.charge_pump_pin = 1;
    return profile;
}

bool is_pumped(const PortWrite& write) {
    return (write.levels & kChargePumpBit) != 0;
}

/// Each of these ticks has changed it.
::testing::AssertionResult toggles_every_tick(const std::vector<PortWrite>& writes, std::uint64_t ticks) {
    if (writes.size() != ticks) return ::testing::AssertionFailure() << writes.size() << " writes";
    for (std::size_t i = 1; i < writes.size(); ++i) {
        if (writes[i].tick != writes[i - 1].tick + 1) return ::testing::AssertionFailure() << "tick left out";
        if (is_pumped(writes[i]) == is_pumped(writes[i - 1])) {
            return ::testing::AssertionFailure() << "still at tick " << writes[i].tick;
        }
    }
    return ::testing::AssertionSuccess();
}

TEST(ChargePump, TogglesWithEveryTickAtRestAndInMotion) {
    MachineRig sut(pumped_profile());
    sut.port->writes.clear();
    sut.run(100);
    EXPECT_TRUE(toggles_every_tick(sut.port->writes, 100));
    ASSERT_EQ(sut.ask(RequestKind::home), Refusal::none);
    sut.run(20);
    sut.port->writes.clear();
    sut.run(1000);
    ASSERT_EQ(sut.cycle->state(), MachineState::homing);
    EXPECT_TRUE(toggles_every_tick(sut.port->writes, 1000));
    EXPECT_NE(sut.cycle->sample().signals & kChargePumpBit, 0U);
}

TEST(ChargePump, RestsInAnAlarmUntilItIsReset) {
    MachineRig sut(pumped_profile());
    sut.ask(RequestKind::home);
    sut.run(1001);
    sut.emergency_stop();
    sut.tick();
    sut.port->writes.clear();
    sut.run(100);
    EXPECT_TRUE(sut.port->writes.empty());
    EXPECT_EQ(sut.cycle->sample().signals & kChargePumpBit, 0U);
    ASSERT_EQ(sut.ask(RequestKind::reset_alarm), Refusal::none);
    sut.port->writes.clear();
    sut.run(10);
    EXPECT_TRUE(toggles_every_tick(sut.port->writes, 10));
}

TEST(ChargePump, IsLowInAnAlarmFromWhicheverPhase) {
    for (int phase = 0; phase < 2; ++phase) {
        MachineRig sut(pumped_profile());
        sut.run(100 + static_cast<std::uint64_t>(phase));
        sut.emergency_stop();
        sut.tick();
        EXPECT_FALSE(is_pumped(sut.port->writes.back()));
        EXPECT_EQ(sut.port->writes.back().levels, 0U) << "nor is any other line of a machine that rests";
    }
}

TEST(ChargePump, IsLowAtTheEnd) {
    MachineRig sut(pumped_profile());
    sut.run(1);
    ASSERT_TRUE(is_pumped(sut.port->writes.back()));
    sut.cycle->shut_down();
    EXPECT_FALSE(is_pumped(sut.port->writes.back()));
    EXPECT_EQ(sut.port->writes.back().levels, 0U);
}

TEST(ChargePump, RestsWhenThePortFailed) {
    MachineRig sut(pumped_profile());
    sut.run(10);
    sut.port->healthy = false;
    sut.run(2);
    sut.port->writes.clear();
    sut.run(100);
    EXPECT_TRUE(sut.port->writes.empty());
}

TEST(ChargePump, TogglesWithTheInputsAndPulsesOfTwoTimers) {
    Profile profile = pumped_profile();
    profile.tick.schedule = Schedule::two_timer;
    profile.tick.period_us = 100.0;
    MachineRig sut(profile);
    sut.run(50);
    ASSERT_GE(sut.port->writes.size(), 50U);
    for (std::size_t i = 2; i < sut.port->writes.size(); ++i) {
        EXPECT_EQ(sut.port->writes[i].tick, sut.port->writes[i - 1].tick + 5);
        EXPECT_NE(is_pumped(sut.port->writes[i]), is_pumped(sut.port->writes[i - 1]));
    }
}

TEST(ChargePump, IsInNoTraceAndChangesNoOtherPin) {
    std::vector<std::vector<SignalWord>> levels;
    for (const bool is_pumped_machine : {false, true}) {
        Profile profile = pumped_profile();
        if (!is_pumped_machine) profile.port.charge_pump_pin = 0;
        MachineRig sut(profile);
        const auto ring = std::make_unique<trace::TraceRing>();
        sut.io->trace = ring.get();
        sut.ask(RequestKind::home);
        std::vector<SignalWord> traced;
        for (int i = 0; i < 20; ++i) {
            sut.run(1000);
            trace::TraceEntry entry;
            while (ring->pop_into(entry)) traced.push_back(entry.levels);
        }
        levels.push_back(traced);
    }
    ASSERT_GT(levels[0].size(), 1000U);
    EXPECT_EQ(levels[0], levels[1]);
}

}  // namespace
}  // namespace psicarve::cycle
