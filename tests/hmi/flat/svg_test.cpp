// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/hmi/flat/flat_files.hpp"

namespace psicarve::flat {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

class Svg : public FlatTest {};

TEST_F(Svg, ASquareHasItsHalfSideAndItsHalfDiagonal) {
    const auto mesh = svg("<rect x='10' y='20' width='30' height='30'/>");
    EXPECT_NEAR(radius(mesh, 0), 15.0, kExact_mm);
    EXPECT_NEAR(radius(mesh, 90), 15.0, kExact_mm);
    EXPECT_NEAR(radius(mesh, 45), 15.0 * std::sqrt(2.0), kExact_mm);
    EXPECT_NEAR(radius(mesh, 30), 15.0 / std::cos(rad_from_deg(30)), kExact_mm);
    EXPECT_NEAR((*mesh.axis_hint)[0], 25.0, kExact_mm);
    EXPECT_NEAR((*mesh.axis_hint)[1], -35.0, kExact_mm);  // y points up
    EXPECT_DOUBLE_EQ(mesh.facts.max[2] - mesh.facts.min[2], 20.0);
    EXPECT_TRUE(mesh.facts.closed);
    EXPECT_TRUE(mesh.facts.same_orientation);
    EXPECT_NEAR(mesh.facts.signed_volume, 30.0 * 30.0 * 20.0, 0.01);
}

TEST_F(Svg, ACircleIsRoundWithinATenthOfAPulse) {
    const auto mesh = svg("<circle cx='50' cy='50' r='20'/>");
    for (double angle_deg = 0.0; angle_deg < 360.0; angle_deg += 7.3) {
        EXPECT_NEAR(radius(mesh, angle_deg), 20.0, kCurve_mm) << angle_deg;
    }
}

TEST_F(Svg, AnEllipseThatIsTurnedByATransformIsExact) {
    const auto mesh = svg("<ellipse cx='0' cy='0' rx='20' ry='10' transform='translate(50 50) rotate(30)'/>");
    // Clockwise in a picture whose y points down, and so on the table seen from above.
    EXPECT_NEAR(radius(mesh, -30), 20.0, kCurve_mm);
    EXPECT_NEAR(radius(mesh, 60), 10.0, kCurve_mm);
    EXPECT_NEAR(radius(mesh, 0),
                1.0 / std::hypot(std::cos(rad_from_deg(30)) / 20, std::sin(rad_from_deg(30)) / 10),
                kCurve_mm);
}

TEST_F(Svg, AStarHasItsTipsAndItsNotches) {
    std::string points;
    for (int i = 0; i < 10; ++i) {
        const double r = i % 2 == 0 ? 30.0 : 12.0;
        const double a = rad_from_deg(36.0 * i);
        points += std::to_string(50 + r * std::cos(a)) + "," + std::to_string(50 - r * std::sin(a)) + " ";
    }
    const auto mesh = svg("<polygon points='" + points + "'/>");
    for (int i = 0; i < 10; ++i) {
        EXPECT_NEAR(radius(mesh, 36.0 * i), i % 2 == 0 ? 30.0 : 12.0, 1e-4) << i;
    }
}

TEST_F(Svg, PathsOfEveryCommandAreFollowed) {
    // A box of 20 x 20 around (50, 50): each side with other commands, all of them straight or round the
    // corner.
    const auto mesh =
        svg("<path d='M40 40 h10 H60 v10 V60 l-10 0 L40 60 C40 55 40 52 40 50 S40 45 40 42 Q40 41 40 40.5 "
            "T40 40 z'/>");
    EXPECT_NEAR(radius(mesh, 0), 10.0, kExact_mm);
    EXPECT_NEAR(radius(mesh, 180), 10.0, kExact_mm);
    EXPECT_NEAR(radius(mesh, 225), 10.0 * std::sqrt(2.0), kExact_mm);
}

TEST_F(Svg, ArcsTakeTheWayTheirFlagsSay) {
    // Two half circles; flags written without gaps, as programs that save every byte do.
    const auto disc = svg("<path d='M30 50a20 20 0 0140 0a20 20 0 01-40 0z'/>");
    EXPECT_NEAR(radius(disc, 77), 20.0, kCurve_mm);
    // Three quarters of a circle of radius 10 around (50, 50), and straight to the centre.
    const auto pie = svg("<path d='M50 50 L60 50 A10 10 0 1 1 50 40 Z'/>", {});
    EXPECT_NEAR((*pie.axis_hint)[0], 50.0 - 40.0 / (9.0 * kPi), 1e-3);
    // Radii too small to reach are made just large enough.
    const auto grown = svg("<path d='M30 50A1 1 0 0 1 70 50A1 1 0 0 1 30 50z'/>");
    EXPECT_NEAR(radius(grown, 200), 20.0, kCurve_mm);
}

TEST_F(Svg, ACubicBezierIsWithinItsFlatness) {
    // A parabola: y = 4 x (1 - x) over a unit of 20 mm, 20 mm high.
    const auto mesh = svg("<path d='M40 60 Q50 20 60 60z'/>");
    const double centre_y =
        -(60.0 - 0.4 * 20.0);  // the centroid of a parabola's area lies at 2/5 of its height
    EXPECT_NEAR((*mesh.axis_hint)[1], centre_y, 1e-3);
    EXPECT_NEAR(radius(mesh, 90), -40.0 - centre_y, kCurve_mm);
}

TEST_F(Svg, UnitsAndViewBoxSetTheSize) {
    const auto in = [this](const std::string& head) {
        return loaded(file("u.svg", "<svg xmlns='http://www.w3.org/2000/svg' " + head + "</svg>"));
    };
    EXPECT_NEAR(radius(in("width='2in' height='2in'><rect width='1in' height='1in'/>"), 0), 12.7, kExact_mm);
    EXPECT_NEAR(radius(in("width='96' height='96'><rect width='96' height='96'/>"), 0), 12.7, kExact_mm);
    EXPECT_NEAR(
        radius(in("width='40mm' height='20mm' viewBox='0 0 10 10'><rect width='10' height='10'/>"), 0), 10.0,
        kExact_mm);  // meet: the smaller side decides
    EXPECT_NEAR(radius(in("width='40mm' height='20mm' preserveAspectRatio='none' viewBox='0 0 10 10'>"
                          "<rect width='10' height='10'/>"),
                       0),
                20.0, kExact_mm);
    EXPECT_NEAR(radius(in("width='4cm' viewBox='0 0 10 10'><rect width='50%' height='5'/>"), 0), 10.0,
                kExact_mm);
    FlatOptions half;
    half.scale = 0.5;
    half.height_mm = 7.0;
    const auto mesh = svg("<rect width='30' height='30'/>", half);
    EXPECT_NEAR(radius(mesh, 0), 7.5, kExact_mm);
    EXPECT_DOUBLE_EQ(mesh.facts.max[2], 7.0);
}

TEST_F(Svg, TransformsApplyFromTheInsideOut) {
    const auto mesh =
        svg("<g transform='translate(10,0) scale(2)'><rect width='10' height='5' "
            "transform='matrix(1 0 0 1 1 0) skewX(0) rotate(90 5 2.5)'/></g>");
    EXPECT_NEAR(radius(mesh, 0), 5.0, kExact_mm);
    EXPECT_NEAR(radius(mesh, 90), 10.0, kExact_mm);
    EXPECT_NEAR((*mesh.axis_hint)[0], 10.0 + 2.0 * (1.0 + 5.0), kExact_mm);
}

TEST_F(Svg, UseAndSymbolDrawWhatTheyName) {
    const auto mesh = svg(
        "<defs><rect id='r' width='10' height='10'/></defs><symbol id='s' viewBox='0 0 1 1'><circle cx='.5' "
        "cy='.5' r='.5'/></symbol><use href='#r' x='20'/><use xmlns:xlink='http://www.w3.org/1999/xlink' "
        "xlink:href='#s' x='20' y='0' width='10' height='10'/>");
    EXPECT_NEAR((*mesh.axis_hint)[0], 25.0, 1e-4);
    EXPECT_NEAR(radius(mesh, 45), 5.0 * std::sqrt(2.0), kExact_mm);
}

TEST_F(Svg, ASymbolsOwnWordsCountWhereItIsUsed) {
    const auto used = [](const std::string& symbol, const std::string& inside) {
        return "<symbol id='s' " + symbol + ">" + inside + "</symbol><use href='#s' width='50' height='50'/>";
    };
    const std::string open = "<path d='M5 5 L35 5 L35 35'/>";
    EXPECT_THAT(refusal(file("open.svg", picture(used("fill='none' stroke='black'", open)))),
                HasSubstr("has no closed outline"));
    const std::string square = "<rect width='10' height='10'/>";
    EXPECT_NEAR((*svg(used("transform='translate(20)'", square)).axis_hint)[0], 25.0, kExact_mm);
    EXPECT_NEAR(radius(svg(square + used("visibility='hidden'", "<rect width='40' height='40'/>")), 0), 5.0,
                kExact_mm);
    EXPECT_EQ(
        svg("<clipPath id='c'/>\n" + used("clip-path='url(#c)'", square)).warnings,
        std::vector<std::string>{"line 2: clipping and masks are not followed: <symbol> is carved whole"});
    EXPECT_EQ(svg(square + "\n" + used("transform='nothing'", "<rect width='40' height='40'/>")).warnings,
              std::vector<std::string>{"line 2: a transform that cannot be read; the element is left out"});
    // Only through <use> a symbol is seen, and then whatever its display says.
    EXPECT_NEAR(radius(svg(used("display='none'", square)), 0), 5.0, kExact_mm);
    EXPECT_NEAR(radius(svg(square + "<defs><svg id='n' display='none'><rect width='40' height='40'/></svg>"
                                    "</defs><use href='#n'/>"),
                       0),
                5.0, kExact_mm);
    EXPECT_THAT(
        refusal(file("gone.svg", "<svg width='9mm' height='9mm' display='none'>" + square + "</svg>")),
        HasSubstr("holds no line"));
    FlatOptions options;
    options.engraving = {0.5, 0.0, true, {}};
    const auto line =
        svg(used("viewBox='0 0 10 10' fill='none' stroke='black' stroke-width='3'", "<path d='M1 1 L9 9'/>"),
            options);
    ASSERT_EQ(line.grooves->strokes.size(), 1U);
    EXPECT_NEAR(line.grooves->strokes.front().half_floor_mm, 0.5 * 3.0 * 5.0, 1e-9);
}

TEST_F(Svg, ASizeInPercentIsNone) {
    const auto in = [this](const std::string& head) {
        return loaded(
            file("p.svg", "<svg " + head + " viewBox='0 0 96 48'><rect width='96' height='48'/></svg>"));
    };
    const std::vector<std::string> has_no_size{
        "the drawing does not say how large it is: its units are taken as 1/96 inch"};
    for (const char* head : {"width='100%' height='100%'", "width=' 50% '", "height='100%'", ""}) {
        const auto mesh = in(head);
        EXPECT_EQ(mesh.warnings, has_no_size) << head;
        EXPECT_NEAR(radius(mesh, 0), 12.7, kExact_mm) << head;
    }
    for (const char* head : {"width='2in' height='100%'", "width='100%' height='1in'"}) {
        const auto mesh = in(head);
        EXPECT_TRUE(mesh.warnings.empty()) << head;
        EXPECT_NEAR(radius(mesh, 0), 25.4, kExact_mm) << head;
    }
}

TEST_F(Svg, WhatIsNotShownIsNotCarved) {
    const auto mesh = svg(
        "<style>.gone{display:none} .x, .y {fill:none}</style><rect class='gone' width='90' height='90'/>"
        "<rect style='display:none' width='80' height='80'/><g visibility='hidden'><rect width='70' "
        "height='70'/></g><clipPath><rect width='60' height='60'/></clipPath><rect width='10' height='10'/>");
    EXPECT_NEAR(radius(mesh, 0), 5.0, kExact_mm);
}

TEST_F(Svg, AFilledStrokeIsClosedAndAnEmptyOneIsNot) {
    EXPECT_NEAR(svg("<path d='M0 0H10V10H0'/>").facts.signed_volume, 2000.0, 0.01);
    EXPECT_THAT(
        refusal(file("open.svg", picture("<path fill='none' d='M0 0H10V10H0'/>"))),
        AllOf(HasSubstr("open.svg: has no closed outline; the longest stroke goes from (0.000, 0.000) to "
                        "(0.000, -10.000) mm, 10 mm apart"),
              HasSubstr("close it in the drawing program")));
}

TEST_F(Svg, TextIsLeftOutWithAWarning) {
    const auto mesh = svg("<rect width='10' height='10'/><text>no</text>");
    ASSERT_EQ(mesh.warnings.size(), 1U);
    EXPECT_EQ(mesh.warnings[0], "<text> is left out: convert text to paths in the drawing program");
}

TEST_F(Svg, BrokenFilesAreOneClearLine) {
    const std::string good = picture("<rect width='10' height='10'/>");
    const auto wrong = [this](const std::string& content) { return refusal(file("b.svg", content)); };
    EXPECT_THAT(wrong(good.substr(0, good.size() - 5)), EndsWith("b.svg line 1: the XML ends too early"));
    EXPECT_THAT(wrong("<svg\n<"), EndsWith("b.svg line 2: this is not well-formed XML"));
    EXPECT_THAT(wrong("<html><svg/></html>"), EndsWith("the first element is not <svg>"));
    EXPECT_THAT(wrong(picture("")), EndsWith("b.svg: holds no line that can be carved (SVG)"));
    EXPECT_THAT(wrong(picture("<path d='M0 0L1e308 0 1e308 1e308 0 1e308z' transform='scale(1e9)'/>")),
                EndsWith("a coordinate is not a finite number"));
    EXPECT_THAT(wrong(picture("<line x2='5'/>")), HasSubstr("has no closed outline"));
    EXPECT_THAT(wrong(picture("<path d='M0 0H5z'/>")),
                EndsWith("its outlines enclose no area; there is nothing to carve"));
    std::string bomb = "<g id='u0'/>";
    for (int i = 1; i < 12; ++i) {
        const std::string link = "<use href='#u" + std::to_string(i - 1) + "'/>";
        bomb += "<g id='u" + std::to_string(i) + "'>";
        for (int k = 0; k < 10; ++k) bomb += link;
        bomb += "</g>";
    }
    EXPECT_THAT(wrong(picture(bomb)), HasSubstr("more than two million elements"));
    EXPECT_THAT(wrong(picture("<g id='a'><use href='#a'/></g>")), HasSubstr("holds no line"));
    std::string deep;
    for (int i = 0; i < 300; ++i) deep += "<g>";
    EXPECT_THAT(wrong("<svg>" + deep), HasSubstr("more than 200 deep"));
}

TEST_F(Svg, ClippingIsNamedOnceWhereItStandsFirst) {
    const std::string clip = "<clipPath id='c'><rect width='20' height='20'/></clipPath>";
    const std::string shape = "<rect width='60' height='40'/>";
    const auto said = [&](const std::string& inside) { return svg(clip + inside).warnings; };
    const std::string is_carved = ": clipping and masks are not followed: <g> is carved whole";
    for (const char* how : {"clip-path='url(#c)'", "style='fill:red; clip-path: url(#c)'", "mask='url(#c)'",
                            "style='mask:url(#c)'", "style='mask-image:url(#c)'", "class='cut'"}) {
        EXPECT_EQ(
            said("<style>.cut{clip-path:url(#c)}</style>\n<g " + std::string(how) + ">" + shape + "</g>"),
            std::vector<std::string>{"line 2" + is_carved})
            << how;
    }
    EXPECT_EQ(said("\n\n<g mask='url(#c)'>" + shape + "</g><g clip-path='url(#c)'>" + shape + "</g>"),
              std::vector<std::string>{"line 3" + is_carved});
    EXPECT_EQ(
        said("\n<rect width='9' height='9' clip-path='circle(3px)'/>"),
        std::vector<std::string>{"line 2: clipping and masks are not followed: <rect> is carved whole"});
    for (const char* none : {"clip-path='none'", "style='mask:none'", "clip-path='inherit'", "class='cut'"})
        EXPECT_TRUE(said("<g " + std::string(none) + ">" + shape + "</g>").empty()) << none;
    EXPECT_TRUE(said(shape + "<g display='none' clip-path='url(#c)'>" + shape + "</g>").empty());
    const auto whole = loaded(
        file("root.svg", "<svg width='9mm' height='9mm' clip-path='url(#c)'>" + clip + shape + "</svg>"));
    ASSERT_EQ(whole.warnings.size(), 1U);
    EXPECT_NE(whole.warnings[0].find("<svg> is carved whole"), std::string::npos) << whole.warnings[0];
}

TEST_F(Svg, WhatAViewportWouldHideIsWarnedOf) {
    const auto beyond = [](const std::string& line, const std::string& name) {
        return std::vector<std::string>{"line " + line + ": what lies beyond the edge of <" + name +
                                        "> is carved, too"};
    };
    const std::vector<std::string> nothing;
    const std::string inner = "\n<svg x='10' y='10' width='10' height='20' viewBox='0 0 10 10' ";
    const auto inside = [&](const std::string& said, const std::string& shape) {
        return svg(inner + said + ">" + shape + "</svg>").warnings;
    };
    const std::string wide = "<rect width='30' height='10'/>";
    EXPECT_EQ(inside("", wide), beyond("2", "svg"));
    EXPECT_EQ(inside("overflow='scroll'", wide), beyond("2", "svg"));
    EXPECT_EQ(inside("overflow='visible'", wide), nothing);
    EXPECT_EQ(inside("style='overflow:auto'", wide), nothing);
    // The viewport is what hides, not its viewBox: there is room of 5 above and below.
    EXPECT_EQ(inside("", "<rect y='-5' width='10' height='20'/>"), nothing);
    EXPECT_EQ(inside("", "<rect y='-5.1' width='10' height='20'/>"), beyond("2", "svg"));
    EXPECT_EQ(inside("transform='rotate(30 20 20)'", "<rect width='10' height='10' stroke='red'/>"), nothing);
    EXPECT_EQ(inside("transform='rotate(30 20 20)'", "<rect x='.1' width='10' height='10'/>"),
              beyond("2", "svg"));
    EXPECT_EQ(inside("transform='scale(0 1)'", wide + "</svg><svg><rect width='9' height='9'/>"), nothing);
    EXPECT_EQ(inside("overflow='visible'", "<rect width='91' height='10'/>"), beyond("1", "svg"))
        << "beyond the page";
    // Invisible shapes need no warning.
    EXPECT_EQ(inside("", "<rect width='30' height='10' fill='none'/>"), nothing);
    EXPECT_EQ(svg("\n\n<symbol id='s' viewBox='0 0 10 10'><circle r='4'/></symbol>"
                  "<use href='#s' width='9' height='9' x='50'/>" +
                  inner + ">" + wide + "</svg>")
                  .warnings,
              beyond("3", "symbol"));
    const auto page = [this](const std::string& head, const std::string& shape) {
        return loaded(file("page.svg", "<svg " + head + ">" + shape + "</svg>")).warnings;
    };
    const std::string square = "<rect width='40' height='40'/>";
    const std::string sliced = "width='80mm' height='40mm' viewBox='0 0 40 40' preserveAspectRatio=";
    EXPECT_EQ(page(sliced + "'xMaxYMid slice'", square), beyond("1", "svg"));
    EXPECT_EQ(page(sliced + "'xMaxYMid slice' overflow='visible'", square), nothing);
    EXPECT_EQ(page(sliced + "'xMaxYMid'", square), nothing);
    EXPECT_EQ(page("width='9mm' height='9mm'", "<rect width='9.005mm' height='9mm'/>"), nothing)
        << "rounding";
    // A page without any size has no edge.
    EXPECT_EQ(page("", "<rect width='400' height='400'/>").size(), 1U);
    EXPECT_EQ(page("viewBox='0 0 10 10'", square).size(), 2U);
    // Clipping is another matter, told of by itself; of one element both would say the same.
    EXPECT_EQ(inside("", "\n<g clip-path='circle(3px)'>" + wide + "</g>"),
              (std::vector<std::string>{"line 2: what lies beyond the edge of <svg> is carved, too",
                                        "line 3: clipping and masks are not followed: <g> is carved whole"}));
    EXPECT_EQ(inside("mask='url(#m)'", wide),
              std::vector<std::string>{"line 2: clipping and masks are not followed: <svg> is carved whole"});
}

TEST_F(Svg, ShapesWithLengthsThatAreNoneAreLeftOutWithTheirLine) {
    const std::string square = "<rect width='10' height='10'/>\n";
    for (const char* wrong :
         {"rect width='nan' height='90'", "rect width='-90' height='90'", "rect width='90' height='9o'",
          "rect width='90' height='90' x='here'", "rect width='90' height='90' rx='-1'", "circle r='-40'",
          "circle r='NaN'", "ellipse rx='40' ry='-40'", "circle r='40' cx='inf'"}) {
        const auto mesh = svg(square + "<" + wrong + "/>");
        const std::string name(wrong, std::string(wrong).find(' '));
        EXPECT_EQ(mesh.warnings, std::vector<std::string>{"line 2: <" + name + "> is not right and left out"})
            << wrong;
        EXPECT_NEAR(radius(mesh, 0), 5.0, kExact_mm) << wrong;
    }
    // The standard's own ways to show nothing, or to say nothing.
    for (const char* right : {"rect width='0' height='90'", "circle r='0'", "rect width='5' height='auto'",
                              "rect width='9' height='9' rx='auto' ry=''", "rect"}) {
        EXPECT_TRUE(svg(square + "<" + right + "/>").warnings.empty()) << right;
    }
    FlatOptions options;
    options.engraving = {0.5, 0.0, false, {}};
    const auto line = svg("<g stroke='red'><line x2='5'/>\n<line x2='nan' y2='50'/></g>", options);
    EXPECT_EQ(line.warnings, std::vector<std::string>{"line 2: <line> is not right and left out"});
}

TEST_F(Svg, WhatTheWholeDrawingSaysIsInherited) {
    FlatOptions options;
    options.engraving = {0.5, 0.0, true, {}};
    const auto lines = loaded(file("root.svg",
                                   "<svg width='100mm' height='100mm' viewBox='0 0 100 100' fill='none' "
                                   "stroke='currentColor' stroke-width='2'><line x2='50' y2='1'/></svg>"),
                              options);
    ASSERT_EQ(lines.grooves->strokes.size(), 1U);
    EXPECT_NEAR(lines.grooves->strokes.front().half_floor_mm, 1.0, 1e-9);
    const std::string open =
        "<svg width='100mm' height='100mm' viewBox='0 0 100 100' style='fill:none'>"
        "<rect width='10' height='10'/><path d='M 20 0 H 60 V 40'/></svg>";
    EXPECT_NEAR(radius(loaded(file("open.svg", open)), 0), 5.0, kExact_mm) << "not filled, so not closed";
}

TEST_F(Svg, APathBeginsFromTheOriginWhateverWasDrawnBefore) {
    // Two squares of 10 mm that share a corner; the first move is absolute, small letter or not.
    for (const char* first :
         {"<path d='M 20 20 h 10 v 10 h -10 z'/>", "<rect x='20' y='20' width='10' height='10'/>",
          "<path d='m 20 20 h 10 v 10 h -10 z'/>"}) {
        const auto mesh = svg(first + std::string("<path d='m 30 30 h 10 v 10 h -10 z'/>"));
        EXPECT_NEAR(mesh.facts.max[0] - mesh.facts.min[0], 20.0, kExact_mm) << first;
        EXPECT_NEAR(mesh.facts.max[1] - mesh.facts.min[1], 20.0, kExact_mm) << first;
    }
}

TEST_F(Svg, WrongPathDataIsDrawnUpToTheFault) {
    const auto mesh = svg("<rect width='10' height='10'/><path d='M0 0L5 5 L x'/>");
    ASSERT_EQ(mesh.warnings.size(), 1U);
    EXPECT_EQ(mesh.warnings[0], "line 1: <path> is not right; what follows the fault is left out");
}

TEST_F(Svg, WhereNothingIsRightItSaysWhere) {
    for (const char* data : {"M0 0L1e400 0z", "M nan nan L5 5", "M0 0L-inf 4", "L5 5", "M"}) {
        EXPECT_THAT(
            refusal(file("b.svg", picture("\n<path d='" + std::string(data) + "'/>"))),
            EndsWith(
                "b.svg: holds no line that can be carved (SVG): line 2: <path> is not right; what follows "
                "the fault is left out"))
            << data;
    }
    EXPECT_THAT(refusal(file("b.svg", "<svg><text>a</text></svg>")),
                EndsWith("(SVG): <text> is left out: convert text to paths in the drawing program"));
}

TEST_F(Svg, EveryTruncationIsRefusedOrRead) {
    const std::string good =
        picture("<g transform='rotate(3)'><path d='M0 0c1,2 3,4 5,6s1 1 2-2a3 4 5 0 1 8 8z'/></g>");
    for (std::size_t length = 0; length < good.size(); ++length) {
        const auto mesh = load_model(file("t.svg", good.substr(0, length)), {});
        ASSERT_FALSE(mesh.has_value()) << length;
        EXPECT_EQ(mesh.error().message.find('\n'), std::string::npos);
    }
}

}  // namespace
}  // namespace psicarve::flat
