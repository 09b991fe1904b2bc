// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "hmi/model/load_mesh.hpp"
#include "hmi/scene/mesh_scene.hpp"
#include "hmi/scene/radius_map.hpp"
#include "hmi/scene/space_picture.hpp"
#include "hmi/scene/time_map.hpp"
#include "shared/base/units.hpp"
#include "tests/hmi/model/shapes.hpp"
#include "tests/places.hpp"

namespace psicarve::session {
namespace {

/// R1's half stands at 10 mm, R2's at 20 mm, in every layer.
cam::PreparedJob two_halves(Joining joining) {
    const Profile profile;
    JobTable table;
    table.layer_count = 4;
    table.point_count = 5;
    table.psi_sweep_pulses = profile.psi.pulses_per_rev / 2;
    table.joining = joining;
    table.feed_mm_s = 20.0;
    table.profile_toml = profile_to_toml(profile);
    table.report_json = "{}";
    for (std::int64_t layer = 0; layer < 4; ++layer) {
        table.layer_height_pulses.push_back(400 * (layer + 1));
        // Continuous layers begin where those before ended: the heads change sides.
        const bool is_swapped = joining == Joining::continuous && layer % 2 == 1;
        table.r_left_pulses.insert(table.r_left_pulses.end(), 5, is_swapped ? 8000 : 4000);
        table.r_right_pulses.insert(table.r_right_pulses.end(), 5, is_swapped ? 4000 : 8000);
    }
    auto job = cam::prepare_blob(job_blob_from_table(table), profile, "two halves");
    EXPECT_TRUE(job);
    return std::move(*job);
}

TEST(RadiusMap, HasTheWorkpiecesDirectionsWhicheverHeadCarvesThem) {
    for (const Joining joining : {Joining::continuous, Joining::zigzag}) {
        const auto job = two_halves(joining);
        const RadiusMap map = radius_map(job, 720, 600);
        ASSERT_EQ(map.rows, 4U);
        ASSERT_EQ(map.columns, 8U);
        EXPECT_EQ(map.least_mm, 10.0);
        EXPECT_EQ(map.most_mm, 20.0);
        for (std::size_t i = 0; i < map.radius_mm.size(); ++i)
            EXPECT_FLOAT_EQ(map.radius_mm[i], i % 8 < 4 ? 10.0F : 20.0F) << i;
    }
}

TEST(RadiusMap, BecomesAPictureWithTheHighestLayerFirst) {
    RadiusMap map{2, 2, {1.0F, 1.0F, 3.0F, 3.0F}, 1.0, 3.0};
    const auto picture = radius_picture(map, false);
    EXPECT_EQ(picture[0], 0xFFFDE725U);
    EXPECT_EQ(picture[2], 0xFF440154U);
    EXPECT_NE(radius_picture(map, true), picture);
    EXPECT_EQ(viridis(-1.0), 0x440154U);
    EXPECT_EQ(viridis(0.5), 0x21918CU);
}

/// The n-th way of each layer takes n ms; the second one is bounded by R1, the others by the feed.
PointPlan steady_plan(const cam::PreparedJob& job) {
    PointPlan plan{std::vector<float>(20), std::vector<WayBound>(20, WayBound::unknown)};
    for (std::uint32_t layer = 0; layer < 4; ++layer) {
        for (std::uint32_t step = 1; step < 5; ++step) {
            const std::size_t place = layer * 5 + carved_point(job.view.joining(), 5, layer, step);
            const std::uint32_t way =
                job.view.joining() == Joining::zigzag && layer % 2 == 1 ? 5 - step : step;
            plan.seconds[place] = 1e-3F * static_cast<float>(way);
            plan.bounds[place] = way == 2 ? WayBound::r1 : WayBound::feed;
        }
    }
    return plan;
}

TEST(TimeMap, HasEachWayWhereBothHeadsGoIt) {
    for (const Joining joining : {Joining::continuous, Joining::zigzag}) {
        const auto job = two_halves(joining);
        const TimeMap map = time_map(job, steady_plan(job), 720, 600);
        ASSERT_EQ(map.rows, 4U);
        ASSERT_EQ(map.columns, 8U);
        for (std::size_t i = 0; i < map.way_ms.size(); ++i) {
            EXPECT_FLOAT_EQ(map.way_ms[i], static_cast<float>(i % 4 + 1)) << i;
            EXPECT_EQ(map.bounds[i], i % 4 == 1 ? WayBound::r1 : WayBound::feed) << i;
        }
        EXPECT_DOUBLE_EQ(map.most_ms, 4.0);
        EXPECT_NEAR(map.bound_ratio[static_cast<std::size_t>(WayBound::r1)], 0.2, 1e-6);
        EXPECT_NEAR(map.bound_ratio[static_cast<std::size_t>(WayBound::feed)], 0.8, 1e-6);
    }
}

TEST(TimeMap, OfFewerCellsHasTheMeanAndWhatBoundsMostOfTheTime) {
    const auto job = two_halves(Joining::continuous);
    const TimeMap map = time_map(job, steady_plan(job), 4, 2);
    ASSERT_EQ(map.rows, 2U);
    ASSERT_EQ(map.columns, 4U);
    for (std::size_t i = 0; i < map.way_ms.size(); ++i) {
        EXPECT_FLOAT_EQ(map.way_ms[i], i % 2 == 0 ? 1.5F : 3.5F) << i;
        EXPECT_EQ(map.bounds[i], i % 2 == 0 ? WayBound::r1 : WayBound::feed) << i;
    }
}

TEST(TimeMap, BecomesPicturesWithTheHighestLayerFirst) {
    TimeMap map{2,   2, {0.0F, 0.0F, 4.0F, 8.0F}, {WayBound::r1, WayBound::r2, WayBound::y, WayBound::psi},
                4.0, {}};
    const auto times = time_picture(map);
    EXPECT_EQ(times, (std::vector<std::uint32_t>{0xFFFDE725U, 0xFFFDE725U, 0xFF440154U, 0xFF440154U}));
    EXPECT_EQ(bound_picture(map, {9, 1, 2, 3, 4, 5}),
              (std::vector<std::uint32_t>{0xFF000004U, 0xFF000003U, 0xFF000001U, 0xFF000002U}));
}

TEST(LayerRim, GoesOnceRoundWithBothHalves) {
    const auto job = two_halves(Joining::continuous);
    const LayerRim rim = layer_rim(job, 1);
    EXPECT_DOUBLE_EQ(rim.y_mm, 2.0);
    ASSERT_EQ(rim.r1.size(), 5U);
    EXPECT_DOUBLE_EQ(rim.r1.front().direction_deg, 180.0);
    EXPECT_DOUBLE_EQ(rim.r2.front().direction_deg, 0.0);
    EXPECT_DOUBLE_EQ(rim.r2.back().direction_deg, 180.0);
    EXPECT_DOUBLE_EQ(rim.r1.front().radius_mm, 20.0);
}

TEST(LayerCurves, HasBothRadiiOverTheTablesAngle) {
    const auto job = two_halves(Joining::continuous);
    const LayerCurves curves = layer_curves(job, 1);
    EXPECT_EQ(curves.psi_deg, (std::vector<double>{180.0, 225.0, 270.0, 315.0, 360.0}));
    EXPECT_EQ(curves.r1_mm, std::vector<double>(5, 20.0));
    EXPECT_EQ(curves.r2_mm, std::vector<double>(5, 10.0));
    EXPECT_EQ(layer_curves(job, 2).psi_deg.front(), 0.0) << "a whole turn on";
}

TEST(RingOutline, IsACircleFromAnySideAndInFrontOfWhatItGoesRound) {
    const std::array<double, 3> size{20.0, 20.0, 50.0};
    const std::array<double, 3> centre{8.0, -3.0, 12.0};
    for (const double elevation_rad : {0.0, 0.4, kPi / 2.0}) {
        const SceneCamera camera{size, {1.1, elevation_rad}, 640.0, 480.0};
        const auto middle = camera.project(centre);
        double widest_px = 0.0;
        for (const SceneLine& line : ring_outline(camera, centre, 5.0, 0xFF0000)) {
            EXPECT_EQ(line.rgb, 0xFF0000U);
            const auto at = camera.project(line.from);
            const double off_px = std::hypot(at[0] - middle[0], at[1] - middle[1]);
            EXPECT_NEAR(off_px, 5.0 * camera.px_per_unit(), 0.04 * 5.0 * camera.px_per_unit());
            EXPECT_GT(at[2], middle[2]);
            widest_px = std::max(widest_px, off_px);
        }
        EXPECT_NEAR(widest_px, 5.0 * camera.px_per_unit(), 1e-6);
    }
}

TEST(HalfSpans, ChangeSidesFromLayerToLayerOfAContinuousJob) {
    const auto job = two_halves(Joining::continuous);
    for (const std::uint32_t layer : {0U, 1U, 2U}) {
        const auto spans = half_spans(job, layer);
        ASSERT_EQ(spans.size(), 2U);
        EXPECT_EQ(spans[0].from_deg, 0.0);
        EXPECT_EQ(spans[0].to_deg, 180.0);
        EXPECT_EQ(spans[0].is_r2, layer == 1);
        EXPECT_EQ(spans[1].to_deg, 360.0);
        EXPECT_EQ(spans[1].is_r2, layer != 1);
    }
    for (const std::uint32_t layer : {0U, 1U})
        EXPECT_FALSE(half_spans(two_halves(Joining::zigzag), layer)[0].is_r2);
}

TEST(HalfSpans, GoOnBeyondDirectionNought) {
    auto job = two_halves(Joining::continuous);
    job.profile.psi.pulses_per_rev = job.view.psi_sweep_pulses() * 4;  // a sweep is a quarter of a turn
    const auto quarter = half_spans(job, 1);
    ASSERT_EQ(quarter.size(), 3U);
    EXPECT_TRUE(quarter[0].is_r2);
    EXPECT_EQ(quarter[0].to_deg, 90.0);
    EXPECT_FALSE(quarter[1].is_r2);
    EXPECT_EQ(quarter[1].to_deg, 270.0);
    EXPECT_TRUE(quarter[2].is_r2);
    const auto late = half_spans(job, 3);
    ASSERT_EQ(late.size(), 3U);
    EXPECT_FALSE(late[0].is_r2);
    EXPECT_TRUE(late[1].is_r2);
    EXPECT_EQ(late[1].from_deg, 90.0);
}

class MeshPicture : public ::testing::Test {
protected:
    MeshPicture() {
        auto read = model::load_mesh(example("figurine.stl"));
        EXPECT_TRUE(read);
        mesh_ = std::move(*read);
    }
    static verify::PixelImage draw(const MeshScene& scene, const SceneView& view, std::size_t width_px,
                                   std::size_t height_px, bool is_coarse = false) {
        return draw_bodies(
            {scene.size, view, {{std::make_shared<const MeshScene>(scene), {}}}, {}, is_coarse}, width_px,
            height_px);
    }
    static std::size_t painted(const verify::PixelImage& image) {
        return static_cast<std::size_t>(std::count_if(image.argb.begin(), image.argb.end(),
                                                      [](std::uint32_t pixel) { return pixel != 0; }));
    }
    model::Mesh mesh_;
};

TEST_F(MeshPicture, FitsWithAMarginFromEverySide) {
    const MeshScene scene = make_mesh_scene(mesh_);
    for (const double elevation_rad : {-kPi / 2.0, 0.0, 0.4, kPi / 2.0}) {
        for (const double azimuth_rad : {0.0, 1.0, 4.0}) {
            SceneView view;
            view.azimuth_rad = azimuth_rad;
            view.elevation_rad = elevation_rad;
            const auto image = draw(scene, view, 120, 100);
            EXPECT_GT(painted(image), 120U * 100U / 40U);
            for (std::size_t x = 0; x < 120; ++x) {
                EXPECT_EQ(image.argb[x], 0U);
                EXPECT_EQ(image.argb[99 * 120 + x], 0U);
            }
        }
    }
}

TEST_F(MeshPicture, CostsFewFacetsAndLooksTheSame) {
    const MeshScene fine = make_mesh_scene(mesh_, 100'000);
    const MeshScene coarse = make_mesh_scene(mesh_, 80, 30);
    EXPECT_GT(fine.facets.size(), mesh_.triangles.size() - 100);
    EXPECT_LT(coarse.facets.size(), fine.facets.size());
    EXPECT_LT(coarse.vertices.size(), std::size_t{80 * 80 * 8});
    const auto a = static_cast<double>(painted(draw(fine, {}, 200, 200)));
    const auto b = static_cast<double>(painted(draw(coarse, {}, 200, 200)));
    EXPECT_NEAR(b / a, 1.0, 0.05);
    EXPECT_LT(coarse.coarse_facets.size(), coarse.facets.size() / 4);
    const auto c = static_cast<double>(painted(draw(coarse, {}, 200, 200, true)));
    EXPECT_NEAR(c / a, 1.0, 0.15);
    EXPECT_NE(b, c);
}

TEST_F(MeshPicture, NeverHasMoreFacetsThanAViewCanDrawInTime) {
    // A rugged ball with every facet in a cell of its own.
    constexpr int kRound = 500;
    const auto at = [](int row, int column) {
        const double up_rad = kPi * row / kRound;
        const double round_rad = 2.0 * kPi * column / kRound;
        const double radius = 100.0 + 2.0 * ((row + column) % 2);
        return shapes::Point{radius * std::sin(up_rad) * std::cos(round_rad),
                             radius * std::sin(up_rad) * std::sin(round_rad), radius * std::cos(up_rad)};
    };
    shapes::Builder ball;
    for (int row = 0; row < kRound; ++row) {
        for (int column = 0; column < kRound; ++column)
            ball.quad(at(row, column), at(row, column + 1), at(row + 1, column + 1), at(row + 1, column));
    }
    const MeshScene scene = make_mesh_scene(ball.mesh(), 1000);
    EXPECT_LT(scene.facets.size(), 200'000U);
    EXPECT_GT(scene.facets.size(), 50'000U);
    EXPECT_LT(scene.coarse_facets.size(), scene.facets.size());
}

TEST_F(MeshPicture, LooksFromTheRightAndKnowsWhatStandsInFront) {
    MeshScene scene;
    // Two squares that face +x: the near one small, at x = 1.
    scene.vertices = {{1, -1, -1}, {1, 1, -1}, {1, 0, 1}, {-1, -2, -2}, {-1, 2, -2}, {-1, 0, 2}};
    scene.facets = {{3, 4, 5}, {0, 1, 2}};
    scene.size = {2, 4, 4};
    SceneView view;  // from +x: +y to the right, z up
    const SceneCamera camera{scene.size, view, 100, 100};
    const auto right = camera.project({0.0, 1.0, 0.0});
    const auto high = camera.project({0.0, 0.0, 1.0});
    const auto near = camera.project({1.0, 0.0, 0.0});
    EXPECT_GT(right[0], 50.0);
    EXPECT_LT(high[1], 50.0);
    EXPECT_GT(near[2], 0.0);
    scene.facets = {{0, 1, 2}, {3, 4, 5}};
    const auto one = draw(scene, view, 50, 50);
    std::swap(scene.facets[0], scene.facets[1]);
    EXPECT_EQ(draw(scene, view, 50, 50).argb, one.argb);
}

TEST(AxisTriad, StandsWhereItIsWantedAndPointsAsTheFileDoes) {
    for (const slice::Up up : {slice::Up::x, slice::Up::y, slice::Up::z}) {
        SceneView view;
        view.azimuth_rad = -kPi / 2.0;  // from the front: placed x to the right, z up
        view.zoom = 3.0;
        view.pan_x = 0.2;
        view.up = up;
        const SceneCamera camera{{10.0, 20.0, 30.0}, view, 400.0, 300.0};
        const auto axes = axis_triad(camera, up, 350.0, 260.0, 25.0, 0);
        const auto from = slice::source_coordinate(up);
        for (std::size_t k = 0; k < 3; ++k) {
            const auto begin = camera.project(axes[from[k]].from);
            const auto end = camera.project(axes[from[k]].to);
            EXPECT_NEAR(begin[0], 350.0, 1e-9);
            EXPECT_NEAR(begin[1], 260.0, 1e-9);
            EXPECT_NEAR(end[0] - begin[0], k == 0 ? 25.0 : 0.0, 1e-9);
            EXPECT_NEAR(end[1] - begin[1], k == 2 ? -25.0 : 0.0, 1e-9) << "down is more";
        }
    }
}

}  // namespace
}  // namespace psicarve::session
