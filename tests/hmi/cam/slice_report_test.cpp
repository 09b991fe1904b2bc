// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cam/slice_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "hmi/model/mesh.hpp"
#include "shared/profile/profile.hpp"
#include "tests/hmi/cam/built_job.hpp"
#include "tests/hmi/model/shapes.hpp"

namespace psicarve::cam {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

TEST(SliceReport, WarnsWhereTheFilesFloatsAreCoarserThanAPulse) {
    model::Mesh mesh = oblong();
    mesh.facts.coordinate_step = 0.0024;  // a pulse is 0.0025 mm
    EXPECT_THAT(built(mesh, Profile{}, small(4, 5)).report.warnings, Not(Contains(HasSubstr("rounded to"))));
    mesh.facts.coordinate_step = 0.0078;
    EXPECT_THAT(built(mesh, Profile{}, small(4, 5)).report.warnings,
                Contains(AllOf(HasSubstr("rounded to 0.0078 mm"), HasSubstr("a pulse (0.0025 mm)"))));
}

TEST(SliceReport, SuspectsInchesInATinyFigurine) {
    Profile thin_core;
    thin_core.core_radius_mm = 0.05;
    const BuiltJob sut = built(shapes::cylinder(0.2, 0.0, 0.8, 20), thin_core, JobOptions{});
    EXPECT_THAT(sut.report.warnings, Contains(AllOf(HasSubstr("0.80 mm high"), HasSubstr("inches"))));
}

TEST(SliceReport, DoesNotSuspectAModelTwentyWide) {
    EXPECT_TRUE(
        built(shapes::cylinder(10.0, 0.0, 30.0, 40), Profile{}, JobOptions{}).report.warnings.empty());
}

TEST(SliceReport, DoesNotSuspectATinyModelWhoseSizeWasGiven) {
    JobOptions options;
    options.height_mm = 40.0;
    EXPECT_TRUE(built(shapes::cylinder(0.2, 0.0, 0.8, 40), Profile{}, options).report.warnings.empty());
}

TEST(SliceReport, IsJsonWithWhatTheSlicerSaw) {
    const model::Mesh mesh = shapes::torus(12.0, 4.0, 30, 40);
    const BuiltJob sut = built(mesh, Profile{}, small(10, 30));
    const auto json = nlohmann::json::parse(sut.table.report_json);
    EXPECT_EQ(json["triangles"], mesh.triangles.size());
    EXPECT_EQ(json["layers_without_axis"], 10);
    EXPECT_EQ(json["open_points"], 0);
    EXPECT_NEAR(json["bounding_box_mm"][2].get<double>(), 8.0, 0.1);
    EXPECT_GT(json["undercut_share"].get<double>(), 0.3);
    EXPECT_EQ(json["axis_at"], "centre");
}

/// A plate with a post aside of its middle.
model::Mesh lopsided() {
    return shapes::Builder()
        .add(shapes::box({-20, -10, 0}, {20, 10, 2}))
        .add(shapes::cylinder(4.0, 2.0, 40.0, 32, 10.0, 3.0))
        .mesh();
}

// The search takes longer than all the slicing.
TEST(SliceReport, LooksForABetterAxisOnlyWhereAsked) {
    JobOptions options = small(40, 30);
    int looks = 0;
    options.search_progress = [&looks](double) {
        ++looks;
        return true;
    };
    const BuiltJob quick = built(lopsided(), Profile{}, options);
    EXPECT_EQ(looks, 0);
    EXPECT_FALSE(quick.report.axis_search.has_value());
    EXPECT_FALSE(nlohmann::json::parse(quick.table.report_json).contains("best_axis"));
    EXPECT_THAT(quick.report.warnings,
                Contains(HasSubstr("; --axis-at best looks for an axis that loses less")));
    options.compares_axes = true;
    const BuiltJob compared = built(lopsided(), Profile{}, options);
    EXPECT_GT(looks, 0);
    EXPECT_EQ(compared.table.r_left_pulses, quick.table.r_left_pulses);
    options.axis_at = AxisAt::best;
    EXPECT_THAT(built(lopsided(), Profile{}, options).report.warnings,
                Not(Contains(HasSubstr("--axis-at best"))));
}

// Nothing is promised of an axis at which next to nothing is lost.
TEST(SliceReport, NamesNoOtherAxisWhereLittleIsLost) {
    const BuiltJob sut = built(shapes::Builder()
                                   .add(shapes::cylinder(10.0, 0.0, 40.0, 64))
                                   .add(shapes::box({11, -0.1, 10}, {11.2, 0.1, 12}))
                                   .mesh(),
                               Profile{}, small(40, 200));
    EXPECT_GT(sut.report.undercut_share, 0.0);
    EXPECT_LT(sut.report.undercut_share, 0.01);
    EXPECT_THAT(sut.report.warnings, Not(Contains(HasSubstr("--axis-at"))));
}

TEST(SliceReport, OffersABetterAxisWhereOneIs) {
    const model::Mesh mesh = lopsided();
    JobOptions asked = small(40, 30);
    asked.compares_axes = true;
    const BuiltJob centre = built(mesh, Profile{}, asked);
    EXPECT_GT(centre.report.layers_without_axis, 30U);
    EXPECT_THAT(centre.report.warnings, Contains(HasSubstr("layers, by the same look this axis")));
    JobOptions options = small(40, 30);
    options.axis_at = AxisAt::best;
    const BuiltJob best = built(mesh, Profile{}, options);
    EXPECT_EQ(best.report.layers_without_axis, 0U);
    ASSERT_TRUE(centre.report.axis_search.has_value());
    EXPECT_EQ(best.report.axis, centre.report.axis_search->best);
}

TEST(SliceReport, CountsOpenPoints) {
    model::Mesh mesh = shapes::cylinder(10.0, 0.0, 20.0, 24);
    mesh.triangles.erase(mesh.triangles.begin() + 4);
    EXPECT_GT(built(mesh, Profile{}, small(10, 97)).report.open_points, 0U);
    EXPECT_EQ(built(shapes::cylinder(10.0, 0.0, 20.0, 24), Profile{}, small(10, 97)).report.open_points, 0U);
}

}  // namespace
}  // namespace psicarve::cam
