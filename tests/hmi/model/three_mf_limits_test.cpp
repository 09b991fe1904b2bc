// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zip.h>

#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>

#include "hmi/model/load_mesh.hpp"
#include "hmi/model/zip_archive.hpp"
#include "shared/base/result.hpp"
#include "tests/hmi/model/shapes.hpp"
#include "tests/hmi/model/three_mf_files.hpp"

namespace psicarve::model {
namespace {

using mesh_files::Folder;
using mesh_files::item;
using mesh_files::little_endian;
using mesh_files::object;
using mesh_files::refusal;
using mesh_files::refusal_of_file;
using mesh_files::refusal_of_xml;
using mesh_files::three_mf_archive;
using mesh_files::three_mf_model;
using mesh_files::Zip;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// An archive that is packed as well as it goes: 1:1000 where one letter repeats.
std::string packed_archive(const Folder& folder, const std::string& model) {
    const std::string path = (folder.path() / "packed.3mf").string();
    struct zip* const archive = zip_open(path.c_str(), ZIP_CREATE | ZIP_TRUNCATE, nullptr);
    zip_source_t* const source = zip_source_buffer(archive, model.data(), model.size(), 0);
    EXPECT_GE(zip_file_add(archive, "3D/3dmodel.model", source, 0), 0);
    EXPECT_EQ(zip_close(archive), 0);
    return path;
}

std::string box_model(const std::string& more_resources = "") {
    const std::string box = mesh_files::three_mf_mesh(shapes::box({0, 0, 0}, {1, 2, 3}));
    return three_mf_model(object(1, box) + more_resources, item(1));
}

std::string blank_lines(std::size_t count) {
    std::string lines;
    lines.resize(count, '\n');
    return lines;
}

TEST(ThreeMfLimits, APackedModelIsRead) {
    const Folder folder;
    const auto sut = load_mesh(packed_archive(folder, box_model(blank_lines(10'000'000))));
    ASSERT_TRUE(sut.has_value()) << sut.error().message;
    EXPECT_EQ(sut->triangles.size(), 12U);
}

TEST(ThreeMfLimits, AnArchiveThatUnpacksToFarMoreThanItselfIsRefused) {
    const Folder folder;
    EXPECT_THAT(refusal_of_file(packed_archive(folder, box_model(blank_lines(70'000'000)))),
                HasSubstr("the archive unpacks to far more than a model needs"));
}

TEST(ThreeMfLimits, WhatThePartsUnpackToIsAddedUp) {
    Zip zip;
    zip.add("a", std::string(600, 'a'));
    zip.add("b", std::string(600, 'b'));
    const std::string bytes = zip.bytes();
    const auto take = [](std::string_view) { return Result<void>(); };
    auto sut = ZipArchive::open(bytes, "a.3mf", {.most_bytes = 1000});
    ASSERT_TRUE(sut.has_value());
    EXPECT_TRUE(sut->read("a", take).has_value());
    EXPECT_THAT(sut->read("b", take).error().message, HasSubstr("far more"));
    auto by_ratio = ZipArchive::open(bytes, "a.3mf", {.free_bytes = 1000, .most_ratio = 0});
    ASSERT_TRUE(by_ratio.has_value());
    EXPECT_TRUE(by_ratio->read("a", take).has_value());
    EXPECT_FALSE(by_ratio->read("b", take).has_value());
}

TEST(ThreeMfLimits, APartThatClaimsGigabytesIsDamaged) {
    const std::string model = box_model();
    Zip zip = mesh_files::three_mf_surroundings();
    zip.add("3D/model.model", model, {.unpacked_bytes = 0xFFFFFFF0U, .crc = mesh_files::crc32(model)});
    EXPECT_THAT(refusal(zip.bytes()), HasSubstr("damaged"));
}

TEST(ThreeMfLimits, ADirectoryThatClaimsEndlessEntriesIsDamaged) {
    const std::string many = little_endian(0xFFFFFFF0U) + little_endian(0xFFFFU);
    const std::string end_64 = std::string("PK\x06\x06") + little_endian(44) + little_endian(0) +
                               little_endian(45, 2) + little_endian(45, 2) + little_endian(0) +
                               little_endian(0) + many + many + many + little_endian(4) + little_endian(0);
    const std::string locator =
        std::string("PK\x06\x07") + little_endian(0) + little_endian(4) + little_endian(0) + little_endian(1);
    const std::string end = std::string("PK\x05\x06") + little_endian(0) + little_endian(0xFFFFU, 2) +
                            little_endian(0xFFFFU, 2) + little_endian(0xFFFFFFFFU) +
                            little_endian(0xFFFFFFFFU) + little_endian(0, 2);
    EXPECT_THAT(refusal("PK\x03\x04" + end_64 + locator + end), HasSubstr("damaged"));
    EXPECT_THAT(refusal("PK\x03\x04" + end), HasSubstr("damaged"));
}

TEST(ThreeMfLimits, DamagedAnywhereAnArchiveIsReadOrRefused) {
    const std::string whole = mesh_files::three_mf(shapes::box({0, 0, 0}, {1, 2, 3}));
    std::mt19937 random(11);
    for (int i = 0; i < 300; ++i) {
        std::string bytes = whole;
        for (int k = 0; k < 3; ++k) bytes[random() % bytes.size()] = static_cast<char>(random());
        refusal(bytes);
    }
    for (std::size_t length = 4; length < whole.size(); length += 31) {
        EXPECT_NE(refusal(whole.substr(0, length)), "") << length;
    }
}

TEST(ThreeMfLimits, EntitiesThatMultiplyAreRefusedBeforeTheyDo) {
    std::string xml = "<?xml version=\"1.0\"?>\n<!DOCTYPE model [<!ENTITY e0 \"0123456789\">";
    for (int i = 1; i < 12; ++i) {
        xml += "<!ENTITY e" + std::to_string(i) + " \"";
        for (int k = 0; k < 10; ++k) xml += "&e" + std::to_string(i - 1) + ";";
        xml += "\">";
    }
    EXPECT_THAT(refusal_of_xml(xml + "]>\n<model>&e11;</model>"),
                HasSubstr("line 2: a document type declaration, which 3MF does not allow"));
}

TEST(ThreeMfLimits, EntitiesOfOtherFilesAreRefused) {
    EXPECT_THAT(refusal_of_xml("<!DOCTYPE model [<!ENTITY e SYSTEM \"/etc/passwd\">]><model>&e;</model>"),
                HasSubstr("document type declaration"));
}

TEST(ThreeMfLimits, ElementsThatNeverEndAreRefused) {
    std::string deep;
    for (int i = 0; i < 100'000; ++i) deep += "<a>";
    EXPECT_THAT(refusal_of_xml(deep), HasSubstr("elements stand in each other more than 100 deep"));
}

TEST(ThreeMfLimits, ATagOrCommentAsLongAsAFileIsRefused) {
    const std::string endless(3'000'000, 'x');
    EXPECT_THAT(refusal_of_xml("<model a=\"" + endless + "\"/>"),
                HasSubstr("a tag or comment of more than a megabyte"));
    EXPECT_THAT(refusal_of_xml("<model><!-- " + endless + " --></model>"), HasSubstr("a tag or comment of"));
    EXPECT_EQ(refusal_of_xml(box_model(endless)), "");  // plain text between tags passes by
}

TEST(ThreeMfLimits, MoreObjectsThanCanBeCarvedAreRefused) {
    std::string many = "<build>";
    for (int i = 0; i < 100'001; ++i) many += item(1);
    EXPECT_THAT(refusal_of_xml("<model>" + many + "</build></model>"), HasSubstr("more than 100000 objects"));
}

}  // namespace
}  // namespace psicarve::model
