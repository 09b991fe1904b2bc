// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/axis_actions.hpp"

#include <gtest/gtest.h>

#include "tests/hmi/session/sights.hpp"

namespace psicarve::session {
namespace {

using test::machine_in;
using S = MachineState;

std::string said(const std::optional<Phrase>& lock) {
    return lock ? in_english(*lock) : "";
}

TEST(HomeLock, LetsPsiWaitForTheHeads) {
    EXPECT_EQ(said(home_lock(machine_in(S::off, 0), Axis::r1)), "");
    EXPECT_EQ(said(home_lock(machine_in(S::off, 0), Axis::y)), "");
    EXPECT_EQ(said(home_lock(machine_in(S::off, 0b0001), Axis::psi)), "Home Ψ: home R1 and R2 first");
    EXPECT_EQ(said(home_lock(machine_in(S::off, 0b0011), Axis::psi)), "");
    EXPECT_EQ(said(home_lock(machine_in(S::carving), Axis::r2)), "Locked while carving");
    EXPECT_EQ(said(home_lock(machine_in(S::testing, 0), Axis::r2)), "Locked by the wiring test");
    EXPECT_EQ(said(home_lock(MachineView{}, Axis::r2)), "No core serves the segment");
}

TEST(ZeroLock, WantsAPositionThatMeansSomething) {
    EXPECT_EQ(said(zero_lock(machine_in(S::ready), Axis::psi)), "");
    EXPECT_EQ(said(zero_lock(machine_in(S::off, 0b0111), Axis::y)), "Zero: axis Y is not homed");
    EXPECT_EQ(said(zero_lock(machine_in(S::carving), Axis::y)), "Locked while carving");
    MachineView machine = machine_in(S::ready);
    machine.profile.reset();
    EXPECT_EQ(said(zero_lock(machine, Axis::y)), "Zero: the machine's profile is not known here");
}

TEST(DrivesOffLock, IsOpenAtRestAlone) {
    EXPECT_EQ(said(drives_off_lock(machine_in(S::ready))), "");
    EXPECT_EQ(said(drives_off_lock(machine_in(S::off, 0))), "Drives off: they are off");
    EXPECT_EQ(said(drives_off_lock(machine_in(S::moving))), "Locked while an axis moves");
    MachineView holding = machine_in(S::off, 0b0001);
    holding.status->signals |= bit_of(Signal::r1_enable);
    EXPECT_EQ(said(drives_off_lock(holding)), "") << "R1 was homed alone, and its drive is on";
}

TEST(WorkZero, ShowsPositionsFromTheOperatorsZero) {
    MachineView machine = machine_in(S::ready);
    machine.status->position_pulses[index_of(Axis::r1)] = 400 * 21;
    machine.status->position_pulses[index_of(Axis::psi)] = 6400 * 3 + 1600;
    EXPECT_DOUBLE_EQ(position_of(machine, Axis::r1).value(), 21.0);
    EXPECT_DOUBLE_EQ(position_of(machine, Axis::psi).value(), 90.0);
    WorkZero sut;
    EXPECT_FALSE(from_zero(machine, Axis::r1, sut.of(Axis::r1)));
    sut.set(Axis::r1, 25.0);
    sut.set(Axis::psi, 100.0);
    EXPECT_DOUBLE_EQ(from_zero(machine, Axis::r1, sut.of(Axis::r1)).value(), -4.0);
    EXPECT_DOUBLE_EQ(from_zero(machine, Axis::psi, sut.of(Axis::psi)).value(), 350.0);
    EXPECT_FALSE(is_at_zero(from_zero(machine, Axis::r1, sut.of(Axis::r1))));
    EXPECT_TRUE(is_at_zero(from_zero(machine, Axis::r1, position_of(machine, Axis::r1))));
    machine.status->homed_mask = 0b1110;
    EXPECT_FALSE(from_zero(machine, Axis::r1, sut.of(Axis::r1))) << "where it stands is not known";
}

}  // namespace
}  // namespace psicarve::session
