// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/model/mesh_parts.hpp"

#include <gtest/gtest.h>

#include "tests/hmi/model/shapes.hpp"

namespace psicarve::model {
namespace {

Mesh inside_out(const Mesh& mesh) {
    Mesh out = mesh;
    for (Triangle& triangle : out.triangles) std::swap(triangle.vertices[0], triangle.vertices[1]);
    return out;
}

TEST(MeshParts, AreBodiesThatShareNoCorner) {
    const Mesh box = shapes::box({0, 0, 0}, {1, 2, 3});
    const MeshParts one = parts_of(box.triangles);
    EXPECT_EQ(one.components, 1U);
    EXPECT_EQ(one.open, 0U);
    EXPECT_EQ(one.holes, 0U);
    EXPECT_EQ(one.inside_out, 0U);
    const Mesh two = shapes::Builder().add(box).add(shapes::sphere(4.0, 8, 12)).mesh();
    EXPECT_EQ(parts_of(two.triangles).components, 2U);
    EXPECT_EQ(parts_of({}).components, 0U);
}

TEST(MeshParts, TellWhichBodiesAreInsideOut) {
    const Mesh far = shapes::box({50, 0, 0}, {51, 2, 3});
    const Mesh sut = shapes::Builder()
                         .add(shapes::box({0, 0, 0}, {1, 2, 3}))
                         .add(inside_out(far))
                         .add(shapes::sphere(4.0, 8, 12))
                         .mesh();
    EXPECT_EQ(parts_of(sut.triangles).inside_out, 1U);
    EXPECT_EQ(parts_of(sut.triangles).components, 3U);
}

TEST(MeshParts, CountHolesByTheirRims) {
    Mesh ball = shapes::sphere(4.0, 8, 12);
    // Two facets apart from each other, and one more next to the first.
    ball.triangles.erase(ball.triangles.begin() + 60);
    ball.triangles.erase(ball.triangles.begin() + 20, ball.triangles.begin() + 22);
    const MeshParts sut = parts_of(ball.triangles);
    EXPECT_EQ(sut.holes, 2U);
    EXPECT_EQ(sut.open, 1U);
    EXPECT_EQ(sut.components, 1U);
    EXPECT_EQ(sut.inside_out, 0U);
}

}  // namespace
}  // namespace psicarve::model
