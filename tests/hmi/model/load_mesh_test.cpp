// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/model/load_mesh.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <algorithm>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "hmi/model/mesh.hpp"
#include "shared/base/result.hpp"
#include "tests/hmi/model/mesh_files.hpp"
#include "tests/hmi/model/shapes.hpp"
#include "tests/hmi/model/three_mf_files.hpp"

namespace psicarve::model {
namespace {

using mesh_files::Folder;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

const Mesh& spring() {
    static const Mesh mesh = shapes::spring(15.0, 4.0, 2.0, 50.0, 60, 16);
    return mesh;
}

/// Reads the bytes back and compares every coordinate with the spring's, x moved by `shift_x`.
void expect_spring(const std::string& name, const std::string& bytes, const std::string& format,
                   double shift_x = 0.0) {
    const Folder folder;
    const auto sut = load_mesh(folder.write(name, bytes));
    ASSERT_TRUE(sut.has_value()) << sut.error().message;
    EXPECT_EQ(sut->format, format);
    EXPECT_EQ(sut->source_name, name);
    ASSERT_EQ(sut->triangles.size(), spring().triangles.size());
    for (std::size_t i = 0; i < sut->triangles.size(); ++i) {
        for (std::size_t v = 0; v < 3; ++v) {
            for (std::size_t k = 0; k < 3; ++k) {
                const double got = double{sut->triangles[i].vertices[v][k]} + sut->origin[k];
                const double wanted = double{spring().triangles[i].vertices[v][k]} + (k == 0 ? shift_x : 0.0);
                ASSERT_NEAR(got, wanted, 1e-5) << i;
            }
        }
    }
}

TEST(LoadMesh, ReadsBinaryStl) {
    expect_spring("a.stl", mesh_files::binary_stl(spring()), "binary STL");
}
TEST(LoadMesh, ReadsAsciiStl) {
    expect_spring("a.stl", mesh_files::ascii_stl(spring()), "ASCII STL");
}
TEST(LoadMesh, ReadsObj) {
    expect_spring("a.obj", mesh_files::obj(spring()), "OBJ");
}
TEST(LoadMesh, ReadsPly) {
    expect_spring("a.ply", mesh_files::ply(spring()), "PLY");
}
TEST(LoadMesh, ReadsOff) {
    expect_spring("a.off", mesh_files::off(spring()), "OFF");
}
TEST(LoadMesh, ReadsOffWithCommentsAnywhereAndWithoutItsFirstWord) {
    const std::string plain = mesh_files::off(spring());
    const std::string body = plain.substr(plain.find('\n') + 1);
    expect_spring("a.off", "# by a tool\n#CBP\n\n  # closed 1\n" + plain, "OFF");
    expect_spring("a.mesh", "#by a tool\r\nOFF # format\n# counts\n" + body, "OFF");
    expect_spring("a.off", "# first word left out\n" + body, "OFF");
    std::string commented = "OFF\n" + body;
    for (std::size_t at = commented.find('\n'); at != std::string::npos; at = commented.find('\n', at + 8))
        commented.insert(at, " # 1 2");
    expect_spring("a.off", commented, "OFF");
}

TEST(LoadMesh, PassesOverColoursAndNormalsOfAnOff) {
    const std::string plain = mesh_files::off(spring());
    const std::size_t points = (3 * spring().triangles.size());
    const auto with = [&](const std::string& kind, const std::string& of_point, const std::string& of_face) {
        std::string out = kind;
        std::size_t line = 0;
        for (const char c : plain.substr(plain.find('\n'))) {
            if (c == '\n' && line > 1) out += line <= points + 1 ? of_point : of_face;
            if (c == '\n') ++line;
            out += c;
        }
        return out;
    };
    expect_spring("a.off", with("COFF", " 255 0 0 255", " 0.5 0.5 0.5"), "OFF");
    expect_spring("a.off", with("NOFF", " 0 0 1", ""), "OFF");
    expect_spring("a.off", with("STCNOFF", " 0 0 1 1 0 0 1 0.5 0.5", " 7"), "OFF");
    expect_spring("a.off", with("OFF", "", " 255 0 0"), "OFF");
}

TEST(LoadMesh, Reads3mfWhereItsBuildPlacesIt) {
    expect_spring("a.3mf", mesh_files::three_mf(spring()), "3MF", 5.0);
}

TEST(LoadMesh, ReadsBinaryPlyOfBothByteOrders) {
    for (const bool big : {false, true}) {
        expect_spring("a.ply", mesh_files::binary_ply(spring(), big), "PLY");
    }
}

TEST(LoadMesh, ReadsPolygonsAndBackwardNumbersOfAnObj) {
    const Folder folder;
    const std::string text =
        "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 2 2 5\nvn 0 0 1\n"
        "f 4//1 3//1 2//1 1//1\nf 1/1 2/2 -1/3\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";
    const auto sut = load_mesh(folder.write("a.obj", text));
    ASSERT_TRUE(sut.has_value()) << sut.error().message;
    EXPECT_EQ(sut->triangles.size(), 6U);
    EXPECT_TRUE(sut->facts.closed && sut->facts.same_orientation);
    EXPECT_NEAR(sut->facts.signed_volume, 16.0 * 5.0 / 3.0, 1e-5);
}

TEST(LoadMesh, TrustsTheContentMoreThanTheExtension) {
    expect_spring("a.obj", mesh_files::binary_stl(spring()), "binary STL");
    expect_spring("b.stl", mesh_files::ply(spring()), "PLY");
    expect_spring("c.ply", mesh_files::obj(spring()), "OBJ");
    expect_spring("d.stl", mesh_files::off(spring()), "OFF");
    expect_spring("e", mesh_files::ascii_stl(spring()), "ASCII STL");
    std::string one_line = mesh_files::ascii_stl(spring());
    std::ranges::replace(one_line, '\n', ' ');
    expect_spring("one_line.stl", one_line, "ASCII STL");
    expect_spring("f.zip", mesh_files::three_mf(spring()), "3MF", 5.0);
}

TEST(LoadMesh, ReadsABinaryStlThatBeginsWithSolid) {
    const auto count = static_cast<std::uint32_t>(spring().triangles.size());
    expect_spring("a.stl", mesh_files::binary_stl(spring(), count, "solid made by a program, facet normal"),
                  "binary STL");
}

TEST(LoadMesh, ReadsABinaryStlWhoseTextFillsItsHeaderAndThatHasMoreAfterTheLastFacet) {
    const auto count = static_cast<std::uint32_t>(spring().triangles.size());
    const std::string header(80, ' ');
    expect_spring("a.stl", mesh_files::binary_stl(spring(), count, "solid" + header) + "more", "binary STL");
}

TEST(LoadMesh, LetsTheSizeDecideWhenTheCountIsZero) {
    expect_spring("a.stl", mesh_files::binary_stl(spring(), 0), "binary STL");
}

TEST(LoadMesh, LetsTheSizeDecideWhenTheCountIsAllOnes) {
    expect_spring("a.stl", mesh_files::binary_stl(spring(), 0xFFFFFFFFU) + "tail", "binary STL");
}

TEST(LoadMesh, IgnoresWhatFollowsTheLastFacet) {
    expect_spring("a.stl", mesh_files::binary_stl(spring()) + std::string(1234, 'x'), "binary STL");
}

TEST(LoadMesh, ReadsSeveralSolidsOfAnAsciiStl) {
    const Folder folder;
    const std::string text = mesh_files::ascii_stl(spring()) + mesh_files::ascii_stl(spring(), 60.0);
    const auto sut = load_mesh(folder.write("a.stl", text));
    ASSERT_TRUE(sut.has_value());
    EXPECT_EQ(sut->triangles.size(), 2 * spring().triangles.size());
}

TEST(LoadMesh, ReadsAsciiStlInCapitalsAndWithDosLines) {
    std::string text = mesh_files::ascii_stl(spring());
    std::string dos;
    for (const char c : text) {
        if (c == '\n') dos += '\r';
        dos += c >= 'a' && c <= 'z' && c != 'e' ? static_cast<char>(c - 'a' + 'A') : c;
    }
    expect_spring("a.stl", dos, "ASCII STL");
}

TEST(LoadMesh, PassesOverAByteOrderMark) {
    const std::string mark = "\xEF\xBB\xBF";
    expect_spring("a.stl", mark + mesh_files::ascii_stl(spring()), "ASCII STL");
    expect_spring("a.obj", mark + mesh_files::obj(spring()), "OBJ");
    expect_spring("a.off", mark + mesh_files::off(spring()), "OFF");
    expect_spring("a.ply", mark + mesh_files::ply(spring()), "PLY");
    expect_spring("a.ply", mark + mesh_files::binary_ply(spring(), false), "PLY");
    const std::string with_comment = mesh_files::obj(spring());
    expect_spring("b", mark + with_comment.substr(with_comment.find("v ")), "OBJ");
}

TEST(LoadMesh, KeepsTheDigitsOfAnAsciiStlFarFromTheOrigin) {
    const Folder folder;
    const auto sut = load_mesh(folder.write("a.stl", mesh_files::ascii_stl(spring(), 5.0e6)));
    ASSERT_TRUE(sut.has_value());
    const double got = double{sut->triangles[7].vertices[1][0]} + sut->origin[0];
    EXPECT_NEAR(got, double{spring().triangles[7].vertices[1][0]} + 5.0e6, 1e-5);
}

TEST(LoadMesh, SeesBoxAndVolume) {
    const Folder folder;
    const auto sut =
        load_mesh(folder.write("a.stl", mesh_files::binary_stl(shapes::box({-1, 2, 3}, {4, 5, 7}))));
    ASSERT_TRUE(sut.has_value());
    EXPECT_THAT(sut->facts.min, ElementsAre(-1.0, 2.0, 3.0));
    EXPECT_THAT(sut->facts.max, ElementsAre(4.0, 5.0, 7.0));
    EXPECT_NEAR(sut->facts.signed_volume, 60.0, 1e-9);
    EXPECT_TRUE(sut->facts.closed);
    EXPECT_TRUE(sut->facts.same_orientation);
    EXPECT_TRUE(sut->warnings.empty());
}

TEST(LoadMesh, HashesTheWholeFile) {
    const Folder folder;
    const std::string bytes = mesh_files::binary_stl(spring());
    const auto plain = load_mesh(folder.write("a.stl", bytes));
    const auto same = load_mesh(folder.write("b.stl", bytes));
    const auto longer = load_mesh(folder.write("c.stl", bytes + "x"));
    ASSERT_TRUE(plain.has_value() && same.has_value() && longer.has_value());
    EXPECT_EQ(plain->source_hash, same->source_hash);
    EXPECT_NE(plain->source_hash, longer->source_hash);
}

}  // namespace
}  // namespace psicarve::model
