// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/flat/grooves.hpp"

#include <algorithm>

#include "hmi/flat/stroke_index.hpp"
#include "tests/hmi/flat/flat_files.hpp"

namespace psicarve::flat {
namespace {

class GroovesTest : public FlatTest {
protected:
    static FlatOptions engraved(double depth_mm, ToolProfile tool = {}) {
        FlatOptions options;
        options.engraving = {depth_mm, 0.0, false, tool};
        return options;
    }
    Grooves grooves(const std::string& inside, const FlatOptions& options) const {
        const model::Mesh mesh = svg(inside, options);
        EXPECT_NE(mesh.grooves, nullptr);
        return mesh.grooves ? *mesh.grooves : Grooves{};
    }
    std::string refused(const std::string& inside, const FlatOptions& options) const {
        return refusal(file("drawing.svg", picture(inside)), options);
    }
};

constexpr const char* kLine = "<path d='M10 10 L40 10 M10 30 L10 20' stroke='black'/>";

TEST_F(GroovesTest, StandInTheMiddleOfTheHeightFromTheirStartOn) {
    FlatOptions options = engraved(0.5, {ToolShape::flat, 2.0});
    options.height_mm = 30.0;
    options.engraving->start_deg = 90.0;
    const Grooves sut = grooves(kLine, options);
    ASSERT_EQ(sut.strokes.size(), 2U);
    const double quarter_mm = 10.0 * kPi;  // of a cylinder 40 mm across
    EXPECT_NEAR(sut.strokes[0].points[0].x, quarter_mm, 1e-9);
    EXPECT_NEAR(sut.strokes[0].points[0].y, 25.0, 1e-9);
    EXPECT_NEAR(sut.strokes[0].points[1].x, quarter_mm + 30.0, 1e-9);
    EXPECT_NEAR(sut.strokes[1].points[0].y, 5.0, 1e-9);
    EXPECT_DOUBLE_EQ(sut.height_mm, 30.0);
    // Without a height: the drawing, a groove's half above and below, and an edge.
    options.height_mm.reset();
    EXPECT_NEAR(grooves(kLine, options).height_mm, 20.0 + 2.0 + 2.0, 1e-9);
}

TEST_F(GroovesTest, GoAllRoundWhenAsked) {
    FlatOptions options = engraved(0.5);
    options.is_full_turn = true;
    options.diameter_mm = 60.0;
    const Grooves sut = grooves(kLine, options);
    EXPECT_NEAR(sut.strokes[0].points[1].x - sut.strokes[0].points[0].x, 60.0 * kPi, 1e-9);
    EXPECT_NEAR(sut.height_mm, 20.0 * 60.0 * kPi / 30.0 + 2.0, 1e-9);
}

TEST_F(GroovesTest, AreRefusedWhereTheyDoNotFit) {
    FlatOptions options = engraved(0.5);
    options.diameter_mm = 9.0;
    EXPECT_NE(refused(kLine, options).find("30.00 mm wide, and once round the cylinder are only 28.27 mm"),
              std::string::npos);
    options.diameter_mm = 40.0;
    options.height_mm = 15.0;
    EXPECT_NE(refused(kLine, options).find("20.00 mm high, and the cylinder only 15.00 mm"),
              std::string::npos);
    EXPECT_NE(refused(kLine, engraved(20.0)).find("less deep than the cylinder's radius"), std::string::npos);
    EXPECT_NE(refused(kLine, engraved(0.0)).find("deeper than 0"), std::string::npos);
    EXPECT_NE(refused("<path d='M0 0 H9' fill='none'/>", engraved(1.0)).find("no lines to engrave"),
              std::string::npos);
}

TEST_F(GroovesTest, StayCalculableWhateverADrawingSays) {
    FlatOptions options = engraved(0.5);
    options.is_full_turn = true;
    const std::string needle = "<path d='M0 0 l1e-9 90' stroke='black'/>";
    EXPECT_NE(refused(needle, options).find("more than ten metres wide or high"), std::string::npos);
    EXPECT_NE(
        refused("<g transform='scale(1e200)'><path d='M0 0 h90 v1e9' stroke='black'/></g>", engraved(0.5))
            .find("more than ten metres"),
        std::string::npos);
    options = engraved(0.5, {ToolShape::ball, 1.0});
    options.engraving->follows_strokes = true;
    const std::string wide = "<path d='M0 0 h5' stroke='black' stroke-width='1e300'/>";
    EXPECT_NE(refused(wide, options).find("more than ten metres"), std::string::npos);
    options.height_mm = 5.0;
    const Grooves sut = grooves(wide, options);
    const StrokeIndex index(sut, 2.0);
    EXPECT_LT(index.beside_floor_mm(sut.round_mm() * 0.75, 1.0), 0.0);
}

TEST_F(GroovesTest, LeaveOutWhatIsNeitherFilledNorStroked) {
    const Grooves sut = grooves(
        "<path d='M0 0 H90 V90 H0 Z' fill='none'/><g fill='none'><path d='M10 10 h5' stroke='red'/>"
        "<path d='M10 20 h5'/></g><path d='M20 20 h5 v5 z'/><line x1='1' x2='3'/>",
        engraved(1.0));
    EXPECT_EQ(sut.strokes.size(), 2U);
}

TEST_F(GroovesTest, AreAsWideAsTheStrokesWhenAskedAndAtLeastAsTheTool) {
    FlatOptions options = engraved(0.5, {ToolShape::flat, 2.0});
    options.engraving->follows_strokes = true;
    options.scale = 0.5;
    const Grooves sut = grooves(
        "<g stroke='black' style='stroke-width:6'><path d='M10 10 h20'/>"
        "<path transform='scale(2 0.5)' stroke-width='10%' d='M10 30 h20'/><path stroke-width='1' d='M9 50 "
        "h9'/></g>",
        options);
    ASSERT_EQ(sut.strokes.size(), 3U);
    EXPECT_NEAR(sut.strokes[0].half_floor_mm, 0.5 * 3.0 - 1.0, 1e-9);
    EXPECT_NEAR(sut.strokes[1].half_floor_mm, 0.5 * 5.0 - 1.0, 1e-9);  // 10 of 100, under one of sqrt(2 0.5)
    EXPECT_EQ(sut.strokes[2].half_floor_mm, 0.0);
    ASSERT_EQ(sut.warnings.size(), 1U);
    EXPECT_NE(sut.warnings[0].find("1 of 3 strokes are narrower than the tool cuts, 2.00 mm"),
              std::string::npos);
}

TEST_F(GroovesTest, CrossSectionIsTheToolAndTheTipGoesInAsFarAsThatLets) {
    for (const ToolProfile& tool : {ToolProfile{ToolShape::ball, 3.0}, ToolProfile{ToolShape::vee, 4.0, 60.0},
                                    ToolProfile{ToolShape::vee, 0.6, 90.0}, ToolProfile{ToolShape::flat, 2.0},
                                    ToolProfile{ToolShape::ball, 1.0}}) {
        const Grooves sut = grooves(kLine, engraved(0.8, tool));
        const tool::Tool cutter = tool::tool_of(tool, 1.0);
        // On the stroke the tool's own shape, up to the surface.
        for (double beside_mm = 0.0; beside_mm < 3.0; beside_mm += 0.0171) {
            const double left_mm = beside_mm <= cutter.radius ? tool::rise(cutter, beside_mm) - 0.8 : 0.0;
            EXPECT_NEAR(sut.depth_beside_mm(beside_mm), -std::min(left_mm, 0.0), 1e-12);
        }
        // Beside it as deep as the tool stands without entering that: the definition, searched through.
        for (double beside_mm = 0.01; beside_mm < 2.5; beside_mm += 0.0937) {
            double tip_mm = -0.8;
            constexpr int kSteps = 5'000;
            for (int k = -kSteps; k <= kSteps; ++k) {
                const double away_mm = cutter.radius * k / kSteps;
                const double surface_mm = -sut.depth_beside_mm(std::abs(beside_mm + away_mm));
                tip_mm = std::max(tip_mm, surface_mm - tool::rise(cutter, std::abs(away_mm)));
            }
            EXPECT_NEAR(sut.tip_depth_mm(beside_mm), -tip_mm, 0.001)
                << tool::name_of(tool) << " " << beside_mm << " beside";
        }
    }
}

TEST_F(GroovesTest, FindTheNearestStrokeAcrossTheSeam) {
    FlatOptions options = engraved(0.5);
    options.diameter_mm = 10.0;  // 31.4 mm round
    options.engraving->start_deg = -36.0;
    const Grooves sut = grooves(kLine, options);
    const StrokeIndex index(sut, 2.0);
    const double line_mm = 0.5 * sut.height_mm + 10.0;
    EXPECT_NEAR(index.beside_floor_mm(0.0, line_mm), 0.0, 1e-12);
    EXPECT_NEAR(index.beside_floor_mm(20.0, line_mm - 1.5), 1.5, 1e-12);
    EXPECT_NEAR(index.beside_floor_mm(-0.1 * sut.round_mm(), line_mm + 1.0), 1.0, 1e-12);
    // The line's two ends are 1.4 mm from each other the short way round.
    const double end_mm = 30.0 - 0.1 * sut.round_mm();
    EXPECT_NEAR(index.beside_floor_mm(end_mm + 0.4, line_mm), 0.4, 1e-12);
    EXPECT_NEAR(index.beside_floor_mm(end_mm + 1.1 - 3.0 * sut.round_mm(), line_mm), sut.round_mm() - 31.1,
                1e-9);
    EXPECT_TRUE(std::isinf(index.beside_floor_mm(15.0, line_mm - 5.0)));
}

TEST_F(GroovesTest, BecomeABodyThatSaysHowItWasMade) {
    FlatOptions options = engraved(0.5, {ToolShape::flat, 2.0});
    options.engraving->start_deg = 12.0;
    const model::Mesh mesh = svg("<path d='M0 0 H30' stroke='black'/>", options);
    EXPECT_TRUE(mesh.facts.closed);
    EXPECT_NEAR(radius(mesh, 50.0), 19.5, 0.001);
    EXPECT_NEAR(radius(mesh, 5.0), 20.0, 0.001);
    const FlatOptions read = flat_options_from_json(mesh.body_json);
    ASSERT_TRUE(read.engraving.has_value());
    EXPECT_EQ(read.engraving->start_deg, 12.0);
    EXPECT_EQ(read.engraving->depth_mm, 0.5);
    EXPECT_EQ(read.engraving->tool.shape, ToolShape::flat);
    EXPECT_EQ(read.engraving->tool.diameter_mm, 2.0);
}

}  // namespace
}  // namespace psicarve::flat
