// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/lost_core.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "hmi/session/display_text.hpp"
#include "tests/hmi/session/sights.hpp"

namespace psicarve::session {
namespace {

using test::limit_alarm;
using test::machine_in;
using testing::HasSubstr;
using S = MachineState;

/// In layer 14 of a job when it was heard last.
MachineView lost_in(S state, CoreLife life = CoreLife::none) {
    MachineView machine = machine_in(state);
    machine.life = life;
    machine.heard_state = state;
    machine.status->layer = 13;
    machine.status->point = 6;
    machine.status->points_done = 1000;
    machine.status->points_total = 2000;
    machine.resumable_layer = 13;
    return machine;
}

/// Its guard has had its say.
MachineView told_by_guard(MachineView machine) {
    machine.status->state = S::alarm;
    machine.status->alarm_cause = AlarmCause::core_lost;
    machine.status->alarm_axis = kNoAxis;
    machine.status->homed_mask = 0;
    return machine;
}

std::vector<std::string> steps_of(const AlarmText& text) {
    std::vector<std::string> steps;
    for (const Phrase& step : text.steps) steps.push_back(in_english(step));
    return steps;
}

TEST(LostCore, SaysWhereTheHeadsMayStandAndWhatToDo) {
    for (const S state : {S::carving, S::holding, S::held, S::stopping, S::finishing}) {
        const MachineView machine = lost_in(state);
        EXPECT_TRUE(is_lost_at_work(machine)) << name_of(state);
        const auto text = loud_text(machine);
        ASSERT_TRUE(text) << name_of(state);
        EXPECT_EQ(in_english(text->title), "The core has ended in layer 14, point 7");
        EXPECT_THAT(in_english(text->detail), HasSubstr("spindle may still be on"));
        EXPECT_THAT(in_english(text->detail), HasSubstr("The heads may stand in the piece."));
        EXPECT_EQ(steps_of(*text),
                  (std::vector<std::string>{"Use the wired emergency stop, or the machine's own switch",
                                            "Start psicarve-rtcore", "Home all", "Continue from layer 14"}));
        EXPECT_EQ(state_text(machine, 20).tone, Tone::alarm);
        EXPECT_EQ(in_english(state_text(machine, 20).word), "NO CORE");
    }
}

TEST(LostCore, SaysWhatItsGuardHasSwitchedOff) {
    MachineView machine = told_by_guard(lost_in(S::carving));
    auto text = loud_text(machine);
    ASSERT_TRUE(text);
    EXPECT_EQ(in_english(text->title), "The core has ended in layer 14, point 7");
    EXPECT_THAT(in_english(text->detail), HasSubstr("Its guard has switched drives and spindle off."));
    EXPECT_EQ(steps_of(*text).front(), "If anything still moves, use the wired emergency stop");
    EXPECT_EQ(steps_of(*text).back(), "Continue from layer 14");
    machine.status->is_port_silent = 1;
    text = loud_text(machine);
    EXPECT_THAT(in_english(text->detail), HasSubstr("could not switch"));
    EXPECT_EQ(steps_of(*text).front(), "Use the wired emergency stop, or the machine's own switch");
    machine.heard_state.reset();  // the window came later
    EXPECT_EQ(in_english(loud_text(machine)->title), "The core has ended in layer 14, point 7");
    machine = told_by_guard(lost_in(S::ready));  // with a job that was stopped before
    EXPECT_FALSE(is_lost_at_work(machine));
    EXPECT_EQ(in_english(loud_text(machine)->title), "The core has ended");
    EXPECT_EQ(steps_of(*loud_text(machine)).back(), "Home all");
}

TEST(LostCore, NamesTheProcessThatIsSilent) {
    const auto text = loud_text(lost_in(S::carving, CoreLife::silent));
    ASSERT_TRUE(text);
    EXPECT_EQ(in_english(text->title), "The core is silent, in layer 14, point 7");
    EXPECT_EQ(steps_of(*text),
              (std::vector<std::string>{"Use the wired emergency stop, or the machine's own switch",
                                        "End psicarve-rtcore, process 42", "Start psicarve-rtcore",
                                        "Home all", "Continue from layer 14"}));
}

TEST(LostCore, OffersOnlyLayersThatTheCheckpointKnows) {
    MachineView machine = lost_in(S::carving);
    machine.resumable_layer.reset();
    EXPECT_EQ(steps_of(*loud_text(machine)).back(), "Start: no layer was finished");
    machine.status->is_dry = 1;
    EXPECT_EQ(steps_of(*loud_text(machine)).back(), "Home all");
    EXPECT_EQ(in_english(loud_text(machine)->detail).find("in the piece"), std::string::npos);
    machine = lost_in(S::homing);
    EXPECT_EQ(in_english(loud_text(machine)->title), "The core has ended in the middle of its work");
    EXPECT_EQ(steps_of(*loud_text(machine)).back(), "Home all");
}

TEST(LostCore, AtRestIsNoneToBeLoudAbout) {
    for (const S state : {S::off, S::ready}) {
        EXPECT_FALSE(loud_text(lost_in(state))) << name_of(state);
        EXPECT_FALSE(loud_text(lost_in(state, CoreLife::silent))) << name_of(state);
        EXPECT_EQ(state_text(lost_in(state), 20).tone, Tone::idle);
    }
    EXPECT_FALSE(loud_text(MachineView{}));
    EXPECT_FALSE(loud_text(machine_in(S::carving))) << "it is there";
}

TEST(LostCore, KeepsTheAlarmThatItEndedIn) {
    MachineView machine = limit_alarm(Axis::r2);
    machine.heard_state = S::alarm;
    EXPECT_EQ(steps_of(*loud_text(machine))[1], "Reset alarm");
    machine.life = CoreLife::none;
    const auto text = loud_text(machine);
    ASSERT_TRUE(text);
    EXPECT_EQ(in_english(text->title), "Limit switch R2 closed (outer end, pin 11)");
    EXPECT_THAT(in_english(text->detail), HasSubstr("21.21 mm"));
    EXPECT_THAT(in_english(text->detail), HasSubstr("Since then the core has ended"));
    EXPECT_EQ(steps_of(*text), (std::vector<std::string>{"Start psicarve-rtcore", "Home all"}))
        << "nobody can reset it";
}

TEST(LostCore, AnEmergencyStopThatNobodyHeardComesFirst) {
    MachineView machine;
    machine.unheard_stop = true;
    auto text = loud_text(machine);
    ASSERT_TRUE(text);
    EXPECT_EQ(in_english(text->title), "Nobody heard the emergency stop");
    EXPECT_THAT(in_english(text->detail), HasSubstr("has stopped nothing"));
    EXPECT_EQ(steps_of(*text),
              (std::vector<std::string>{"Use the wired emergency stop, or the machine's own switch"}));
    machine = lost_in(S::carving);
    machine.unheard_stop = true;
    text = loud_text(machine);
    EXPECT_EQ(in_english(text->title), "Nobody heard the emergency stop");
    EXPECT_THAT(in_english(text->detail), HasSubstr("The core has ended in layer 14, point 7."));
    EXPECT_EQ(steps_of(*text),
              (std::vector<std::string>{"Use the wired emergency stop, or the machine's own switch",
                                        "Start psicarve-rtcore", "Home all", "Continue from layer 14"}));
}

}  // namespace
}  // namespace psicarve::session
