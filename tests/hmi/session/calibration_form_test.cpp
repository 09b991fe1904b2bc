// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/calibration_form.hpp"

#include <gtest/gtest.h>

#include "hmi/phrase/error_phrase.hpp"
#include "tests/hmi/session/sights.hpp"

namespace psicarve::session {
namespace {

using profile::ProfileDraft;
using test::machine_in;
using S = MachineState;

std::string english(const std::optional<Phrase>& text) {
    return text ? in_english(*text) : "nothing";
}

TEST(CalibrationForm, MakesOfWhatIsTypedWhatTheCommandLineWould) {
    CalibrationForm form;
    form[0] = {" 6 ", "2,82", "", "", ""};
    form[2] = {"40", "", "0", "\u22120.25", ""};
    form[3] = {"", "", "", "", "+0.05"};
    const CalibrationOutcome outcome = reckon(ProfileDraft{}, form);
    for (const StepOutcome& step : outcome.steps) EXPECT_EQ(english(step.problem), "nothing");
    EXPECT_EQ(changes_text(outcome.draft),
              "axis.r1.tip_offset_mm: 0.0 -> 0.18000\naxis.r1.tool_wear_mm: 0.0 -> 0.05000\n"
              "head.r2.height_error_mm: 0.0 -> -0.25000\n");
    ASSERT_EQ(outcome.steps[0].changes.size(), 1U);
    EXPECT_EQ(outcome.steps[0].changes[0].to, "0.18000");
    EXPECT_TRUE(outcome.steps[1].changes.empty());
    EXPECT_EQ(outcome.steps[3].changes.front().key, "axis.r1.tool_wear_mm");
}

TEST(CalibrationForm, SaysAtItsStepWhatCannotBe) {
    CalibrationForm form;
    form[1] = {"6", "thirty", "", "", ""};
    form[4] = {"", "", "", "", "9"};
    const CalibrationOutcome outcome = reckon(ProfileDraft{}, form);
    EXPECT_EQ(english(outcome.steps[0].problem), "nothing");
    EXPECT_EQ(english(outcome.steps[1].problem), "thirty is not a number");
    EXPECT_EQ(english(outcome.steps[4].problem),
              "a tool does not become 9.000 mm shorter; 0 to 5 mm, else touch the head off anew");
    EXPECT_EQ(english(write_lock(outcome, machine_in(S::ready))), "Write: step 2 cannot be");
}

TEST(CalibrationForm, IsWrittenOnceSomethingWasMeasuredAndWhileNothingMoves) {
    CalibrationForm form;
    EXPECT_EQ(english(write_lock(reckon(ProfileDraft{}, form), machine_in(S::ready))),
              "Write: nothing was measured");
    form[4].wear = "0.1";
    const CalibrationOutcome outcome = reckon(ProfileDraft{}, form);
    EXPECT_EQ(english(write_lock(outcome, machine_in(S::ready))), "nothing");
    EXPECT_EQ(english(write_lock(outcome, machine_in(S::moving))), "Write: the machine moves");
    EXPECT_EQ(english(write_lock(outcome, MachineView{})), "nothing") << "without a core, too";
}

TEST(CalibrationForm, AsksTheCoreOnlyByItsOwnProfile) {
    MachineView machine = machine_in(S::ready);
    machine.core_profile_hash = profile_hash(Profile{});
    EXPECT_EQ(english(place_lock(machine, "a.toml", Profile{}, Axis::r1)), "nothing");
    machine.core_profile_hash += 1;
    EXPECT_EQ(english(place_lock(machine, "a.toml", Profile{}, Axis::r1)),
              "Here: the core runs with another profile than a.toml; start it with that one");
    machine.core_profile_hash -= 1;
    machine.status->state = S::off;
    EXPECT_EQ(english(place_lock(machine, "a.toml", Profile{}, Axis::r2)),
              "Here: the machine is off; home it, jog R2 to the pin, and let it rest");
    EXPECT_EQ(english(place_lock(MachineView{}, "a.toml", Profile{}, Axis::r1)),
              "No core serves the segment");
}

// A sentence that no table knows would stand there untranslated.
TEST(CalibrationForm, HasWordsOfItsOwnForEveryRefusal) {
    const CalibrationTexts refused[][2] = {
        {{"0", "3", "", "", ""}, {"0.1", "3", "", "", ""}},
        {{"6", "99", "", "", ""}, {"600", "3", "", "", ""}},
        {{"6", "", "", "", ""}, {"", "3", "", "", ""}},
    };
    for (const auto& pair : refused) {
        for (const CalibrationTexts& texts : pair) {
            CalibrationForm form;
            form[0] = texts;
            const auto problem = reckon(ProfileDraft{}, form).steps[0].problem;
            ASSERT_TRUE(problem) << texts.diameter;
            EXPECT_STRNE(problem->english, "%1") << in_english(*problem);
        }
    }
    const CalibrationTexts marks[] = {{"0", "", "1", "1", ""},
                                      {"40", "", "30", "0", ""},
                                      {"40", "", "0", "30", ""},
                                      {"40", "", "0", "", ""},
                                      {"", "", "1", "1", ""}};
    for (const CalibrationTexts& texts : marks) {
        CalibrationForm form;
        form[2] = texts;
        const auto problem = reckon(ProfileDraft{}, form).steps[2].problem;
        ASSERT_TRUE(problem) << texts.around;
        EXPECT_STRNE(problem->english, "%1") << in_english(*problem);
    }
}

}  // namespace
}  // namespace psicarve::session
