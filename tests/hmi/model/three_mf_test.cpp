// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "hmi/model/load_mesh.hpp"
#include "hmi/model/mesh.hpp"
#include "shared/result.hpp"
#include "tests/hmi/model/mesh_files.hpp"
#include "tests/hmi/model/shapes.hpp"

namespace psicarve::model {
namespace {

using mesh_files::Folder;
using mesh_files::three_mf_archive;
using mesh_files::three_mf_model;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::string object(int id, const std::string& content) {
    return "<object id=\"" + std::to_string(id) + "\">" + content + "</object>";
}
std::string box_object(int id) {
    return object(id, mesh_files::three_mf_mesh(shapes::box({0, 0, 0}, {1, 2, 3})));
}
const std::string kItem = "<item objectid=\"1\"/>";

Mesh loaded(const std::string& bytes) {
    const Folder folder;
    auto mesh = load_mesh(folder.write("a.3mf", bytes));
    EXPECT_TRUE(mesh.has_value()) << (mesh ? "" : mesh.error().message);
    return mesh ? std::move(*mesh) : Mesh{};
}

/// What is said about an archive that is refused.
std::string refusal(const std::string& bytes) {
    const Folder folder;
    const std::string path = folder.write("a.3mf", bytes);
    const auto mesh = load_mesh(path);
    if (mesh) return "";
    EXPECT_EQ(mesh.error().code, ErrorCode::bad_input);
    EXPECT_THAT(mesh.error().message, StartsWith(path + ": "));
    EXPECT_THAT(mesh.error().message, Not(HasSubstr("\n")));
    return mesh.error().message;
}
std::string refusal_of_model(const std::string& resources, const std::string& build) {
    return refusal(three_mf_archive(three_mf_model(resources, build)).bytes());
}

TEST(ThreeMf, EveryUnitBecomesMillimetres) {
    const std::pair<const char*, double> units[] = {
        {"unit=\"micron\"", 0.001},    {"unit=\"millimeter\"", 1.0}, {"", 1.0},
        {"unit=\"centimeter\"", 10.0}, {"unit=\"inch\"", 25.4},      {"unit=\"foot\"", 304.8},
        {"unit=\"meter\"", 1000.0}};
    for (const auto& [unit, mm] : units) {
        const Mesh sut = loaded(three_mf_archive(three_mf_model(box_object(1), kItem, unit)).bytes());
        EXPECT_NEAR(sut.facts.max[2], 3.0 * mm, 1e-6 * mm) << unit;
    }
}

TEST(ThreeMf, AnUnknownUnitIsRefused) {
    const auto bytes = three_mf_archive(three_mf_model(box_object(1), kItem, "unit=\"parsec\"")).bytes();
    EXPECT_THAT(refusal(bytes), HasSubstr("line 2: 'parsec' is not a unit of 3MF"));
}

TEST(ThreeMf, ComponentsAreMovedByTheirOwnTransformAndThenByTheirParents) {
    // A quarter turn about z takes +x to +y; the component is moved by 10 in x before it.
    const std::string parts =
        box_object(1) +
        object(2,
               "<components><component objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 10 0 0\"/></components>");
    const std::string item = "<item objectid=\"2\" transform=\"0 1 0 -1 0 0 0 0 1 0 0 5\"/>";
    const Mesh sut = loaded(three_mf_archive(three_mf_model(parts, item)).bytes());
    EXPECT_THAT(sut.facts.min, ElementsAre(-2.0, 10.0, 5.0));
    EXPECT_THAT(sut.facts.max, ElementsAre(0.0, 11.0, 8.0));
}

TEST(ThreeMf, AMirroredObjectKeepsItsOutside) {
    const std::string item = "<item objectid=\"1\" transform=\"-1 0 0 0 1 0 0 0 1 0 0 0\"/>";
    const Mesh sut = loaded(three_mf_archive(three_mf_model(box_object(1), item)).bytes());
    EXPECT_NEAR(sut.facts.signed_volume, 6.0, 1e-9);
}

TEST(ThreeMf, OnlyWhatTheBuildNamesIsMade) {
    const std::string parts = box_object(1) + object(2, mesh_files::three_mf_mesh(shapes::sphere(40, 9, 9)));
    EXPECT_EQ(loaded(three_mf_archive(three_mf_model(parts, kItem)).bytes()).triangles.size(), 12U);
    EXPECT_THAT(refusal_of_model(parts, ""), HasSubstr("no facets"));
}

TEST(ThreeMf, ObjectsMayStandInParts) {
    auto zip = three_mf_archive(three_mf_model(
        object(7, "<components><component objectid=\"1\" p:path=\"/3D/Objects/one.model\"/></components>"),
        "<item objectid=\"7\"/>", "unit=\"centimeter\""));
    zip.add("3D/Objects/one.model", three_mf_model(box_object(1), ""));
    EXPECT_NEAR(loaded(zip.bytes()).facts.max[2], 30.0, 1e-5);
}

TEST(ThreeMf, ExtensionsVerticesAreNoSurface) {
    const std::string model = three_mf_model(
        box_object(1) + "<s:slicestack xmlns:s=\"urn:other\"><s:vertex x=\"1\" y=\"1\"/></s:slicestack>",
        kItem);
    EXPECT_EQ(loaded(three_mf_archive(model).bytes()).triangles.size(), 12U);
}

TEST(ThreeMf, ATriangleWhoseVertexIsNotThereIsRefused) {
    const std::string mesh =
        "<mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"0\" z=\"0\"/>"
        "<vertex x=\"0\" y=\"1\" z=\"0\"/></vertices>\n<triangles><triangle v1=\"0\" v2=\"1\" v3=\"3\"/>"
        "</triangles></mesh>";
    EXPECT_THAT(refusal_of_model(object(1, mesh), kItem),
                HasSubstr("/3D/model.model line 4: triangle 0 of object 1 names vertex 3, there are 3"));
}

TEST(ThreeMf, WhatIsMissingOrNoNumberIsNamed) {
    EXPECT_THAT(
        refusal_of_model(object(1, "<mesh><vertices><vertex x=\"0\" y=\"one\" z=\"0\"/></vertices></mesh>"),
                         kItem),
        HasSubstr("'one' is not a number"));
    EXPECT_THAT(
        refusal_of_model(object(1, "<mesh><vertices><vertex x=\"0\" y=\"1\"/></vertices></mesh>"), kItem),
        HasSubstr("a vertex without z"));
    EXPECT_THAT(refusal_of_model(box_object(1), "<item objectid=\"8\"/>"), HasSubstr("object 8 is not in"));
    EXPECT_THAT(refusal_of_model(box_object(1), "<item objectid=\"1\" transform=\"1 0 0\"/>"),
                HasSubstr("needs 12 numbers"));
    EXPECT_THAT(refusal_of_model(box_object(1) + box_object(1), kItem),
                HasSubstr("object 1 stands there twice"));
}

TEST(ThreeMf, ObjectsThatAreMadeOfThemselvesAreRefused) {
    const std::string loop = object(1, "<components><component objectid=\"1\"/></components>");
    EXPECT_THAT(refusal_of_model(loop, kItem), HasSubstr("object 1 is made of itself"));
    std::string doubling = box_object(1);
    for (int id = 2; id <= 32; ++id) {
        const std::string half = "<component objectid=\"" + std::to_string(id - 1) + "\"/>";
        doubling += object(id, "<components>" + half + half + "</components>");
    }
    EXPECT_THAT(refusal_of_model(doubling, "<item objectid=\"32\"/>"), HasSubstr("multiply"));
}

TEST(ThreeMf, ArchivesThatAreNoneOrHoldNoModelAreRefused) {
    const std::string whole = mesh_files::three_mf(shapes::box({0, 0, 0}, {1, 2, 3}));
    EXPECT_THAT(refusal(whole.substr(0, whole.size() - 10)), HasSubstr("truncated or damaged"));
    EXPECT_THAT(refusal(std::string("PK\x03\x04") + std::string(500, 'x')),
                HasSubstr("truncated or damaged"));
    mesh_files::Zip letter;
    letter.add("letter.txt", "Dear reader\n");
    EXPECT_THAT(refusal(letter.bytes()), HasSubstr("holds no 3MF model"));
    EXPECT_THAT(refusal(three_mf_archive("<model").bytes()), HasSubstr("the XML ends too early"));
    EXPECT_THAT(refusal(three_mf_archive("<model></mode>").bytes()), HasSubstr("not well-formed XML"));
    EXPECT_THAT(refusal(three_mf_archive("").bytes()), HasSubstr("the XML ends too early"));
    std::string flipped = whole;
    flipped[flipped.find("<vertex x=") + 11] = '7';
    EXPECT_THAT(refusal(flipped), HasSubstr("damaged"));
}

}  // namespace
}  // namespace psicarve::model
