// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "rtcore/cycle/lease.hpp"
#include "tests/rtcore/cycle/machine_rig.hpp"
#include "tests/rtcore/cycle/move_requests.hpp"

namespace psicarve::cycle {
namespace {

constexpr double kTick_s = 50e-6;
constexpr double kStart_pps = 400.0;  // r1 of the default machine
constexpr double kAccel_pps2 = 40'000.0;
constexpr std::uint32_t kLeaseTicks = 4000;  // 200 ms

MachineRig homed_in_the_middle() {
    MachineRig rig(quick_profile());
    EXPECT_TRUE(rig.home());
    rig.ask(move_request({{Axis::r1, 4000}, {Axis::y, 4000}}));
    EXPECT_TRUE(rig.run_until(MachineState::ready));
    return rig;
}

double ramp_pulses(double speed_pps) {
    return (speed_pps * speed_pps - kStart_pps * kStart_pps) / (2.0 * kAccel_pps2);
}
double ramp_seconds(double speed_pps) {
    return (speed_pps - kStart_pps) / kAccel_pps2;
}

/// Way from rest, held for so many ticks, to rest again.
double way_pulses(double speed_pps, double held_ticks) {
    const double steady_s = held_ticks * kTick_s - ramp_seconds(speed_pps);
    return 2.0 * ramp_pulses(speed_pps) + steady_s * speed_pps;
}

void renew(MachineRig& rig, std::uint32_t beat, std::uint32_t token = kToken) {
    rig.io->urgent.jog_lease.store(jog_lease_word(token, beat));
}

TEST(Jog, ByADistanceMovesExactlySoMuch) {
    MachineRig sut = homed_in_the_middle();
    for (const std::int64_t way : {1, -1, 37, -1200, 0, 2000}) {
        const std::int64_t before = sut.positions()[0];
        ASSERT_EQ(sut.ask(jog_request(Axis::r1, way)), Refusal::none);
        ASSERT_TRUE(sut.run_until(MachineState::ready));
        EXPECT_EQ(sut.positions()[0], before + way);
        EXPECT_EQ(sut.machine->position_pulses(Axis::r1), before + way);
        EXPECT_EQ(sut.cycle->sample().move_end, MoveEnd::reached);
    }
}

TEST(Jog, IsNoFasterThanAsked) {
    MachineRig sut = homed_in_the_middle();
    const std::uint64_t start = sut.cycle->next_tick();
    sut.ask(jog_request(Axis::r1, 2000, 1000.0));
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    const double seconds = static_cast<double>(sut.cycle->next_tick() - start) * kTick_s;
    EXPECT_NEAR(seconds, 2.0 * ramp_seconds(1000.0) + (2000.0 - 2.0 * ramp_pulses(1000.0)) / 1000.0, 0.002);
}

TEST(ContinuousJog, EndsByItselfWhenItsLeaseIsNotRenewed) {
    MachineRig sut = homed_in_the_middle();
    ASSERT_EQ(sut.ask(jog_on_request(Axis::r1, false, 2000.0, kLeaseTicks)), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(sut.cycle->sample().move_end, MoveEnd::lease_gone);
    EXPECT_NEAR(static_cast<double>(4000 - sut.positions()[0]), way_pulses(2000.0, kLeaseTicks), 3.0);
    EXPECT_EQ(sut.machine->position_pulses(Axis::r1), sut.positions()[0]);
    EXPECT_EQ(sut.machine->report().axis(Axis::r1).stalls, 0U);
}

TEST(ContinuousJog, GoesOnWhileItIsRenewedAndEndsALeaseAfterTheLastRenewal) {
    MachineRig sut = homed_in_the_middle();
    sut.ask(jog_on_request(Axis::y, true, 500.0, kLeaseTicks));
    const std::uint64_t start = sut.cycle->next_tick();
    for (std::uint32_t beat = 2; beat < 12; ++beat) {
        sut.run(kLeaseTicks - 10);
        ASSERT_EQ(sut.cycle->state(), MachineState::moving);
        renew(sut, beat);
    }
    const auto held_ticks = static_cast<double>(sut.cycle->next_tick() - start) + kLeaseTicks;
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_NEAR(static_cast<double>(sut.positions()[3] - 4000), way_pulses(500.0, held_ticks), 3.0);
}

TEST(ContinuousJog, AnothersRenewalDoesNotKeepItGoing) {
    MachineRig sut = homed_in_the_middle();
    sut.ask(jog_on_request(Axis::psi, true, 1000.0, kLeaseTicks));
    const std::uint64_t start = sut.cycle->next_tick();
    for (std::uint32_t beat = 2; sut.cycle->state() == MachineState::moving; ++beat) {
        ASSERT_LT(beat, 100U);
        renew(sut, beat, kToken + 1);
        sut.run(100);
    }
    EXPECT_LT(sut.cycle->next_tick(), start + kLeaseTicks + 1000);
    EXPECT_EQ(sut.cycle->sample().move_end, MoveEnd::lease_gone);
}

TEST(ContinuousJog, SlowsDownAtOnceWhenItIsLetGo) {
    MachineRig sut = homed_in_the_middle();
    sut.ask(jog_on_request(Axis::r1, true, 2000.0, kLeaseTicks));
    sut.run(1500);
    renew(sut, 0);
    ASSERT_TRUE(sut.run_until(MachineState::ready, 2000));
    EXPECT_EQ(sut.cycle->sample().move_end, MoveEnd::released);
    EXPECT_NEAR(static_cast<double>(sut.positions()[0] - 4000), way_pulses(2000.0, 1500.0), 3.0);
    EXPECT_EQ(sut.records_of(RecordKind::jog_end).size(), 1U);
}

TEST(ContinuousJog, LetGoBeforeItBeganMovesNothing) {
    MachineRig sut = homed_in_the_middle();
    renew(sut, 0);
    const Positions before = sut.positions();
    ASSERT_EQ(sut.ask(jog_on_request(Axis::r1, true, 2000.0, kLeaseTicks)), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::ready, 100));
    EXPECT_EQ(sut.positions(), before);
}

TEST(ContinuousJog, RestsExactlyOnTheSoftLimit) {
    for (const bool up : {true, false}) {
        MachineRig sut = homed_in_the_middle();
        sut.ask(jog_on_request(Axis::r1, up, 4000.0, 0));
        ASSERT_TRUE(sut.run_until(MachineState::ready));
        EXPECT_EQ(sut.positions()[0], up ? 8000 : 600);
        EXPECT_EQ(sut.cycle->sample().move_end, MoveEnd::reached);
        EXPECT_EQ(sut.ask(jog_on_request(Axis::r1, up, 4000.0, 0)), Refusal::at_the_end);
        EXPECT_EQ(sut.machine->report().axis(Axis::r1).stalls, 0U);
    }
}

TEST(ContinuousJog, IsEndedByStopAndTheNextOneStartsAfresh) {
    MachineRig sut = homed_in_the_middle();
    sut.ask(jog_on_request(Axis::psi, true, 2000.0, kLeaseTicks));
    sut.run(1000);
    sut.stop();
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    const std::int64_t rest = sut.positions()[2];
    sut.run(2 * kLeaseTicks);
    EXPECT_EQ(sut.positions()[2], rest);
    ASSERT_EQ(sut.ask(jog_on_request(Axis::psi, false, 2000.0, kLeaseTicks)), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_LT(sut.positions()[2], rest);
}

TEST(ContinuousJog, AMoveAfterItHasNoLease) {
    MachineRig sut = homed_in_the_middle();
    sut.ask(jog_on_request(Axis::r1, true, 2000.0, 100));
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    sut.ask(move_request({{Axis::r1, 700}}));
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(sut.positions()[0], 700);
    EXPECT_EQ(sut.cycle->sample().move_end, MoveEnd::reached);
}

TEST(Lease, EndsExactlyItsTicksAfterTheLastChangeOfTheBeat) {
    Lease sut;
    sut.begin(kToken, 10, jog_lease_word(kToken, 5), 100);
    EXPECT_EQ(sut.end_at(jog_lease_word(kToken, 5), 109), MoveEnd::none);
    EXPECT_EQ(sut.end_at(jog_lease_word(kToken, 6), 109), MoveEnd::none);
    EXPECT_EQ(sut.end_at(jog_lease_word(kToken, 6), 118), MoveEnd::none);
    EXPECT_EQ(sut.end_at(jog_lease_word(kToken, 6), 119), MoveEnd::lease_gone);
    EXPECT_EQ(sut.end_at(jog_lease_word(kToken, 0), 110), MoveEnd::released);
    EXPECT_EQ(sut.end_at(jog_lease_word(kToken + 1, 0), 110), MoveEnd::none);
}

}  // namespace
}  // namespace psicarve::cycle
