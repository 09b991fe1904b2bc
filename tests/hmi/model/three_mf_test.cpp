// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "hmi/model/load_mesh.hpp"
#include "hmi/model/mesh.hpp"
#include "shared/base/result.hpp"
#include "tests/hmi/model/shapes.hpp"
#include "tests/hmi/model/three_mf_files.hpp"

namespace psicarve::model {
namespace {

using mesh_files::box_object;
using mesh_files::component;
using mesh_files::components;
using mesh_files::Folder;
using mesh_files::item;
using mesh_files::object;
using mesh_files::three_mf_archive;
using mesh_files::three_mf_model;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

Mesh loaded(const std::string& bytes) {
    const Folder folder;
    auto mesh = load_mesh(folder.write("a.3mf", bytes));
    EXPECT_TRUE(mesh.has_value()) << (mesh ? "" : mesh.error().message);
    return mesh ? std::move(*mesh) : Mesh{};
}
Mesh loaded_model(const std::string& resources, const std::string& build) {
    return loaded(three_mf_archive(three_mf_model(resources, build)).bytes());
}

TEST(ThreeMf, EveryUnitBecomesMillimetres) {
    const std::pair<const char*, double> units[] = {
        {"unit=\"micron\"", 0.001},  {"unit=\"millimeter\"", 1.0}, {"", 1.0},
        {"unit='centimeter'", 10.0}, {"unit=\"inch\"", 25.4},      {"xml:lang=\"en\" unit=\"foot\"", 304.8},
        {"unit=\"meter\"", 1000.0}};
    for (const auto& [unit, mm] : units) {
        const Mesh sut = loaded(three_mf_archive(three_mf_model(box_object(1), item(1), unit)).bytes());
        EXPECT_NEAR(sut.facts.max[2], 3.0 * mm, 1e-6 * mm) << unit;
    }
}

TEST(ThreeMf, AUnitThatIsNoMillimetreIsNamed) {
    const auto bytes = three_mf_archive(three_mf_model(box_object(1), item(1), "unit=\"inch\"")).bytes();
    EXPECT_EQ(loaded(bytes).format, "3MF, unit inch");
    EXPECT_EQ(loaded_model(box_object(1), item(1)).format, "3MF");
}

TEST(ThreeMf, ComponentsAreMovedByTheirOwnTransformAndThenByTheirParents) {
    // A quarter turn about z takes +x to +y; the component is moved by 10 in x before it.
    const std::string parts = box_object(1) + object(2, components(component(1, "1 0 0 0 1 0 0 0 1 10 0 0")));
    const Mesh sut = loaded_model(parts, item(2, "0 1 0 -1 0 0 0 0 1 0 0 5"));
    EXPECT_THAT(sut.facts.min, ElementsAre(-2.0, 10.0, 5.0));
    EXPECT_THAT(sut.facts.max, ElementsAre(0.0, 11.0, 8.0));
}

TEST(ThreeMf, ComponentsOfComponentsAddUpTheirTransforms) {
    std::string parts = box_object(1);
    for (int id = 2; id <= 20; ++id) {
        parts += object(id, components(component(id - 1, "1 0 0 0 1 0 0 0 1 0 0 7")));
    }
    const Mesh sut = loaded_model(parts, item(20));
    EXPECT_EQ(sut.triangles.size(), 12U);
    EXPECT_EQ(sut.facts.min[2], 19 * 7.0);
}

TEST(ThreeMf, EveryItemOfTheBuildIsPlaced) {
    const Mesh sut = loaded_model(
        box_object(1), item(1) + item(1, "1 0 0 0 1 0 0 0 1 20 0 0") + item(1, "2 0 0 0 2 0 0 0 2 0 30 0"));
    EXPECT_EQ(sut.triangles.size(), 36U);
    EXPECT_THAT(sut.facts.max, ElementsAre(21.0, 34.0, 6.0));
    EXPECT_NEAR(sut.facts.signed_volume, 6.0 + 6.0 + 48.0, 1e-4);
}

TEST(ThreeMf, AMirroredObjectKeepsItsOutside) {
    const Mesh sut = loaded_model(box_object(1), item(1, "-1 0 0 0 1 0 0 0 1 0 0 0"));
    EXPECT_NEAR(sut.facts.signed_volume, 6.0, 1e-9);
    EXPECT_TRUE(sut.warnings.empty());
}

TEST(ThreeMf, OnlyWhatTheBuildNamesIsMade) {
    const std::string parts = box_object(1) + object(2, mesh_files::three_mf_mesh(shapes::sphere(40, 9, 9)));
    EXPECT_EQ(loaded_model(parts, item(1)).triangles.size(), 12U);
}

TEST(ThreeMf, ObjectsMayStandInPartsWhoseOwnBuildsDoNotCount) {
    const std::string inner = "<component objectid=\"1\" p:path=\"/3D/Objects/one.model\"/>";
    auto zip = three_mf_archive(three_mf_model(object(7, components(inner)), item(7), "unit=\"centimeter\""));
    zip.add("3D/Objects/one.model", three_mf_model(box_object(1), item(1)));
    const Mesh sut = loaded(zip.bytes());
    EXPECT_NEAR(sut.facts.max[2], 30.0, 1e-5);
    EXPECT_EQ(sut.triangles.size(), 12U);
}

TEST(ThreeMf, WithoutRelationsTheModelStandsAtItsUsualPlace) {
    mesh_files::Zip zip;
    zip.add("3D/3dmodel.model", three_mf_model(box_object(1), item(1)));
    EXPECT_EQ(loaded(zip.bytes()).triangles.size(), 12U);
}

TEST(ThreeMf, VerticesOfExtensionsAreNoSurface) {
    const std::string slices =
        "<s:slicestack xmlns:s=\"urn:other\"><s:vertex x=\"1\" y=\"1\"/></s:slicestack>";
    EXPECT_EQ(loaded_model(box_object(1) + slices, item(1)).triangles.size(), 12U);
}

TEST(ThreeMf, FewNanCoordinatesAreLeftOutAndCounted) {
    const Mesh cylinder = shapes::cylinder(10.0, 0.0, 20.0, 60);
    std::string mesh = mesh_files::three_mf_mesh(cylinder);
    mesh.replace(mesh.find("x=\"10\""), 6, "x=\"nan\"");
    const Mesh sut = loaded_model(object(1, mesh), item(1));
    EXPECT_EQ(sut.facts.dropped_count, 1U);
    EXPECT_THAT(sut.warnings, Contains(HasSubstr("1 facet with a NaN or infinite coordinate")));
}

TEST(ThreeMf, AModelFarFromItsOriginKeepsItsDigits) {
    const Mesh sut = loaded_model(box_object(1), item(1, "1 0 0 0 1 0 0 0 1 5000000.25 0 0"));
    EXPECT_EQ(sut.facts.min[0], 5'000'000.25);
    EXPECT_EQ(sut.facts.max[0], 5'000'001.25);
}

}  // namespace
}  // namespace psicarve::model
