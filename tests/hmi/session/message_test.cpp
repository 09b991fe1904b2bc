// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "hmi/session/alarm_text.hpp"
#include "hmi/session/message_log.hpp"
#include "tests/hmi/session/sights.hpp"

namespace psicarve::session {
namespace {

using test::limit_alarm;
using test::machine_in;
using S = MachineState;

std::string told(const MachineSight& before, const MachineSight& after) {
    std::string text;
    for (const Message& message : changes_between(before, after)) text += in_english(message.what) + "; ";
    return text;
}

TEST(AlarmText, NamesTheSwitchTheAxisAndTheRemedy) {
    const AlarmText text = alarm_text(limit_alarm(Axis::r2));
    EXPECT_EQ(in_english(text.title), "Limit switch R2 closed (outer end, pin 11)");
    EXPECT_EQ(in_english(text.detail),
              "Axis R2 stopped at 21.21 mm; its switch stands at 60.00 mm. Likely a chip or a broken wire at "
              "the switch, "
              "or R2 has lost steps.");
    ASSERT_EQ(text.steps.size(), 4U);
    EXPECT_EQ(in_english(text.steps[0]), "Clear switch R2, or Back off, until its lamp goes out");
    EXPECT_EQ(in_english(text.steps[3]), "From layer 315");
    EXPECT_EQ(in_english(alarm_text(limit_alarm(Axis::y)).title),
              "Limit switch Y closed (lower end, pin 10)");
}

TEST(AlarmText, SaysWhichAxisToHomeWhenItIsOne) {
    MachineSight machine = limit_alarm(Axis::r2);
    machine.status->homed_mask = 0b1101;  // all but R2
    EXPECT_EQ(in_english(alarm_text(machine).steps[2]), "Home R2");
    machine.status->homed_mask = 0b0101;  // Y neither
    EXPECT_EQ(in_english(alarm_text(machine).steps[2]), "Home all");
}

TEST(AlarmText, OfAnEmergencyStopAtRestKeepsThePositions) {
    MachineSight machine = limit_alarm(Axis::r2);
    machine.status->alarm_cause = AlarmCause::emergency_stop;
    machine.status->homed_mask = 0b1111;
    for (const Phrase& step : alarm_text(machine).steps) EXPECT_NE(in_english(step), "Home all");
    EXPECT_NE(in_english(alarm_text(machine).detail).find("No axis moved"), std::string::npos);
    machine.status->homed_mask = 0b1000;
    EXPECT_EQ(in_english(alarm_text(machine).steps[1]), "Home all");
}

// The computer's troubles may go on; the alarm is of what was.
TEST(AlarmText, CountsTheTicksThatWereMissedUpToTheAlarm) {
    MachineSight machine = machine_in(S::carving);
    const auto hear = [&machine](std::uint64_t tick, std::uint64_t missed, std::uint64_t alarms) {
        CoreStatus status = *machine.status;
        status.tick = tick;
        status.missed_ticks = missed;
        status.alarm_count = alarms;
        machine.missed_ticks_at_alarm = missed_ticks_at_alarm(machine, status);
        machine.status = status;
    };
    hear(1, 0, 0);
    hear(2, 70, 1);
    machine.status->alarm_cause = AlarmCause::missed_ticks;
    hear(3, 900, 1);
    EXPECT_NE(in_english(alarm_text(machine).detail).find("(70 since"), std::string::npos)
        << in_english(alarm_text(machine).detail);
    hear(4, 1200, 2);
    EXPECT_EQ(machine.missed_ticks_at_alarm, 1200U);
    hear(1, 5, 2);  // another core
    EXPECT_EQ(machine.missed_ticks_at_alarm, 5U);
}

TEST(AlarmText, NamesTheAxisThatMovedInAPauseOfTheComputer) {
    MachineSight machine = limit_alarm(Axis::r2);
    machine.status->alarm_cause = AlarmCause::tick_gap;
    EXPECT_EQ(in_english(alarm_text(machine).title), "The computer paused while axis R2 moved");
    EXPECT_NE(in_english(alarm_text(machine).detail).find("21.21 mm"), std::string::npos);
}

TEST(AlarmText, GivesEveryCauseATitleAndAWayOut) {
    for (std::uint8_t i = 1; i < kAlarmCauseCount; ++i) {
        MachineSight machine = limit_alarm(Axis::psi);
        machine.status->alarm_cause = static_cast<AlarmCause>(i);
        const AlarmText text = alarm_text(machine);
        EXPECT_FALSE(in_english(text.title).empty()) << int{i};
        EXPECT_FALSE(in_english(text.detail).empty()) << int{i};
        EXPECT_FALSE(text.steps.empty()) << int{i};
    }
}

TEST(MessageLog, TellsWhatBecameOfTheMachine) {
    EXPECT_EQ(told(MachineSight{}, machine_in(S::off)), "Core found, process 42; ");
    EXPECT_EQ(told(machine_in(S::off), machine_in(S::homing)), "Machine: homing; ");
    EXPECT_EQ(told(machine_in(S::ready), machine_in(S::ready)), "");
    EXPECT_EQ(told(machine_in(S::carving), limit_alarm(Axis::r2)),
              "Limit switch R2 closed (outer end, pin 11); ");
    EXPECT_EQ(told(limit_alarm(Axis::r2), limit_alarm(Axis::r2)), "");
}

TEST(MessageLog, TellsOfASecondAlarmAndOfAJob) {
    MachineSight again = limit_alarm(Axis::r1);
    again.status->alarm_count = 2;
    EXPECT_EQ(told(limit_alarm(Axis::r2), again), "Limit switch R1 closed (outer end, pin 13); ");
    MachineSight other_job = machine_in(S::ready);
    other_job.status->job_generation = 4;
    other_job.status->override_percent = 80;
    EXPECT_EQ(told(machine_in(S::ready), other_job), "Job no. 4 accepted; Feed override 100 % → 80 %; ");
}

TEST(MessageLog, TellsThatTheCoreIsGoneOrSilent) {
    MachineSight gone = machine_in(S::carving);
    gone.life = CoreLife::none;
    EXPECT_EQ(told(machine_in(S::carving), gone), "The core has ended; ");
    MachineSight half_done = limit_alarm(Axis::r2);
    half_done.status->layer = 13;
    EXPECT_EQ(told(half_done, gone), "The core has ended in layer 14; ");
    gone.life = CoreLife::silent;
    EXPECT_EQ(told(machine_in(S::carving), gone), "The core is silent; ");
}

TEST(MessageLog, KeepsTheNewest) {
    MessageLog sut;
    for (std::size_t i = 0; i < MessageLog::kMost + 5; ++i)
        sut.add(Severity::info, phrase("%1", std::to_string(i)));
    EXPECT_EQ(sut.messages().size(), MessageLog::kMost);
    EXPECT_EQ(in_english(sut.messages().front().what), "5");
    EXPECT_EQ(sut.count(), MessageLog::kMost + 5);
}

}  // namespace
}  // namespace psicarve::session
