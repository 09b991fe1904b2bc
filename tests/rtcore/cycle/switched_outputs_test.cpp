// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/rtcore/cycle/program_rig.hpp"

namespace psicarve::cycle {
namespace {

using plan::test::Script;

constexpr SignalWord kMist = bit_of(Signal::mist);
constexpr SignalWord kFlood = bit_of(Signal::flood);
constexpr SignalWord kOutput2 = bit_of(Signal::output_2);
constexpr SignalWord kSpindleAndSwitched = bit_of(Signal::spindle) | kSwitchedMask;

Profile coolant_profile() {
    Profile profile = program_profile();
    for (const Axis axis : kAllAxes) profile.port.pins[index_of(enable_of(axis))] = 0;
    profile.port.pins[index_of(Signal::mist)] = 1;
    profile.port.pins[index_of(Signal::flood)] = -7;
    profile.port.pins[index_of(Signal::output_2)] = 6;
    return profile;
}

class CoolantRig : public ProgramRig {
public:
    CoolantRig() : ProgramRig(coolant_profile()) {}
    SignalWord on() const { return cycle->pulses().levels() & kSpindleAndSwitched; }
};

/// What was written, without pulses that end: "+mist", "-flood", and "r1" for each pulse of it, in order.
std::string order_of_edges(const std::vector<PortWrite>& writes) {
    std::string told;
    SignalWord before = 0;
    for (const PortWrite& write : writes) {
        for (const Signal signal : {Signal::spindle, Signal::mist, Signal::flood, Signal::output_2}) {
            if (((write.levels ^ before) & bit_of(signal)) == 0) continue;
            told += ((write.levels & bit_of(signal)) != 0 ? "+" : "-") + std::string{name_of(signal)} + " ";
        }
        if ((write.levels & ~before & kStepMask) != 0) told += "step ";
        before = write.levels;
    }
    return told;
}

TEST(SwitchedOutputs, GoOnAndOffAtTheirPlaceBetweenTheWays) {
    CoolantRig sut;
    Script script{sut.positions()};
    script.way({-2, 0, 0, 0}, 0.01)
        .output(Signal::mist, true)
        .way({1, 0, 0, 0}, 0.01)
        .output(Signal::flood, true)
        .output(Signal::output_2, true)
        .way({1, 0, 0, 0}, 0.01)
        .output(Signal::mist, false)
        .way({-1, 0, 0, 0}, 0.01)
        .end();
    sut.give(script.steps);
    ASSERT_EQ(sut.start(), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    sut.run(10);
    EXPECT_EQ(order_of_edges(sut.port->writes),
              "step step +mist step +flood +output_2 step -mist step -flood -output_2 ");
}

// Not before the last pulse of the way before has gone out, not after the first of the way behind.
TEST(SwitchedOutputs, TakeOneTickBesideTheRest) {
    const auto first_pulse_behind = [](bool has_output) {
        CoolantRig sut;
        Script script{sut.positions()};
        script.way({-40, 0, 0, 0}, 0.0);
        if (has_output) script.output(Signal::mist, true);
        script.way({40, 0, 0, 0}, 0.0).end();
        sut.give(script.steps);
        EXPECT_EQ(sut.start(), Refusal::none);
        EXPECT_TRUE(sut.run_until(MachineState::ready));
        std::vector<std::uint64_t> steps;
        std::uint64_t switched = 0;
        SignalWord before = 0;
        for (const PortWrite& write : sut.port->writes) {
            if ((write.levels & ~before & kStepMask) != 0) steps.push_back(write.tick);
            if ((write.levels & ~before & kMist) != 0) switched = write.tick;
            before = write.levels;
        }
        EXPECT_EQ(steps.size(), 80U);
        if (has_output) {
            EXPECT_GE(switched, steps.at(39));
            EXPECT_LT(switched, steps.at(40));
        }
        return steps.at(40) - steps.at(39);
    };
    EXPECT_EQ(first_pulse_behind(true), first_pulse_behind(false) + 1);
}

TEST(SwitchedOutputs, StayAsTheyAreWhileTheProgramHoldsAndThroughTheSpindlesOwnSwitching) {
    CoolantRig sut;
    Script script{sut.positions()};
    script.output(Signal::flood, true).spindle(true).way({-400, 0, 200, 0}, 0.01).spindle(false).stop();
    script.way({400, 0, 0, 0}, 0.01).end();
    sut.give(script.steps);
    ASSERT_EQ(sut.start(), Refusal::none);
    ASSERT_TRUE(sut.run_while([&] { return sut.positions()[kPsi] < 20 || !sut.is_spindle_on(); }));
    ASSERT_EQ(sut.ask(RequestKind::hold), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::held));
    EXPECT_EQ(sut.on(), kFlood | bit_of(Signal::spindle));
    ASSERT_EQ(sut.ask(RequestKind::resume), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::held));
    EXPECT_EQ(sut.on(), kFlood) << "M5 leaves the coolant on";
    ASSERT_EQ(sut.ask(RequestKind::resume), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(sut.on(), 0U);
}

/// Under way, with the spindle, mist and an output on.
void bring_under_way(CoolantRig& sut, plan::Supply at_the_end = plan::Supply::ended) {
    Script script{sut.positions()};
    script.spindle(true).output(Signal::mist, true).output(Signal::output_2, true);
    script.way({-400, 0, 800, 0}, 0.01);
    if (at_the_end == plan::Supply::ended) script.end();
    sut.give(script.steps, at_the_end);
    ASSERT_EQ(sut.start(), Refusal::none);
    const std::int64_t begin = sut.positions()[kPsi];
    ASSERT_TRUE(sut.run_while([&] { return sut.positions()[kPsi] < begin + 50; }));
    ASSERT_EQ(sut.on(), bit_of(Signal::spindle) | kMist | kOutput2);
}

TEST(SwitchedOutputs, GoOffWithTheSpindleWhenTheProgramIsStopped) {
    CoolantRig sut;
    bring_under_way(sut);
    sut.port->writes.clear();
    sut.stop();
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    sut.run(10);
    EXPECT_EQ(sut.on(), 0U);
    std::vector<SignalWord> kept;
    for (const PortWrite& write : sut.port->writes) kept.push_back(write.levels & kSpindleAndSwitched);
    kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
    EXPECT_EQ(kept, (std::vector<SignalWord>{bit_of(Signal::spindle) | kMist | kOutput2, 0}))
        << "all at one tick, when the heads are out";
}

TEST(SwitchedOutputs, AreOffFromTheNextTickOnAfterAnEmergencyStop) {
    CoolantRig sut;
    bring_under_way(sut);
    sut.port->writes.clear();
    sut.emergency_stop();
    sut.run(100);
    EXPECT_EQ(sut.cycle->state(), MachineState::alarm);
    ASSERT_FALSE(sut.port->writes.empty());
    EXPECT_EQ(sut.port->writes.front().levels & kSpindleAndSwitched, 0U);
    EXPECT_EQ(sut.on(), 0U);
}

TEST(SwitchedOutputs, GoOffWithEveryAlarm) {
    CoolantRig sut;
    bring_under_way(sut);
    sut.port->healthy = false;
    sut.run(2);
    EXPECT_EQ(sut.cycle->state(), MachineState::alarm);
    EXPECT_EQ(sut.on(), 0U);
}

TEST(SwitchedOutputs, StayOnWhereTheProgramsReaderIsLostUntilItIsStopped) {
    CoolantRig sut;
    bring_under_way(sut, plan::Supply::lost);
    ASSERT_TRUE(sut.run_until(MachineState::held));
    EXPECT_EQ(sut.on(), bit_of(Signal::spindle) | kMist | kOutput2);
    sut.stop();
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(sut.on(), 0U);
}

TEST(SwitchedOutputs, OnAtRestAreNotLeftAloneByASilentSupervisor) {
    CoolantRig sut;
    Script script{sut.positions()};
    script.output(Signal::mist, true).stop().end();
    sut.give(script.steps);
    ASSERT_EQ(sut.start(), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::held));
    ASSERT_EQ(sut.on(), kMist);
    sut.io->urgent.rounds.store(1);
    const auto second_ticks = static_cast<std::uint64_t>(1'000'000'000 / tick_period_ns(sut.profile));
    sut.run(2 * second_ticks);
    EXPECT_EQ(sut.on(), 0U);
}

TEST(SwitchedOutputs, ReachTheMachinesPins) {
    CoolantRig sut;
    const PinMap map = PinMap::from_profile(sut.profile).value();
    EXPECT_EQ(map.pins_from_registers(map.encode(0)) & (1U << 7 | 1U << 1), 1U << 7) << "off";
    EXPECT_EQ(map.pins_from_registers(map.encode(kMist | kFlood)) & (1U << 7 | 1U << 1), 1U << 1) << "on";
}

}  // namespace
}  // namespace psicarve::cycle
