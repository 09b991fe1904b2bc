// SPDX-License-Identifier: GPL-3.0-or-later
// The warnings about a blank that does not suit the model, the machine, the tool or another job.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "hmi/cam/blank_check.hpp"
#include "hmi/cam/prepared_job.hpp"
#include "shared/base/units.hpp"
#include "tests/hmi/cam/built_job.hpp"
#include "tests/hmi/cam/off_axis.hpp"
#include "tests/hmi/model/shapes.hpp"

namespace psicarve::cam {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

TEST(Blank, OffTheAxisIsWarnedOfWhereTheModelStandsOut) {
    Profile profile = off_axis();
    // Opposite to the offset the blank begins 7 mm from the axis: direction 127.
    const model::Mesh body = shapes::cylinder(8.0, 0.0, 10.0, 720);
    EXPECT_THAT(
        built(body, profile, small(4, 361)).report.warnings,
        Contains(HasSubstr("stands out of the blank, which is off the table's axis, by up to 1.00 mm in "
                           "direction 127 deg")));
    EXPECT_THAT(built(shapes::cylinder(6.9, 0.0, 10.0, 720), profile, small(4, 361)).report.warnings,
                Not(Contains(HasSubstr("blank"))));
}

TEST(Blank, ThatAHeadWouldStandInIsRefused) {
    const model::Mesh body = shapes::cylinder(8.0, 0.0, 10.0, 90);
    Profile profile;
    profile.blank = {50.0, 20.0, 20.0, 0.0};
    const auto wide = build_job(body, profile, small(4, 9));
    ASSERT_FALSE(wide.has_value());
    EXPECT_THAT(wide.error().message,
                EndsWith(": the blank reaches out to 70.00 mm, but head r1 only to 60.00 mm: it would stand "
                         "in the blank before the carving begins; take a smaller blank"));
    profile.blank = {50.0, 20.0};
    profile.r2.travel_mm = {0.0, 45.0};
    const auto one_head = build_job(body, profile, small(4, 9));
    ASSERT_FALSE(one_head.has_value());
    EXPECT_THAT(one_head.error().message, HasSubstr("head r2 only to 45.00 mm"));
    // A job of an older program has it in its profile.
    profile.blank.radius_mm = 12.0;
    BuiltJob old = built(body, profile, small(4, 9));
    profile.blank.radius_mm = 50.0;
    const auto opened = prepare_blob(job_blob_from_table(old.table), profile, "old.job");
    ASSERT_FALSE(opened.has_value());
    EXPECT_THAT(opened.error().message, HasSubstr("old.job: the blank reaches out to 50.00 mm"));
}

TEST(Blank, ThatLeavesLessRoomThanTheClearanceIsWarnedOf) {
    const model::Mesh body = shapes::cylinder(8.0, 0.0, 10.0, 90);
    const auto warnings = [&body](double radius_mm) {
        Profile profile;
        profile.blank = {radius_mm, 20.0};
        return built(body, profile, small(4, 9)).report.warnings;
    };
    EXPECT_THAT(warnings(59.0), Contains("the heads can go only 1.00 mm out of the blank before they begin, "
                                         "not the 2.00 mm of job.clearance_mm"));
    EXPECT_THAT(warnings(60.0), Contains(HasSubstr("only 0.00 mm out of the blank")));
    EXPECT_THAT(warnings(58.0), Not(Contains(HasSubstr("clearance_mm"))));
    // Without one, what is carved is the model at least.
    EXPECT_THAT(built(shapes::cylinder(59.5, 0.0, 10.0, 90), Profile{}, small(4, 9)).report.warnings,
                Contains(HasSubstr("only 0.50 mm out of the blank")));
    EXPECT_THAT(warnings(0.0), Not(Contains(HasSubstr("clearance_mm"))));
}

TEST(Blank, OfAJobIsHeldAgainstTheMachines) {
    const auto told = [](const BlankProfile& job, const BlankProfile& machine) {
        const auto other = blank_difference(job, machine);
        return other ? blank_difference_text(*other) : std::string{};
    };
    const BlankProfile blank{20.0, 60.0, 1.0, 0.0};
    EXPECT_EQ(told(blank, blank), "");
    EXPECT_EQ(told(blank, {}), "") << "the machine's profile tells of none";
    EXPECT_EQ(told({}, blank), "");
    EXPECT_EQ(told(blank, {20.0, 0.0, 1.0, 0.0}), "") << "a height that is not known";
    EXPECT_EQ(
        told({20.0, 60.0}, {25.0, 60.0}),
        "the job was made for a blank of 20.00 mm radius, the machine's profile tells of 25.00 mm; what "
        "is larger is in the heads' way: mount the job's, or slice again");
    EXPECT_EQ(
        told({20.0, 60.0}, {15.0, 60.0}),
        "the job was made for a blank of 20.00 mm radius, the machine's profile tells of 15.00 mm; with "
        "what is smaller a part of the job is air");
    EXPECT_THAT(told({20.0, 60.0}, {20.0, 61.0}),
                AllOf(HasSubstr("60.00 mm height"), HasSubstr("in the heads' way")));
    EXPECT_THAT(told({20.0, 60.0}, {20.0, 59.0}), HasSubstr("a part of the job is air"));
    // The one that is in the way comes first.
    EXPECT_THAT(told({20.0, 60.0}, {15.0, 61.0}), AllOf(HasSubstr("height"), HasSubstr("in the heads' way")));
    EXPECT_THAT(told(blank, {20.0, 60.0, 1.0, 3.0}),
                AllOf(HasSubstr("stands 3.00 mm beside"), HasSubstr("in the heads' way")));
    // Smaller, and elsewhere: in the job's, or partly out of it.
    EXPECT_FALSE(blank_difference(blank, {16.0, 60.0, 4.0, 0.0})->is_in_the_way);
    EXPECT_TRUE(blank_difference(blank, {18.0, 60.0, 4.0, 0.0})->is_in_the_way);
}

TEST(Blank, TellsADirectionWithinATurn) {
    const auto told_of = [](double direction_deg) {
        SliceReport report;
        const std::array directions_rad{0.0, rad_from_deg(direction_deg)};
        const std::array model_mm{1.0, 30.0};
        warn_about_blank(off_axis(), directions_rad, model_mm, 0.0, report);
        return report.warnings.empty() ? std::string{} : report.warnings.front();
    };
    EXPECT_THAT(told_of(359.4), EndsWith("in direction 359 deg"));
    EXPECT_THAT(told_of(359.7), EndsWith("in direction 0 deg"));
    EXPECT_THAT(told_of(-0.3), EndsWith("in direction 0 deg"));
    EXPECT_THAT(told_of(360.6), EndsWith("in direction 1 deg"));
}

std::vector<std::string> layer_warnings(const Profile& profile, std::uint32_t layers, Joining joining) {
    JobOptions options = small(layers, 61);
    options.joining = joining;
    std::vector<std::string> found;
    for (const std::string& warning :
         built(shapes::cylinder(8.0, 0.0, 20.0, 720), profile, options).report.warnings) {
        if (warning.find("layers lie ") != std::string::npos) found.push_back(warning);
    }
    return found;
}

TEST(Blank, StaysBetweenLayersThatLieFurtherApartThanTheToolIsWide) {
    Profile profile;
    profile.blank = {12.0, 25.0};
    profile.tool = {ToolShape::ball, 1.0};
    for (const Joining joining : {Joining::continuous, Joining::zigzag, Joining::spiral}) {
        EXPECT_EQ(
            layer_warnings(profile, 10, joining),
            (std::vector<std::string>{"the layers lie 2.00 mm apart, but the tool is only 1.00 mm wide: "
                                      "between them material stays, as high as the blank; more layers "
                                      "leave less"}));
        EXPECT_TRUE(layer_warnings(profile, 20, joining).empty());
        EXPECT_TRUE(layer_warnings(profile, 1, joining).empty());
    }
    profile.tool = {ToolShape::point, 1.0};
    EXPECT_TRUE(layer_warnings(profile, 10, Joining::continuous).empty());
}

TEST(Blank, IsRoughedNoFinerThanTheJobsLayers) {
    Profile profile;
    profile.blank = {12.0, 25.0};
    profile.tool = {ToolShape::ball, 3.0};
    profile.roughing.stepdown_mm = 2.0;
    for (const Joining joining : {Joining::continuous, Joining::spiral}) {
        EXPECT_EQ(layer_warnings(profile, 10, joining),
                  (std::vector<std::string>{
                      "roughing cannot keep its stepover of 1.50 mm: the job's layers lie 2.00 mm apart"}));
        EXPECT_TRUE(layer_warnings(profile, 20, joining).empty());
    }
}

}  // namespace
}  // namespace psicarve::cam
