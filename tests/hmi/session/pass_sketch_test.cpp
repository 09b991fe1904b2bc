// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/pass_sketch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace psicarve::session {
namespace {

constexpr double kRatio = 0.5;

Profile roughed_profile(ToolShape shape = ToolShape::ball) {
    Profile profile;
    profile.tool = {shape, 4.0, 60.0, 0.0};
    profile.blank.radius_mm = 10.0;
    profile.roughing = {3.0, 0.5, 2.0};
    return profile;
}

double least_radius_mm(const PassSketch& sketch) {
    const auto least = std::ranges::min_element(sketch.stock, {}, &SketchPoint::radius_mm);
    return least->radius_mm;
}

TEST(PassSketch, IsTheToolAloneWithoutABlankAndNothingOfAPoint) {
    Profile profile = roughed_profile();
    profile.blank = {};
    for (const ToolProfile& tool :
         {ToolProfile{ToolShape::ball, 6.0}, ToolProfile{ToolShape::flat, 1.0, 60.0, 12.0},
          ToolProfile{ToolShape::vee, 4.0, 10.0}}) {
        profile.tool = tool;
        const PassSketch sut = pass_sketch(profile, kRatio);
        EXPECT_DOUBLE_EQ(sut.height_mm, kRatio * sut.width_mm);
        EXPECT_GT(sut.height_mm, tool.diameter_mm);
        EXPECT_TRUE(sut.stock.empty());
        EXPECT_EQ(sut.shank.size(), tool.flute_mm > 0.0 ? 4U : 0U);
        const auto [low, high] = std::ranges::minmax(sut.tool, {}, &SketchPoint::height_mm);
        EXPECT_NEAR(high.height_mm - low.height_mm, tool.diameter_mm, 1e-9);
        EXPECT_NEAR(high.height_mm + low.height_mm, sut.height_mm, 1e-9) << "in the middle";
        const auto [tip, end] = std::ranges::minmax(sut.tool, {}, &SketchPoint::radius_mm);
        EXPECT_GT(tip.radius_mm, 0.0);
        EXPECT_LE(end.radius_mm, sut.width_mm + 1e-9);
        EXPECT_EQ(in_english(passes_phrase(sut)), "The tool alone: no blank is chosen");
    }
    profile.tool.shape = ToolShape::point;
    EXPECT_EQ(pass_sketch(profile, kRatio).width_mm, 0.0);
}

TEST(PassSketch, GoesInByTheStepdownToTheAllowanceOverTheCore) {
    const PassSketch sut = pass_sketch(roughed_profile(), kRatio);
    EXPECT_EQ(sut.depths_mm, (std::vector{7.0, 4.0, 2.0}));
    EXPECT_EQ(sut.blank_mm, 10.0);
    EXPECT_EQ(sut.finished_mm, 1.5);
    EXPECT_GT(sut.width_mm, sut.blank_mm);
    EXPECT_DOUBLE_EQ(sut.height_mm, kRatio * sut.width_mm);
    EXPECT_EQ(in_english(passes_phrase(sut)), "Up to 3 roughing passes, layers 2.00 mm apart");
}

TEST(PassSketch, GoesNoDeeperThanTheDepthLimit) {
    Profile profile = roughed_profile();
    profile.blank.depth_limit_mm = 5.0;
    const PassSketch sut = pass_sketch(profile, kRatio);
    EXPECT_EQ(sut.finished_mm, 5.0);
    EXPECT_EQ(sut.depths_mm, (std::vector{7.0, 5.5}));
}

TEST(PassSketch, StandsOutAsSteps) {
    Profile profile = roughed_profile(ToolShape::flat);
    profile.roughing.stepover_mm = 0.01;
    profile.tool.diameter_mm = 0.02;
    const PassSketch sut = pass_sketch(profile, kRatio);
    // Four bands, from the last pass' depth at the bottom to the blank at the top.
    const std::vector wanted{2.0, 4.0, 7.0, 10.0};
    for (const SketchPoint& point : sut.stock) {
        const double band = point.height_mm / sut.height_mm * 4.0;
        if (std::abs(band - std::round(band)) < 0.05) continue;
        EXPECT_DOUBLE_EQ(point.radius_mm, wanted[static_cast<std::size_t>(band)]) << point.height_mm;
    }
}

TEST(PassSketch, LeavesRidgesAsHighAsTheToolLeavesThem) {
    Profile profile = roughed_profile();
    profile.roughing = {100.0, 0.5, 3.0};
    profile.blank.radius_mm = 40.0;
    const PassSketch sut = pass_sketch(profile, kRatio);
    ASSERT_EQ(sut.depths_mm, std::vector{2.0});
    double most_mm = 0.0;
    for (const SketchPoint& point : sut.stock) {
        if (point.height_mm < 0.4 * sut.height_mm) most_mm = std::max(most_mm, point.radius_mm);
    }
    // Half-way between two layers 3 mm apart a ball of 2 mm radius leaves 2 - sqrt(4 - 1.5 * 1.5).
    EXPECT_NEAR(most_mm - 2.0, 2.0 - std::sqrt(1.75), 0.05);
    EXPECT_NEAR(least_radius_mm(sut), 2.0, 0.01);
}

TEST(PassSketch, NoToolStandsInWhatIsLeft) {
    for (const ToolShape shape : {ToolShape::point, ToolShape::ball, ToolShape::flat, ToolShape::vee}) {
        const Profile profile = roughed_profile(shape);
        const PassSketch sut = pass_sketch(profile, kRatio);
        const auto tip = std::ranges::min_element(sut.tool, {}, &SketchPoint::radius_mm);
        EXPECT_DOUBLE_EQ(tip->radius_mm, 2.0) << name_of(shape);
        if (shape == ToolShape::point) continue;
        const auto [low, high] = std::ranges::minmax(sut.tool, {}, &SketchPoint::height_mm);
        EXPECT_NEAR(high.height_mm - low.height_mm, profile.tool.diameter_mm, 1e-9) << "to scale";
        const double middle_mm = 0.5 * (high.height_mm + low.height_mm);
        for (const SketchPoint& point : sut.stock) {
            const double away_mm = std::abs(point.height_mm - middle_mm);
            if (away_mm > 2.0) continue;
            const double rise_mm = shape == ToolShape::flat   ? 0.0
                                   : shape == ToolShape::ball ? 2.0 - std::sqrt(4.0 - away_mm * away_mm)
                                                              : away_mm / std::tan(std::acos(-1.0) / 6.0);
            EXPECT_LE(point.radius_mm, 2.0 + rise_mm + 1e-9) << name_of(shape) << ' ' << point.height_mm;
        }
    }
}

TEST(PassSketch, ShowsWhereTheFlutesEnd) {
    Profile profile = roughed_profile();
    EXPECT_TRUE(pass_sketch(profile, kRatio).shank.empty());
    profile.tool.flute_mm = 5.0;
    const PassSketch sut = pass_sketch(profile, kRatio);
    ASSERT_EQ(sut.shank.size(), 4U);
    EXPECT_DOUBLE_EQ(sut.tool.front().radius_mm, 7.0);
    EXPECT_DOUBLE_EQ(sut.shank.front().radius_mm, 7.0);
}

TEST(PassSketch, WithoutRoughingTheFinishingPassCutsItsWayAlone) {
    Profile profile = roughed_profile();
    profile.roughing.stepdown_mm = 0.0;
    const PassSketch sut = pass_sketch(profile, kRatio);
    EXPECT_TRUE(sut.depths_mm.empty());
    EXPECT_NEAR(least_radius_mm(sut), 1.5, 0.01);
    EXPECT_EQ(in_english(passes_phrase(sut)), "The finishing pass alone");
}

TEST(PassSketch, OfNeverEndingPassesIsDrawnAllTheSame) {
    Profile profile = roughed_profile();
    profile.roughing.stepdown_mm = 1e-9;
    const PassSketch sut = pass_sketch(profile, kRatio);
    EXPECT_EQ(in_english(passes_phrase(sut)), "Hundreds of roughing passes");
    EXPECT_FALSE(sut.stock.empty());
}

TEST(RoughingProblem, IsWhatSlicingWouldBeRefusedFor) {
    Profile profile = roughed_profile();
    EXPECT_TRUE(roughing_problem(profile).is_empty());
    profile.roughing.stepover_mm = 5.0;
    EXPECT_EQ(in_english(roughing_problem(profile)),
              "a stepover of 5 mm is more than the tool is wide, 4 mm");
    profile.roughing = {2e4, 0.3, 0.0};
    EXPECT_EQ(in_english(roughing_problem(profile)),
              "the stepdown must be more than 0 mm, and 10000 mm at most, not 20000 mm");
    profile.roughing = {2.0, -1.0, 0.0};
    EXPECT_EQ(in_english(roughing_problem(profile)), "the allowance must be 0 to 10000 mm, not -1 mm");
    profile.roughing = {2.0, 0.3, 0.0};
    profile.blank = {};
    EXPECT_EQ(in_english(roughing_problem(profile)),
              "roughing begins at the blank's surface: say how large the blank is, or choose finishing only");
    profile.roughing.stepdown_mm = 0.0;
    EXPECT_TRUE(roughing_problem(profile).is_empty());
}

}  // namespace
}  // namespace psicarve::session
