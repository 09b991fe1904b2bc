// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cam/fitting_scale.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "hmi/model/turned_mesh.hpp"
#include "shared/base/units.hpp"
#include "tests/hmi/cam/built_job.hpp"

namespace psicarve::cam {
namespace {

JobOptions fitted() {
    JobOptions options = small(6, 41);
    options.fits = true;
    return options;
}

double radius_mm(const SliceReport& report) {
    return std::hypot(report.box_mm[0], report.box_mm[1]) / 2.0;
}

TEST(FittingScale, IsBoundByTheHeadsWhereTheModelIsWide) {
    const Profile profile;
    const SliceReport sut = built(oblong(), profile, fitted()).report;
    const double cleared_mm = reachable_radius(profile, 1.0) - profile.job.clearance_mm;
    EXPECT_NEAR(radius_mm(sut), cleared_mm, 1e-4);
    EXPECT_LE(radius_mm(sut), cleared_mm);
    for (const std::string& warning : sut.warnings)
        EXPECT_EQ(warning.find("clearance"), std::string::npos) << warning;
    ASSERT_FALSE(sut.notes.empty());
    EXPECT_NE(sut.notes.front().find("the heads' travel"), std::string::npos) << sut.notes.front();
}

TEST(FittingScale, IsBoundByYWhereTheModelIsHigh) {
    const Profile profile;
    const SliceReport sut = built(shapes::box({-1, -1, 0}, {1, 1, 40}), profile, fitted()).report;
    const double travel_mm =
        mm_from_pulses(axis_motion(profile, Axis::y).travel_max_pulses, profile.y.pulses_per_mm);
    EXPECT_NEAR(sut.box_mm[2] + profile.job.base_height_mm, travel_mm, 0.01);
    EXPECT_NE(sut.notes.front().find("axis y's travel"), std::string::npos) << sut.notes.front();
}

TEST(FittingScale, KeepsWithinTheBlank) {
    Profile profile;
    profile.blank.radius_mm = 12.0;
    profile.blank.height_mm = 200.0;
    const SliceReport wide = built(oblong(), profile, fitted()).report;
    EXPECT_NEAR(radius_mm(wide), 12.0, 1e-4);
    for (const std::string& warning : wide.warnings)
        EXPECT_EQ(warning.find("the blank"), std::string::npos) << warning;
    profile.blank.height_mm = profile.job.base_height_mm + 5.0;
    const SliceReport high = built(oblong(), profile, fitted()).report;
    EXPECT_NEAR(high.box_mm[2], 5.0, 1e-4);
    for (const std::string& warning : high.warnings)
        EXPECT_EQ(warning.find("the blank"), std::string::npos) << warning;
}

/// How far the corner that stands out most does, of the blank's circle.
double out_of_blank_mm(const model::Mesh& mesh, const BlankProfile& blank, double scale) {
    double most_mm = -blank.radius_mm;
    for (const model::Triangle& triangle : mesh.triangles) {
        for (const auto& corner : triangle.vertices) {
            const double x = (mesh.origin[0] + double{corner[0]}) * scale - blank.offset_x_mm;
            const double y = (mesh.origin[1] + double{corner[1]}) * scale - blank.offset_z_mm;
            most_mm = std::max(most_mm, std::hypot(x, y) - blank.radius_mm);
        }
    }
    return most_mm;
}

TEST(FittingScale, IsTheLargestInABlankThatStandsOffTheAxis) {
    Profile profile;
    profile.blank.radius_mm = 14.0;
    profile.blank.height_mm = 200.0;
    for (const auto& [x, z] :
         {std::pair{3.0, 0.0}, std::pair{0.0, -4.0}, std::pair{-2.0, 5.0}, std::pair{9.0, 9.0}}) {
        for (const double turn_deg : {0.0, 30.0, 200.0}) {
            SCOPED_TRACE(std::to_string(x) + "," + std::to_string(z) + " at " + std::to_string(turn_deg));
            profile.blank.offset_x_mm = x;
            profile.blank.offset_z_mm = z;
            model::MeshTurn turn;
            turn.rotate_deg = {0.0, 0.0, turn_deg};
            const model::Mesh mesh = model::turned(shapes::box({-3, -4, 0}, {2, 6, 1}), turn);
            JobOptions options = fitted();
            options.axis_at = AxisAt::origin;
            const SliceReport sut = built(mesh, profile, options).report;
            EXPECT_LE(out_of_blank_mm(mesh, profile.blank, sut.scale), 0.0);
            EXPECT_GT(out_of_blank_mm(mesh, profile.blank, sut.scale), -1e-4);
            EXPECT_NE(sut.notes.front().find("the blank where it stands"), std::string::npos);
            for (const std::string& warning : sut.warnings)
                EXPECT_EQ(warning.find("out of the blank"), std::string::npos) << warning;
        }
    }
}

TEST(FittingScale, LooksForTheBestAxisBefore) {
    const Profile profile;
    JobOptions options = fitted();
    options.axis_at = AxisAt::best;
    const SliceReport sut = built(shapes::figurine(4000.0, 20, 30), profile, options).report;
    EXPECT_EQ(sut.axis_choice, "best");
    EXPECT_LE(sut.r_max_mm, reachable_radius(profile, 1.0));
    EXPECT_GT(sut.r_max_mm, 0.8 * reachable_radius(profile, 1.0));
    EXPECT_LT(sut.scale, 0.1);
}

TEST(FittingScale, SetsTheSizeAlone) {
    JobOptions options = fitted();
    options.height_mm = 10.0;
    const auto both = build_job(oblong(), Profile{}, options);
    ASSERT_FALSE(both);
    EXPECT_EQ(both.error().code, ErrorCode::bad_usage);
    Profile profile;
    profile.blank.radius_mm = 12.0;
    profile.blank.height_mm = 1.0;
    profile.job.base_height_mm = 2.0;
    const auto none = build_job(oblong(), profile, fitted());
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, ErrorCode::bad_input);
}

TEST(SliceReport, SaysHowTheModelWasTurned) {
    model::MeshTurn turn;
    turn.rotate_deg = {0.0, 0.0, 90.0};
    turn.mirror = 1;
    const auto job = built(model::turned(oblong(), turn), Profile{}, small(4, 9));
    EXPECT_NE(to_json(job.report).find(R"("turn":{"mirror":"y","rotate_deg":[0.0,0.0,90.0]})"),
              std::string::npos)
        << to_json(job.report);
    EXPECT_NEAR(job.report.box_mm[0], 10.0, 1e-9);
    EXPECT_EQ(to_json(built(oblong(), Profile{}, small(4, 9)).report).find("\"turn\""), std::string::npos);
}

}  // namespace
}  // namespace psicarve::cam
