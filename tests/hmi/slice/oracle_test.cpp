// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "hmi/model/mesh.hpp"
#include "hmi/slice/directions.hpp"
#include "hmi/slice/placement.hpp"
#include "hmi/slice/slicer.hpp"
#include "tests/hmi/model/shapes.hpp"
#include "tests/hmi/slice/oracle.hpp"

namespace psicarve::slice {
namespace {

constexpr double kFinePulse_mm = 1.0 / 4000.0;

/// The part of samples that are within one pulse of the fine profile, at `scale` mm a unit.
double share_within_a_pulse(const model::Mesh& mesh, double axis_x, double axis_y, double scale) {
    const std::vector<double> heights =
        layer_heights(mesh.facts.min[2], mesh.facts.max[2] - mesh.facts.min[2], 37);
    const std::vector<double> angles = full_circle_rad(48, 128000, 0.0);
    const auto map = radial_map(mesh, {Up::z, axis_x, axis_y}, heights, Directions(angles), {});
    EXPECT_TRUE(map.has_value());
    if (!map) return 0.0;
    std::size_t right = 0;
    for (std::size_t layer = 0; layer < heights.size(); ++layer) {
        for (std::size_t k = 0; k < angles.size(); ++k) {
            const double wanted = oracle::radius(mesh, axis_x, axis_y, angles[k], heights[layer]);
            const double got = map->radius[layer * angles.size() + k];
            right += std::abs(got - wanted) * scale <= kFinePulse_mm ? 1 : 0;
        }
    }
    return static_cast<double>(right) / static_cast<double>(heights.size() * angles.size());
}

shapes::Point tumbled(const shapes::Point& p) {
    const double c = std::cos(0.83), s = std::sin(0.83), d = std::cos(2.1), e = std::sin(2.1);
    const shapes::Point q{c * p[0] - s * p[2], p[1], s * p[0] + c * p[2]};
    return {q[0], d * q[1] - e * q[2], e * q[1] + d * q[2]};
}

TEST(RadialMap, AgreesWithTheOracleOnAFigurineWhoseSectionsLeaveTheAxis) {
    EXPECT_GE(share_within_a_pulse(shapes::figurine(60.0, 60, 70), 0.0, 0.0, 1.0), 0.999);
}

TEST(RadialMap, AgreesWithTheOracleOnASpringThatHidesBehindItself) {
    EXPECT_GE(share_within_a_pulse(shapes::spring(15.0, 4.0, 3.2, 50.0, 150, 24), 0.3, -0.2, 1.0), 0.999);
}

TEST(RadialMap, AgreesWithTheOracleWithTheAxisOutsideTheModel) {
    EXPECT_GE(share_within_a_pulse(shapes::sphere(10.0, 40, 50), 25.0, 4.0, 1.0), 0.999);
}

TEST(RadialMap, AgreesWithTheOracleOnATumbledTorus) {
    const model::Mesh mesh = shapes::moved(shapes::torus(18.0, 6.0, 40, 80), tumbled);
    EXPECT_GE(share_within_a_pulse(mesh, 1.0, 2.0, 1.0), 0.999);
}

TEST(RadialMap, AgreesWithTheOracleOnATinyModelScaledUp) {
    EXPECT_GE(share_within_a_pulse(shapes::figurine(0.002, 50, 60), 0.0, 0.0, 30000.0), 0.999);
}

TEST(RadialMap, AgreesWithTheOracleOnALargeModelScaledDown) {
    EXPECT_GE(share_within_a_pulse(shapes::figurine(60000.0, 50, 60), 0.0, 0.0, 0.001), 0.999);
}

TEST(RadialMap, AgreesWithTheOracleOnPiecesThatRunThroughEachOther) {
    const model::Mesh mesh = shapes::Builder()
                                 .add(shapes::sphere(12.0, 30, 40))
                                 .add(shapes::spring(14.0, 3.0, 2.0, 20.0, 90, 20))
                                 .add(shapes::box({5, -3, 2}, {20, 3, 9}))
                                 .mesh();
    EXPECT_GE(share_within_a_pulse(mesh, 0.1, 0.2, 1.0), 0.999);
}

TEST(RadialMap, AgreesWithTheOracleOnASoupOfRandomFacets) {
    std::mt19937 random(20260101);
    std::uniform_real_distribution<double> place(-20.0, 20.0);
    shapes::Builder soup;
    const auto point = [&] { return shapes::Point{place(random), place(random), place(random)}; };
    for (int i = 0; i < 300; ++i) soup.facet(point(), point(), point());
    EXPECT_GE(share_within_a_pulse(soup.mesh(), 0.0, 0.0, 1.0), 0.999);
}

}  // namespace
}  // namespace psicarve::slice
