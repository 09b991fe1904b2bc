// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of joining "spiral".
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "hmi/model/load_mesh.hpp"
#include "hmi/model/mesh.hpp"
#include "shared/base/units.hpp"
#include "shared/job/job.hpp"
#include "shared/profile/profile.hpp"
#include "tests/hmi/cam/built_job.hpp"
#include "tests/hmi/model/shapes.hpp"
#include "tests/hmi/slice/oracle.hpp"
#include "tests/places.hpp"

namespace psicarve::cam {
namespace {

/// Every point of a spiral against the definition of r(theta, h) at its own direction and height.
void expect_spiral_as_defined(const std::string& path, const Profile& profile, double axis_x_mm,
                              std::uint32_t layers, std::uint32_t points) {
    const auto mesh = model::load_mesh(path);
    ASSERT_TRUE(mesh.has_value());
    JobOptions options = small(layers, points);
    options.joining = Joining::spiral;
    options.axis_at = AxisAt::point;
    options.axis_x = mesh->facts.min[0] + axis_x_mm;
    options.axis_y = 0.5 * (mesh->facts.min[1] + mesh->facts.max[1]);
    const JobTable sut = built(*mesh, profile, options).table;
    ASSERT_EQ(sut.layer_count, layers + 1);
    const double low = mesh->facts.min[2];
    const double height = mesh->facts.max[2] - low;
    const auto layer_height = [&](std::uint32_t layer) { return low + (layer + 0.5) * height / layers; };
    int wrong = 0;
    for (std::uint32_t row = 0; row <= layers; ++row) {
        const double bottom = layer_height(row == 0 ? 0 : row - 1);
        const double top = layer_height(std::min(row, layers - 1));
        for (std::uint32_t point = 0; point < points; ++point) {
            const double z = bottom + (top - bottom) * point / (points - 1.0);
            const double psi =
                rad_from_pulses(table_angle_pulses(Joining::spiral, sut.psi_sweep_pulses, points, row, point),
                                profile.psi.pulses_per_rev);
            const auto wanted = [&](double angle, double at, const LinearAxisProfile& head) {
                const double radius =
                    oracle::radius(*mesh, options.axis_x - mesh->origin[0], options.axis_y - mesh->origin[1],
                                   angle, at - mesh->origin[2]);
                return pulses_from_mm(std::max(radius, profile.core_radius_mm), head.pulses_per_mm);
            };
            const double error = rad_from_deg(profile.head_r2_angle_error_deg);
            const std::int64_t r1 = wanted(psi, z, profile.r1);
            const std::int64_t r2 =
                wanted(psi + kPi + error, z + profile.head_r2_height_error_mm, profile.r2);
            wrong += std::abs(left(sut, row, point) - r1) > 1 || std::abs(right(sut, row, point) - r2) > 1;
        }
    }
    EXPECT_EQ(wrong, 0) << path;
    const std::vector<std::byte> blob = job_blob_from_table(sut);
    const auto accepted = check_job(JobView::check(blob).value(), profile);
    EXPECT_TRUE(accepted.has_value()) << (accepted ? "" : accepted.error().message);
}

TEST(Spiral, IsExactToAPulseAtEveryPointsOwnHeightAndDirection) {
    Profile crooked;
    crooked.head_r2_angle_error_deg = 1.3;
    crooked.head_r2_height_error_mm = 0.21;
    crooked.head_clearance_mm = 0.0;
    for (const Profile& profile : {Profile{}, crooked}) {
        expect_spiral_as_defined(example("small.stl"), profile, 10.0, 9, 48);
        expect_spiral_as_defined(example("letter.stl"), profile, 9.0, 7, 33);
    }
    expect_spiral_as_defined(example("letter.stl"), Profile{}, 9.0, 2, 2);
}

TEST(Spiral, JoinsItsRowsAndClosesWithARingAtBothEnds) {
    JobOptions options = small(4, 17);
    options.joining = Joining::spiral;
    const BuiltJob spiral = built(shapes::figurine(50.0, 60, 70), Profile{}, options);
    const BuiltJob layers = built(shapes::figurine(50.0, 60, 70), Profile{}, small(4, 17));
    const JobTable& sut = spiral.table;
    ASSERT_EQ(sut.layer_count, 5U);
    EXPECT_EQ(spiral.report.layers, 5U);
    for (std::size_t row = 1; row < 5; ++row) {
        EXPECT_EQ(left(sut, row, 0), left(sut, row - 1, 16));
        EXPECT_EQ(right(sut, row, 0), right(sut, row - 1, 16));
    }
    for (std::size_t point = 0; point < 17; ++point) {
        EXPECT_EQ(left(sut, 0, point), left(layers.table, 0, point));
        // Half a turn further than layer 3 of the rings: R2 is where R1 was.
        EXPECT_EQ(right(sut, 4, point), left(layers.table, 3, point));
    }
}

TEST(Spiral, OfOneLayerIsOneRing) {
    JobOptions options = small(1, 9);
    options.joining = Joining::spiral;
    const JobTable sut = built(oblong(), Profile{}, options).table;
    EXPECT_EQ(sut.layer_count, 1U);
    EXPECT_EQ(sut.r_left_pulses, built(oblong(), Profile{}, small(1, 9)).table.r_left_pulses);
}

TEST(Spiral, IsTheSameForAnyNumberOfThreads) {
    JobOptions options = small(23, 40);
    options.joining = Joining::spiral;
    const model::Mesh mesh = shapes::figurine(50.0, 60, 70);
    const JobTable one = built(mesh, Profile{}, options).table;
    options.thread_count = 3;
    const JobTable three = built(mesh, Profile{}, options).table;
    EXPECT_EQ(one.r_left_pulses, three.r_left_pulses);
    EXPECT_EQ(one.r_right_pulses, three.r_right_pulses);
    EXPECT_EQ(one.report_json, three.report_json);
}

TEST(Spiral, CountsOpenPointsButNotWhereTheAxisLeavesTheSolid) {
    JobOptions options = small(10, 97);
    options.joining = Joining::spiral;
    model::Mesh mesh = shapes::cylinder(10.0, 0.0, 20.0, 24);
    EXPECT_EQ(built(mesh, Profile{}, options).report.open_points, 0U);
    mesh.triangles.erase(mesh.triangles.begin() + 4);
    EXPECT_GT(built(mesh, Profile{}, options).report.open_points, 0U);
    options.axis_at = AxisAt::origin;
    const model::Mesh hollow = shapes::Builder()
                                   .add(shapes::box({-6, -6, 0}, {6, 6, 5}))
                                   .add(shapes::box({2, -6, 5}, {6, 6, 12}))
                                   .mesh();
    const BuiltJob sut = built(hollow, Profile{}, options);
    EXPECT_GT(sut.report.layers_without_axis, 0U);
    EXPECT_EQ(sut.report.open_points, 0U);
}

}  // namespace
}  // namespace psicarve::cam
