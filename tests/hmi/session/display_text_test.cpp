// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/display_text.hpp"

#include <gtest/gtest.h>

#include "tests/hmi/session/sights.hpp"

namespace psicarve::session {
namespace {

using test::machine_in;
using S = MachineState;

MachineSight at(Axis axis, std::int64_t pulses) {
    MachineSight machine = machine_in(S::ready);
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
    MachineSight machine = at(Axis::y, -30192);
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
    MachineSight machine = machine_in(S::carving);
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
    MachineSight machine = machine_in(S::carving);
    machine.status->points_total = 100;
    machine.status->points_done = 63;
    machine.status->seconds_left = 758.0;
    EXPECT_DOUBLE_EQ(done_ratio(machine), 0.63);
    EXPECT_EQ(in_english(time_text(machine)), "12:38 left");
    machine.status->state = S::alarm;
    EXPECT_EQ(in_english(time_text(machine)), "stopped");
    EXPECT_LT(done_ratio(machine_in(S::ready)), 0.0);
}

TEST(DisplayText, TellsHowLongTheOpenJobTakes) {
    MachineSight machine = machine_in(S::ready);
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
    machine.status->state = S::carving;
    EXPECT_EQ(in_english(job_times(machine, false, 61.0).time), "12:38 left");
    machine.status->seconds_left = -1.0;
    EXPECT_TRUE(job_times(machine, true, 61.0).time.is_empty());
}

TEST(Phrase, PutsArgumentsInPlace) {
    EXPECT_EQ(in_english(phrase("%2 of %1, 100 %", "a", "b")), "b of a, 100 %");
    EXPECT_EQ(in_english(phrase("%1 and %3", "a")), "a and ");
}

}  // namespace
}  // namespace psicarve::session
