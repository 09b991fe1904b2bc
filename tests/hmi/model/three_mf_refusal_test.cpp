// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "hmi/model/load_mesh.hpp"
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
using mesh_files::refusal;
using mesh_files::refusal_of_xml;
using mesh_files::three_mf_archive;
using mesh_files::three_mf_model;
using mesh_files::Zip;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::string refusal_of_model(const std::string& resources, const std::string& build) {
    return refusal_of_xml(three_mf_model(resources, build));
}
std::string refusal_of_vertices(const std::string& vertices) {
    return refusal_of_model(object(1, "<mesh><vertices>" + vertices + "</vertices></mesh>"), item(1));
}
/// Three vertices, and in the next line a triangle with this as its third corner.
std::string refusal_of_corner(const std::string& corner) {
    const std::string mesh =
        "<mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"0\" z=\"0\"/>"
        "<vertex x=\"0\" y=\"1\" z=\"0\"/></vertices>\n<triangles><triangle v1=\"0\" v2=\"1\" v3=\"" +
        corner + "\"/></triangles></mesh>";
    return refusal_of_model(object(1, mesh), item(1));
}

TEST(ThreeMfRefusal, AnUnknownUnit) {
    EXPECT_THAT(refusal_of_xml(three_mf_model(box_object(1), item(1), "unit=\"light year\"")),
                HasSubstr("'/3D/model.model' line 2: 'light year' is not a unit of 3MF"));
}

TEST(ThreeMfRefusal, ATriangleWhoseVertexIsNotThere) {
    EXPECT_THAT(refusal_of_corner("3"),
                HasSubstr("'/3D/model.model' line 4: triangle 0 of object 1 names vertex 3, there are 3"));
    for (const char* corner : {"-1", "1.5", "two", "", "99999999999999999999"}) {
        EXPECT_THAT(refusal_of_corner(corner),
                    HasSubstr("line 4: v3='" + std::string(corner) + "' is no number"));
    }
    EXPECT_THAT(refusal_of_corner("4294967296"), HasSubstr("names vertex 4294967296, there are 3"));
}

TEST(ThreeMfRefusal, VerticesThatAreNoNumbers) {
    EXPECT_THAT(refusal_of_vertices("<vertex x=\"0\" y=\"one\" z=\"0\"/>"),
                HasSubstr("'one' is not a number"));
    EXPECT_THAT(refusal_of_vertices("<vertex x=\"0\" y=\"1\"/>"), HasSubstr("a vertex without z"));
    EXPECT_THAT(refusal_of_xml(three_mf_model("<vertex x=\"0\" y=\"0\" z=\"0\"/>", item(1))),
                HasSubstr("a vertex outside of an object"));
}

TEST(ThreeMfRefusal, ManyNanCoordinates) {
    const std::string nowhere = item(1, "nan 0 0 0 1 0 0 0 1 0 0 0");
    EXPECT_THAT(refusal_of_model(box_object(1), nowhere), HasSubstr("12 of 12 facets have NaN or infinite"));
    EXPECT_THAT(refusal_of_model(box_object(1), item(1, "1 0 0 0 1 0 0 0 1 0 0 1e999")),
                HasSubstr("12 of 12 facets have NaN or infinite"));
}

TEST(ThreeMfRefusal, ObjectsThatAreNotThereOrThereTwice) {
    EXPECT_THAT(refusal_of_model(box_object(1), item(8)), HasSubstr("object 8 is not in the archive"));
    EXPECT_THAT(refusal_of_model(box_object(1) + box_object(1), item(1)),
                HasSubstr("object 1 stands there twice"));
    EXPECT_THAT(refusal_of_model(box_object(1), item(1, "1 0 0")), HasSubstr("needs 12 numbers"));
    EXPECT_THAT(refusal_of_model(box_object(1), ""), HasSubstr("no facets"));
}

TEST(ThreeMfRefusal, PartsThatAreNotThereWhateverTheyAreCalled) {
    const std::string away = "<component objectid=\"1\" p:path=\"/3D/a&#10;&#x9b;2J.model\"/>";
    EXPECT_THAT(refusal_of_model(object(7, components(away)), item(7)),
                HasSubstr("there is no part '/3D/a???2J.model' of the archive"));
}

TEST(ThreeMfRefusal, ObjectsThatAreMadeOfThemselves) {
    EXPECT_THAT(refusal_of_model(object(1, components(component(1))), item(1)),
                HasSubstr("object 1 stands more than 32 deep in others, or in itself"));
    EXPECT_THAT(
        refusal_of_model(object(1, components(component(2))) + object(2, components(component(1))), item(1)),
        HasSubstr("or in itself"));
}

TEST(ThreeMfRefusal, ObjectsThatMultiply) {
    std::string doubling = box_object(1);
    for (int id = 2; id <= 32; ++id) {
        doubling += object(id, components(component(id - 1) + component(id - 1)));
    }
    EXPECT_THAT(refusal_of_model(doubling, item(32)), HasSubstr("multiply to more than can be carved"));
    std::string many;
    for (int i = 0; i < 1000; ++i) many += item(1);
    std::string large = "<mesh><vertices>";
    for (int i = 0; i < 100'100; ++i) large += "<vertex x=\"0\" y=\"0\" z=\"0\"/>";
    EXPECT_THAT(refusal_of_model(object(1, large + "</vertices></mesh>"), many), HasSubstr("multiply"));
}

TEST(ThreeMfRefusal, WhatIsNoZipArchive) {
    EXPECT_THAT(refusal("This is a letter, not a model.\n"),
                HasSubstr("is no 3MF file: these are zip archives"));
    const std::string whole = mesh_files::three_mf(shapes::box({0, 0, 0}, {1, 2, 3}));
    EXPECT_THAT(refusal(whole.substr(0, whole.size() - 10)), HasSubstr("truncated or damaged"));
    EXPECT_THAT(refusal(std::string("PK\x03\x04") + std::string(500, 'x')),
                HasSubstr("truncated or damaged"));
}

TEST(ThreeMfRefusal, AnArchiveWithoutAModel) {
    Zip letter;
    letter.add("letter.txt", "Dear reader\n");
    EXPECT_THAT(refusal(letter.bytes()), HasSubstr("is a zip archive, but holds no 3MF model"));
    EXPECT_THAT(refusal(mesh_files::three_mf_surroundings().bytes()), HasSubstr("holds no 3MF model"));
}

TEST(ThreeMfRefusal, XmlThatIsCutOrNone) {
    EXPECT_THAT(refusal_of_xml("<model"), HasSubstr("the XML ends too early"));
    EXPECT_THAT(refusal_of_xml(""), HasSubstr("the XML ends too early"));
    const std::string model = three_mf_model(box_object(1), item(1));
    EXPECT_THAT(refusal_of_xml(model.substr(0, model.size() / 2)), HasSubstr("the XML ends too early"));
    EXPECT_THAT(refusal_of_xml("<model></mode>"), HasSubstr("line 1: this is not well-formed XML"));
    EXPECT_THAT(refusal_of_xml(std::string("\x00\x01\x02\xff", 4)), HasSubstr("not well-formed XML"));
}

TEST(ThreeMfRefusal, DamagedParts) {
    std::string flipped = mesh_files::three_mf(shapes::box({0, 0, 0}, {1, 2, 3}));
    flipped[flipped.find("<vertex x=") + 11] = '7';
    EXPECT_THAT(refusal(flipped), HasSubstr("part '/3D/model.model' of the archive is damaged"));
}

TEST(ThreeMfRefusal, EncryptedParts) {
    Zip zip = mesh_files::three_mf_surroundings();
    zip.add("3D/model.model", std::string(200, 'x'), {.flags = 1, .unpacked_bytes = 188});
    EXPECT_THAT(refusal(zip.bytes()),
                HasSubstr("part '/3D/model.model' of the archive is encrypted: save it without a password"));
}

TEST(ThreeMfRefusal, PartsPackedInAWayThat3mfDoesNotKnow) {
    Zip zip = mesh_files::three_mf_surroundings();
    constexpr std::uint32_t kLzma = 14;
    // LZMA begins with the size of the dictionary that is to be allocated: here four gigabytes.
    zip.add("3D/model.model", std::string("\x09\x14\x05\x00\x5d\xff\xff\xff\xff", 9) + std::string(90, 'x'),
            {.method = kLzma, .unpacked_bytes = 1000});
    EXPECT_THAT(refusal(zip.bytes()), HasSubstr("is packed in a way that 3MF does not allow"));
}

}  // namespace
}  // namespace psicarve::model
