// SPDX-License-Identifier: GPL-3.0-or-later
// While a program in G-code runs nothing is told of the job that ran before it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "hmi/session/action_lock.hpp"
#include "hmi/session/alarm_text.hpp"
#include "hmi/session/display_text.hpp"
#include "hmi/session/going_on.hpp"
#include "hmi/session/job_places.hpp"
#include "hmi/session/lost_core.hpp"
#include "hmi/session/message_log.hpp"
#include "shared/base/message_text.hpp"
#include "shared/wording/wording.hpp"
#include "tests/hmi/session/sights.hpp"

namespace psicarve::session {
namespace {

using test::machine_in;
using testing::HasSubstr;
using testing::Not;
using S = MachineState;

/// A program in line 12, and the status still has the figures of a job that was stopped in layer 14.
MachineView program_in(S state, ProgramHold hold = ProgramHold::none) {
    MachineView machine = machine_in(state);
    machine.heard_state = state;
    machine.status->layer = 13;
    machine.status->point = 6;
    machine.status->points_done = 1000;
    machine.status->points_total = 2000;
    machine.status->job_start_tick = 40;
    machine.status->job_end_tick = 4000;
    machine.status->tick = 80'000;
    machine.status->seconds_left = 60.0;
    machine.resumable_layer = 13;
    machine.checkpoint_layer_count = 28;
    machine.program.program = 3;
    machine.program.line = 12;
    machine.program.is_running = 1;
    machine.program.hold = hold;
    return machine;
}

MachineView lost_program(CoreLife life = CoreLife::none) {
    MachineView machine = program_in(S::carving);
    machine.life = life;
    return machine;
}

MachineView lost_program_told_by_guard() {
    MachineView machine = lost_program();
    machine.status->state = S::alarm;
    machine.status->alarm_cause = AlarmCause::core_lost;
    machine.status->alarm_axis = kNoAxis;
    return machine;
}

MachineView refused_program() {
    MachineView machine = program_in(S::held, ProgramHold::refused);
    machine.program_refusal = message_of(MessageId::program_goes_on_after_end, count_argument(13U));
    return machine;
}

std::string lock_text(Action action, const MachineView& machine) {
    const auto why = lock_of(action, machine, OpenJobView{OpenJobState::published, false, 10});
    return why ? in_english(*why) : "";
}

std::string messages_of(const MachineView& before, const MachineView& after) {
    std::string text;
    for (const Message& message : changes_between(before, after)) text += in_english(message.what) + "; ";
    return text;
}

std::vector<std::string> steps_in(const AlarmText& text) {
    std::vector<std::string> steps;
    for (const Phrase& step : text.steps) steps.push_back(in_english(step));
    return steps;
}

TEST(ProgramView, NamesTheLineWhereAJobHasItsLayer) {
    EXPECT_EQ(in_english(state_text(program_in(S::carving), 28).word), "PROGRAM");
    for (const S state : {S::carving, S::holding, S::held})
        EXPECT_EQ(in_english(state_text(program_in(state), 28).second), "Line 12") << name_of(state);
    EXPECT_EQ(in_english(state_text(program_in(S::held), 28).word), "HELD");
    MachineView not_begun = program_in(S::carving);
    not_begun.program.line = 0;
    EXPECT_EQ(in_english(state_text(not_begun, 28).second), "Before its first line");
}

TEST(ProgramView, SaysWhyItIsHeld) {
    const auto second = [](ProgramHold hold) {
        return in_english(state_text(program_in(S::held, hold), 28).second);
    };
    EXPECT_EQ(second(ProgramHold::program), "stop (M0)");
    EXPECT_EQ(second(ProgramHold::optional), "optional stop (M1)");
    EXPECT_EQ(second(ProgramHold::tool_change), "tool change (M6)");
    EXPECT_EQ(second(ProgramHold::single), "single block");
    EXPECT_EQ(second(ProgramHold::starved), "waits for more of it");
    EXPECT_EQ(second(ProgramHold::feeder_lost), "its reader is gone");
    EXPECT_EQ(second(ProgramHold::refused), "a record was refused");
    EXPECT_EQ(second(static_cast<ProgramHold>(99)), "Line 12") << "a number from shared memory";
}

TEST(ProgramView, HasNoProgressTimeOrElapsedTimeOfAJob) {
    for (const S state : {S::carving, S::holding, S::held, S::stopping}) {
        const MachineView machine = program_in(state);
        EXPECT_LT(done_ratio(machine), 0.0);
        EXPECT_EQ(in_english(time_text(machine, 28)), "Program, line 12");
        EXPECT_FALSE(end_time(machine, std::chrono::system_clock::now()));
        EXPECT_EQ(in_english(work_text(machine, 28, 100)), "Program, line 12 · override 100 %");
        EXPECT_FALSE(is_time_about(machine));
        EXPECT_NE(in_english(job_times(machine, true, 0.0).time), "1:00 left");
        EXPECT_EQ(place_in_question(machine, {OpenJobState::job}, true), JobPlace::desk);
    }
}

TEST(ProgramView, OffersNoLayerToContinueFrom) {
    for (const MachineView& machine :
         {program_in(S::carving), program_in(S::held), lost_program(), lost_program_told_by_guard()}) {
        const OpenJobView job{OpenJobState::published, false, 28, 28};
        EXPECT_FALSE(place_to_begin_with(machine, job, false));
        EXPECT_EQ(in_english(start_text(machine, job, false)), "Start");
        EXPECT_FALSE(unfinished_piece(machine, job));
    }
}

TEST(ProgramView, SaysWhatTheButtonsDo) {
    EXPECT_EQ(lock_text(Action::start, program_in(S::carving)), "Start: a program runs");
    EXPECT_EQ(lock_text(Action::from_layer, program_in(S::held)), "Start: on hold; resume or stop");
    EXPECT_EQ(lock_text(Action::jog, program_in(S::carving)), "Locked while a program runs");
    EXPECT_EQ(lock_text(Action::hold, program_in(S::carving)), "");
    EXPECT_EQ(lock_text(Action::resume, program_in(S::held, ProgramHold::tool_change)), "");
    EXPECT_EQ(lock_text(Action::resume, program_in(S::held, ProgramHold::starved)),
              "Resume: the program goes on by itself when more of it comes");
    for (const ProgramHold hold : {ProgramHold::feeder_lost, ProgramHold::refused}) {
        EXPECT_EQ(lock_text(Action::resume, program_in(S::held, hold)),
                  "Resume: nothing is left of the program; stop");
        EXPECT_EQ(lock_text(Action::stop, program_in(S::held, hold)), "");
        EXPECT_EQ(lock_text(Action::start, program_in(S::held, hold)), "Start: on hold; only Stop is left");
        EXPECT_EQ(lock_text(Action::home, program_in(S::held, hold)), "Locked on hold: stop");
    }
    EXPECT_EQ(lock_text(Action::hold, program_in(S::held, ProgramHold::starved)), "")
        << "it stays held then, when more comes";
}

TEST(ProgramView, TellsOfALostCoreWithTheProgramsLine) {
    auto text = loud_text(lost_program());
    ASSERT_TRUE(text);
    EXPECT_EQ(in_english(text->title), "The core has ended in line 12 of its program");
    EXPECT_THAT(in_english(text->detail), HasSubstr("The heads may stand in the piece."));
    EXPECT_EQ(steps_in(*text),
              (std::vector<std::string>{"Use the wired emergency stop, or the machine's own switch",
                                        "Start psicarve-rtcore", "Home all",
                                        "psicarve gcode run FILE --from-line 12"}));
    EXPECT_EQ(in_english(loud_text(lost_program(CoreLife::silent))->title),
              "The core is silent, in line 12 of its program");
    MachineView told = lost_program_told_by_guard();
    EXPECT_TRUE(is_lost_at_work(told));
    EXPECT_EQ(in_english(loud_text(told)->title), "The core has ended in line 12 of its program");
    told.heard_state.reset();  // the window came later
    EXPECT_TRUE(is_lost_at_work(told));
    EXPECT_EQ(in_english(loud_text(told)->title), "The core has ended in line 12 of its program");
    EXPECT_EQ(steps_in(*loud_text(told)).back(), "psicarve gcode run FILE --from-line 12");
}

TEST(ProgramView, TellsOfAnAlarmWithTheProgramsLine) {
    MachineView machine = test::limit_alarm(Axis::r2);
    machine.resumable_layer = 300;
    machine.program.line = 12;
    machine.is_alarm_of_program = true;
    const auto steps = steps_in(alarm_text(machine));
    EXPECT_EQ(steps.back(), "psicarve gcode run FILE --from-line 12");
    for (const std::string& step : steps) EXPECT_THAT(step, Not(HasSubstr("layer")));
    EXPECT_EQ(in_english(time_text(machine, 500)), "Program, line 12");
}

TEST(ProgramView, LogsItsBeginningItsHoldsAndItsEnd) {
    MachineView ready = program_in(S::ready);
    ready.program = {};
    EXPECT_THAT(messages_of(ready, program_in(S::carving)), HasSubstr("Program begun; "));
    EXPECT_THAT(messages_of(program_in(S::carving), program_in(S::held, ProgramHold::tool_change)),
                HasSubstr("Program held in line 12: tool change (M6); "));
    EXPECT_THAT(messages_of(program_in(S::carving), program_in(S::held, ProgramHold::single)),
                Not(HasSubstr("single")))
        << "every block";
    EXPECT_THAT(messages_of(program_in(S::carving), refused_program()),
                HasSubstr("Program held in line 12: line 13: the program goes on after its end"));
    MachineView done = program_in(S::ready);
    done.program.is_running = 0;
    done.program.is_done = 1;
    EXPECT_THAT(messages_of(program_in(S::carving), done), HasSubstr("Program done, up to line 12; "));
    done.program.is_done = 0;
    EXPECT_THAT(messages_of(program_in(S::stopping), done), HasSubstr("Program ended in line 12; "));
    EXPECT_THAT(messages_of(program_in(S::carving), lost_program()),
                HasSubstr("The core has ended in line 12 of its program"));
}

TEST(ProgramView, IsOverWhenAJobRuns) {
    MachineView machine = program_in(S::carving);
    machine.program.is_running = 0;
    EXPECT_EQ(in_english(state_text(machine, 28).second), "Layer 14 of 28");
    EXPECT_DOUBLE_EQ(done_ratio(machine), 0.5);
}

}  // namespace
}  // namespace psicarve::session
