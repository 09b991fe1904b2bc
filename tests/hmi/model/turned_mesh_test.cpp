// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/model/turned_mesh.hpp"

#include <gtest/gtest.h>

#include "hmi/model/edge_count.hpp"
#include "tests/hmi/model/shapes.hpp"

namespace psicarve::model {
namespace {

/// Signed, from the facets.
double volume_of(const Mesh& mesh) {
    return shapes::Builder().add(mesh).mesh().facts.signed_volume;
}

MeshTurn rotated(double x_deg, double y_deg, double z_deg) {
    return {{x_deg, y_deg, z_deg}, {}};
}

/// A box from a low to a high corner, to see where its corners went.
void expect_box(const Mesh& mesh, const std::array<double, 3>& low, const std::array<double, 3>& high) {
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(mesh.facts.min[k], low[k]) << k;
        EXPECT_EQ(mesh.facts.max[k], high[k]) << k;
    }
}

TEST(TurnedMesh, GoesCounterClockwiseAboutEachAxisExactlyByQuarters) {
    const Mesh box = shapes::box({1, 2, 3}, {4, 6, 8});
    expect_box(turned(box, rotated(90, 0, 0)), {1, -8, 2}, {4, -3, 6});
    expect_box(turned(box, rotated(0, 90, 0)), {3, 2, -4}, {8, 6, -1});
    expect_box(turned(box, rotated(0, 0, 90)), {-6, 1, 3}, {-2, 4, 8});
    expect_box(turned(box, rotated(0, 0, -270)), {-6, 1, 3}, {-2, 4, 8});
    expect_box(turned(box, rotated(90, 0, 90)), {3, 1, 2}, {8, 4, 6});
}

TEST(TurnedMesh, MirrorsBeforeItTurnsAndKeepsItsOutsideOutside) {
    const Mesh box = shapes::box({1, 2, 3}, {4, 6, 8});
    const Mesh mirrored = turned(box, {{0, 0, 0}, 0});
    expect_box(mirrored, {-4, 2, 3}, {-1, 6, 8});
    EXPECT_NEAR(volume_of(mirrored), 60.0, 1e-6);
    expect_box(turned(box, {{0, 0, 90}, 0}), {-6, -4, 3}, {-2, -1, 8});
    EXPECT_NEAR(volume_of(turned(box, {{30, 50, 70}, 2})), 60.0, 1e-4);
}

TEST(TurnedMesh, KeepsItsShapeAtAnyAngle) {
    const Mesh mesh = shapes::figurine(40.0, 20, 30);
    const Mesh sut = turned(mesh, rotated(12.3, -45.6, 78.9));
    EXPECT_NEAR(volume_of(sut), volume_of(mesh), 1e-4 * volume_of(mesh));
    EXPECT_EQ(count_edges(sut.triangles).open, 0U);
    EXPECT_EQ(sut.turn.rotate_deg[1], -45.6);
}

TEST(TurnedMesh, TakesItsFarOriginAndItsAxisAlong) {
    Mesh mesh = shapes::box({1, 2, 3}, {4, 6, 8});
    mesh.origin = {1000, 0, 0};
    mesh.axis_hint = {{1002, 3}};
    const Mesh sut = turned(mesh, rotated(0, 0, 90));
    EXPECT_EQ(sut.facts.min[1], 1001.0);
    ASSERT_TRUE(sut.axis_hint);
    EXPECT_EQ((*sut.axis_hint)[0], -3.0);
    EXPECT_EQ((*sut.axis_hint)[1], 1002.0);
    EXPECT_FALSE(turned(mesh, rotated(90, 0, 0)).axis_hint);
    EXPECT_TRUE(turned(mesh, {}).axis_hint);
}

}  // namespace
}  // namespace psicarve::model
