// SPDX-License-Identifier: GPL-3.0-or-later
// Tables for tools that have a size: every point against the tool's definition, searched through all facets.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "hmi/cam/blank_check.hpp"
#include "hmi/slice/directions.hpp"
#include "hmi/tool/tool.hpp"
#include "shared/base/units.hpp"
#include "shared/job/job.hpp"
#include "tests/hmi/cam/built_job.hpp"
#include "tests/hmi/model/fins.hpp"
#include "tests/hmi/model/shapes.hpp"
#include "tests/hmi/tool/brute_force.hpp"

namespace psicarve::cam {
namespace {

using testing::Contains;
using testing::HasSubstr;

constexpr std::uint32_t kLayers = 5;
constexpr std::uint32_t kPoints = 7;
constexpr double kScale = 1.5;

/// An L that stands off the axis, with a slot deeper than tools reach.
model::Mesh angular() {
    shapes::Builder body;
    body.add(shapes::box({-4, -3, 0}, {5, 3, 8}));
    body.add(shapes::box({3, -0.7, 1}, {9, 0.6, 3}));
    return body.mesh();
}

Profile with_tool(ToolShape shape, double diameter_mm) {
    Profile profile;
    profile.tool = {shape, diameter_mm, 70.0, 0.0};
    return profile;
}

/// Where head R1 or R2 stands in a row: its direction in the model, and its height over the model's foot
/// [mm].
struct Place {
    double direction_rad;
    double height_mm;
};

std::int64_t wanted_pulses(const model::Mesh& mesh, const Profile& profile, const LinearAxisProfile& head,
                           const Place& place) {
    const tool::Tool tool = tool::tool_of(profile.tool, 1.0 / kScale);
    const auto rise = [&tool](double s) { return tool::rise(tool, s); };
    const brute::Shape<decltype(rise)> shape{tool.radius, rise};
    const double radius =
        kScale * brute::tip_radius(mesh, place.direction_rad, place.height_mm / kScale, shape);
    return pulses_from_mm(std::max(radius, profile.core_radius_mm) - head.tip_offset_mm, head.pulses_per_mm);
}

void expect_as_defined(const Profile& profile, Joining joining) {
    const model::Mesh mesh = angular();
    JobOptions options = small(kLayers, kPoints);
    options.joining = joining;
    options.axis_at = AxisAt::origin;
    options.scale = kScale;
    const JobTable sut = built(mesh, profile, options).table;
    const double height_mm = 8.0 * kScale;
    const auto layer_mm = [&](std::uint32_t layer) {
        return (std::min(layer, kLayers - 1) + 0.5) * height_mm / kLayers;
    };
    for (std::uint32_t row = 0; row < sut.layer_count; ++row) {
        const bool rises = joining == Joining::spiral && row > 0 && row < kLayers;
        for (std::uint32_t point = 0; point < kPoints; ++point) {
            // A spiral's joint is the point that ends the row before.
            const bool is_joint = joining == Joining::spiral && row > 0 && point == 0;
            const double part = static_cast<double>(point) / (kPoints - 1.0);
            const double bottom_mm = layer_mm(rises ? row - 1 : row);
            const double z_mm = is_joint ? layer_mm(row - 1) : bottom_mm + part * (layer_mm(row) - bottom_mm);
            const double psi =
                rad_from_pulses(table_angle_pulses(joining, sut.psi_sweep_pulses, kPoints, row, point),
                                profile.psi.pulses_per_rev);
            const double error_rad = rad_from_deg(profile.head_r2_angle_error_deg);
            const std::int64_t r1 = wanted_pulses(mesh, profile, profile.r1, {psi, z_mm});
            const std::int64_t r2 = wanted_pulses(
                mesh, profile, profile.r2, {psi + kPi + error_rad, z_mm + profile.head_r2_height_error_mm});
            EXPECT_LE(std::abs(left(sut, row, point) - r1), 1) << "row " << row << " point " << point;
            EXPECT_LE(std::abs(right(sut, row, point) - r2), 1) << "row " << row << " point " << point;
        }
    }
}

TEST(ToolJob, HasTheToolsRadiiInLayers) {
    for (const ToolShape shape : {ToolShape::ball, ToolShape::flat, ToolShape::vee}) {
        SCOPED_TRACE(name_of(shape));
        expect_as_defined(with_tool(shape, 3.0), Joining::continuous);
        expect_as_defined(with_tool(shape, 4.0), Joining::zigzag);
    }
}

TEST(ToolJob, HasTheToolsRadiiInSpirals) {
    expect_as_defined(with_tool(ToolShape::ball, 3.0), Joining::spiral);
}

TEST(ToolJob, HasEachHeadsOwnErrorsTakenOff) {
    Profile profile = with_tool(ToolShape::ball, 3.0);
    profile.head_r2_angle_error_deg = 3.0;
    profile.head_r2_height_error_mm = -0.4;
    profile.r1.tip_offset_mm = 0.25;
    expect_as_defined(profile, Joining::continuous);
    expect_as_defined(profile, Joining::spiral);
}

TEST(ToolJob, SaysWhatToolItIsForAndCarriesItInItsProfile) {
    JobOptions options = small(kLayers, kPoints);
    const BuiltJob sut = built(angular(), with_tool(ToolShape::vee, 4.0), options);
    EXPECT_EQ(nlohmann::json::parse(sut.table.report_json).at("tool"), "vee 4 mm 70 deg");
    EXPECT_THAT(sut.table.profile_toml, HasSubstr("shape = \"vee\""));
}

TEST(ToolJob, TellsHowFarTheToolGoesInBetweenPoints) {
    const Profile profile = with_tool(ToolShape::ball, 3.0);
    const tool::Tool tool = tool::tool_of(profile.tool, 1.0);
    const auto rise = [&tool](double s) { return tool::rise(tool, s); };
    const brute::Shape<decltype(rise)> shape{tool.radius, rise};
    const model::Mesh mesh = angular();
    JobOptions options = small(kLayers, kPoints);
    options.axis_at = AxisAt::origin;
    double middle_mm = 0.0;
    double most_mm = 0.0;
    for (std::uint32_t row = 0; row < kLayers; ++row) {
        const double height_mm = (row + 0.5) * 8.0 / kLayers;
        // Points stand on whole pulses.
        const auto round = slice::full_circle_rad(kPoints, profile.psi.pulses_per_rev, 0.0);
        const auto tip_mm = [&](double direction_rad) {
            return std::max(profile.core_radius_mm, brute::tip_radius(mesh, direction_rad, height_mm, shape));
        };
        for (std::size_t i = 0; i + 1 < round.size(); ++i) {
            constexpr int kSteps = 64;
            for (int k = 1; k < kSteps; ++k) {
                const double part = static_cast<double>(k) / kSteps;
                const double straight_mm =
                    tip_mm(round[i]) + part * (tip_mm(round[i + 1]) - tip_mm(round[i]));
                const double sunk_mm = tip_mm(round[i] + part * (round[i + 1] - round[i])) - straight_mm;
                most_mm = std::max(most_mm, sunk_mm);
                if (2 * k == kSteps) middle_mm = std::max(middle_mm, sunk_mm);
            }
        }
    }
    ASSERT_GT(middle_mm, 0.1);
    const SliceReport sut = built(mesh, profile, options).report;
    EXPECT_GE(sut.between_points_mm.value_or(0.0), middle_mm - 1e-6);
    EXPECT_LE(sut.between_points_mm.value_or(0.0), most_mm + 0.02);
    EXPECT_THAT(sut.warnings, Contains(HasSubstr("between two points of a layer the tool goes up to ")));
    EXPECT_THAT(to_json(sut), HasSubstr("\"between_points_mm\":"));
    options.point_count = 3201;
    const SliceReport fine = built(mesh, profile, options).report;
    EXPECT_LT(fine.between_points_mm.value_or(1.0), 0.002);
    EXPECT_THAT(fine.warnings, testing::Not(Contains(HasSubstr("between two points"))));
}

// 398 directions round: the fin, 0.1 degrees wide at its end, stands in the middle of one gap.
TEST(ToolJob, FindsAFinInWhicheverGapItStands) {
    JobOptions options = small(40, 200);
    options.axis_at = AxisAt::origin;
    Profile profile = with_tool(ToolShape::vee, 3.0);
    profile.tool.angle_deg = 20.0;
    const auto round = slice::full_circle_rad(200, profile.psi.pulses_per_rev, 0.0);
    for (const Joining joining : {Joining::continuous, Joining::zigzag, Joining::spiral}) {
        options.joining = joining;
        for (const std::size_t k : {4U, 8U, 9U, 250U}) {
            const double direction_deg = deg_from_rad(0.5 * (round[k] + round[k + 1]));
            const SliceReport sut = built(shapes::finned(direction_deg, 1.2, 0.1), profile, options).report;
            EXPECT_NEAR(sut.between_points_mm.value_or(0.0), 0.79, 0.02) << k << ' ' << name_of(joining);
            EXPECT_THAT(sut.warnings, Contains(HasSubstr("between two points of a layer"))) << k;
            // The layers that a low blank leaves.
            Profile low = profile;
            low.blank = {20.0, profile.job.base_height_mm + 0.3 * sut.box_mm[2]};
            const SliceReport kept = built(shapes::finned(direction_deg, 1.2, 0.1), low, options).report;
            EXPECT_GT(kept.layers_above_blank, 20U);
            EXPECT_NEAR(kept.between_points_mm.value_or(0.0), 0.79, 0.02) << k << ' ' << name_of(joining);
        }
    }
}

TEST(ToolJob, FindsANeedleBetweenThePointsOfAPoint) {
    JobOptions options = small(4, 31);
    options.axis_at = AxisAt::origin;
    for (const double direction_deg : {3.0, 100.0, 333.3}) {
        for (const Joining joining : {Joining::continuous, Joining::zigzag, Joining::spiral}) {
            options.joining = joining;
            const SliceReport sut = built(shapes::needle(direction_deg, 0.1), Profile{}, options).report;
            EXPECT_NEAR(sut.between_points_mm.value_or(0.0), 5.0, 0.02) << direction_deg;
        }
    }
    Profile askew;
    askew.head_r2_angle_error_deg = 7.3;
    askew.head_r2_height_error_mm = 0.35;
    EXPECT_NEAR(built(shapes::needle(100.0, 0.1), askew, options).report.between_points_mm.value_or(0.0), 5.0,
                0.02);
    EXPECT_LT(built(shapes::cylinder(15.0, 0.0, 10.0, 360), Profile{}, small(4, 181))
                  .report.between_points_mm.value_or(1.0),
              0.003);
}

TEST(ToolJob, TellsProgressOfBothPartsAndCanBeCancelledInEach) {
    for (const double at : {0.1, 0.6}) {
        JobOptions options = small(kLayers, 200);
        double last = 0.0;
        options.progress = [&last, at](double done) {
            EXPECT_GE(done, last);
            last = done;
            return done < at;
        };
        const auto job = build_job(angular(), with_tool(ToolShape::ball, 3.0), options);
        ASSERT_FALSE(job);
        EXPECT_EQ(job.error().code, ErrorCode::cancelled);
    }
}

TEST(ToolJob, WarnsOfABlankOrAToolThatIsTooSmall) {
    Profile profile = with_tool(ToolShape::flat, 2.0);
    profile.tool.flute_mm = 3.0;
    profile.blank = {7.0, 7.5};
    JobOptions options = small(kLayers, kPoints);
    options.axis_at = AxisAt::origin;
    const auto warnings = built(angular(), profile, options).report.warnings;
    EXPECT_THAT(warnings, Contains(HasSubstr("the blank's radius of 7.00 mm is less than the model's, 9.0")));
    EXPECT_THAT(warnings,
                Contains(HasSubstr("the blank's top stands 7.50 mm above the table, the model's 8.00 mm")));
    EXPECT_THAT(warnings, Contains(HasSubstr("the tool cuts 3.00 mm deep, but the job goes ")));
    // The same warning before slicing, which refuses such a blank.
    SliceReport before;
    profile.blank = {100.0, 100.0};
    warn_about_blank_size(profile, {}, {}, 8.0, before);
    EXPECT_THAT(before.warnings, Contains("the blank's radius of 100.00 mm is more than the heads can clear, "
                                          "60.00 mm"));
}

}  // namespace
}  // namespace psicarve::cam
