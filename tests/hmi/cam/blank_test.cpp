// SPDX-License-Identifier: GPL-3.0-or-later
// A blank that stands off the table's axis, and one that is not to be cut all the way.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "hmi/cam/job_plan.hpp"
#include "hmi/piece/expected_piece.hpp"
#include "hmi/piece/piece_carver.hpp"
#include "hmi/surface/job_geometry.hpp"
#include "shared/base/units.hpp"
#include "tests/hmi/cam/built_job.hpp"
#include "tests/hmi/cam/off_axis.hpp"
#include "tests/hmi/model/shapes.hpp"

namespace psicarve::cam {
namespace {

using testing::Contains;
using testing::EndsWith;
using testing::HasSubstr;

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

}  // namespace
}  // namespace psicarve::cam
