// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/run_watch.hpp"

#include <gtest/gtest.h>

#include "tests/hmi/session/sights.hpp"

namespace psicarve::session {
namespace {

using test::machine_in;
using S = MachineState;
constexpr RunWatch::Clock::time_point kWatchNow{std::chrono::hours{1}};

MachineView running(S state, std::uint64_t start_tick, std::uint64_t emitted) {
    MachineView view = machine_in(state);
    CoreStatus& status = *view.status;
    status.tick = start_tick + emitted;
    status.job_start_tick = start_tick;
    for (std::uint64_t& pulses : status.emitted_pulses) pulses = emitted;
    status.points_total = 100;
    status.points_done = state == S::ready ? 100 : 50;
    status.carve_first_tick = start_tick + 10;
    status.carve_last_tick = state == S::ready ? start_tick + 20'010 : 0;
    status.job_end_tick = state == S::ready ? start_tick + 40'000 : 0;
    status.reference_seconds = 0.9;
    return view;
}

std::string value_of(const RunWatch& watch, const std::string& name) {
    for (const ReportRow& row : run_rows(*watch.run(), watch.is_over(), 10, {}, watch.seen_from_layer())) {
        if (in_english(row.name) == name) return in_english(row.value);
    }
    return "no such row";
}

TEST(RunWatch, HasNoRunBeforeAJobIsStarted) {
    RunWatch sut;
    sut.note(machine_in(S::ready), kWatchNow);
    EXPECT_FALSE(sut.run());
}

TEST(RunWatch, TellsARunFromStartToEndAndNothingOfWhatComesAfter) {
    RunWatch sut;
    sut.note(machine_in(S::ready), kWatchNow);
    sut.note(running(S::carving, 500, 1'000), kWatchNow);
    EXPECT_FALSE(sut.is_over());
    EXPECT_EQ(value_of(sut, "Result"), "under way");
    sut.note(running(S::ready, 500, 2'345), kWatchNow);
    EXPECT_TRUE(sut.is_over());
    sut.note(running(S::moving, 500, 9'999), kWatchNow);  // a jog
    EXPECT_EQ(value_of(sut, "Result"), "carved to the last point");
    EXPECT_EQ(value_of(sut, "Pulses of Y, with the ways in and out"), "2\u2009345");
    EXPECT_EQ(value_of(sut, "Carving time"), "0:01");
    EXPECT_EQ(value_of(sut, "Total time"), "0:02");
    sut.note(running(S::positioning, 90'000, 5), kWatchNow);
    EXPECT_FALSE(sut.is_over());
    EXPECT_EQ(value_of(sut, "Pulses of R1, with the ways in and out"), "5");
}

TEST(RunWatch, CountsTheAlarmsOfTheRunAlone) {
    RunWatch sut;
    MachineView before = machine_in(S::ready);
    before.status->alarm_count = 2;
    before.status->missed_ticks = 7;
    sut.note(before, kWatchNow);
    MachineView alarm = running(S::alarm, 500, 100);
    alarm.status->alarm_count = 3;
    alarm.status->missed_ticks = 9;
    sut.note(alarm, kWatchNow);
    EXPECT_EQ(value_of(sut, "Result"), "ended by an alarm");
    EXPECT_EQ(value_of(sut, "Alarms"), "1");
    EXPECT_EQ(value_of(sut, "Missed ticks"), "2");
}

TEST(RunWatch, SaysFromWhichLayerOnItSawARunThatItFound) {
    RunWatch sut;
    MachineView found = running(S::carving, 500, 1'000);
    found.status->layer = 4;
    found.status->missed_ticks = 7;
    sut.note(found, kWatchNow);
    found.status->missed_ticks = 9;
    sut.note(found, kWatchNow);
    EXPECT_EQ(sut.seen_from_layer(), 4U);
    EXPECT_EQ(value_of(sut, "Missed ticks"), "2 since layer 5, when this window came");
    sut.note(running(S::ready, 500, 2'345), kWatchNow);
    sut.note(running(S::carving, 90'000, 5), kWatchNow);  // the next one, from its start
    EXPECT_FALSE(sut.seen_from_layer());
}

TEST(RunWatch, ForgetsTheRunsOfACoreThatIsNoMore) {
    RunWatch sut;
    sut.note(running(S::carving, 500, 1'000), kWatchNow);
    EXPECT_TRUE(sut.run());
    MachineView next = machine_in(S::off, 0);
    next.core_pid = 43;
    sut.note(next, kWatchNow);
    EXPECT_FALSE(sut.run());
}

TEST(RunWatch, DoesNotCallADryRunCarved) {
    RunWatch sut;
    MachineView machine = running(S::carving, 500, 1'000);
    machine.status->is_dry = 1;
    sut.note(machine, kWatchNow);
    machine = running(S::ready, 500, 2'345);
    machine.status->is_dry = 1;
    sut.note(machine, kWatchNow);
    EXPECT_EQ(value_of(sut, "Result"), "dry run to the last point: nothing was carved");
    EXPECT_EQ(value_of(sut, "Verified"), "no: a dry run carves nothing");
}

}  // namespace
}  // namespace psicarve::session
