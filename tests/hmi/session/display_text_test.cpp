// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/display_text.hpp"

#include <gtest/gtest.h>

#include "tests/hmi/session/sights.hpp"

namespace psicarve::session {
namespace {

using test::machine_in;
using S = MachineState;

MachineView at(Axis axis, std::int64_t pulses) {
    MachineView machine = machine_in(S::ready);
    machine.status->position_pulses[index_of(axis)] = pulses;
    return machine;
}

TEST(DisplayText, ShowsMillimetresWithThePulsesBelow) {
    const AxisReadout readout = axis_readout(at(Axis::r1, 8617), Axis::r1);
    EXPECT_EQ(readout.value, "21.54");
    EXPECT_EQ(readout.unit, "mm");
    EXPECT_EQ(in_english(readout.second), "8\u2009617 pulses");
}

TEST(DisplayText, ShowsPsiWithinATurnAndTheTurns) {
    const AxisReadout ahead = axis_readout(at(Axis::psi, 157 * 6400 + 1360), Axis::psi);
    EXPECT_EQ(ahead.value, "76.50");
    EXPECT_EQ(in_english(ahead.second), "157 turns");
    const AxisReadout behind = axis_readout(at(Axis::psi, -1600), Axis::psi);
    EXPECT_EQ(behind.value, "270.00");
    EXPECT_EQ(in_english(behind.second), "\u22121 turns");
}

TEST(DisplayText, ShowsPulsesWhereTheProfileIsNotKnown) {
    MachineView machine = at(Axis::y, -30192);
    machine.profile.reset();
    EXPECT_EQ(axis_readout(machine, Axis::y).value, "\u221230\u2009192");
    EXPECT_EQ(axis_readout(machine, Axis::y).unit, "pulses");
}

TEST(DisplayText, FormatsNumbersAndTimes) {
    EXPECT_EQ(number_text(-0.001, 2), "0.00");
    EXPECT_EQ(number_text(-1234.5, 2), "\u22121\u2009234.50");
    EXPECT_EQ(count_text(1204318), "1\u2009204\u2009318");
    EXPECT_EQ(clock_text(0.4), "0:00");
    EXPECT_EQ(clock_text(758), "12:38");
    EXPECT_EQ(clock_text(3725), "1:02:05");
}

TEST(DisplayText, NamesTheStateAndItsLayer) {
    MachineView machine = machine_in(S::carving);
    machine.status->layer = 314;
    const StateText text = state_text(machine, 500);
    EXPECT_EQ(in_english(text.word), "CARVING");
    EXPECT_EQ(in_english(text.second), "Layer 315 of 500");
    EXPECT_EQ(text.tone, Tone::run);
    machine.life = CoreLife::silent;
    EXPECT_EQ(in_english(state_text(machine, 500).word), "NO CORE");
}

TEST(DisplayText, GivesEveryStateAWord) {
    for (std::uint8_t i = 0; i < kMachineStateCount; ++i) {
        EXPECT_FALSE(state_text(machine_in(static_cast<S>(i)), 0).word.is_empty()) << int{i};
    }
}

TEST(DisplayText, TellsTheTimeLeft) {
    MachineView machine = machine_in(S::carving);
    machine.status->points_total = 100;
    machine.status->points_done = 63;
    machine.status->seconds_left = 758.0;
    EXPECT_DOUBLE_EQ(done_ratio(machine), 0.63);
    EXPECT_EQ(in_english(time_text(machine)), "12:38 left");
    EXPECT_FALSE(is_time_about(machine));
    machine.status->is_left_forecast = 1;
    EXPECT_EQ(in_english(time_text(machine)), "about 12:38 left");
    EXPECT_TRUE(is_time_about(machine));
    machine.status->state = S::alarm;
    EXPECT_FALSE(is_time_about(machine));
    machine.status->job_start_tick = 500;
    EXPECT_EQ(in_english(time_text(machine)), "stopped");
    EXPECT_LT(done_ratio(machine_in(S::ready)), 0.0);
}

TEST(DisplayText, AnAlarmCutsShortOnlyTheRunThatItEnded) {
    MachineView machine = machine_in(S::alarm);
    CoreStatus& status = *machine.status;
    status.alarm_count = 1;
    status.alarms[0].tick = 900;
    EXPECT_FALSE(is_cut_short(machine)) << "there is no job";
    EXPECT_EQ(in_english(time_text(machine)), "No job running");
    status.points_total = 100;
    status.seconds_left = 60.0;
    EXPECT_FALSE(is_cut_short(machine)) << "it was not started";
    EXPECT_EQ(in_english(time_text(machine)), "1:00 planned");
    status.job_start_tick = 500;
    status.points_done = 40;
    EXPECT_TRUE(is_cut_short(machine));
    EXPECT_EQ(in_english(time_text(machine)), "stopped");
    status.state = S::backing_off;
    EXPECT_TRUE(is_cut_short(machine));
    status.state = S::alarm;
    status.alarm_count = 2;
    status.alarms[1].tick = 2000;
    EXPECT_FALSE(is_cut_short(machine)) << "the alarm before did, and was reset";
    status.alarms[0].tick = 400;
    EXPECT_TRUE(is_cut_short(machine)) << "the alarm before was before the run";
    status.points_done = 100;
    status.job_end_tick = 800;
    EXPECT_FALSE(is_cut_short(machine)) << "it was done";
    EXPECT_EQ(in_english(time_text(machine)), "done");
    status.points_done = 40;
    EXPECT_FALSE(is_cut_short(machine)) << "it was stopped in order";
    EXPECT_EQ(in_english(time_text(machine)), "");
    EXPECT_FALSE(is_left_undone(machine)) << "the alarm first";
    status.state = S::ready;
    EXPECT_TRUE(is_left_undone(machine));
    EXPECT_EQ(in_english(time_text(machine)), "stopped");
    EXPECT_EQ(in_english(time_text(machine, 10)), "stopped in layer 5") << "four are done";
    status.points_done = 100;
    EXPECT_FALSE(is_left_undone(machine));
}

TEST(DisplayText, TellsOfARunOnlyBesideItsOwnJob) {
    MachineView machine = machine_in(S::ready);
    EXPECT_TRUE(tells_of_run(machine, {OpenJobState::published}));
    EXPECT_TRUE(tells_of_run(machine, {OpenJobState::empty}));
    EXPECT_FALSE(tells_of_run(machine, {OpenJobState::model}));
    EXPECT_FALSE(tells_of_run(machine, {OpenJobState::job}));
    for (const S state : {S::carving, S::held, S::waiting}) {
        machine.status->state = state;
        EXPECT_TRUE(tells_of_run(machine, {OpenJobState::model})) << name_of(state);
    }
    machine = machine_in(S::alarm);
    EXPECT_FALSE(tells_of_run(machine, {OpenJobState::model}));
    machine.status->points_total = 100;
    machine.status->points_done = 40;
    machine.status->job_start_tick = 500;
    EXPECT_TRUE(tells_of_run(machine, {OpenJobState::model})) << "the alarm is of that run";
}

TEST(DisplayText, KnowsThePlannedTimeOfAJobThatIsNotBegun) {
    MachineView machine = machine_in(S::ready);
    EXPECT_FALSE(planned_seconds(machine));
    machine.status->points_total = 100;
    machine.status->seconds_left = 60.0;
    EXPECT_EQ(planned_seconds(machine), 60.0);
    machine.status->points_done = 1;
    EXPECT_FALSE(planned_seconds(machine)) << "that is what is left";
    machine.status->points_done = 0;
    machine.status->state = S::positioning;
    EXPECT_FALSE(planned_seconds(machine));
}

TEST(DisplayText, SaysThatThereIsNoJob) {
    EXPECT_EQ(in_english(time_text(machine_in(S::ready))), "No job running");
    EXPECT_EQ(in_english(time_text(machine_in(S::off))), "No job running");
    MachineView machine = machine_in(S::homing);
    EXPECT_TRUE(time_text(machine).is_empty());
    machine = machine_in(S::ready);
    machine.life = CoreLife::silent;
    EXPECT_TRUE(time_text(machine).is_empty()) << "nobody knows";
}

TEST(DisplayText, TellsWhenTheAlarmStoppedTheMachine) {
    MachineView machine = machine_in(S::alarm);
    CoreStatus& status = *machine.status;
    status.period_ns = 50'000;
    status.tick = 1'000'000;
    status.alarm_count = 9;
    status.alarms[0].tick = 960'000;  // the ninth
    machine.status_time = std::chrono::system_clock::time_point{std::chrono::hours{1}};
    ASSERT_TRUE(alarm_time(machine));
    EXPECT_EQ(machine.status_time - *alarm_time(machine), std::chrono::seconds{2});
    status.is_virtual_clock = 1;
    EXPECT_FALSE(alarm_time(machine)) << "its clock is not the wall's";
    status.is_virtual_clock = 0;
    status.state = S::ready;
    EXPECT_FALSE(alarm_time(machine)) << "it is over";
    EXPECT_FALSE(alarm_time(MachineView{}));
}

TEST(DisplayText, TellsHowLongTheOpenJobTakes) {
    MachineView machine = machine_in(S::ready);
    EXPECT_TRUE(job_times(machine, true, 0.0).time.is_empty());
    const JobTimes least = job_times(machine, true, 61.0);
    EXPECT_EQ(in_english(least.time), "at least 1:01");
    EXPECT_TRUE(least.is_least);
    EXPECT_TRUE(least.reference.is_empty());
    machine.status->points_total = 100;
    machine.status->points_done = 40;  // stopped once
    machine.status->seconds_left = 758.0;
    machine.status->reference_seconds = 750.0;
    const JobTimes planned = job_times(machine, true, 61.0);
    EXPECT_EQ(in_english(planned.time), "12:38 planned");
    EXPECT_EQ(in_english(planned.reference), "12:30");
    EXPECT_FALSE(planned.is_least);
    EXPECT_EQ(in_english(job_times(machine, false, 61.0).time), "at least 1:01") << "it is another job's";
    EXPECT_TRUE(job_times(machine, false, 61.0).reference.is_empty());
    const machine::PlannedTime ours{70.0, {}, 65.0};
    EXPECT_EQ(in_english(job_times(machine, false, 61.0, ours).time), "1:10 planned");
    EXPECT_EQ(in_english(job_times(machine, false, 61.0, ours).reference), "1:05");
    EXPECT_FALSE(job_times(machine, false, 61.0, ours).is_least);
    EXPECT_EQ(in_english(job_times(machine, true, 61.0, ours).time), "12:38 planned")
        << "by the machine's core";
    machine.status->state = S::carving;
    EXPECT_EQ(in_english(job_times(machine, false, 61.0, ours).time), "12:38 left");
    EXPECT_EQ(in_english(job_times(machine, false, 61.0, ours).reference), "1:05") << "as before";
    machine.status->is_left_forecast = 1;
    EXPECT_EQ(in_english(job_times(machine, false, 61.0, ours).time), "about 12:38 left");
    machine.life = CoreLife::none;
    EXPECT_EQ(in_english(job_times(machine, true, 61.0).time), "at least 1:01") << "the core is gone";
    machine.life = CoreLife::alive;
    machine.status->seconds_left = -1.0;
    EXPECT_TRUE(job_times(machine, true, 61.0).time.is_empty());
    EXPECT_TRUE(in_english(job_times(machine, true, 61.0, ours).time).ends_with(" planned"))
        << "until the core has planned what is left";
}

TEST(Phrase, PutsArgumentsInPlace) {
    EXPECT_EQ(in_english(phrase("%2 of %1, 100 %", "a", "b")), "b of a, 100 %");
    EXPECT_EQ(in_english(phrase("%1 and %3", "a")), "a and ");
}

TEST(DisplayText, TellsHowFarTheWorkIsWhileAJobRuns) {
    MachineView machine = machine_in(S::carving);
    machine.status->layer = 314;
    machine.status->point = 211;
    machine.status->period_ns = 50'000;
    machine.status->job_start_tick = 1'000;
    machine.status->tick = 1'000 + 1292 * 20'000;
    machine.status->override_percent = 80;
    EXPECT_EQ(in_english(work_text(machine, 500, 500)),
              "Layer 315 / 500 · point 212 / 500 · elapsed 21:32 · override 80 %");
    EXPECT_TRUE(work_text(machine_in(S::ready), 500, 500).is_empty());
}

TEST(DisplayText, TellsByTheClockWhenARunningJobEnds) {
    using std::chrono::seconds;
    const auto now = std::chrono::system_clock::time_point{seconds{1'000'000}};
    MachineView machine = machine_in(S::carving);
    machine.status->seconds_left = 600.0;
    EXPECT_EQ(end_time(machine, now), now + seconds{600});
    machine.status->is_virtual_clock = 1;
    EXPECT_FALSE(end_time(machine, now)) << "its seconds are not ours";
    machine.status->is_virtual_clock = 0;
    machine.status->state = S::held;
    EXPECT_FALSE(end_time(machine, now)) << "nobody knows how long it rests";
}

TEST(DisplayText, TellsWhereASimulatedMachineReallyStands) {
    MachineView machine = at(Axis::r1, 8617);
    machine.status->is_simulator = 0;
    EXPECT_EQ(in_english(commanded_and_actual(machine, Axis::r1)), "8\u2009617 pulses");
    machine.status->is_simulator = 1;
    machine.status->sim_true_position_pulses[index_of(Axis::r1)] = 8600;
    EXPECT_EQ(in_english(commanded_and_actual(machine, Axis::r1)),
              "8\u2009617 pulses counted; the simulated machine stands at 8\u2009600");
}

TEST(DisplayText, SaysOfADryRunThatItIsOne) {
    MachineView machine = machine_in(S::carving);
    machine.status->is_dry = 1;
    machine.status->layer = 2;
    EXPECT_EQ(in_english(state_text(machine, 5).word), "DRY RUN");
    EXPECT_EQ(in_english(state_text(machine, 5).second), "Layer 3 of 5");
    machine.status->state = S::held;
    EXPECT_EQ(in_english(state_text(machine, 5).word), "HELD");
    EXPECT_EQ(in_english(state_text(machine, 5).second), "Dry run, layer 3 of 5");
    machine.status->state = S::waiting;
    EXPECT_EQ(in_english(state_text(machine, 5).second), "Dry run: at its beginning");
    machine.status->state = S::ready;
    EXPECT_EQ(in_english(state_text(machine, 5).word), "READY");
}

}  // namespace
}  // namespace psicarve::session
