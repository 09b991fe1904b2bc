// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/flat/outline.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>

#include "hmi/flat/ear_clipping.hpp"
#include "tests/hmi/flat/flat_files.hpp"

namespace psicarve::flat {
namespace {

class OutlineOf : public FlatTest {};

Path square(double x, double y, double side) {
    return {{{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}}, true, false};
}

Drawing drawing_of(std::vector<Path> paths) {
    return {std::move(paths), "test", {}};
}

double area_of(const std::vector<Point>& ring, const std::vector<std::array<std::size_t, 3>>& triangles) {
    double sum = 0.0;
    for (const auto& [a, b, c] : triangles) {
        const double one = 0.5 * ((ring[b].x - ring[a].x) * (ring[c].y - ring[a].y) -
                                  (ring[b].y - ring[a].y) * (ring[c].x - ring[a].x));
        EXPECT_GE(one, -1e-12);
        sum += one;
    }
    return sum;
}

TEST_F(OutlineOf, TheOuterOneCountsHoweverTheInnerOneTurns) {
    Path hole = square(5, 5, 10);
    for (int turn = 0; turn < 2; ++turn) {
        const auto outline = outline_of(drawing_of({square(0, 0, 20), hole, square(7, 7, 2)}), "f");
        ASSERT_TRUE(outline.has_value());
        EXPECT_EQ(outline->outers.size(), 1U);
        EXPECT_NEAR(outline->area_mm2, 400.0, 1e-9);
        EXPECT_NEAR(outline->centroid.x, 10.0, 1e-9);
        std::reverse(hole.points.begin(), hole.points.end());
    }
}

TEST_F(OutlineOf, OverlappingOutlinesAreOneAndApartOnesStay) {
    Path second = square(10, 10, 20);
    std::reverse(second.points.begin(), second.points.end());
    const auto joint = outline_of(drawing_of({square(0, 0, 20), second}), "f");
    ASSERT_TRUE(joint.has_value());
    EXPECT_EQ(joint->outers.size(), 1U);
    EXPECT_NEAR(joint->area_mm2, 700.0, 1e-6);
    const auto apart = outline_of(drawing_of({square(0, 0, 10), square(30, 0, 10)}), "f");
    ASSERT_TRUE(apart.has_value());
    EXPECT_EQ(apart->outers.size(), 2U);
    EXPECT_NEAR(apart->centroid.x, 20.0, 1e-9);
}

TEST_F(OutlineOf, FarFromTheOriginTheCentroidIsAsExact) {
    const auto outline = outline_of(drawing_of({square(4e6, -3e6, 20)}), "f");
    ASSERT_TRUE(outline.has_value());
    EXPECT_NEAR(outline->centroid.x, 4e6 + 10.0, 1e-6);
    EXPECT_NEAR(outline->centroid.y, -3e6 + 10.0, 1e-6);
}

TEST_F(OutlineOf, StrokesThatMeetMakeOneOutlineInAnyOrderAndSense) {
    std::vector<Path> sides{{{{0, 0}, {10, 0}}, false, false},
                            {{{0, 10}, {0, 0.004}}, false, false},
                            {{{10, 10}, {10, 0}}, false, false},
                            {{{0, 10}, {10, 10}}, false, false}};
    std::mt19937 random(7);
    for (int i = 0; i < 20; ++i) {
        std::shuffle(sides.begin(), sides.end(), random);
        const auto outline = outline_of(drawing_of(sides), "f");
        ASSERT_TRUE(outline.has_value()) << outline.error().message;
        EXPECT_NEAR(outline->area_mm2, 100.0, 0.05);
        EXPECT_TRUE(outline->warnings.empty());
    }
}

TEST_F(OutlineOf, AnOpenStrokeBesideAnOutlineIsToldOf) {
    const auto outline = outline_of(drawing_of({square(0, 0, 5), {{{9, 0}, {9, 1}}, false, false}}), "f");
    ASSERT_TRUE(outline.has_value());
    ASSERT_EQ(outline->warnings.size(), 1U);
    EXPECT_EQ(outline->warnings[0],
              "1 stroke is not closed and left out, the first from (9.000, 0.000) to (9.000, 1.000) mm");
}

TEST_F(OutlineOf, EarsCoverARaggedRingExactly) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> radius(1.0, 10.0);
    for (const std::size_t count : {3U, 4U, 17U, 500U, 5000U}) {
        std::vector<Point> ring;
        double area = 0.0;
        for (std::size_t i = 0; i < count; ++i) {
            const double angle = 2.0 * kPi * static_cast<double>(i) / static_cast<double>(count);
            const double r = radius(random);
            ring.push_back({r * std::cos(angle), r * std::sin(angle)});
        }
        for (std::size_t i = 0; i < count; ++i) {
            const Point &a = ring[i], &b = ring[(i + 1) % count];
            area += 0.5 * (a.x * b.y - a.y * b.x);
        }
        const auto triangles = triangles_of(ring);
        EXPECT_EQ(triangles.size(), count - 2);
        EXPECT_NEAR(area_of(ring, triangles), area, 1e-9 * area);
    }
}

TEST_F(OutlineOf, ASpiralArmIsClosedOnBothEnds) {
    // No star shape seen from its centroid: what a fan of triangles would get wrong.
    std::string d = "M";
    for (int i = 0; i <= 200; ++i) {
        const double a = 0.06 * i, r = 5.0 + 0.15 * i;
        d += std::to_string(50 + r * std::cos(a)) + " " + std::to_string(50 + r * std::sin(a)) + "L";
    }
    for (int i = 200; i >= 0; --i) {
        const double a = 0.06 * i, r = 3.0 + 0.15 * i;
        d += std::to_string(50 + r * std::cos(a)) + " " + std::to_string(50 + r * std::sin(a)) +
             (i > 0 ? "L" : "z");
    }
    const auto mesh = svg("<path d='" + d + "'/>");
    EXPECT_TRUE(mesh.facts.closed);
    EXPECT_TRUE(mesh.facts.same_orientation);
    EXPECT_TRUE(mesh.warnings.empty());
}

}  // namespace
}  // namespace psicarve::flat
