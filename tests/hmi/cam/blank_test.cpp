// SPDX-License-Identifier: GPL-3.0-or-later
// A blank that stands off the table's axis, and one that is not to be cut all the way.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "hmi/cam/blank_check.hpp"
#include "hmi/cam/job_plan.hpp"
#include "hmi/cam/prepared_job.hpp"
#include "hmi/piece/expected_piece.hpp"
#include "hmi/piece/piece_carver.hpp"
#include "hmi/verify/job_geometry.hpp"
#include "shared/units.hpp"
#include "tests/hmi/cam/built_job.hpp"
#include "tests/hmi/model/shapes.hpp"

namespace psicarve::cam {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

Profile off_axis() {
    Profile profile;
    profile.blank = {12.0, 20.0, 3.0, -4.0};
    return profile;
}

/// The blank's surface in a direction, searched for: the farthest place that is inside.
double searched_surface_mm(const BlankProfile& blank, double direction_rad) {
    double inside = 0.0;
    double outside = 100.0;
    while (outside - inside > 1e-9) {
        const double middle = 0.5 * (inside + outside);
        const double x = middle * std::cos(direction_rad) - blank.offset_x_mm;
        const double z = middle * std::sin(direction_rad) - blank.offset_z_mm;
        (std::hypot(x, z) < blank.radius_mm ? inside : outside) = middle;
    }
    return inside;
}

TEST(Blank, HasItsSurfaceWhereItStands) {
    const BlankProfile sut = off_axis().blank;
    double most_mm = 0.0;
    for (int k = 0; k < 720; ++k) {
        const double at = 2.0 * kPi * k / 720;
        EXPECT_NEAR(sut.surface_mm(at), searched_surface_mm(sut, at), 1e-8);
        most_mm = std::max(most_mm, sut.surface_mm(at));
    }
    EXPECT_NEAR(sut.reach_mm(), 17.0, 1e-12);
    EXPECT_NEAR(most_mm, 17.0, 0.001);
    EXPECT_EQ(BlankProfile{}.reach_mm(), 0.0);
    EXPECT_EQ((BlankProfile{5.0, 1.0}.surface_mm(1.0)), 5.0);
}

Profile low_blank(ToolProfile tool, double height_mm) {
    Profile profile;
    profile.tool = tool;
    profile.job.base_height_mm = 2.0;
    profile.blank = {12.0, height_mm};
    return profile;
}

TEST(Blank, LayersAboveItsTopAreLeftOut) {
    // Layers of 0.5 mm in the middles 2.25, 2.75 ... of a body that goes up to 12 mm.
    const model::Mesh body = shapes::cylinder(8.0, 0.0, 10.0, 90);
    const JobTable whole = built(body, low_blank({}, 12.0), small(20, 17)).table;
    ASSERT_EQ(whole.layer_count, 20U);
    for (const auto& [tool, kept] :
         {std::pair{ToolProfile{}, 6U}, std::pair{ToolProfile{ToolShape::ball, 2.0}, 8U},
          std::pair{ToolProfile{ToolShape::flat, 0.2}, 6U}}) {
        const Profile profile = low_blank(tool, 5.0);
        const BuiltJob sut = built(body, profile, small(20, 17));
        ASSERT_EQ(sut.table.layer_count, kept);
        EXPECT_EQ(sut.report.layers, kept);
        EXPECT_EQ(sut.report.layers_above_blank, 20U - kept);
        EXPECT_TRUE(std::equal(sut.table.layer_height_pulses.begin(), sut.table.layer_height_pulses.end(),
                               whole.layer_height_pulses.begin()));
        EXPECT_THAT(sut.report.warnings, Contains("above the blank's top there is nothing to cut: " +
                                                  std::to_string(20 - kept) + " of 20 layers are left out"));
        EXPECT_NE(to_json(sut.report).find("\"layers_above_blank\":" + std::to_string(20 - kept)),
                  std::string::npos);
    }
    EXPECT_EQ(built(body, low_blank({}, 0.0), small(20, 17)).table.layer_count, 20U) << "no height is known";
    EXPECT_EQ(to_json(built(body, low_blank({}, 12.0), small(20, 17)).report).find("above_blank"),
              std::string::npos);
}

// Each layer that is left out is air: nothing of the blank is in its tool's way.
TEST(Blank, WhatIsLeftOutOfTheJobIsMissingNowhereInThePiece) {
    const model::Mesh body = shapes::figurine(10.0, 40, 40);
    for (const ToolProfile& tool : {ToolProfile{ToolShape::ball, 2.0}, ToolProfile{ToolShape::flat, 1.0}}) {
        Profile low = low_blank(tool, 6.0);
        low.blank.radius_mm = 20.0;
        Profile high = low;
        high.blank.height_mm = 40.0;
        const auto piece = [&](const Profile& profile) {
            const auto blob = job_blob_from_table(built(body, profile, small(30, 61)).table);
            const JobView view = JobView::check(blob).value();
            const auto geometry = verify::JobGeometry::make(view, profile);
            return piece::expected_piece(*geometry, low, 180);
        };
        const piece::StockMap left_out = piece(low);
        const piece::StockMap all = piece(high);
        const auto row_at = [&all](double height_mm) {
            return static_cast<std::size_t>((height_mm - all.bottom_mm()) / all.row_mm());
        };
        for (std::size_t row = 0; row < left_out.row_count(); ++row) {
            if (left_out.height_mm(row) > 6.0 || left_out.height_mm(row) < all.bottom_mm()) continue;
            ASSERT_NEAR(left_out.row_mm(), all.row_mm(), 1e-9);
            for (std::size_t column = 0; column < 180; ++column)
                EXPECT_FLOAT_EQ(left_out.row(row)[column], all.row(row_at(left_out.height_mm(row)))[column]);
        }
    }
}

TEST(Blank, ASpiralBelowItsTopClosesWithItsRingAndIsRoughed) {
    Profile profile = low_blank({ToolShape::ball, 2.0}, 5.0);
    profile.roughing = {2.0, 0.3, 0.0};
    JobOptions options = small(20, 17);
    options.joining = Joining::spiral;
    const BuiltJob sut = built(shapes::cylinder(8.0, 0.0, 10.0, 90), profile, options);
    const auto blob = job_blob_from_table(sut.table);
    const auto view = JobView::check(blob);
    ASSERT_TRUE(view.has_value()) << view.error().message;
    const auto accepted = check_job(*view, profile);
    EXPECT_TRUE(accepted.has_value()) << (accepted ? "" : accepted.error().message);
    ASSERT_GE(view->passes().size(), 2U);
    EXPECT_EQ(view->passes().back().layer_count, 9U) << "eight layers and the ring";
    const auto heights = view->layer_heights_pulses();
    EXPECT_EQ(heights[heights.size() - 1], heights[heights.size() - 2]);
    const std::int64_t highest = *std::max_element(heights.begin(), heights.end());
    EXPECT_EQ(highest, pulses_from_mm(5.75, profile.y.pulses_per_mm));
    EXPECT_EQ(heights[0], pulses_from_mm(2.25, profile.y.pulses_per_mm)) << "the same layers, not others";
    // One layer that is left is one ring.
    profile.blank.height_mm = 2.4;
    profile.tool = {};
    profile.roughing = {};
    EXPECT_EQ(built(shapes::cylinder(8.0, 0.0, 10.0, 90), profile, options).table.layer_count, 1U);
}

TEST(Blank, ThatNoLayerReachesIsRefused) {
    const auto job = build_job(shapes::cylinder(8.0, 0.0, 10.0, 90), low_blank({}, 2.0), small(20, 17));
    ASSERT_FALSE(job.has_value());
    EXPECT_THAT(job.error().message,
                EndsWith("stands 2.00 mm above the table, and the blank is only 2.00 mm high: "
                         "nothing of it is left to be carved"));
}

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

TEST(Blank, OffTheAxisBoundsAModelThatIsToFit) {
    JobOptions options;
    options.fits = true;
    const SliceReport sut = built(shapes::cylinder(3.0, 0.0, 2.0, 720), off_axis(), options).report;
    EXPECT_NEAR(0.5 * sut.box_mm[0], 7.0, 0.001);
    EXPECT_THAT(sut.notes, Contains(HasSubstr("the blank where it stands")));
}

/// Both heads against the same job without a limit.
void expect_held(const Profile& profile, JobOptions options) {
    Profile free = profile;
    free.blank.depth_limit_mm = 0.0;
    const model::Mesh body = shapes::figurine(13.0, 20, 30);
    const BuiltJob limited = built(body, profile, options);
    const BuiltJob whole = built(body, free, options);
    const auto blob = job_blob_from_table(limited.table);
    const JobView view = JobView::check(blob).value();
    std::size_t held = 0;
    for (std::uint32_t layer = 0; layer < view.layer_count(); ++layer) {
        for (std::uint32_t point = 0; point < view.point_count(); ++point) {
            const double turn_rad =
                rad_from_pulses(view.psi_pulses(layer, point), profile.psi.pulses_per_rev);
            for (const bool is_right : {false, true}) {
                const double direction_rad =
                    turn_rad + (is_right ? kPi + rad_from_deg(profile.head_r2_angle_error_deg) : 0.0);
                const LinearAxisProfile& axis = is_right ? profile.r2 : profile.r1;
                const double floor_mm = searched_surface_mm(profile.blank, direction_rad) -
                                        profile.blank.depth_limit_mm - axis.tip_mm();
                const double got = (is_right ? right : left)(limited.table, layer, point);
                const double wanted = (is_right ? right : left)(whole.table, layer, point);
                EXPECT_GE(got, floor_mm * axis.pulses_per_mm - 0.001);
                EXPECT_LT(got, std::max(wanted + 0.5, floor_mm * axis.pulses_per_mm + 1.0));
                EXPECT_GE(got, wanted);
                held += got > wanted ? 1 : 0;
            }
        }
    }
    ASSERT_TRUE(limited.report.depth_limit.has_value());
    EXPECT_EQ(limited.report.depth_limit->points, held);
    EXPECT_GT(held, 100U);
    EXPECT_LT(limited.report.depth_limit->share, 1.0);
    EXPECT_FALSE(whole.report.depth_limit.has_value());
    EXPECT_THAT(limited.report.warnings, Contains(HasSubstr("the depth limit of 6.00 mm below the blank's "
                                                            "surface keeps the heads out of ")));
    EXPECT_EQ(nlohmann::json::parse(limited.table.report_json)["depth_limit"]["points"], held);
}

TEST(Blank, IsCutNoDeeperThanItsLimit) {
    Profile profile = off_axis();
    profile.blank.depth_limit_mm = 6.0;
    profile.head_r2_angle_error_deg = 2.0;
    profile.r2.tip_offset_mm = 0.3;
    expect_held(profile, small(12, 31));
    JobOptions spiral = small(12, 31);
    spiral.joining = Joining::spiral;
    expect_held(profile, spiral);
    JobOptions zigzag = small(12, 31);
    zigzag.joining = Joining::zigzag;
    profile.tool = {ToolShape::ball, 2.0};
    expect_held(profile, zigzag);
}

TEST(Blank, OffTheAxisIsCarvedWhereItStands) {
    Profile profile = off_axis();
    const BuiltJob job = built(shapes::cylinder(8.0, 0.0, 20.0, 720), profile, small(20, 361));
    const auto blob = job_blob_from_table(job.table);
    const auto geometry = verify::JobGeometry::make(JobView::check(blob).value(), profile);
    ASSERT_TRUE(geometry.has_value());
    const piece::StockMap fresh = piece::blank_of(*geometry, profile, 360);
    EXPECT_NEAR(fresh.blank_radius_mm(), 17.0, 1e-9);
    EXPECT_EQ(fresh.removed_mm3(), 0.0);
    const piece::StockMap carved = piece::expected_piece(*geometry, profile, 360);
    double wanted_mm3 = 0.0;
    for (std::size_t column = 0; column < carved.column_count(); ++column) {
        const double surface_mm = searched_surface_mm(profile.blank, carved.direction_rad(column));
        EXPECT_NEAR(fresh.row(10)[column], surface_mm, 1e-5);
        EXPECT_NEAR(carved.row(10)[column], std::min(8.0, surface_mm), 0.003);
        wanted_mm3 += std::max(0.0, surface_mm * surface_mm - 64.0);
    }
    const double height_mm = carved.row_mm() * static_cast<double>(carved.row_count());
    wanted_mm3 *= 0.5 * height_mm * 2.0 * kPi / static_cast<double>(carved.column_count());
    EXPECT_NEAR(carved.removed_mm3(), wanted_mm3, 0.002 * wanted_mm3);
}

// What lies below the table's top is no wood.
TEST(Blank, OfAKnownHeightIsAsHighAsThatHoweverWideTheTool) {
    Profile profile;
    profile.blank = {12.0, 25.0};
    for (const ToolShape shape : {ToolShape::ball, ToolShape::point}) {
        profile.tool = {shape, 3.0};
        const BuiltJob job = built(shapes::cylinder(8.0, 0.0, 20.0, 720), profile, small(40, 61));
        const auto blob = job_blob_from_table(job.table);
        const auto geometry = verify::JobGeometry::make(JobView::check(blob).value(), profile);
        ASSERT_TRUE(geometry.has_value());
        const piece::StockMap fresh = piece::blank_of(*geometry, profile, 360);
        // A point's rows are those that it carves, so that half a layer is left to chance.
        const double exact_mm = shape == ToolShape::point ? 0.26 : 1e-9;
        EXPECT_NEAR(fresh.bottom_mm(), 0.0, exact_mm);
        EXPECT_NEAR(fresh.bottom_mm() + fresh.row_mm() * static_cast<double>(fresh.row_count()), 25.0,
                    exact_mm);
    }
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
