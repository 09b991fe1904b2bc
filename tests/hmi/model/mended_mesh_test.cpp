// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <string>
#include <utility>

#include "hmi/model/edge_count.hpp"
#include "hmi/model/load_mesh.hpp"
#include "hmi/model/mesh.hpp"
#include "tests/hmi/model/mesh_files.hpp"
#include "tests/hmi/model/shapes.hpp"

namespace psicarve::model {
namespace {

using mesh_files::Folder;
using testing::ElementsAre;
using testing::IsEmpty;

Mesh cylinder() {
    return shapes::cylinder(10.0, 0.0, 20.0, 60);
}  // 240 facets

Mesh loaded(const std::string& bytes, const std::string& name = "a.stl") {
    const Folder folder;
    auto mesh = load_mesh(folder.write(name, bytes));
    EXPECT_TRUE(mesh.has_value()) << (mesh ? "" : mesh.error().message);
    return mesh ? std::move(*mesh) : Mesh{};
}

TEST(DuplicateFacets, OneIsLeftOutAndLeavesNoHole) {
    Mesh mesh = cylinder();
    mesh.triangles.push_back(mesh.triangles[17]);
    const Mesh sut = loaded(mesh_files::binary_stl(mesh));
    EXPECT_EQ(sut.facts.duplicate_count, 1U);
    EXPECT_EQ(sut.triangles.size(), 240U);
    EXPECT_TRUE(sut.facts.closed);
    EXPECT_THAT(sut.warnings, ElementsAre("1 facet stands in the file once more; left out"));
}

TEST(DuplicateFacets, AMeshThatStandsThereTwiceIsTakenOnce) {
    const Mesh once = shapes::sphere(10.0, 40, 50);
    const Mesh twice = shapes::Builder().add(once).add(once).mesh();
    const Mesh sut = loaded(mesh_files::binary_stl(twice));
    EXPECT_EQ(sut.facts.duplicate_count, once.triangles.size());
    EXPECT_EQ(sut.triangles.size(), once.triangles.size());
    EXPECT_NEAR(sut.facts.signed_volume, loaded(mesh_files::binary_stl(once)).facts.signed_volume, 1e-6);
    EXPECT_TRUE(sut.facts.closed && sut.facts.same_orientation);
}

TEST(DuplicateFacets, CornersInAnotherOrderAreTheSameFacet) {
    Mesh mesh = cylinder();
    Triangle again = mesh.triangles[17];
    std::rotate(again.vertices.begin(), again.vertices.begin() + 1, again.vertices.end());
    mesh.triangles.push_back(again);
    EXPECT_EQ(loaded(mesh_files::binary_stl(mesh)).facts.duplicate_count, 1U);
}

TEST(DuplicateFacets, OfASurfaceWrittenWithBothSidesOneIsTaken) {
    Mesh mesh = shapes::sphere(10.0, 40, 50);
    const std::size_t once = mesh.triangles.size();
    for (std::size_t i = 0; i < once; ++i) {
        Triangle back = mesh.triangles[i];
        std::swap(back.vertices[0], back.vertices[1]);
        mesh.triangles.push_back(back);
    }
    const Mesh sut = loaded(mesh_files::binary_stl(mesh));
    EXPECT_EQ(sut.triangles.size(), once);
    EXPECT_GT(sut.facts.signed_volume, 1000.0);
}

TEST(DuplicateFacets, AWallBetweenTwoBodiesStays) {
    const Mesh boxes = shapes::Builder()
                           .add(shapes::box({0, 0, 0}, {4, 4, 4}))
                           .add(shapes::box({4, 0, 0}, {8, 4, 4}))
                           .mesh();
    const Mesh sut = loaded(mesh_files::binary_stl(boxes));
    EXPECT_EQ(sut.triangles.size(), 24U);
    EXPECT_EQ(sut.facts.duplicate_count, 0U);
}

/// The mesh with every corner of every facet moved by itself, by at most so much.
Mesh shaken(Mesh mesh, double by) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> noise(-by, by);
    for (Triangle& t : mesh.triangles) {
        for (auto& v : t.vertices) {
            for (float& c : v) c = static_cast<float>(double{c} + noise(random));
        }
    }
    return mesh;
}

TEST(Holes, WhatRoundingTearsApartIsNone) {
    for (const double noise : {1e-15, 1e-12, 1e-9, 5e-7}) {
        const Mesh sut = loaded(mesh_files::binary_stl(shaken(cylinder(), noise)));
        EXPECT_EQ(sut.facts.open_edge_count, 0U) << noise;
        EXPECT_TRUE(sut.facts.closed) << noise;
        EXPECT_THAT(sut.warnings, IsEmpty()) << noise;
    }
}

// Else a direction that falls into the tear would meet no surface and be carved down to the core.
TEST(Holes, WhatRoundingTearsApartIsJoined) {
    for (const double noise : {1e-15, 1e-12, 1e-9, 5e-7}) {
        const Mesh sut = loaded(mesh_files::binary_stl(shaken(cylinder(), noise)));
        EXPECT_EQ(count_edges(sut.triangles).open, 0U) << noise;
    }
}

TEST(Holes, BesideAHoleWhatRoundingTearsApartIsJoinedToo) {
    Mesh mesh = shaken(cylinder(), 1e-9);
    mesh.triangles.erase(mesh.triangles.begin() + 8);
    EXPECT_EQ(count_edges(loaded(mesh_files::binary_stl(mesh)).triangles).open, 3U);
}

TEST(Holes, AGapThatIsWiderThanRoundingIsOne) {
    EXPECT_GT(loaded(mesh_files::binary_stl(shaken(cylinder(), 1e-3))).facts.open_edge_count, 100U);
    Mesh mesh = shaken(cylinder(), 1e-12);
    mesh.triangles.erase(mesh.triangles.begin() + 8);
    EXPECT_EQ(loaded(mesh_files::binary_stl(mesh)).facts.open_edge_count, 3U);
}

TEST(CoordinateStep, IsThatOfTheFilesFloats) {
    const Mesh far = shapes::moved(cylinder(), [](const shapes::Point& p) {
        return shapes::Point{p[0] + 100'000.0, p[1], p[2]};
    });
    constexpr double kStep = 0x1p-7;  // from 65536 to 131072
    EXPECT_EQ(loaded(mesh_files::binary_stl(far)).facts.coordinate_step, kStep);
    EXPECT_EQ(loaded(mesh_files::binary_ply(far, false), "a.ply").facts.coordinate_step, kStep);
    EXPECT_LT(loaded(mesh_files::binary_stl(cylinder())).facts.coordinate_step, 1e-5);
    EXPECT_EQ(loaded(mesh_files::obj(far), "a.obj").facts.coordinate_step, 0.0);
}

}  // namespace
}  // namespace psicarve::model
