// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>

#include "tests/rtcore/cycle/machine_rig.hpp"

namespace psicarve::cycle {
namespace {

constexpr RequestKind kCommands[] = {
    RequestKind::home,     RequestKind::start,        RequestKind::start_interpolation,
    RequestKind::hold,     RequestKind::resume,       RequestKind::reset_alarm,
    RequestKind::back_off, RequestKind::reset_height, RequestKind::job_loaded,
    RequestKind::jog,      RequestKind::jog_on,       RequestKind::move,
    RequestKind::spindle,  RequestKind::run_program};

/// Asks everything but `allowed`; all of it must be refused and change nothing.
void expect_only(MachineRig& rig, std::initializer_list<RequestKind> allowed) {
    const MachineState before = rig.cycle->state();
    for (const RequestKind kind : kCommands) {
        if (std::find(allowed.begin(), allowed.end(), kind) != allowed.end()) continue;
        EXPECT_NE(rig.ask(kind), Refusal::none)
            << "state " << name_of(before) << " request " << static_cast<int>(kind);
        EXPECT_EQ(rig.cycle->state(), before);
    }
}

TEST(States, RefuseEveryCommandThatTheyDoNotList) {
    using R = RequestKind;
    MachineRig sut(quick_profile());
    expect_only(sut, {R::home, R::reset_height, R::job_loaded});
    ASSERT_EQ(sut.ask(R::home), Refusal::none);
    expect_only(sut, {R::job_loaded});
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    expect_only(sut, {R::home, R::reset_height, R::job_loaded, R::jog, R::jog_on, R::move, R::spindle,
                      R::run_program});
    EXPECT_EQ(sut.ask(R::start), Refusal::no_job);
    sut.load(random_job(2, 60, 5));
    ASSERT_EQ(sut.ask(R::start), Refusal::none);
    expect_only(sut, {});
    ASSERT_TRUE(sut.run_until(MachineState::waiting));
    EXPECT_NE(sut.cycle->pulses().levels() & bit_of(Signal::spindle), 0U);
    expect_only(sut, {R::start_interpolation});
    ASSERT_EQ(sut.ask(R::start_interpolation), Refusal::none);
    expect_only(sut, {R::hold});
    ASSERT_EQ(sut.ask(R::hold), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::held));
    expect_only(sut, {R::resume});
    ASSERT_EQ(sut.ask(R::resume), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::finishing));
    expect_only(sut, {});
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    sut.emergency_stop();
    sut.tick();
    expect_only(sut, {R::reset_alarm, R::job_loaded});
    EXPECT_EQ(sut.ask(R::start), Refusal::not_in_this_state);
}

TEST(States, StartBeforeHomingSaysSo) {
    MachineRig sut(quick_profile());
    sut.load(random_job(1, 10, 1));
    EXPECT_EQ(sut.ask(RequestKind::start), Refusal::not_homed);
}

TEST(States, AnErrorOfThePortIsAnAlarmThatStaysUntilItAnswers) {
    MachineRig sut(quick_profile());
    ASSERT_TRUE(sut.prepare(random_job(1, 60, 5)));
    sut.ask(RequestKind::start_interpolation);
    sut.run(3000);
    sut.port->healthy = false;
    sut.run(25);
    EXPECT_EQ(sut.cycle->sample().alarm_cause, AlarmCause::port_error);
    EXPECT_EQ(sut.ask(RequestKind::reset_alarm), Refusal::port_failed);
    EXPECT_GE(sut.port->safe_tries, 25 - 10) << "the safe state, every tick";
    sut.port->answers = true;
    EXPECT_EQ(sut.ask(RequestKind::reset_alarm), Refusal::none);
    EXPECT_EQ(sut.cycle->state(), MachineState::off) << "who knows what its lines did";
    const int tries = sut.port->safe_tries;
    sut.run(25);
    EXPECT_EQ(sut.port->safe_tries, tries);
    EXPECT_TRUE(sut.home());
}

TEST(States, AFaultThatTheSupervisorFoundStopsOnThePath) {
    MachineRig sut(quick_profile());
    ASSERT_TRUE(sut.prepare(random_job(1, 60, 5)));
    sut.ask(RequestKind::start_interpolation);
    sut.run(3000);
    EXPECT_EQ(sut.ask(RequestKind::fail, 0, static_cast<std::uint64_t>(AlarmCause::segment_lost)),
              Refusal::none);
    ASSERT_TRUE(sut.run_while([&] { return sut.cycle->state() != MachineState::alarm; }, 20000));
    EXPECT_EQ(sut.cycle->sample().alarm_cause, AlarmCause::segment_lost);
    EXPECT_EQ(sut.cycle->sample().homed_mask, 0) << "its drives are off now";
    for (const Axis axis : kAllAxes) {
        EXPECT_EQ(sut.machine->position_pulses(axis), sut.positions()[index_of(axis)]);
    }
}

TEST(States, AFaultThatTheSupervisorFoundKeepsThePositionOfDrivesThatStayOn) {
    MachineRig sut(always_on_profile());
    ASSERT_TRUE(sut.prepare(random_job(1, 60, 5)));
    sut.ask(RequestKind::start_interpolation);
    sut.run(3000);
    sut.ask(RequestKind::fail, 0, static_cast<std::uint64_t>(AlarmCause::segment_lost));
    ASSERT_TRUE(sut.run_while([&] { return sut.cycle->state() != MachineState::alarm; }, 20000));
    EXPECT_EQ(sut.cycle->sample().homed_mask, 0xF);
    EXPECT_EQ(sut.ask(RequestKind::reset_alarm), Refusal::none);
    EXPECT_EQ(sut.cycle->state(), MachineState::ready);
}

TEST(States, AFaultThatTheSupervisorFoundWaitsBehindNoRequest) {
    MachineRig sut(quick_profile());
    ASSERT_TRUE(sut.prepare(random_job(1, 60, 5)));
    sut.ask(RequestKind::start_interpolation);
    sut.run(3000);
    Request request{};
    request.kind = RequestKind::override;
    request.value = 90;
    while (sut.io->requests.push(request)) {
    }
    sut.io->urgent.failures.fetch_or(failure_bits(AlarmCause::guard_lost));
    sut.run(1);
    EXPECT_EQ(sut.cycle->state(), MachineState::stopping);
    EXPECT_GT(sut.io->requests.size(), 60U);
    EXPECT_EQ(sut.io->urgent.failures.load(), 0U) << "taken once";
    ASSERT_TRUE(sut.run_while([&] { return sut.cycle->state() != MachineState::alarm; }, 20000));
    EXPECT_EQ(sut.cycle->sample().alarm_cause, AlarmCause::guard_lost);
    EXPECT_EQ(sut.records_of(RecordKind::failure).size(), 1U);
}

TEST(States, ASupervisorThatStandsStillForASecondIsAControlledStop) {
    MachineRig sut(quick_profile());
    const std::int64_t second_ticks = 20'000;
    ASSERT_TRUE(sut.home());
    sut.io->urgent.rounds.store(1);
    sut.run(2 * second_ticks);
    EXPECT_EQ(sut.cycle->state(), MachineState::ready) << "nothing moves, nothing turns";
    sut.io->urgent.rounds.store(2);
    ASSERT_EQ(sut.ask(RequestKind::spindle, 0, 1), Refusal::none);
    sut.run(second_ticks / 2);
    sut.io->urgent.rounds.store(3);
    sut.run(second_ticks);
    EXPECT_EQ(sut.cycle->state(), MachineState::ready);
    sut.run(10);
    EXPECT_EQ(sut.cycle->sample().alarm_cause, AlarmCause::supervisor_stalled);
    EXPECT_EQ(sut.cycle->pulses().levels() & bit_of(Signal::spindle), 0U);
    EXPECT_EQ(sut.records_of(RecordKind::failure).size(), 1U);
}

TEST(States, ASupervisorThatStandsStillForASecondIsOneOfTwoTimersToo) {
    Profile profile = quick_profile();
    profile.tick.schedule = Schedule::two_timer;
    profile.tick.period_us = 100.0;
    MachineRig sut(profile);
    ASSERT_TRUE(sut.home());
    ASSERT_EQ(sut.ask(RequestKind::spindle, 0, 1), Refusal::none);
    sut.io->urgent.rounds.store(1);
    const std::uint64_t begin = sut.cycle->next_tick();
    ASSERT_TRUE(sut.run_while([&] { return sut.cycle->state() != MachineState::alarm; }, 30'000));
    EXPECT_EQ(sut.cycle->sample().alarm_cause, AlarmCause::supervisor_stalled);
    const std::uint64_t second_ticks = 1'000'000'000 / static_cast<std::uint64_t>(tick_period_ns(profile));
    EXPECT_NEAR(static_cast<double>(sut.cycle->next_tick() - begin), static_cast<double>(second_ticks), 20.0);
}

TEST(States, AnAxisThatIsHomedAnewIsNotHomedUntilItHasBeen) {
    for (const unsigned axes : {0b0001U, 0b0010U, 0b0100U, 0b1000U, 0b1011U}) {
        MachineRig sut(always_on_profile());
        ASSERT_TRUE(sut.home());
        ASSERT_EQ(sut.ask(RequestKind::home, 0, axes), Refusal::none);
        EXPECT_EQ(sut.cycle->sample().homed_mask, 0xFU & ~axes);
        sut.stop();
        ASSERT_TRUE(sut.run_while([&] {
            return sut.cycle->state() == MachineState::homing || sut.cycle->state() == MachineState::stopping;
        }));
        EXPECT_EQ(sut.cycle->sample().homed_mask, 0xFU & ~axes) << "nor after a stop";
        EXPECT_EQ(sut.cycle->state(), MachineState::off);
    }
}

TEST(States, AfterAGapThatWasFoundOutsideTheAxesThatItNamesAreNotHomed) {
    for (const unsigned lost : {0b0000U, 0b0001U, 0b0010U, 0b1100U, 0b1111U}) {
        MachineRig sut(always_on_profile());
        ASSERT_TRUE(sut.home());
        sut.run(20'000);
        sut.io->urgent.failures.fetch_or(failure_bits(AlarmCause::tick_gap, static_cast<std::uint8_t>(lost)));
        sut.run(1);
        EXPECT_EQ(sut.cycle->sample().alarm_cause, AlarmCause::tick_gap);
        EXPECT_EQ(sut.cycle->sample().homed_mask, 0xFU & ~lost);
        EXPECT_EQ(sut.port->forgotten, 1) << "whoever had the port meanwhile may have written to it";
    }
}

TEST(States, TwoFaultsAtOnceAreBothRecordedAndAGapStopsAtOnce) {
    MachineRig sut(quick_profile());
    ASSERT_TRUE(sut.prepare(random_job(1, 60, 5)));
    sut.ask(RequestKind::start_interpolation);
    sut.run(3000);
    sut.io->urgent.failures.fetch_or(failure_bits(AlarmCause::segment_lost));
    sut.io->urgent.failures.fetch_or(failure_bits(AlarmCause::tick_gap, 0b1000));
    sut.run(25);
    EXPECT_EQ(sut.cycle->state(), MachineState::alarm);
    EXPECT_EQ(sut.cycle->sample().alarm_cause, AlarmCause::tick_gap);
    EXPECT_EQ(sut.cycle->sample().homed_mask & 0b1000, 0);
    EXPECT_EQ(sut.records_of(RecordKind::failure).size(), 2U);
}

TEST(States, ASecondJobDropsWholeTurnsAndVisitsItsPoints) {
    MachineRig sut(quick_profile());
    const JobTable job = random_job(7, 40, 5);
    ASSERT_TRUE(sut.prepare(job));
    for (int round = 0; round < 2; ++round) {
        const std::uint64_t begin = sut.cycle->next_tick();
        ASSERT_EQ(sut.ask(RequestKind::start_interpolation), Refusal::none);
        ASSERT_TRUE(sut.run_until(MachineState::ready));
        EXPECT_GE(sut.cycle->sample().carve_first_tick, begin) << "its own, not that of the job before";
        EXPECT_GT(sut.cycle->sample().carve_last_tick, sut.cycle->sample().carve_first_tick);
        ASSERT_EQ(sut.ask(RequestKind::start), Refusal::none);
        ASSERT_TRUE(sut.run_until(MachineState::waiting));
        EXPECT_EQ(sut.positions(), points_of(job).front());
    }
    EXPECT_EQ((sut.machine->position_pulses(Axis::psi) - sut.positions()[2]) % 6400, 0);
}

TEST(Epochs, BlocksOfAnOverTakenProgramAreNeverExecuted) {
    MachineRig sut(quick_profile());
    ASSERT_TRUE(sut.prepare(random_job(60, 400, 5)));
    sut.run(10);
    ASSERT_GT(sut.io->blocks.size(), 10000U);  // the whole carving waits in the queue
    sut.stop();
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    const Positions at = sut.positions();
    EXPECT_EQ(at[2], 0);
    sut.run(1000);
    EXPECT_EQ(sut.positions(), at);
}

}  // namespace
}  // namespace psicarve::cycle
