// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/pin_trial.hpp"

#include <gtest/gtest.h>

#include <bit>

#include "shared/machine/jog_lease.hpp"
#include "tests/rtcore/cycle/machine_rig.hpp"

namespace psicarve::cycle {
namespace {

constexpr std::uint32_t kToken = 77;
constexpr std::uint32_t kLeaseTicks = 4000;

Request test_of(Signal signal, std::uint32_t pulses = 0) {
    Request request{};
    request.kind = RequestKind::test_pin;
    request.value = packed(PinOrder{static_cast<std::uint8_t>(signal), true, pulses, 1});
    request.lease_token = kToken;
    request.lease_ticks = kLeaseTicks;
    return request;
}

SignalWord outputs(const MachineRig& rig) {
    return rig.cycle->pulses().levels() & kOutputMask;
}

TEST(PinTrial, ActivatesOneOutputAloneUntilItsLeaseIsGone) {
    for (std::size_t i = 0; i < kFirstInput; ++i) {
        MachineRig sut(quick_profile());
        const auto signal = static_cast<Signal>(i);
        ASSERT_EQ(sut.ask(test_of(signal)), Refusal::none);
        EXPECT_EQ(sut.cycle->state(), MachineState::testing);
        sut.run(kLeaseTicks - 10);
        EXPECT_EQ(outputs(sut), bit_of(signal)) << name_of(signal);
        sut.run(20);
        EXPECT_EQ(sut.cycle->state(), MachineState::off);
        EXPECT_EQ(outputs(sut), 0U) << name_of(signal);
        for (const PortWrite& write : sut.port->writes)
            ASSERT_LE(std::popcount(write.levels), 1) << name_of(signal);
    }
}

TEST(PinTrial, GoesOnWhileItsLeaseIsRenewedAndEndsWhenItIsReleased) {
    MachineRig sut(quick_profile());
    ASSERT_EQ(sut.ask(test_of(Signal::spindle)), Refusal::none);
    for (std::uint32_t beat = 1; beat < 5; ++beat) {
        sut.io->urgent.jog_lease.store(jog_lease_word(kToken, beat));
        sut.run(kLeaseTicks - 10);
        ASSERT_EQ(outputs(sut), bit_of(Signal::spindle));
    }
    sut.io->urgent.jog_lease.store(jog_lease_word(kToken, 0));
    sut.run(2);
    EXPECT_EQ(sut.cycle->state(), MachineState::off);
    EXPECT_EQ(outputs(sut), 0U);
    EXPECT_EQ(sut.cycle->sample().move_end, MoveEnd::released);
}

TEST(PinTrial, SaysHowItEnded) {
    MachineRig sut(quick_profile());
    ASSERT_EQ(sut.ask(test_of(Signal::spindle)), Refusal::none);
    EXPECT_EQ(sut.cycle->sample().move_end, MoveEnd::none);
    sut.run(2 * kLeaseTicks);
    EXPECT_EQ(sut.cycle->state(), MachineState::off);
    EXPECT_EQ(sut.cycle->sample().move_end, MoveEnd::lease_gone);
    ASSERT_EQ(sut.ask(test_of(Signal::r1_step, 1)), Refusal::none);
    sut.run(kLeaseTicks - 10);
    EXPECT_EQ(sut.cycle->sample().move_end, MoveEnd::reached);
}

TEST(PinTrial, SendsSoManyPulsesAndNoneOfThemIsCounted) {
    MachineRig sut(quick_profile());
    Request request = test_of(Signal::r1_step, 25);
    ASSERT_EQ(sut.ask(request), Refusal::none);
    sut.run(kLeaseTicks - 10);
    PinCounter pins(Positions{});
    for (const PortWrite& write : sut.port->writes) (void)pins.take(write.levels);
    EXPECT_EQ(pins.positions()[0], -25) << "its direction pin is low";
    EXPECT_EQ(sut.positions(), Positions{});
    EXPECT_EQ(sut.cycle->sample().emitted_pulses[0], 0U);
    EXPECT_EQ(sut.machine->report().axes[0].pulses_ignored, 25U) << "its drive is off";
}

TEST(PinTrial, LosesNoPulseToMissedTicks) {
    MachineRig sut(quick_profile());
    ASSERT_EQ(sut.ask(test_of(Signal::r1_step, 25)), Refusal::none);
    for (int i = 0; i < 52; ++i) {
        sut.run(1);
        sut.cycle->advance_missed(70);
    }
    EXPECT_EQ(sut.cycle->state(), MachineState::off);
    PinCounter pins(Positions{});
    for (const PortWrite& write : sut.port->writes) (void)pins.take(write.levels);
    EXPECT_EQ(pins.positions()[0], -25);
}

TEST(PinTrial, TakesTheNextOutputFromTheSameHandAndNobodyElses) {
    MachineRig sut(quick_profile());
    ASSERT_EQ(sut.ask(test_of(Signal::r1_dir)), Refusal::none);
    ASSERT_EQ(sut.ask(test_of(Signal::y_enable)), Refusal::none);
    EXPECT_EQ(outputs(sut), bit_of(Signal::y_enable));
    Request foreign = test_of(Signal::spindle);
    foreign.lease_token = kToken + 1;
    EXPECT_EQ(sut.ask(foreign), Refusal::not_in_this_state);
    EXPECT_EQ(outputs(sut), bit_of(Signal::y_enable));
    Request end = test_of(Signal::y_enable);
    end.value = packed(PinOrder{});
    EXPECT_EQ(sut.ask(end), Refusal::none);
    EXPECT_EQ(sut.cycle->state(), MachineState::off);
}

TEST(PinTrial, IsRefusedUnlessTheDrivesAreOffAndLosesThePositions) {
    MachineRig sut(quick_profile());
    ASSERT_EQ(sut.ask(RequestKind::home), Refusal::none);
    EXPECT_EQ(sut.ask(test_of(Signal::spindle)), Refusal::not_in_this_state);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(sut.ask(test_of(Signal::spindle)), Refusal::not_in_this_state);
    EXPECT_EQ(outputs(sut) & bit_of(Signal::spindle), 0U);
    ASSERT_EQ(sut.ask(RequestKind::drives_off), Refusal::none);
    EXPECT_EQ(sut.cycle->state(), MachineState::off);
    EXPECT_EQ(outputs(sut) & (kEnableMask | kStepMask), 0U);
    EXPECT_EQ(sut.cycle->sample().homed_mask, 0);
    EXPECT_EQ(sut.ask(RequestKind::drives_off), Refusal::not_in_this_state);
    ASSERT_EQ(sut.ask(RequestKind::reset_height), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::off));
    EXPECT_NE(sut.cycle->sample().homed_mask, 0);
    ASSERT_EQ(sut.ask(test_of(Signal::y_step)), Refusal::none);
    EXPECT_EQ(sut.cycle->sample().homed_mask, 0);
    for (const RequestKind kind : {RequestKind::home, RequestKind::reset_height, RequestKind::start,
                                   RequestKind::jog, RequestKind::move, RequestKind::spindle})
        EXPECT_NE(sut.ask(kind), Refusal::none) << static_cast<int>(kind);
    EXPECT_EQ(outputs(sut), bit_of(Signal::y_step));
}

TEST(PinTrial, EndsByStopAndByTheEmergencyStopButNotByALimitSwitchUnderAFinger) {
    MachineRig sut(quick_profile());
    sut.machine->hold_input(Signal::r1_limit, true);
    ASSERT_EQ(sut.ask(test_of(Signal::spindle)), Refusal::none);
    sut.machine->hold_input(Signal::y_limit, true);
    sut.run(100);
    EXPECT_EQ(sut.cycle->state(), MachineState::testing);
    sut.stop();
    sut.run(1);
    EXPECT_EQ(sut.cycle->state(), MachineState::off);
    EXPECT_EQ(outputs(sut), 0U);
    ASSERT_EQ(sut.ask(test_of(Signal::spindle)), Refusal::none);
    sut.machine->hold_input(Signal::estop, true);
    sut.run(2);
    EXPECT_EQ(sut.cycle->state(), MachineState::alarm);
    EXPECT_EQ(outputs(sut), 0U);
    EXPECT_EQ(sut.ask(test_of(Signal::spindle)), Refusal::not_in_this_state);
}

}  // namespace
}  // namespace psicarve::cycle
