// SPDX-License-Identifier: GPL-3.0-or-later
// Areas, centroids and radii of DXF's curves, blocks and units, against formulas.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <locale>
#include <sstream>
#include <string>

#include "tests/hmi/flat/dxf_files.hpp"

namespace psicarve::flat {
namespace {

constexpr double kHeight_mm = 20.0;  // of an extruded drawing

/// " 10 X 20 Y", with another group in place of 10.
std::string at(Point p, int code = 10) {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out.precision(17);
    out << ' ' << code << ' ' << p.x << ' ' << code + 10 << ' ' << p.y;
    return out.str();
}
std::string with(int code, double value) {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out.precision(17);
    out << ' ' << code << ' ' << value;
    return out.str();
}

class DxfClosedForm : public DxfTest {
protected:
    static double area_mm2(const model::Mesh& mesh) { return mesh.facts.signed_volume / kHeight_mm; }
    static void expect_centroid(const model::Mesh& mesh, Point wanted, double tolerance_mm = kCurve_mm) {
        ASSERT_TRUE(mesh.axis_hint.has_value());
        EXPECT_NEAR((*mesh.axis_hint)[0], wanted.x, tolerance_mm);
        EXPECT_NEAR((*mesh.axis_hint)[1], wanted.y, tolerance_mm);
    }
};

TEST_F(DxfClosedForm, APartOfAnEllipseAndItsChordAreASegment) {
    const Point centre{7.0, -3.0};
    const Point major{12.0, 5.0};  // 13 long, turned
    constexpr double kRatio = 0.4;
    for (const double normal : {1.0, -1.0}) {
        // The minor axis stands to the left of the major one as seen from where the extrusion points to.
        const Point minor{-normal * kRatio * major.y, normal * kRatio * major.x};
        for (const auto& [from, to] : {std::array{0.0, kPi},
                                       {0.3, 2.0},
                                       {1.5 * kPi, 0.5 * kPi},
                                       {-1.0, 1.0},
                                       {2.0, 6.0},
                                       {5.5, 8.0}}) {
            const auto on = [&](double t) {
                return Point{centre.x + std::cos(t) * major.x + std::sin(t) * minor.x,
                             centre.y + std::cos(t) * major.y + std::sin(t) * minor.y};
            };
            const auto mesh =
                dxf("0 ELLIPSE 8 0" + at(centre) + at(major, 11) + with(40, kRatio) + with(41, from) +
                    with(42, to) + with(230, normal) + " 0 LINE 8 0" + at(on(from)) + at(on(to), 11));
            double sweep = to - from;
            if (sweep < 0.0) sweep += 2.0 * kPi;
            const double kArea = 0.5 * 13.0 * 13.0 * kRatio * (sweep - std::sin(sweep));
            EXPECT_NEAR(area_mm2(mesh), kArea, 40.0 * kFlatness_mm) << normal << ' ' << from;
            // As far along the middle's radius as a circle's segment has it, in both axes' measure.
            const double out = 4.0 * std::pow(std::sin(sweep / 2), 3) / (3.0 * (sweep - std::sin(sweep)));
            const Point middle = on(from + sweep / 2);
            expect_centroid(mesh,
                            {centre.x + out * (middle.x - centre.x), centre.y + out * (middle.y - centre.y)});
        }
    }
}

TEST_F(DxfClosedForm, AWholeEllipseHasItsAxesWhicheverWayItIsSeen) {
    for (const char* normal : {" 230 1", " 230 -1", ""}) {
        const auto mesh =
            dxf("0 ELLIPSE 8 0 10 4 20 9 11 0 21 8 40 0.25 41 0 42 6.283185307179586" + std::string(normal));
        EXPECT_NEAR(area_mm2(mesh), kPi * 8.0 * 2.0, 0.03) << normal;
        expect_centroid(mesh, {4.0, 9.0});
        EXPECT_NEAR(radius(mesh, 90), 8.0, kCurve_mm);
        EXPECT_NEAR(radius(mesh, 180), 2.0, kCurve_mm);
        EXPECT_NEAR(radius(mesh, 45), std::sqrt(2.0 / (1.0 / 64 + 1.0 / 4)), kCurve_mm);
    }
}

TEST_F(DxfClosedForm, AnArcSeenFromBelowIsMirrored) {
    // From 30 to 120 degrees about (6, 2), mirrored to (-6, 2), from 60 to 150 degrees.
    const auto on = [](double angle_deg) {
        return Point{-6.0 + 5.0 * std::cos(rad_from_deg(angle_deg)),
                     2.0 + 5.0 * std::sin(rad_from_deg(angle_deg))};
    };
    const auto mesh = dxf("0 ARC 8 0 10 6 20 2 40 5 50 30 51 120 210 0 220 0 230 -1 0 LINE 8 0" + at(on(60)) +
                          at(on(150), 11));
    EXPECT_NEAR(area_mm2(mesh), 0.5 * 25.0 * (kPi / 2 - 1.0), 0.01);
    const double out_mm = 5.0 * 4.0 * std::pow(std::sin(kPi / 4), 3) / (3.0 * (kPi / 2 - 1.0));
    expect_centroid(
        mesh, {-6.0 + out_mm * std::cos(rad_from_deg(105.0)), 2.0 + out_mm * std::sin(rad_from_deg(105.0))});
}

TEST_F(DxfClosedForm, ACubicSplineOfOneSpanIsABezierCurve) {
    // y = 3 h t (1 - t) over x = w (3 t^2 - 2 t^3).
    const auto mesh = dxf(
        "0 SPLINE 8 0 70 8 71 3 72 8 73 4 40 0 40 0 40 0 40 0 40 1 40 1 40 1 40 1 10 0 20 0 10 0 20 14 10 10 "
        "20 14 10 10 20 0 0 LINE 8 0 10 0 20 0 11 10 21 0");
    EXPECT_NEAR(area_mm2(mesh), 0.6 * 14.0 * 10.0, 0.02);
    expect_centroid(mesh, {5.0, 9.0 * 14.0 / 28.0});
    EXPECT_NEAR(radius(mesh, 90), 0.75 * 14.0 - 4.5, kCurve_mm);
}

TEST_F(DxfClosedForm, APeriodicSplineOfUniformKnotsGoesRound) {
    // Its four points, the first three repeated; knots that do not stop at the ends.
    std::string words = "0 SPLINE 8 0 70 11 71 3 72 11 73 7";
    for (int i = -3; i <= 7; ++i) words += " 40 " + std::to_string(i);
    const std::array<Point, 4> corners{{{6, -6}, {6, 6}, {-6, 6}, {-6, -6}}};
    for (std::size_t i = 0; i < 7; ++i) words += at(corners[i % 4]);
    const auto mesh = dxf(words);
    expect_centroid(mesh, {0.0, 0.0});
    // At a knot (P0 + 4 P1 + P2) / 6, in the middle of a span (P0 + 23 P1 + 23 P2 + P3) / 48.
    for (double a = 45.0; a < 360.0; a += 90.0) EXPECT_NEAR(radius(mesh, a), 4.0 * std::sqrt(2.0), kCurve_mm);
    for (double a = 0.0; a < 360.0; a += 90.0) EXPECT_NEAR(radius(mesh, a), 6.0 * 11.0 / 12.0, kCurve_mm);
}

TEST_F(DxfClosedForm, ALightPolylinesBulgesAreArcs) {
    // A slot: two straight sides of 12, two half circles of radius 4; also clockwise.
    const auto slot = dxf("0 LWPOLYLINE 8 0 90 4 70 1 10 0 20 0 10 12 20 0 42 1 10 12 20 8 10 0 20 8 42 1");
    EXPECT_NEAR(area_mm2(slot), 12.0 * 8.0 + 16.0 * kPi, 0.03);
    expect_centroid(slot, {6.0, 4.0});
    EXPECT_NEAR(radius(slot, 0), 10.0, kCurve_mm);
    const auto back = dxf("0 LWPOLYLINE 8 0 90 4 70 1 10 0 20 8 10 12 20 8 42 -1 10 12 20 0 10 0 20 0 42 -1");
    EXPECT_NEAR(area_mm2(back), 12.0 * 8.0 + 16.0 * kPi, 0.03);
    // Three quarters of a circle over a chord: bulge tan(270 / 4).
    const double bulge = std::tan(rad_from_deg(67.5));
    const auto most = dxf("0 LWPOLYLINE 8 0 90 2 70 1 10 5 20 0" + with(42, bulge) + " 10 0 20 5");
    EXPECT_NEAR(area_mm2(most), 25.0 * (0.75 * kPi + 0.5), 0.03);
    // Open, and seen from below: the half circle over (-6, 0) and (0, 0) and a line beneath.
    const auto below =
        dxf("0 LWPOLYLINE 8 0 90 2 70 0 10 6 20 0 42 1 10 0 20 0 230 -1 0 LINE 8 0 10 0 20 0 11 -6 21 0");
    EXPECT_NEAR(area_mm2(below), 4.5 * kPi, 0.01);
    expect_centroid(below, {-3.0, 4.0 * 3.0 / (3.0 * kPi)});
}

TEST_F(DxfClosedForm, BlocksInBlocksAreScaledTurnedAndMirroredTogether) {
    // A circle of radius 3 at (5, 0) of INNER; OUTER has it turned by 90 degrees about (2, 1), twice as
    // large.
    const std::string blocks =
        " 0 SECTION 2 BLOCKS 0 BLOCK 2 INNER 10 0 20 0 0 CIRCLE 8 0 10 5 20 0 40 3 0 ENDBLK 8 0"
        " 0 BLOCK 2 OUTER 10 1 20 1 0 INSERT 8 0 2 INNER 10 2 20 1 41 2 42 2 50 90 0 ENDBLK 8 0 0 ENDSEC";
    // There its centre is (2, 1) + 2 (0, 5) = (2, 11), its radius 6; from the base point that is (1, 10).
    const auto plain = dxf("0 INSERT 8 0 2 OUTER 10 100 20 40", blocks);
    EXPECT_NEAR(area_mm2(plain), 36.0 * kPi, 0.05);
    expect_centroid(plain, {101.0, 50.0});
    EXPECT_NEAR(radius(plain, 12), 6.0, kCurve_mm);
    // Scaled to an ellipse, then turned by 180 degrees.
    const auto scaled = dxf("0 INSERT 8 0 2 OUTER 10 100 20 40 41 3 42 0.5 50 180", blocks);
    EXPECT_NEAR(area_mm2(scaled), 36.0 * kPi * 1.5, 0.05);
    expect_centroid(scaled, {97.0, 35.0});
    EXPECT_NEAR(radius(scaled, 0), 18.0, kCurve_mm);
    EXPECT_NEAR(radius(scaled, 90), 3.0, kCurve_mm);
    // Mirrored by its scale, and by being seen from below.
    expect_centroid(dxf("0 INSERT 8 0 2 OUTER 10 100 20 40 41 -1", blocks), {99.0, 50.0});
    expect_centroid(dxf("0 INSERT 8 0 2 OUTER 10 100 20 40 230 -1", blocks), {-101.0, 50.0});
    // Two rows of three, 20 and 30 apart along the turned axes.
    const auto rows = dxf("0 INSERT 8 0 2 OUTER 10 0 20 0 50 90 70 3 71 2 44 20 45 30", blocks);
    EXPECT_NEAR(area_mm2(rows), 6 * 36.0 * kPi, 0.3);
    expect_centroid(rows, {-10.0 - 15.0, 1.0 + 20.0});
}

TEST_F(DxfClosedForm, ABlockThatIsNotThereIsMissedOnlyWhereItWouldBeSeen) {
    const std::string before =
        " 0 SECTION 2 TABLES 0 TABLE 2 LAYER 0 LAYER 2 off 70 0 62 -7 0 ENDTAB 0 ENDSEC 0 SECTION 2 BLOCKS 0 "
        "BLOCK 2 B 10 0 20 0 0 INSERT 8 0 2 NONE 10 0 20 0 0 ENDBLK 8 0 0 ENDSEC";
    const std::string square = std::string(kSquare) + " ";
    EXPECT_TRUE(dxf(square + "0 INSERT 8 OFF 2 NONE 10 0 20 0", before).warnings.empty());
    // In a block, what has no layer of its own stands on the block's.
    EXPECT_TRUE(dxf(square + "0 INSERT 8 off 2 B 10 0 20 0", before).warnings.empty());
    for (const char* seen : {"0 INSERT 8 on 2 NONE 10 0 20 0", "0 INSERT 8 on 2 B 10 0 20 0"}) {
        const auto warnings = dxf(square + seen, before).warnings;
        ASSERT_EQ(warnings.size(), 1U) << seen;
        EXPECT_NE(warnings[0].find("INSERT of a block that is not there is left out"), std::string::npos);
    }
}

TEST_F(DxfClosedForm, LayersThatAreOffHideWhatStandsOnThemInBlocksAsWell) {
    const std::string tables =
        " 0 SECTION 2 TABLES 0 TABLE 2 LAYER 0 LAYER 2 off 70 0 62 -3 0 LAYER 2 on 70 0 62 3 0 LAYER 2 cold "
        "70 1 62 3 0 ENDTAB 0 "
        "ENDSEC";
    const std::string blocks =
        " 0 SECTION 2 BLOCKS 0 BLOCK 2 B 10 0 20 0 0 CIRCLE 8 0 10 0 20 0 40 4 0 CIRCLE 8 on 10 0 20 0 40 2 "
        "0 CIRCLE 8 off 10 0 20 0 40 9 0 ENDBLK 8 0 0 ENDSEC";
    const auto seen = dxf("0 INSERT 8 on 2 B 10 50 20 0 0 CIRCLE 8 off 10 0 20 0 40 7", tables + blocks);
    EXPECT_NEAR(area_mm2(seen), 16.0 * kPi, 0.02);
    expect_centroid(seen, {50.0, 0.0});
    // When a block is inserted on that layer, only what has no layer of its own is hidden.
    const auto other = dxf("0 INSERT 8 off 2 B 10 50 20 0", tables + blocks);
    EXPECT_NEAR(area_mm2(other), 4.0 * kPi, 0.02);
    expect_centroid(other, {50.0, 0.0});
    // One that is frozen hides all of it; so does an insertion that is invisible itself.
    const auto frozen = dxf("0 INSERT 8 cold 2 B 10 50 20 0 0 CIRCLE 8 on 10 0 20 0 40 1", tables + blocks);
    EXPECT_NEAR(area_mm2(frozen), kPi, 0.01);
    const auto unseen =
        dxf("0 INSERT 8 off 60 1 2 B 10 50 20 0 0 CIRCLE 8 on 10 0 20 0 40 1", tables + blocks);
    EXPECT_NEAR(area_mm2(unseen), kPi, 0.01);
    // What a block holds on layer 0 stands where the block is inserted, whatever layer 0 is.
    const std::string no_zero =
        " 0 SECTION 2 TABLES 0 TABLE 2 LAYER 0 LAYER 2 0 70 0 62 -7 0 LAYER 2 off 70 1 0 ENDTAB 0 ENDSEC";
    const auto inherited = dxf("0 INSERT 8 on 2 B 10 50 20 0 0 CIRCLE 8 0 10 0 20 0 40 30", no_zero + blocks);
    EXPECT_NEAR(area_mm2(inherited), 16.0 * kPi, 0.02);
    expect_centroid(inherited, {50.0, 0.0});
}

TEST_F(DxfClosedForm, UnitsAreLengths) {
    struct Unit {
        int code;
        double mm;
        bool is_told_of;
    };
    for (const Unit& unit :
         {Unit{0, 1.0, true}, Unit{1, 25.4, false}, Unit{2, 304.8, false}, Unit{4, 1.0, false},
          Unit{5, 10.0, false}, Unit{6, 1000.0, false}, Unit{9, 0.0254, false}, Unit{13, 0.001, false},
          Unit{14, 100.0, false}, Unit{99, 1.0, true}, Unit{-1, 1.0, true}}) {
        const double radius_mm = 12.0;
        const auto mesh =
            loaded(file("u.dxf", lines("0 SECTION 2 HEADER 9 $INSUNITS 70 " + std::to_string(unit.code) +
                                       " 9 $LUNITS 70 2 0 ENDSEC 0 SECTION 2 ENTITIES 0 CIRCLE 8 0" +
                                       with(10, 3.0 / unit.mm) + with(20, 0.0) +
                                       with(40, radius_mm / unit.mm) + " 0 ENDSEC 0 EOF")));
        EXPECT_NEAR(radius(mesh, 77), radius_mm, kCurve_mm) << unit.code;
        expect_centroid(mesh, {3.0, 0.0});
        EXPECT_EQ(mesh.warnings.size(), unit.is_told_of ? 1U : 0U) << unit.code;
    }
}

}  // namespace
}  // namespace psicarve::flat
