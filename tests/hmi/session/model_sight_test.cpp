// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/model_sight.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/hmi/model/shapes.hpp"

namespace psicarve::session {
namespace {

/// A column on the axis, and a plate that stands before it on the side of +x.
model::Mesh column_behind_a_plate() {
    return shapes::Builder{}
        .add(shapes::box({-5, -5, 0}, {5, 5, 40}))
        .add(shapes::box({20, -30, 0}, {22, 30, 40}))
        .mesh();
}

TEST(ModelSight, FindsWhatAnotherWallHidesAndNothingElse) {
    const model::Mesh mesh = column_behind_a_plate();
    cam::JobOptions options;
    options.axis_at = cam::AxisAt::origin;
    // Places of our own choice instead of the corners.
    MeshScene scene = make_mesh_scene(mesh);
    scene.vertices = {{5, 0, 0}, {-5, 0, 0}, {22, 0, 0}, {20, 0, 0}, {5, 0, 20}, {5, 0, -20}};
    for (auto& vertex : scene.vertices) vertex[0] -= static_cast<float>(scene.middle[0]);  // of the whole box
    const auto sight = look_at_model(mesh, scene, Profile{}, options);
    ASSERT_TRUE(sight) << sight.error().message;
    // The column before the plate, its back, the plate outside and inside; the column's top and bottom rims.
    EXPECT_EQ(sight->is_hidden, (std::vector<std::uint8_t>{1, 0, 0, 1, 0, 0}));
    EXPECT_NEAR(sight->blank_radius, std::hypot(22, 30), 0.5);
    EXPECT_NEAR(sight->axis[0], -scene.middle[0], 1e-9);
    EXPECT_GT(sight->undercut_share, 0.2);
    const MeshScene painted = painted_scene(scene, *sight, 0x111111, 0x222222);
    EXPECT_EQ(painted.vertex_rgb[0], 0x222222U);
    EXPECT_EQ(painted.vertex_rgb[1], 0x111111U);
}

TEST(ModelSight, SeesAllOfAColumnAndMeasuresItsBlank) {
    const model::Mesh mesh = shapes::box({-5, -5, 0}, {5, 5, 40});
    cam::JobOptions options;
    options.height_mm = 80.0;
    const MeshScene scene = make_mesh_scene(mesh);
    const auto sight = look_at_model(mesh, scene, Profile{}, options);
    ASSERT_TRUE(sight) << sight.error().message;
    for (const auto hidden : sight->is_hidden) EXPECT_EQ(hidden, 0);
    EXPECT_EQ(sight->undercut_share, 0.0);
    EXPECT_NEAR(sight->blank_radius, std::hypot(5, 5), 0.05);
    EXPECT_DOUBLE_EQ(sight->mm_per_unit, 2.0);
}

TEST(ModelSight, CanBeEnded) {
    cam::JobOptions options;
    options.search_progress = [](double) { return false; };
    const model::Mesh mesh = column_behind_a_plate();
    const auto sight = look_at_model(mesh, make_mesh_scene(mesh), Profile{}, options);
    ASSERT_FALSE(sight);
    EXPECT_EQ(sight.error().code, ErrorCode::cancelled);
}

}  // namespace
}  // namespace psicarve::session
