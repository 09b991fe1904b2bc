// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/hmi/flat/dxf_files.hpp"
#include "tests/thoroughness.hpp"

namespace psicarve::flat {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

class Dxf : public DxfTest {};

TEST_F(Dxf, LinesAndAnArcBecomeOneOutline) {
    const auto mesh =
        dxf("0 LINE 8 0 10 0 20 0 11 20 21 0 0 LINE 8 0 10 20 20 0 11 20 21 10 0 ARC 8 0 10 10 20 10 40 10 "
            "50 0 51 180 "
            "0 LINE 8 0 10 0 20 10 11 0 21 0");
    EXPECT_NEAR(mesh.facts.signed_volume, 20.0 * (200.0 + 50.0 * kPi), 0.2);
    EXPECT_NEAR(radius(mesh, 90), 20.0 - (*mesh.axis_hint)[1], kCurve_mm);
}

TEST_F(Dxf, ACircleAndAnEllipseAreExact) {
    const auto circle = dxf("0 CIRCLE 8 0 10 3 20 -4 40 12.5");
    for (double a = 1.0; a < 360.0; a += 13.0) EXPECT_NEAR(radius(circle, a), 12.5, kCurve_mm);
    EXPECT_NEAR((*circle.axis_hint)[0], 3.0, 1e-6);
    EXPECT_NEAR((*circle.axis_hint)[1], -4.0, 1e-6);
    const auto ellipse = dxf("0 ELLIPSE 8 0 10 0 20 0 11 0 21 20 40 0.5 41 0 42 6.283185307179586");
    EXPECT_NEAR(radius(ellipse, 90), 20.0, kCurve_mm);
    EXPECT_NEAR(radius(ellipse, 0), 10.0, kCurve_mm);
}

TEST_F(Dxf, BulgesAreArcsOnTheRightSide) {
    // Bulge 1: half circles to the right of the way, so outside of a counter-clockwise square's side.
    const auto out = dxf("0 LWPOLYLINE 8 0 90 4 70 1 10 0 20 0 42 1 10 10 20 0 10 10 20 10 10 0 20 10");
    EXPECT_NEAR(out.facts.signed_volume, 20.0 * (100.0 + 12.5 * kPi), 0.2);
    const auto in =
        dxf("0 LWPOLYLINE 8 0 90 4 70 1 10 0 20 0 42 -0.4142135623730951 10 10 20 0 10 10 20 10 10 0 20 10");
    // A quarter circle over a chord of 10 cuts off a segment of r^2 (pi/2 - 1) / 2, r^2 = 50.
    EXPECT_NEAR(in.facts.signed_volume, 20.0 * (100.0 - 50.0 * (kPi / 2 - 1) / 2), 0.2);
    const auto old =
        dxf("0 POLYLINE 8 0 66 1 70 1 0 VERTEX 8 0 10 0 20 0 42 1 0 VERTEX 8 0 10 10 20 0 42 1 0 SEQEND 8 0");
    EXPECT_NEAR(radius(old, 33), 5.0, kCurve_mm);
}

TEST_F(Dxf, AQuadraticSplineIsAParabola) {
    const auto mesh =
        dxf("0 SPLINE 8 0 70 8 71 2 72 6 73 3 40 0 40 0 40 0 40 1 40 1 40 1 10 0 20 0 10 10 20 40 10 20 20 0 "
            "0 LINE 8 0 10 0 20 0 11 20 21 0");
    EXPECT_NEAR(mesh.facts.signed_volume, 20.0 * 2.0 / 3.0 * 20.0 * 20.0, 0.3);
    EXPECT_NEAR((*mesh.axis_hint)[1], 8.0, 1e-3);
    EXPECT_NEAR(radius(mesh, 90), 12.0, kCurve_mm);
}

TEST_F(Dxf, ARationalSplineIsACircle) {
    // Four quarters of weight 1/sqrt 2 at the corners.
    const std::string w = " 41 1 41 0.7071067811865476";
    const auto mesh =
        dxf("0 SPLINE 8 0 70 12 71 2 40 0 40 0 40 0 40 1 40 1 40 2 40 2 40 3 40 3 40 4 40 4 40 4" + w + w +
            w + w +
            " 41 1 10 10 20 0 10 10 20 10 10 0 20 10 10 -10 20 10 10 -10 20 0 10 -10 20 -10 10 0 20 -10 10 "
            "10 20 -10 "
            "10 10 20 0");
    for (double a = 0.0; a < 360.0; a += 11.0) EXPECT_NEAR(radius(mesh, a), 10.0, kCurve_mm) << a;
}

TEST_F(Dxf, ASplineOfFitPointsAloneGoesThroughThemSmoothly) {
    const auto fit_points = [](int count, double sweep_deg) {
        std::string words;
        for (int i = 0; i < count; ++i) {
            const double a = rad_from_deg(sweep_deg * i / (count - 1));
            words +=
                " 11 " + std::to_string(10.0 * std::cos(a)) + " 21 " + std::to_string(10.0 * std::sin(a));
        }
        return words;
    };
    const auto ring = dxf("0 SPLINE 8 0 70 11 71 3 74 13" + fit_points(13, 360.0));
    EXPECT_NEAR((*ring.axis_hint)[0], 0.0, 1e-4);
    for (double a = 0.0; a < 360.0; a += 30.0) EXPECT_NEAR(radius(ring, a), 10.0, kCurve_mm) << a;
    for (double a = 0.0; a < 360.0; a += 7.0) EXPECT_NEAR(radius(ring, a), 10.0, 0.003) << a;
    const std::string chord = " 0 LINE 8 0 10 10 20 0 11 -10 21 0";
    const auto with_slopes =
        dxf("0 SPLINE 8 0 70 8 71 3 74 7 12 0 22 5 13 0 23 -1" + fit_points(7, 180.0) + chord);
    EXPECT_NEAR(with_slopes.facts.signed_volume, 20.0 * 50.0 * kPi, 1.5);
    // Without slopes it runs out straight, as a thin strip of wood does.
    const auto without = dxf("0 SPLINE 8 0 70 8 71 3 74 7" + fit_points(7, 180.0) + chord);
    EXPECT_LT(without.facts.signed_volume, 20.0 * 50.0 * kPi - 3.0);
    EXPECT_GT(without.facts.signed_volume, 20.0 * 50.0 * kPi - 40.0);
    // Unevenly spaced, it still bends no more than the circle does.
    std::string uneven;
    for (const double at_deg :
         {0.0, 10.0, 45.0, 60.0, 100.0, 120.0, 165.0, 200.0, 215.0, 250.0, 290.0, 300.0, 340.0}) {
        uneven += " 11 " + std::to_string(10.0 * std::cos(rad_from_deg(at_deg))) + " 21 " +
                  std::to_string(10.0 * std::sin(rad_from_deg(at_deg)));
    }
    const auto wheel = dxf("0 SPLINE 8 0 70 11 71 3 74 13" + uneven);
    EXPECT_LT(std::hypot((*wheel.axis_hint)[0], (*wheel.axis_hint)[1]), 0.01);
    for (double a = 0.0; a < 360.0; a += 7.0) EXPECT_NEAR(radius(wheel, a), 10.0, 0.05) << a;
    const auto pair =
        dxf("0 SPLINE 8 0 70 8 71 3 74 3 11 0 21 0 11 0 21 0 11 9 21 0 0 LINE 8 0 10 9 20 0 11 0 21 9 "
            "0 LINE 8 0 10 0 20 9 11 0 21 0");
    EXPECT_NEAR(pair.facts.signed_volume, 20.0 * 40.5, 1e-2);
    const auto point = dxf(std::string(kSquare) + " 0 SPLINE 8 0 70 8 71 3 74 1 11 1 21 1");
    ASSERT_EQ(point.warnings.size(), 1U);
    EXPECT_THAT(point.warnings[0], HasSubstr("do not belong together"));
}

TEST_F(Dxf, ABinaryOneIsSaidToBeThat) {
    const std::string bytes{"AutoCAD Binary DXF\r\n\x1a\0\0\0SECTION\0", 33};
    EXPECT_THAT(refusal(file("b.dxf", bytes)), EndsWith("a binary DXF drawing; save it as text (ASCII DXF)"));
}

TEST_F(Dxf, WhereNothingIsALineItSaysWhatThereWas) {
    const std::string nothing =
        lines("0 SECTION 2 ENTITIES 0 SOLID 8 0 0 HATCH 8 0 0 TEXT 8 0 0 ENDSEC 0 EOF");
    EXPECT_THAT(
        refusal(file("b.dxf", nothing)),
        EndsWith(
            "holds no line that can be carved (DXF): left out, as they are no lines: HATCH, SOLID, TEXT"));
    FlatOptions engraved;
    engraved.engraving = {0.5, 0.0, false, {}};
    EXPECT_THAT(refusal(file("b.dxf", nothing), engraved),
                EndsWith("no lines to engrave: left out, as they are no lines: HATCH, SOLID, TEXT"));
}

TEST_F(Dxf, BlocksAreScaledTurnedAndRepeated) {
    const std::string blocks =
        std::string(" 0 SECTION 2 BLOCKS 0 BLOCK 2 B 10 5 20 5 ") + kSquare + " 0 ENDBLK 8 0 0 ENDSEC";
    const auto one = dxf("0 INSERT 8 0 2 B 10 100 20 50 41 2 42 1 50 90", blocks);
    EXPECT_NEAR((*one.axis_hint)[0], 100.0, 1e-6);
    EXPECT_NEAR((*one.axis_hint)[1], 50.0, 1e-6);
    EXPECT_NEAR(radius(one, 0), 5.0, kExact_mm);
    EXPECT_NEAR(radius(one, 90), 10.0, kExact_mm);
    const auto row = dxf("0 INSERT 8 0 2 B 10 0 20 0 70 3 44 30", blocks);
    EXPECT_NEAR(row.facts.signed_volume, 3 * 2000.0, 0.1);
    EXPECT_NEAR((*row.axis_hint)[0], 30.0, 1e-6);
}

TEST_F(Dxf, AnExtrusionDownwardsMirrors) {
    const auto mesh = dxf("0 CIRCLE 8 0 10 7 20 2 40 3 210 0 220 0 230 -1");
    EXPECT_NEAR((*mesh.axis_hint)[0], -7.0, 1e-6);
    EXPECT_NEAR((*mesh.axis_hint)[1], 2.0, 1e-6);
}

TEST_F(Dxf, UnitsSetTheSizeAndMissingOnesAreToldOf) {
    const std::string square = lines(std::string("0 SECTION 2 ENTITIES ") + kSquare + " 0 ENDSEC 0 EOF");
    const auto bare = loaded(file("bare.dxf", square));
    EXPECT_NEAR(radius(bare, 0), 5.0, kExact_mm);
    ASSERT_EQ(bare.warnings.size(), 1U);
    EXPECT_EQ(bare.warnings[0], "the drawing does not say its units: they are taken as millimetres");
    const auto inches =
        loaded(file("inch.dxf", lines("0 SECTION 2 HEADER 9 $INSUNITS 70 1 0 ENDSEC") + square));
    EXPECT_NEAR(radius(inches, 0), 127.0, 1e-4);
}

TEST_F(Dxf, HiddenLayersPaperAndInvisibleThingsAreNotDrawn) {
    const std::string layers =
        " 0 SECTION 2 TABLES 0 TABLE 2 LAYER 0 LAYER 2 off 70 0 62 -7 0 LAYER 2 cold 70 1 62 7 0 ENDTAB 0 "
        "ENDSEC";
    const auto mesh =
        dxf(std::string(kSquare) +
                " 0 CIRCLE 8 off 10 0 20 0 40 90 0 CIRCLE 8 cold 10 0 20 0 40 80 0 CIRCLE 8 0 67 1 10 0 "
                "20 0 40 70 0 CIRCLE 8 0 60 1 10 0 20 0 40 60 0 TEXT 8 0 1 hi",
            layers);
    EXPECT_NEAR(radius(mesh, 0), 5.0, kExact_mm);
    ASSERT_EQ(mesh.warnings.size(), 1U);
    EXPECT_EQ(mesh.warnings[0], "left out, as they are no lines: TEXT");
}

TEST_F(Dxf, NamesAreTheSameInAnyCase) {
    const std::string blocks =
        std::string(" 0 SECTION 2 BLOCKS 0 BLOCK 2 B1 10 5 20 5 ") + kSquare + " 0 ENDBLK 8 0 0 ENDSEC";
    const auto block = dxf("0 INSERT 8 0 2 b1 10 30 20 0", blocks);
    EXPECT_NEAR((*block.axis_hint)[0], 30.0, 1e-6);
    EXPECT_TRUE(block.warnings.empty());
    const std::string layers =
        " 0 SECTION 2 TABLES 0 TABLE 2 LAYER 0 LAYER 2 HIDE 70 0 62 -7 0 ENDTAB 0 ENDSEC";
    const auto layer =
        dxf(std::string(kSquare) + " 0 CIRCLE 8 Hide 10 0 20 0 40 90 0 CIRCLE 8 Hid 10 5 20 5 40 9", layers);
    EXPECT_NEAR(radius(layer, 0), 9.0, kCurve_mm);
}

TEST_F(Dxf, TheMarkSomeEditorsPutBeforeItIsPassedOver) {
    const auto mesh = loaded(file("mark.dxf", "\xEF\xBB\xBF" + drawing(kSquare)));
    EXPECT_NEAR(radius(mesh, 0), 5.0, kExact_mm);
    EXPECT_THAT(refusal(file("mark.dxf", "\xEF\xBB\xBF" + drawing("0 LINE 8 0 10 1x"))),
                EndsWith("line 20: '1x' is not a number"));
}

TEST_F(Dxf, WhatEndsABlocksAttributesIsNoEntity) {
    const std::string blocks =
        std::string(" 0 SECTION 2 BLOCKS 0 BLOCK 2 B 10 5 20 5 ") + kSquare + " 0 ENDBLK 8 0 0 ENDSEC";
    EXPECT_TRUE(dxf("0 INSERT 8 0 66 1 2 B 10 0 20 0 0 SEQEND 8 0", blocks).warnings.empty());
    const std::string named =
        "0 INSERT 8 0 66 1 2 B 10 0 20 0 0 ATTRIB 8 0 1 a 0 ATTRIB 8 0 1 b 0 SEQEND 8 0";
    EXPECT_EQ(dxf(named, blocks).warnings,
              std::vector<std::string>{"left out, as they are no lines: ATTRIB"});
}

TEST_F(Dxf, BrokenFilesAreOneClearLine) {
    const auto wrong = [this](const std::string& content) { return refusal(file("b.dxf", content)); };
    EXPECT_THAT(wrong("hello\nworld\n"), EndsWith("b.dxf line 1: 'hello' is no group code"));
    EXPECT_THAT(wrong("  5\n7\n"), HasSubstr("this is no DXF file"));
    EXPECT_THAT(wrong(lines("0 SECTION 2 ENTITIES 0 LINE 8 0 10 1x 20 0 0 EOF")),
                EndsWith("line 10: '1x' is not a number"));
    EXPECT_THAT(wrong(lines("0 SECTION 2 ENTITIES 0 LINE 8 0 10 nan 20 0 0 EOF")),
                EndsWith("'nan' is not a number"));
    EXPECT_THAT(wrong(drawing("0 TEXT 8 0 1 x")),
                HasSubstr("holds no line that can be carved (DXF): left out"));
    EXPECT_THAT(wrong("AutoCAD Binary DXF\r\n\x1A"), HasSubstr("binary DXF drawing; save it as text"));
    // A count of vertices is no reason to allocate.
    EXPECT_THAT(wrong(drawing("0 LWPOLYLINE 8 0 90 500000000 70 1 10 0 20 0")), HasSubstr("holds no line"));
    // A block that holds itself, ten times over.
    std::string self = " 0 SECTION 2 BLOCKS 0 BLOCK 2 B 10 0 20 0";
    for (int i = 0; i < 10; ++i) self += " 0 INSERT 8 0 2 B 10 1 20 0";
    EXPECT_THAT(
        wrong(drawing("0 INSERT 8 0 2 B 10 0 20 0 70 1000000 71 1000000", self + " 0 ENDBLK 0 ENDSEC")),
        HasSubstr("more than a million elements"));
}

// Invisible entities are read all the same, once for each copy.
TEST_F(Dxf, HiddenBlocksAreNotWalkedForEver) {
    std::string many = " 0 SECTION 2 BLOCKS 0 BLOCK 2 B 10 0 20 0 0 LWPOLYLINE 8 hidden 70 0";
    for (int i = 0; i < 50'000; ++i) many += " 10 1 20 1";
    // Where each line takes ten times as long the same length of text is in fewer of them.
    if (!test::is_thorough()) {
        const std::string comment = " 999 " + std::string(1000, 'c');
        for (int i = 0; i < 10'000; ++i) many += comment;
    }
    const std::string layers = " 0 SECTION 2 TABLES 0 LAYER 2 hidden 70 1 62 7 0 ENDSEC";
    EXPECT_THAT(refusal(file("b.dxf", drawing("0 INSERT 8 0 2 B 10 0 20 0 70 499999",
                                              layers + many + " 0 ENDBLK 0 ENDSEC"))),
                HasSubstr("its blocks draw more than half a gigabyte of text"));
}

TEST_F(Dxf, EveryTruncationIsRefused) {
    const std::string good = drawing(std::string(kSquare) + " 0 CIRCLE 8 0 10 0 20 0 40 3");
    for (std::size_t length = 0; length + 1 < good.size(); ++length) {
        EXPECT_FALSE(refusal(file("t.dxf", good.substr(0, length))).empty()) << length;
    }
}

}  // namespace
}  // namespace psicarve::flat
