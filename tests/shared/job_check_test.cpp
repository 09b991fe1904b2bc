// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/shared/job_fixture.hpp"
#include "tests/shared/spiral_fixture.hpp"

namespace psicarve {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string verdict_on(const JobTable& table, const Profile& profile = {}) {
    const auto blob = job_blob_from_table(table);
    const auto view = JobView::check(blob);
    if (!view) return "no job: " + view.error().message;
    const auto result = check_job(*view, profile);
    return result ? "accepted" : result.error().message;
}

TEST(CheckJob, AcceptsWhatTheMachineCanCarve) {
    EXPECT_EQ(verdict_on(small_job()), "accepted");
}

TEST(CheckJob, AcceptsEveryRadiusFromTheCoreToTheSensor) {
    JobTable table = small_job();
    table.r_left_pulses[0] = 600;     // 1.5 mm
    table.r_right_pulses[1] = 24000;  // the last pulse at which the sensor is clear
    EXPECT_EQ(verdict_on(table), "accepted");
}

TEST(CheckJob, NamesTheFirstRadiusInsideTheCore) {
    JobTable table = small_job();
    table.r_left_pulses[7] = 599;
    table.r_right_pulses[8] = 599;
    const std::string verdict = verdict_on(table);
    EXPECT_THAT(verdict, StartsWith("layer 1, point 2: the radius of r1, 1.4975 mm (599 pulses)"));
    EXPECT_THAT(verdict, HasSubstr("core radius of 1.5000 mm (600 pulses)"));
}

TEST(CheckJob, NamesARadiusBeyondTheTravel) {
    JobTable table = small_job();
    table.r_right_pulses[14] = 24001;  // the sensor trips
    const std::string verdict = verdict_on(table);
    EXPECT_THAT(verdict, StartsWith("layer 2, point 4: the radius of r2, 60.0025 mm (24001 pulses)"));
    EXPECT_THAT(verdict, HasSubstr("above the travel, which ends at 60.0000 mm (24000 pulses)"));
}

TEST(CheckJob, NamesARadiusBelowTheTravel) {
    Profile profile;
    profile.r1.travel_mm = {5.0, 60.0};
    JobTable table = small_job(profile);
    table.r_left_pulses[0] = 1999;
    EXPECT_THAT(verdict_on(table, profile),
                HasSubstr("below the travel, which ends at 5.0000 mm (2000 pulses)"));
}

TEST(CheckJob, ReadsExtremeRadiiWithoutOverflow) {
    JobTable table = small_job();
    table.r_left_pulses[3] = std::numeric_limits<std::int32_t>::min();
    EXPECT_THAT(verdict_on(table), StartsWith("layer 0, point 3: the radius of r1, -5368709.1200 mm"));
    table.r_left_pulses[3] = std::numeric_limits<std::int32_t>::max();
    EXPECT_THAT(verdict_on(table), StartsWith("layer 0, point 3: the radius of r1, 5368709.1175 mm"));
}

TEST(CheckJob, NamesTipsCloserThanTheirClearance) {
    Profile profile;
    profile.core_radius_mm = 0.5;
    profile.r2.pulses_per_mm = 1000.0;
    profile.r2.speed_mm_s = 5.0;
    JobTable table = small_job(profile);
    table.r_left_pulses[6] = 400;    // 1 mm
    table.r_right_pulses[6] = 1000;  // 1 mm: just apart
    EXPECT_EQ(verdict_on(table, profile), "accepted");
    table.r_right_pulses[6] = 998;
    const std::string verdict = verdict_on(table, profile);
    EXPECT_THAT(verdict,
                StartsWith("layer 1, point 1: the tips of r1 at 1.0000 mm (400 pulses) and r2 at 0.9980 mm"));
    EXPECT_THAT(verdict, HasSubstr("1.9980 mm apart, closer than head_clearance_mm = 2.0000 mm"));
}

TEST(CheckJob, AllowsTheRoundingOfBothRadiiToPulses) {
    Profile profile;
    profile.core_radius_mm = 1.0;
    profile.r1.pulses_per_mm = 333.3;
    profile.r2.pulses_per_mm = 333.3;
    EXPECT_EQ(verdict_on(small_job(profile, 2, 3, 1.0), profile), "accepted");
}

TEST(CheckJob, CountsFromTheRealTip) {
    Profile profile;
    profile.r1.tip_offset_mm = 0.5;
    profile.r2.tip_offset_mm = -0.25;
    JobTable table = small_job(profile, 3, 5, 1.5);
    EXPECT_EQ(table.r_left_pulses[0], 400);
    EXPECT_EQ(table.r_right_pulses[0], 700);
    EXPECT_EQ(verdict_on(table, profile), "accepted");
    table.r_left_pulses[0] = 399;
    EXPECT_THAT(verdict_on(table, profile),
                StartsWith("layer 0, point 0: the radius of r1, 1.4975 mm (399 pulses)"));
    EXPECT_THAT(verdict_on(table, Profile{}), HasSubstr("inside the core radius"));
}

TEST(CheckJob, CountsTheClearanceFromEachHeadsOwnTip) {
    for (const bool is_r1_longer : {false, true}) {
        Profile profile;
        profile.core_radius_mm = 0.5;
        profile.head_clearance_mm = 3.0;
        (is_r1_longer ? profile.r1 : profile.r2).tip_offset_mm = 0.5;
        (is_r1_longer ? profile.r2 : profile.r1).tip_offset_mm = -0.25;
        JobTable table = small_job(profile, 3, 5, 3.0);
        // The tips stand 0.25 mm further out together than the heads: 2.75 mm, 1100 pulses.
        table.r_left_pulses[6] = 550;
        table.r_right_pulses[6] = 550;
        EXPECT_EQ(verdict_on(table, profile), "accepted");
        table.r_left_pulses[6] = 549;
        table.r_right_pulses[6] = 550;
        EXPECT_EQ(verdict_on(table, profile), "accepted") << "rounding of both to pulses";
        table.r_left_pulses[6] = 549;
        table.r_right_pulses[6] = 549;
        EXPECT_THAT(verdict_on(table, profile), HasSubstr("2.9950 mm apart, closer than head_clearance_mm"));
    }
}

TEST(CheckJob, HeightsRiseWithinTheTravel) {
    JobTable table = small_job();
    table.layer_height_pulses = {1, 2, 60000};
    EXPECT_EQ(verdict_on(table), "accepted");
    table.layer_height_pulses = {-1, 2, 3};
    EXPECT_THAT(verdict_on(table),
                StartsWith("layer 0, point 0: the height of -0.0025 mm (-1 pulses) lies outside"));
    table.layer_height_pulses = {1, 2, 60001};
    EXPECT_THAT(verdict_on(table), StartsWith("layer 2, point 0: the height of 150.0025 mm (60001 pulses)"));
    table.layer_height_pulses = {5, 5, 6};
    EXPECT_THAT(verdict_on(table),
                StartsWith("layer 1, point 0: the height of 0.0125 mm (5 pulses) does not lie above"));
    table.layer_height_pulses = {5, 7, 6};
    EXPECT_THAT(verdict_on(table), StartsWith("layer 2, point 0: "));
    table.layer_height_pulses = {5, 7, std::numeric_limits<std::int64_t>::max()};
    EXPECT_THAT(verdict_on(table), StartsWith("layer 2, point 0: "));
}

TEST(CheckJob, ALayerIsHalfARevolutionOfThisMachine) {
    Profile fine;
    fine.psi.pulses_per_rev = 128'000;
    fine.psi.speed_deg_s = 20.0;
    fine.psi.start_stop_deg_s = 5.0;
    EXPECT_THAT(verdict_on(small_job(), fine),
                HasSubstr("3200 pulses of psi, half a revolution of this machine is 64000"));
}

TEST(CheckJob, MorePointsThanPulsesAreRefused) {
    EXPECT_EQ(verdict_on(small_job({}, 1, 3201)), "accepted");
    EXPECT_THAT(verdict_on(small_job({}, 1, 3202)), HasSubstr("slice with at most 3201 points"));
}

TEST(CheckJob, DirectionsMustBeThisMachines) {
    Profile other;
    other.psi.positive_is_high = false;
    EXPECT_THAT(verdict_on(small_job(), other), HasSubstr("axis psi is the other way round"));
}

TEST(CheckJob, AcceptsASpiralThatClosesWithARing) {
    EXPECT_EQ(verdict_on(spiral_of(small_job())), "accepted");
    EXPECT_EQ(verdict_on(spiral_of(small_job({}, 1))), "accepted") << "one layer: one ring";
}

TEST(CheckJob, NamesAClosingRingAtAnotherHeight) {
    for (const std::int64_t height : {111, 109}) {
        JobTable table = spiral_of(small_job());
        table.layer_height_pulses[2] = height;
        const std::string verdict = verdict_on(table);
        EXPECT_THAT(verdict, StartsWith("layer 2, point 0: the height of 0.27"));
        EXPECT_THAT(verdict, HasSubstr("is not that of the layer below, 0.2750 mm (110 pulses)"));
        EXPECT_THAT(verdict, HasSubstr("ring that closes a spiral"));
    }
}

TEST(CheckJob, NamesARowOfASpiralThatDoesNotRise) {
    JobTable table = spiral_of(small_job({}, 4));
    table.layer_height_pulses = {100, 100, 110, 110};
    EXPECT_THAT(verdict_on(table),
                StartsWith("layer 1, point 0: the height of 0.2500 mm (100 pulses) does not lie above"));
}

TEST(CheckJob, NamesARowOfASpiralThatBeginsElsewhereThanTheOneBeforeEnds) {
    JobTable table = spiral_of(small_job());
    table.r_right_pulses[10] += 3;
    EXPECT_EQ(verdict_on(table),
              "layer 2, point 0: the radius of r2, 4003 pulses, is not the 4000 pulses in which the layer "
              "below ends: a spiral has no links; slice the model again");
}

}  // namespace
}  // namespace psicarve
