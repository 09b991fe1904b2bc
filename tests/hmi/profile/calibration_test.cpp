// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/profile/calibration.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "hmi/profile/calibration_steps.hpp"
#include "shared/base/units.hpp"

namespace psicarve::profile {
namespace {

using testing::HasSubstr;

std::string refusal(const Result<void>& result) {
    return result ? std::string{} : result.error().message;
}

Profile profile_of(const ProfileDraft& draft) {
    const auto profile = draft.profile();
    EXPECT_TRUE(profile.has_value());
    return profile ? *profile : Profile{};
}

TEST(Calibration, ATipThatTouchesThePinFurtherInThanCountedStandsFurtherOut) {
    ProfileDraft sut;
    ASSERT_EQ(refusal(tool_wear(sut, Axis::r1, 0.4)), "");
    ASSERT_EQ(refusal(touch_off(sut, Axis::r1, 6.0, 2.82)), "");
    ASSERT_EQ(refusal(touch_off(sut, Axis::r2, 6.0, 3.12)), "");
    EXPECT_DOUBLE_EQ(profile_of(sut).r1.tip_offset_mm, 0.18);
    EXPECT_DOUBLE_EQ(profile_of(sut).r2.tip_offset_mm, -0.12);
    EXPECT_EQ(profile_of(sut).r1.tool_wear_mm, 0.0) << "what was touched off is as long as it is";
    ASSERT_EQ(refusal(tool_wear(sut, Axis::r1, 0.05)), "");
    EXPECT_DOUBLE_EQ(profile_of(sut).r1.tip_mm(), 0.23);
}

TEST(Calibration, TwoMarksAreAnAngleAndAHeight) {
    ProfileDraft sut;
    ASSERT_EQ(refusal(two_marks(sut, 40.0, 20.0 * kPi / 180.0, -0.25)), "");
    EXPECT_NEAR(profile_of(sut).head_r2_angle_error_deg, 1.0, 1e-5);
    EXPECT_DOUBLE_EQ(profile_of(sut).head_r2_height_error_mm, -0.25);
}

TEST(Calibration, RefusesWhatNobodyCanHaveMeasuredAndLeavesTheDraft) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    ProfileDraft sut;
    EXPECT_THAT(refusal(touch_off(sut, Axis::r1, -6.0, 3.0)), HasSubstr("pin"));
    EXPECT_THAT(refusal(touch_off(sut, Axis::r1, 0.0, 3.0)), HasSubstr("pin"));
    EXPECT_THAT(refusal(touch_off(sut, Axis::r1, kNan, 3.0)), HasSubstr("pin"));
    EXPECT_THAT(refusal(touch_off(sut, Axis::r1, 60.0, 3.0)), HasSubstr("pin's diameter"));
    EXPECT_THAT(refusal(touch_off(sut, Axis::r2, 6.0, 61.0)), HasSubstr("travel"));
    EXPECT_THAT(refusal(touch_off(sut, Axis::r2, 6.0, kNan)), HasSubstr("r2"));
    EXPECT_THAT(refusal(two_marks(sut, 40.0, 35.0, 0.0)), HasSubstr("half a turn"));
    EXPECT_THAT(refusal(two_marks(sut, 40.0, kNan, 0.0)), HasSubstr("half a turn"));
    EXPECT_THAT(refusal(two_marks(sut, 40.0, 0.1, 25.0)), HasSubstr("height"));
    EXPECT_THAT(refusal(two_marks(sut, 0.0, 0.1, 0.1)), HasSubstr("blank"));
    EXPECT_THAT(refusal(tool_wear(sut, Axis::r1, -0.1)), HasSubstr("shorter"));
    EXPECT_THAT(refusal(tool_wear(sut, Axis::r1, 6.0)), HasSubstr("touch the head off"));
    EXPECT_EQ(sut.changed_count(), 0U);
}

TEST(Calibration, SaysWhatItChanges) {
    ProfileDraft sut;
    EXPECT_EQ(changes_text(sut), "");
    ASSERT_EQ(refusal(tool_wear(sut, Axis::r2, 0.05)), "");
    EXPECT_THAT(changes_text(sut), HasSubstr("axis.r2.tool_wear_mm: 0"));
}

}  // namespace
}  // namespace psicarve::profile
