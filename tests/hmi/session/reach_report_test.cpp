// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/reach_report.hpp"

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

TEST(ReachReport, FindsWhatAnotherWallHidesAndNothingElse) {
    const model::Mesh mesh = column_behind_a_plate();
    cam::JobOptions options;
    options.axis_at = cam::AxisAt::origin;
    // Places of our own choice instead of the corners.
    MeshScene scene = make_mesh_scene(mesh);
    scene.vertices = {{5, 0, 0}, {-5, 0, 0}, {22, 0, 0}, {20, 0, 0}, {5, 0, 20}, {5, 0, -20}};
    for (auto& vertex : scene.vertices) vertex[0] -= static_cast<float>(scene.middle[0]);  // of the whole box
    const auto reach = look_at_model(mesh, scene, Profile{}, options);
    ASSERT_TRUE(reach) << reach.error().message;
    // The column before the plate, its back, the plate outside and inside; the column's top and bottom rims.
    EXPECT_EQ(reach->is_hidden, (std::vector<std::uint8_t>{1, 0, 0, 1, 0, 0}));
    EXPECT_NEAR(reach->blank_radius, std::hypot(22, 30), 0.5);
    EXPECT_NEAR(reach->axis[0], -scene.middle[0], 1e-9);
    EXPECT_GT(reach->undercut_share, 0.2);
    const MeshScene painted = painted_scene(scene, *reach, 0x111111, 0x222222);
    EXPECT_EQ(painted.vertex_rgb[0], 0x222222U);
    EXPECT_EQ(painted.vertex_rgb[1], 0x111111U);
}

TEST(ReachReport, KnowsFromWhereWhatIsHiddenIsSeen) {
    const model::Mesh mesh = column_behind_a_plate();
    cam::JobOptions options;
    options.axis_at = cam::AxisAt::origin;
    const MeshScene scene = make_mesh_scene(mesh);
    auto reach = look_at_model(mesh, scene, Profile{}, options);
    ASSERT_TRUE(reach) << reach.error().message;
    // The plate's inner face alone: from the side of -x, where nothing but the column stands before it.
    for (std::size_t i = 0; i < scene.vertices.size(); ++i)
        reach->is_hidden[i] = std::abs(scene.vertices[i][0] + scene.middle[0] - 20.0) < 0.01 ? 1 : 0;
    const auto view = view_of_hidden(scene, *reach, slice::Up::z);
    ASSERT_TRUE(view);
    EXPECT_LT(std::cos(view->azimuth_rad), -0.3);
    std::fill(reach->is_hidden.begin(), reach->is_hidden.end(), std::uint8_t{0});
    EXPECT_FALSE(view_of_hidden(scene, *reach, slice::Up::z));
}

TEST(ReachReport, SeesAllOfAColumnAndMeasuresItsBlank) {
    const model::Mesh mesh = shapes::box({-5, -5, 0}, {5, 5, 40});
    cam::JobOptions options;
    options.height_mm = 80.0;
    const MeshScene scene = make_mesh_scene(mesh);
    const auto reach = look_at_model(mesh, scene, Profile{}, options);
    ASSERT_TRUE(reach) << reach.error().message;
    for (const auto hidden : reach->is_hidden) EXPECT_EQ(hidden, 0);
    EXPECT_EQ(reach->undercut_share, 0.0);
    EXPECT_NEAR(reach->blank_radius, std::hypot(5, 5), 0.05);
    EXPECT_DOUBLE_EQ(reach->mm_per_unit, 2.0);
}

// A drawing's axis is its centroid, as the slicer has it.
TEST(ReachReport, TurnsADrawingAboutItsCentroid) {
    model::Mesh mesh = shapes::box({-5, -5, 0}, {5, 5, 40});
    mesh.axis_hint = std::array{1.0, 2.0};
    const MeshScene scene = make_mesh_scene(mesh);
    cam::JobOptions options;
    const auto reach = look_at_model(mesh, scene, Profile{}, options);
    ASSERT_TRUE(reach) << reach.error().message;
    EXPECT_NEAR(reach->blank_radius, std::hypot(6, 7), 0.1);
    options.up = slice::Up::x;
    EXPECT_NEAR(look_at_model(mesh, scene, Profile{}, options)->blank_radius, std::hypot(5, 20), 0.1);
}

class BlankOfView : public ::testing::Test {
protected:
    /// A column 10 units wide that stands 3 mm above the table, 2 mm a unit.
    BlankOfView() {
        const model::Mesh mesh = shapes::box({-5, -5, 0}, {5, 5, 40});
        cam::JobOptions options;
        options.scale = 2.0;
        profile_.job.base_height_mm = 3.0;
        auto reach = look_at_model(mesh, make_mesh_scene(mesh), profile_, options);
        EXPECT_TRUE(reach) << reach.error().message;
        view_ = std::move(*reach);
    }
    Profile profile_;
    ReachReport view_;
};

TEST_F(BlankOfView, IsTheLeastUnlessOneIsChosen) {
    const BlankOutline least = blank_outline(view_, profile_);
    EXPECT_FALSE(least.is_chosen);
    EXPECT_NEAR(least.diameter_mm, 4.0 * std::hypot(5, 5), 0.2);
    EXPECT_EQ(least.centre, view_.axis);
    EXPECT_DOUBLE_EQ(least.high, 20.0);
    profile_.blank = {18.0, 0.0, 1.0, -3.0, 0.0};
    EXPECT_EQ(blank_outline(view_, profile_), (BlankOutline{{0.5, -1.5}, 9.0, -20.0, 20.0, 36.0, true}));
    profile_.blank.height_mm = 90.0;
    EXPECT_EQ(blank_outline(view_, profile_), (BlankOutline{{0.5, -1.5}, 9.0, -21.5, 23.5, 36.0, true}))
        << "it stands on the table";
}

// The words are the slicer's own.
TEST_F(BlankOfView, IsWarnedOfBeforeSlicingAsTheSlicerDoes) {
    EXPECT_TRUE(blank_warnings(view_, profile_).empty());
    profile_.blank.radius_mm = 14.3;
    EXPECT_TRUE(blank_warnings(view_, profile_).empty()) << "large enough";
    profile_.blank.radius_mm = 12.0;
    const auto small = blank_warnings(view_, profile_);
    ASSERT_EQ(small.size(), 1U);
    EXPECT_EQ(small[0].find("the blank's radius of 12.00 mm is less than the model's, 14.1"), 0U) << small[0];
    profile_.blank = {16.0, 50.0, -4.0, 0.0, 0.0};
    const auto off = blank_warnings(view_, profile_);
    ASSERT_EQ(off.size(), 2U);
    EXPECT_NE(off[0].find("stands out of the blank, which is off the table's axis, by up to "),
              std::string::npos)
        << off[0];
    EXPECT_EQ(off[1], "the blank's top stands 50.00 mm above the table, the model's 83.00 mm");
}

TEST(ReachReport, CanBeEnded) {
    cam::JobOptions options;
    options.search_progress = [](double) { return false; };
    const model::Mesh mesh = column_behind_a_plate();
    const auto reach = look_at_model(mesh, make_mesh_scene(mesh), Profile{}, options);
    ASSERT_FALSE(reach);
    EXPECT_EQ(reach.error().code, ErrorCode::cancelled);
}

}  // namespace
}  // namespace psicarve::session
