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

std::string told(const MachineView& before, const MachineView& after) {
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

TEST(AlarmHeads, AreWhereTheAlarmIsToBeLookedFor) {
    EXPECT_EQ(alarm_heads(limit_alarm(Axis::r2)), std::vector{Axis::r2});
    EXPECT_EQ(alarm_heads(limit_alarm(Axis::y)), (std::vector{Axis::r1, Axis::r2})) << "the slide of both";
    EXPECT_TRUE(alarm_heads(limit_alarm(Axis::psi)).empty());
    MachineView machine = limit_alarm(Axis::r1);
    machine.status->alarm_axis = kNoAxis;
    EXPECT_TRUE(alarm_heads(machine).empty()) << "the computer's, say";
    machine = limit_alarm(Axis::r1);
    machine.status->state = MachineState::ready;
    EXPECT_TRUE(alarm_heads(machine).empty()) << "it is over";
    EXPECT_TRUE(alarm_heads(MachineView{}).empty());
}

TEST(AlarmText, SaysWhichAxisToHomeWhenItIsOne) {
    MachineView machine = limit_alarm(Axis::r2);
    machine.status->homed_mask = 0b1101;  // all but R2
    EXPECT_EQ(in_english(alarm_text(machine).steps[2]), "Home R2");
    machine.status->homed_mask = 0b0101;  // Y neither
    EXPECT_EQ(in_english(alarm_text(machine).steps[2]), "Home all");
}

TEST(AlarmText, OfAnEmergencyStopAtRestKeepsThePositions) {
    MachineView machine = limit_alarm(Axis::r2);
    machine.status->alarm_cause = AlarmCause::emergency_stop;
    machine.status->homed_mask = 0b1111;
    for (const Phrase& step : alarm_text(machine).steps) EXPECT_NE(in_english(step), "Home all");
    EXPECT_NE(in_english(alarm_text(machine).detail).find("No axis moved"), std::string::npos);
    machine.status->homed_mask = 0b1000;
    EXPECT_EQ(in_english(alarm_text(machine).steps[1]), "Home all");
}

// The computer's troubles may go on; the alarm is of what was.
TEST(AlarmText, CountsTheTicksThatWereMissedUpToTheAlarm) {
    MachineView machine = machine_in(S::carving);
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

TEST(AlarmText, SaysByHowMuchTheTableIsOffAndWhichLayersThatAffects) {
    MachineView machine = limit_alarm(Axis::psi);
    machine.status->alarm_cause = AlarmCause::steps_lost;
    machine.status->alarm_count = 1;
    AlarmRecord& alarm = machine.status->alarms[0];
    alarm = {100, AlarmCause::steps_lost, 2, 4, 3, 19'200, 19'240};
    const std::string before = "The Ψ index was expected at 19\u2009200 pulses and came at 19\u2009240";
    const std::string off = before + ": the table stands \u22122.250° off. Likely it was held or braked.";
    EXPECT_EQ(in_english(alarm_text(machine).detail), off + " Layers 4 to 7 can be wrong.");
    alarm.layer_count = 1;
    EXPECT_EQ(in_english(alarm_text(machine).detail), off + " Layer 4 can be wrong.");
    machine.profile->blank.radius_mm = 30.0;
    EXPECT_NE(in_english(alarm_text(machine).detail).find("stands \u22122.250° (≤ 1.178 mm) off"),
              std::string::npos)
        << in_english(alarm_text(machine).detail);
    machine.profile->blank.radius_mm = 0.0;
    alarm.layer_count = 0;
    EXPECT_EQ(in_english(alarm_text(machine).detail), off);
    machine.profile.reset();
    EXPECT_EQ(in_english(alarm_text(machine).detail), before + ". Likely the table was held or braked.");
}

TEST(AlarmText, NamesTheAxisThatMovedInAPauseOfTheComputer) {
    MachineView machine = limit_alarm(Axis::r2);
    machine.status->alarm_cause = AlarmCause::tick_gap;
    EXPECT_EQ(in_english(alarm_text(machine).title), "The computer paused while axis R2 moved");
    EXPECT_NE(in_english(alarm_text(machine).detail).find("21.21 mm"), std::string::npos);
}

TEST(AlarmText, GivesEveryCauseATitleAndAWayOut) {
    for (std::uint8_t i = 1; i < kAlarmCauseCount; ++i) {
        MachineView machine = limit_alarm(Axis::psi);
        machine.status->alarm_cause = static_cast<AlarmCause>(i);
        const AlarmText text = alarm_text(machine);
        EXPECT_FALSE(in_english(text.title).empty()) << int{i};
        EXPECT_FALSE(in_english(text.detail).empty()) << int{i};
        EXPECT_FALSE(text.steps.empty()) << int{i};
    }
}

TEST(MessageLog, TellsWhatBecameOfTheMachine) {
    EXPECT_EQ(told(MachineView{}, machine_in(S::off)), "Core found, process 42; ");
    EXPECT_EQ(told(machine_in(S::off), machine_in(S::homing)), "Machine: homing; ");
    EXPECT_EQ(told(machine_in(S::ready), machine_in(S::ready)), "");
    EXPECT_EQ(told(machine_in(S::carving), limit_alarm(Axis::r2)),
              "Limit switch R2 closed (outer end, pin 11); ");
    EXPECT_EQ(told(limit_alarm(Axis::r2), limit_alarm(Axis::r2)), "");
}

TEST(MessageLog, TellsOfASecondAlarmAndOfAJob) {
    MachineView again = limit_alarm(Axis::r1);
    again.status->alarm_count = 2;
    EXPECT_EQ(told(limit_alarm(Axis::r2), again), "Limit switch R1 closed (outer end, pin 13); ");
    MachineView other_job = machine_in(S::ready);
    other_job.status->job_generation = 4;
    other_job.status->override_percent = 80;
    other_job.status->rapid_override_percent = 50;
    EXPECT_EQ(told(machine_in(S::ready), other_job),
              "Job no. 4 accepted; Feed override 100 % → 80 %; Override of rapids 100 % → 50 %; ");
}

TEST(MessageLog, TellsThatTheCoreIsGoneOrSilent) {
    const auto lost = [](MachineView machine, CoreLife life) {
        machine.heard_state = machine.state();
        machine.life = life;
        return machine;
    };
    MachineView ready = machine_in(S::ready);
    EXPECT_EQ(told(ready, lost(ready, CoreLife::none)), "The core has ended; ");
    EXPECT_EQ(told(ready, lost(ready, CoreLife::silent)), "The core is silent; ");
    ready.status->layer = 13;
    ready.status->points_done = 1000;  // stopped there
    ready.status->points_total = 2000;
    EXPECT_EQ(told(ready, lost(ready, CoreLife::none)), "The core has ended in layer 14; ");
}

TEST(MessageLog, TellsAsAnAlarmThatTheCoreWasLostAtWork) {
    MachineView carving = machine_in(S::carving);
    carving.heard_state = S::carving;
    carving.status->layer = 13;
    carving.status->points_done = 1000;
    carving.status->points_total = 2000;
    for (const CoreLife life : {CoreLife::none, CoreLife::silent}) {
        MachineView lost = carving;
        lost.life = life;
        const auto messages = changes_between(carving, lost);
        ASSERT_EQ(messages.size(), 1U);
        EXPECT_EQ(messages[0].severity, Severity::alarm);
        EXPECT_EQ(in_english(messages[0].what), life == CoreLife::none
                                                    ? "The core has ended in layer 14, point 1"
                                                    : "The core is silent, in layer 14, point 1");
        EXPECT_EQ(in_english(messages[0].remedy),
                  "Use the wired emergency stop, or the machine's own switch");
        EXPECT_TRUE(changes_between(lost, lost).empty());
        if (life == CoreLife::silent) {
            EXPECT_EQ(told(lost, carving), "The core is heard again; ");
        }
    }
}

TEST(MessageLog, TellsOnceThatTheChosenProfileIsNotTheMachines) {
    MachineView machine = machine_in(S::ready);
    machine.core_profile_hash = 7;
    EXPECT_EQ(told(machine, machine), "");
    MachineView other = machine;
    other.unused_profile = "fine";
    EXPECT_EQ(told(machine, other),
              "Profile fine of --profile is not the machine's, which counts by its own, default; ");
    EXPECT_EQ(told(other, other), "");
    EXPECT_EQ(told(MachineView{}, other),
              "Core found, process 42; Profile fine of --profile is not the "
              "machine's, which counts by its own, default; ");
    other.profile.reset();
    EXPECT_EQ(told(machine, other),
              "Profile fine of --profile is not the machine's, which counts by another one; ");
}

TEST(MessageLog, KeepsTheNewest) {
    MessageLog sut;
    for (std::size_t i = 0; i < MessageLog::kMost + 5; ++i)
        sut.add(Severity::info, phrase("%1", std::to_string(i)));
    EXPECT_EQ(sut.messages().size(), MessageLog::kMost);
    EXPECT_EQ(in_english(sut.messages().front().what), "5");
    EXPECT_EQ(sut.count(), MessageLog::kMost + 5);
}

TEST(Messages, NameTheAxesThatTheyAreOf) {
    MachineView before = machine_in(S::homing);
    before.status->homed_mask = 0b0100;
    MachineView after = machine_in(S::homing);
    after.status->homed_mask = 0b0111;
    auto told = changes_between(before, after);
    ASSERT_EQ(told.size(), 1U);
    EXPECT_EQ(in_english(told[0].what), "Homed");
    EXPECT_EQ(told[0].axes, "R1 R2");
    EXPECT_EQ(changes_between(after, before).size(), 0U) << "homing anew forgets what it will find";
    before.status->state = S::ready;
    told = changes_between(after, before);
    ASSERT_EQ(told.size(), 2U);
    EXPECT_EQ(in_english(told[1].what), "Position not certain any more");
    EXPECT_EQ(told[1].axes, "R1 R2");
    told = changes_between(machine_in(S::carving), limit_alarm(Axis::r2));
    ASSERT_FALSE(told.empty());
    EXPECT_EQ(told[0].axes, "R2");
}

TEST(Messages, TellOnceThatMemoryAndDiskDisagree) {
    const MachineView before = machine_in(S::off);
    MachineView after = before;
    after.job_remarks = {
        message_of(MessageId::segment_and_disk_disagree, count_argument(7), count_argument(4))};
    EXPECT_EQ(told(before, after),
              "The computer's memory says 7 layers, its disk 4: the lower number is taken.; ");
    EXPECT_EQ(told(after, after), "");
    EXPECT_NE(told(MachineView{}, after).find("memory says 7"), std::string::npos)
        << "to a window that is opened then";
}

TEST(Messages, TellOfADiskThatTakesNothing) {
    const MachineView before = machine_in(S::carving);
    MachineView after = before;
    after.is_disk_refusing = true;
    EXPECT_EQ(told(before, after), "The disk does not take how far the piece has come; ");
    EXPECT_EQ(told(after, after), "");
    EXPECT_EQ(told(after, before), "");
}

}  // namespace
}  // namespace psicarve::session
