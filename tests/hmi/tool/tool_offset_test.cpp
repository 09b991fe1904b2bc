// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/tool/tool_offset.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "hmi/slice/directions.hpp"
#include "shared/base/units.hpp"
#include "tests/hmi/model/shapes.hpp"
#include "tests/hmi/tool/brute_force.hpp"

namespace psicarve::tool {
namespace {

constexpr Tool kBall{Shape::ball, 1.5, 0.0};
constexpr Tool kFlat{Shape::flat, 1.0, 0.0};
constexpr Tool kVee{Shape::vee, 2.0, 60.0};
constexpr Tool kBlunt{Shape::vee, 2.5, 120.0};

std::vector<double> heights_between(double low, double high, std::size_t count) {
    std::vector<double> heights;
    for (std::size_t i = 0; i < count; ++i) {
        heights.push_back(low + (high - low) * (static_cast<double>(i) + 0.5) / static_cast<double>(count));
    }
    return heights;
}

std::vector<double> tips(const model::Mesh& mesh, const Tool& tool, const std::vector<double>& directions,
                         const std::vector<double>& heights, unsigned threads = 1) {
    const TipPlaces places{directions, heights.size(), heights};
    return tip_radii(mesh, {}, tool, places, {threads, {}}).value();
}

void expect_as_by_definition(const model::Mesh& mesh, const Tool& tool, double low, double high) {
    const std::vector<double> heights = heights_between(low, high, 7);
    const std::vector<double> directions = slice::full_circle_rad(6, 360, 0.7);
    const auto rise_of = [&tool](double s) { return rise(tool, s); };
    const brute::Shape<decltype(rise_of)> shape{tool.radius, rise_of};
    const std::vector<double> found = tips(mesh, tool, directions, heights);
    std::size_t touched = 0;
    for (std::size_t c = 0; c < directions.size(); ++c) {
        for (std::size_t r = 0; r < heights.size(); ++r) {
            const double wanted = brute::tip_radius(mesh, directions[c], heights[r], shape);
            touched += wanted > 0.0 ? 1 : 0;
            ASSERT_NEAR(found[c * heights.size() + r], wanted, 1e-6)
                << "direction " << deg_from_rad(directions[c]) << " height " << heights[r];
        }
    }
    EXPECT_GT(touched, directions.size() * heights.size() / 2);
}

void expect_as_by_definition(const model::Mesh& mesh, double low, double high) {
    for (const Tool& tool : {kBall, kFlat, kVee, kBlunt}) {
        SCOPED_TRACE(static_cast<int>(tool.shape));
        expect_as_by_definition(mesh, tool, low, high);
    }
}

/// Bumps and dents finer than the tools, overhangs, and a section that is nowhere round.
model::Mesh bumpy(std::uint32_t seed, double out_of_axis) {
    std::mt19937_64 random{seed};
    std::uniform_real_distribution<double> part{-1.0, 1.0};
    constexpr std::size_t kRows = 14;
    constexpr std::size_t kColumns = 22;
    std::vector<double> lift;
    std::vector<double> depth;
    for (std::size_t i = 0; i < (kRows + 1) * kColumns; ++i) {
        lift.push_back(0.6 * part(random));
        depth.push_back(1.2 * part(random));
    }
    return shapes::grid(kRows, kColumns, false, [&](std::size_t i, std::size_t j) {
        const std::size_t at = i * kColumns + j;
        const double t = shapes::turn_part(j, kColumns);
        const double r = 6.0 + depth[at];
        return shapes::Point{out_of_axis + r * std::cos(t), r * std::sin(t),
                             static_cast<double>(i) + lift[at]};
    });
}

TEST(ToolOffset, IsThatOfItsDefinitionOnABumpyBody) {
    expect_as_by_definition(bumpy(1, 0.0), -1.0, 15.0);
}

TEST(ToolOffset, IsThatOfItsDefinitionWhereTheAxisRunsOutside) {
    expect_as_by_definition(bumpy(2, 5.0), -1.0, 15.0);
}

TEST(ToolOffset, IsThatOfItsDefinitionBesideATorusAndABox) {
    expect_as_by_definition(shapes::torus(7.0, 2.0, 12, 17), -0.5, 4.5);
    expect_as_by_definition(shapes::box({-3.0, -4.0, 0.0}, {5.0, 4.0, 6.0}), -1.0, 7.0);
}

TEST(ToolOffset, IsThatOfItsDefinitionOnAMeshWithHoles) {
    model::Mesh mesh = bumpy(3, 0.0);
    shapes::Builder open;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& v = mesh.triangles[i].vertices;
        const auto point = [&v](std::size_t k) { return shapes::Point{v[k][0], v[k][1], v[k][2]}; };
        if (i % 7 == 0) continue;
        // Every fifth is turned inside out.
        if (i % 5 == 0) open.facet(point(0), point(2), point(1));
        if (i % 5 != 0) open.facet(point(0), point(1), point(2));
    }
    mesh = open.mesh();
    ASSERT_FALSE(mesh.facts.closed);
    expect_as_by_definition(mesh, -1.0, 15.0);
}

TEST(ToolOffset, OfAMeshInsideOutIsTheSame) {
    const model::Mesh mesh = bumpy(4, 0.0);
    model::Mesh turned = mesh;
    for (model::Triangle& facet : turned.triangles) std::swap(facet.vertices[1], facet.vertices[2]);
    turned.facts.signed_volume = -mesh.facts.signed_volume;
    const std::vector<double> heights = heights_between(0.0, 14.0, 40);
    const std::vector<double> directions = slice::full_circle_rad(30, 6400, 0.0);
    const auto of_turned = tips(turned, kBall, directions, heights);
    const auto of_mesh = tips(mesh, kBall, directions, heights);
    for (std::size_t i = 0; i < of_mesh.size(); ++i) ASSERT_NEAR(of_turned[i], of_mesh[i], 1e-9);
}

TEST(ToolOffset, OfACylinderIsItsRadiusAndABallRollsOverItsRim) {
    const model::Mesh mesh = shapes::cylinder(10.0, 0.0, 20.0, 4000);
    const std::vector<double> heights{-1.6, -1.2, 5.0, 21.0};
    const std::vector<double> found = tips(mesh, kBall, {0.3}, heights);
    EXPECT_EQ(found[0], 0.0) << "below the body nothing is within reach";
    EXPECT_NEAR(found[1], 10.0 - (1.5 - std::sqrt(1.5 * 1.5 - 1.2 * 1.2)), 1e-5);
    EXPECT_NEAR(found[2], 10.0, 1e-5);
    EXPECT_NEAR(found[3], 10.0 - (1.5 - std::sqrt(1.5 * 1.5 - 1.0)), 1e-5);
}

TEST(ToolOffset, AThinFinHoldsTheToolOffThoughNoSampleMeetsIt) {
    // Between two columns of a table; its tip is 8 from the axis.
    shapes::Builder body;
    body.add(shapes::cylinder(5.0, 0.0, 10.0, 100));
    body.add(shapes::box({4.0, 0.55, 0.0}, {8.0, 0.56, 10.0}));
    const double across = 0.55;
    const std::vector<double> found = tips(body.mesh(), kBall, {0.0}, {5.0});
    EXPECT_NEAR(found[0], 8.0 - (1.5 - std::sqrt(1.5 * 1.5 - across * across)), 1e-6);
    const std::vector<double> flat = tips(body.mesh(), kFlat, {0.0}, {5.0});
    EXPECT_NEAR(flat[0], 8.0, 1e-6);
}

TEST(ToolOffset, IsTheSameForEveryNumberOfThreadsAndTurn) {
    const model::Mesh mesh = bumpy(5, 1.0);
    const std::vector<double> heights = heights_between(0.0, 14.0, 50);
    const std::vector<double> directions = slice::full_circle_rad(80, 6400, 359.9);
    const auto one = tips(mesh, kBall, directions, heights);
    EXPECT_EQ(tips(mesh, kBall, directions, heights, 3), one);
    for (std::size_t c = 0; c < directions.size(); c += 37) {
        const std::vector<double> alone = tips(mesh, kBall, {directions[c]}, heights);
        for (std::size_t r = 0; r < heights.size(); ++r) EXPECT_EQ(alone[r], one[c * heights.size() + r]);
    }
}

TEST(ToolOffset, RowsThatRiseDuringATurnHaveHeightsOfTheirOwn) {
    const model::Mesh mesh = bumpy(6, 0.0);
    const std::vector<double> directions{0.1, 2.0, 4.0};
    const std::vector<double> heights{1.0, 2.0, 1.3, 2.3, 1.6, 2.6};
    const auto rising = tip_radii(mesh, {}, kVee, {directions, 2, heights}, {1, {}}).value();
    for (std::size_t c = 0; c < 3; ++c) {
        const auto flat = tips(mesh, kVee, {directions[c]}, {heights[2 * c], heights[2 * c + 1]});
        EXPECT_EQ(rising[2 * c], flat[0]);
        EXPECT_EQ(rising[2 * c + 1], flat[1]);
    }
}

// However early the other threads have done all there is.
TEST(ToolOffset, CanBeCancelled) {
    const std::vector<double> directions = slice::full_circle_rad(80, 6400, 0.0);
    const std::vector<double> heights{1.0};
    const model::Mesh mesh = bumpy(7, 0.0);
    for (int round = 0; round < 300; ++round) {
        const auto found =
            tip_radii(mesh, {}, kBall, {directions, 1, heights}, {3, [](double) { return false; }});
        ASSERT_FALSE(found) << round;
        EXPECT_EQ(found.error().code, ErrorCode::cancelled);
    }
}

TEST(ToolOffset, TurnsAndMovesWithTheModel) {
    const model::Mesh mesh = shapes::box({10.0, 20.0, 30.0}, {16.0, 28.0, 40.0});
    // Seen upright along x, the box reaches from 20 to 28 and from 30 to 40 across, and from 10 to 16 up.
    const std::vector<double> heights{13.0};
    const std::vector<double> directions{0.0, kPi / 2.0};
    const auto found =
        tip_radii(mesh, {slice::Up::x, 24.0, 34.0}, kFlat, {directions, 1, heights}, {1, {}}).value();
    EXPECT_NEAR(found[0], 4.0, 1e-6);
    EXPECT_NEAR(found[1], 6.0, 1e-6);
}

}  // namespace
}  // namespace psicarve::tool
