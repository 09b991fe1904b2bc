// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/profile/calibration_steps.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace psicarve::profile {
namespace {

using testing::HasSubstr;
using Step = CalibrationStep;

template <typename T>
std::string refusal(const Result<T>& result) {
    return result ? std::string{} : result.error().message;
}

CoreStatus at_rest(std::int64_t r2_pulses) {
    CoreStatus status{};
    status.state = MachineState::ready;
    status.position_pulses[index_of(Axis::r2)] = r2_pulses;
    return status;
}

TEST(CalibrationSteps, LeaveTheProfileWhereNothingIsAnswered) {
    ProfileDraft sut;
    for (const Step step : kCalibrationSteps) EXPECT_EQ(refusal(take_answers(sut, step, {})), "");
    EXPECT_TRUE(changes_of(sut).empty());
}

TEST(CalibrationSteps, PutEachMeasurementAtItsKey) {
    ProfileDraft sut;
    CalibrationAnswers answers;
    answers.diameter_mm = 6.0;
    answers.counted_mm = 2.82;
    ASSERT_EQ(refusal(take_answers(sut, Step::touch_off_r2, answers)), "");
    answers = {};
    answers.wear_mm = 0.04;
    ASSERT_EQ(refusal(take_answers(sut, Step::wear_r1, answers)), "");
    answers = {};
    answers.diameter_mm = 40.0;
    answers.around_mm = 0.0;
    answers.up_mm = 0.2;
    ASSERT_EQ(refusal(take_answers(sut, Step::two_marks, answers)), "");
    EXPECT_EQ(changes_text(sut),
              "axis.r1.tool_wear_mm: 0.0 -> 0.04000\naxis.r2.tip_offset_mm: 0.0 -> 0.18000\n"
              "head.r2.height_error_mm: 0.0 -> 0.20000\n");
}

TEST(CalibrationSteps, SayWhichAnswerIsMissing) {
    ProfileDraft sut;
    CalibrationAnswers answers;
    answers.counted_mm = 3.0;
    EXPECT_THAT(refusal(take_answers(sut, Step::touch_off_r1, answers)), HasSubstr("diameter of the pin"));
    answers = {};
    answers.diameter_mm = 6.0;
    EXPECT_THAT(refusal(take_answers(sut, Step::touch_off_r1, answers)), HasSubstr("where r1 stands"));
    EXPECT_THAT(refusal(take_answers(sut, Step::two_marks, answers)), HasSubstr("both ways"));
    answers = {};
    answers.up_mm = 0.1;
    EXPECT_THAT(refusal(take_answers(sut, Step::two_marks, answers)), HasSubstr("diameter of the blank"));
    EXPECT_EQ(sut.changed_count(), 0U);
}

TEST(CalibrationSteps, AskWhereAHeadStandsOnlyOfACoreThatCountsByThisProfileAndRests) {
    const Profile profile;
    const std::uint64_t hash = profile_hash(profile);
    const auto place = counted_place_mm("a.toml", profile, hash, at_rest(1200), Axis::r2);
    ASSERT_TRUE(place);
    EXPECT_DOUBLE_EQ(*place, 3.0);
    EXPECT_THAT(refusal(counted_place_mm("a.toml", profile, hash + 1, at_rest(1200), Axis::r2)),
                HasSubstr("another profile than a.toml"));
    CoreStatus moves = at_rest(1200);
    moves.state = MachineState::moving;
    EXPECT_THAT(refusal(counted_place_mm("a.toml", profile, hash, moves, Axis::r2)),
                HasSubstr("the machine is moving; home it, jog r2"));
}

}  // namespace
}  // namespace psicarve::profile
