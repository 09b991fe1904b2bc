// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/flat/dashes.hpp"

#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "hmi/flat/grooves.hpp"
#include "tests/hmi/flat/flat_files.hpp"

namespace psicarve::flat {
namespace {

class DashesTest : public FlatTest {
protected:
    static FlatOptions engraved() {
        FlatOptions options;
        options.engraving = {0.5, 0.0, false, {}};
        return options;
    }
    std::vector<GrooveStroke> strokes(const std::string& inside,
                                      const FlatOptions& options = engraved()) const {
        const auto mesh = svg(inside, options);
        return mesh.grooves ? mesh.grooves->strokes : std::vector<GrooveStroke>{};
    }
    /// Where the dashes of a level line of 30 mm begin and end.
    std::vector<double> ends(const std::string& style, const FlatOptions& options = engraved()) const {
        std::vector<double> all;
        for (const auto& stroke :
             strokes("<path d='M10 10 h30' stroke='red' fill='none' " + style + "/>", options)) {
            EXPECT_FALSE(stroke.is_closed);
            all.push_back(stroke.points.front().x);
            all.push_back(stroke.points.back().x);
        }
        return all;
    }
};

void expect_near(const std::vector<double>& found, const std::vector<double>& wanted) {
    ASSERT_EQ(found.size(), wanted.size()) << testing::PrintToString(found);
    for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(found[i], wanted[i], 1e-9) << i;
}

TEST_F(DashesTest, AreEngravedAsTheDrawingHasThem) {
    expect_near(ends("stroke-dasharray='10 5'"), {0, 10, 15, 25});
    expect_near(ends("style='stroke-dasharray: 10px, 5px'"), {0, 10, 15, 25});
    expect_near(ends("stroke-dasharray='8'"), {0, 8, 16, 24});
    expect_near(ends("stroke-dasharray='12 3 6'"), {0, 12, 15, 21});
    expect_near(ends("stroke-dasharray='20%'"), {0, 20});
    expect_near(ends("stroke-dasharray='50 50' pathLength='100'"), {0, 15});
}

TEST_F(DashesTest, GrowWithTheirTransform) {
    const auto sut = strokes(
        "<g transform='scale(10)'><path d='M0 0h3' stroke='red' fill='none' stroke-dasharray='1,2.5'/></g>");
    ASSERT_EQ(sut.size(), 1U);
    EXPECT_NEAR(sut[0].points[1].x, 10.0, 1e-9);
}

TEST_F(DashesTest, BeginWhereTheirOffsetSays) {
    expect_near(ends("stroke-dasharray='10 5' stroke-dashoffset='4'"), {0, 6, 11, 21, 26, 30});
    expect_near(ends("stroke-dasharray='10 5' stroke-dashoffset='-5'"), {5, 15, 20, 30});
    expect_near(ends("stroke-dasharray='10 5' stroke-dashoffset='1510'"), {5, 15, 20, 30});
}

TEST_F(DashesTest, GoAllRoundWithTheDrawing) {
    FlatOptions options = engraved();
    options.is_full_turn = true;
    const double share = 40.0 * kPi / 30.0;
    expect_near(ends("stroke-dasharray='10 5'", options), {0, 10 * share, 15 * share, 25 * share});
}

TEST_F(DashesTest, AreInheritedAndMayBeTakenBack) {
    const auto of_group = [this](const std::string& child) {
        return strokes("<g stroke='red' fill='none' stroke-dasharray='10 5'><path d='M10 10 h30' " + child +
                       "/></g>")
            .size();
    };
    EXPECT_EQ(of_group(""), 2U);
    EXPECT_EQ(of_group("stroke-dasharray='30 1'"), 1U);
    for (const char* whole : {"none", "0", "0 0", "-1 2", "x", "1 x"}) {
        EXPECT_EQ(of_group("stroke-dasharray='" + std::string(whole) + "'"), 1U) << whole;
    }
}

TEST_F(DashesTest, RunOnRoundAClosedShapeToItsBegin) {
    const auto sut =
        strokes("<rect width='10' height='10' fill='none' stroke='red' stroke-dasharray='33 5'/>");
    ASSERT_EQ(sut.size(), 2U);
    ASSERT_EQ(sut[0].points.size(), 5U);
    EXPECT_NEAR(sut[0].points[4].y - sut[0].points[0].y, -7.0, 1e-9);
    EXPECT_NEAR(sut[1].points[0].y - sut[0].points[0].y, -2.0, 1e-9);
    EXPECT_NEAR(sut[1].points[1].y - sut[0].points[0].y, 0.0, 1e-9);
}

TEST_F(DashesTest, WithoutLengthAreDots) {
    expect_near(ends("stroke-dasharray='0 10'"), {0, 0, 10, 10, 20, 20, 30, 30});
    FlatOptions options = engraved();
    options.engraving->tool = {ToolShape::ball, 1.0};
    const auto mesh =
        svg("<path d='M10 10 h30 v20' stroke='red' fill='none' stroke-dasharray='0 10'/>", options);
    EXPECT_NEAR(radius(mesh, rad_from_deg(0.0)), 20.0, 1e-3);
    EXPECT_NEAR(radius(mesh, deg_from_rad(30.0 / 20.0)), 19.5, 0.02) << "the dot half way up";
}

TEST_F(DashesTest, LeaveFilledShapesAndOutlinesWhole) {
    const std::string square = "<rect width='10' height='10' stroke='red' stroke-dasharray='2 2' ";
    const auto filled = strokes(square + "fill='blue'/>");
    ASSERT_EQ(filled.size(), 1U);
    EXPECT_TRUE(filled[0].is_closed);
    EXPECT_NEAR(radius(svg(square + "fill='none'/>"), 0), 5.0, kExact_mm);
}

TEST_F(DashesTest, WithoutEndAreRefused) {
    const std::string line = "<path d='M0 0h90' stroke='red' fill='none' stroke-dasharray='";
    for (const char* dashes : {"1e-7", "1e-300", "0 1e-7", "1e-200 1e-7 0 0"}) {
        EXPECT_THAT(refusal(file("drawing.svg", picture(line + dashes + "'/>")), engraved()),
                    testing::HasSubstr("more than 2000000 points"))
            << dashes;
    }
}

}  // namespace
}  // namespace psicarve::flat
