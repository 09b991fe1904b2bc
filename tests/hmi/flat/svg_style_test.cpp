// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/flat/svg_style.hpp"

#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "hmi/flat/grooves.hpp"
#include "tests/hmi/flat/flat_files.hpp"

namespace psicarve::flat {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class SvgStyleTest : public FlatTest {
protected:
    /// Half the side of the square that is left when the one of 80 is not drawn: 5; else 40.
    double half_side(const std::string& style, const std::string& large) const {
        const auto mesh = svg("<style>" + style + "</style><rect width='80' height='80' " + large +
                              "/><rect width='10' height='10' class='small'/>");
        return radius(mesh, 0);
    }
    std::vector<std::string> warnings(const std::string& style) const {
        return svg("<style>" + style + "</style><rect width='10' height='10'/>").warnings;
    }
    GrooveStroke engraved(const std::string& inside) const {
        FlatOptions options;
        options.engraving = {0.5, 0.0, false, {}};
        const auto mesh = svg(inside, options);
        EXPECT_EQ(mesh.grooves->strokes.size(), 1U);
        return mesh.grooves->strokes.front();
    }
};

constexpr double kGone = 5.0;
constexpr double kThere = 40.0;

TEST_F(SvgStyleTest, RulesForNamesClassesAndIdsAreFollowed) {
    const std::string large = "id='big' class='a  b'";
    for (const char* selector : {"#big", ".a", ".b", ".a.b", "rect#big", "rect.a", "rect#big.b.a", "*#big",
                                 ".c, .a ,.d", "g,#big"}) {
        EXPECT_NEAR(half_side(std::string(selector) + "{display:none}", large), kGone, kExact_mm) << selector;
    }
    for (const char* selector : {"#bi", ".A", ".a.c", "circle#big", "circle.a", "#big.c", "g, h"}) {
        EXPECT_NEAR(half_side(std::string(selector) + "{display:none}", large), kThere, kExact_mm)
            << selector;
    }
    EXPECT_NEAR(half_side("rect{display:none} .small{display:inline}", large), kGone, kExact_mm);
    EXPECT_NEAR(half_side("*{display:none} svg,.small{display:inline}", large), kGone, kExact_mm);
}

TEST_F(SvgStyleTest, CommentsAreNoRules) {
    EXPECT_NEAR(half_side("/* .x{} */ .a /* of { } */ { /* fill:none; */ display: none }", "class='a'"),
                kGone, kExact_mm);
    EXPECT_NEAR(half_side("/* .a{display:none} */ .b{fill:red}", "class='a'"), kThere, kExact_mm);
    EXPECT_NEAR(half_side("<![CDATA[<!-- .a{display:none} -->]]>", "class='a'"), kGone, kExact_mm);
}

TEST_F(SvgStyleTest, TheStrongerRuleWinsAndOfEqualOnesTheLater) {
    const auto seen = [this](const std::string& style, const std::string& more = "") {
        return half_side(style, "id='i' class='a b' " + more) > 20.0;
    };
    EXPECT_TRUE(seen(".a{display:none} .b{display:inline}"));
    EXPECT_FALSE(seen(".b{display:inline} .a{display:none}"));
    EXPECT_TRUE(seen("#i{display:inline} .a.b{display:none}"));
    EXPECT_TRUE(seen(".a{display:inline} rect{display:none} .small{display:inline}"));
    EXPECT_FALSE(seen("rect.a{display:none} .a{display:inline}"));
    EXPECT_TRUE(seen("#i{display:none}", "style='display:inline'"));
    EXPECT_FALSE(seen(".a{display:none!important}", "style='display:inline'"));
    EXPECT_FALSE(seen(".a{display:none}", "display='inline'")) << "an attribute is weaker than every rule";
    EXPECT_FALSE(seen("*{display:none} svg,.small{display:inline}", "display='inline'"));
}

TEST_F(SvgStyleTest, WhatIsNotFollowedIsNamedOnce) {
    const std::string is_left = "of <style> only rules for element names, .class and #id are followed, not ";
    for (const char* selector :
         {"g > rect", "g rect", "rect:hover", "rect[width]", "a + b", "a~b", "svg|rect"}) {
        const std::string shown = std::string(selector) == "g > rect" ? "g &gt; rect" : selector;
        EXPECT_THAT(warnings(shown + "{fill:none} g g{fill:none}"),
                    ElementsAre(is_left + "'" + selector + "'"));
    }
    EXPECT_THAT(warnings("@media print { rect { fill:none } } .x{fill:none}"),
                ElementsAre(is_left + "'@media'"));
    EXPECT_THAT(warnings("@import 'a.css';"), ElementsAre(is_left + "'@import'"));
    EXPECT_THAT(warnings(".ok, g:first-child {stroke:none}"), ElementsAre(is_left + "'g:first-child'"));
}

TEST_F(SvgStyleTest, WhatSaysNothingOfLinesIsNotMissed) {
    EXPECT_THAT(
        warnings("@charset 'utf-8'; @font-face{font-family:x} @keyframes k{from{fill:none}to{fill:red}} "
                 "rect:hover{cursor:pointer} text > tspan{font-size:3px}"),
        IsEmpty());
    EXPECT_NEAR(half_side("@font-face { src: url(x) } .a{display:none}", "class='a'"), kGone, kExact_mm);
}

TEST_F(SvgStyleTest, DamagedSheetsAreReadAsFarAsTheyGo) {
    for (const char* sheet :
         {"{", "}", ".a", ".a{", ".a{fill", "@", "@media", "@media{", "/*", ",{fill:none}", ".{fill:none}",
          "#{fill:none}", "{fill:none}", ".a{fill:none}}", "@media{.a{fill:none}", ";;;"}) {
        const auto mesh = svg("<style>" + std::string(sheet) + "</style><rect width='10' height='10'/>");
        EXPECT_NEAR(radius(mesh, 0), 5.0, kExact_mm) << sheet;
    }
}

TEST_F(SvgStyleTest, WhatIsWhollyTransparentIsNotSeen) {
    for (const char* clear : {"opacity='0'", "style='opacity:0%'", "opacity='-1'", "opacity='.0'"})
        EXPECT_NEAR(half_side("", clear), kGone, kExact_mm) << clear;
    EXPECT_NEAR(half_side(".a{opacity:0}", "class='a'"), kGone, kExact_mm);
    for (const char* seen : {"opacity='0.01'", "opacity='1'", "opacity=''", "opacity='x'"})
        EXPECT_NEAR(half_side("", seen), kThere, kExact_mm) << seen;
    const std::string small = "<rect width='10' height='10'/>";
    const std::string in_group = "<g opacity='0'><rect opacity='1' width='80' height='80'/></g>";
    EXPECT_NEAR(radius(svg(small + in_group), 0), 5.0, kExact_mm);
    // As a fill of none an open path is open.
    for (const char* clear : {"fill-opacity='0'", "fill-opacity='0' fill='red'", "style='fill-opacity:0%'"}) {
        const auto mesh = svg(small + "<path stroke='red' d='M0 0H80V80' " + clear + "/>");
        EXPECT_NEAR(radius(mesh, 0), 5.0, kExact_mm) << clear;
    }
    EXPECT_EQ(
        engraved("<g fill='none' stroke='red'><path stroke-opacity='0' d='M0 0H9'/><g stroke-opacity='0'>"
                 "<path stroke='blue' d='M0 0H8'/><path stroke-opacity='.5' d='M0 0H7'/></g></g>")
            .points.size(),
        2U);
}

TEST_F(SvgStyleTest, AStyleMayTransform) {
    const auto end = [this](const std::string& attributes) {
        const auto stroke = engraved("<line x1='0' y1='0' x2='10' y2='0' stroke='red' " + attributes + "/>");
        return Point{stroke.points[1].x - stroke.points[0].x, stroke.points[1].y - stroke.points[0].y};
    };
    for (const char* turn :
         {"rotate(90deg)", "rotate(.25turn)", "rotate(100grad)", "rotate(1.5707963267949rad)", "rotate(90)",
          "translate(1px, 2mm) rotate(90deg)", "translateX(3px)rotate(90deg)"}) {
        const Point down = end("style='transform:" + std::string(turn) + "'");
        EXPECT_NEAR(down.x, 0.0, 1e-9) << turn;
        EXPECT_NEAR(down.y, -10.0, 1e-9) << turn;
    }
    EXPECT_NEAR(end("style='transform: scaleX(2) skew(0deg,0deg)'").x, 20.0, 1e-9);
    EXPECT_NEAR(end("transform='scale(3)' style='transform:scale(2)'").x, 20.0, 1e-9) << "style is stronger";
    EXPECT_NEAR(end("style='transform:none'").x, 10.0, 1e-9);
}

TEST_F(SvgStyleTest, OfASwitchTheFirstThatFitsIsDrawn) {
    const std::string large = " width='80' height='80'/>";
    const std::string small = "<rect width='10' height='10'/>";
    for (const std::string other : {"<rect systemLanguage='de'", "<rect systemLanguage=''",
                                    "<rect requiredExtensions='http://a'", "<foreignObject"}) {
        const auto mesh = svg("<switch><title/>" + other + large + small + "<rect" + large + "</switch>");
        EXPECT_NEAR(radius(mesh, 0), 5.0, kExact_mm) << other;
        EXPECT_THAT(mesh.warnings, IsEmpty()) << other;
    }
    const auto none = svg(small + "\n<switch><rect systemLanguage='de'" + large + "</switch>");
    EXPECT_NEAR(radius(none, 0), 5.0, kExact_mm);
    EXPECT_THAT(none.warnings,
                ElementsAre("line 2: <switch> holds nothing for every language and is left out"));
}

TEST_F(SvgStyleTest, ATransformTurnsAboutItsOrigin) {
    const auto axis = [this](const std::string& style) {
        return *svg("<rect width='10' height='10' style='" + style + "'/>").axis_hint;
    };
    EXPECT_NEAR(axis("transform:rotate(180deg);transform-origin:10px 20px")[0], 15.0, 1e-4);
    EXPECT_NEAR(axis("transform:rotate(180deg);transform-origin:10px 20px")[1], -35.0, 1e-4);
    EXPECT_NEAR(axis("transform:rotate(180deg);transform-origin:center")[0], 95.0, 1e-4);
    EXPECT_NEAR(axis("transform:rotate(180deg);transform-origin:bottom left")[1], -195.0, 1e-4);
    EXPECT_NEAR(axis("transform:rotate(180deg);transform-origin:25% 0")[0], 45.0, 1e-4);
    EXPECT_NEAR(axis("transform-origin:25% 0")[0], 5.0, 1e-4);
}

TEST_F(SvgStyleTest, ATransformThatCannotBeReadLeavesItsElementOutAndSaysSo) {
    for (const char* style :
         {"transform:rotate3d(1,0,0,10deg)", "transform:translate(50%,0)", "transform:scale(2px)",
          "transform:rotate(90deg);transform-box:fill-box", "transform:rotate(90deg);transform-origin:x y"}) {
        const auto mesh = svg("<rect width='10' height='10'/>\n<rect width='90' height='90' style='" +
                              std::string(style) + "'/>");
        EXPECT_NEAR(radius(mesh, 0), 5.0, kExact_mm) << style;
        EXPECT_THAT(mesh.warnings,
                    ElementsAre("line 2: a transform that cannot be read; the element is left out"));
    }
}

}  // namespace
}  // namespace psicarve::flat
