// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <string>

#include "hmi/model/load_mesh.hpp"
#include "hmi/model/mesh.hpp"
#include "shared/base/result.hpp"
#include "tests/hmi/model/mesh_files.hpp"
#include "tests/hmi/model/shapes.hpp"
#include "tests/hmi/model/three_mf_files.hpp"

namespace psicarve::model {
namespace {

using mesh_files::Folder;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

Mesh cylinder() {
    return shapes::cylinder(10.0, 0.0, 20.0, 60);
}  // 240 facets

/// What load_mesh says about these bytes; empty when it takes them.
std::string refusal(const std::string& name, const std::string& bytes) {
    const Folder folder;
    const std::string path = folder.write(name, bytes);
    const auto mesh = load_mesh(path);
    if (mesh) return "";
    EXPECT_EQ(mesh.error().code, ErrorCode::bad_input);
    EXPECT_THAT(mesh.error().message, StartsWith(path + ": "));
    EXPECT_THAT(mesh.error().message, Not(HasSubstr("\n")));
    return mesh.error().message;
}

Mesh loaded(const std::string& bytes, const std::string& name = "a.stl") {
    const Folder folder;
    auto mesh = load_mesh(folder.write(name, bytes));
    EXPECT_TRUE(mesh.has_value()) << (mesh ? "" : mesh.error().message);
    return mesh ? std::move(*mesh) : Mesh{};
}

TEST(BrokenMesh, NoSuchFile) {
    const auto sut = load_mesh("/nonexistent/thing.stl");
    ASSERT_FALSE(sut.has_value());
    EXPECT_EQ(sut.error().code, ErrorCode::bad_input);
    EXPECT_EQ(sut.error().message, "/nonexistent/thing.stl: no such file");
}

TEST(BrokenMesh, ADirectory) {
    const Folder folder;
    const auto sut = load_mesh(folder.path().string());
    ASSERT_FALSE(sut.has_value());
    EXPECT_THAT(sut.error().message, HasSubstr("is a directory"));
}

TEST(BrokenMesh, ADeviceIsNotAFile) {
    const auto sut = load_mesh("/dev/zero");
    ASSERT_FALSE(sut.has_value());
    EXPECT_THAT(sut.error().message, HasSubstr("not a regular file"));
}

TEST(BrokenMesh, APipeThatNobodyWritesIsNotWaitedFor) {
    const Folder folder;
    const std::string path = (folder.path() / "pipe.stl").string();
    ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
    const auto sut = load_mesh(path);
    ASSERT_FALSE(sut.has_value());
    EXPECT_THAT(sut.error().message, HasSubstr("not a regular file"));
}

TEST(BrokenMesh, BytesThatAreNoTextAreNotPrinted) {
    const std::string message = refusal("a.obj", "v 0 0 0\nv 1 \x1b[2J\x80\xff 0\n");
    EXPECT_THAT(message, HasSubstr("line 2: '?[2J?\?' is not a number"));
    const std::string element = "ply\nformat ascii 1.0\nelement \x1b[31m 1\nproperty int x\nend_header\n";
    EXPECT_THAT(refusal("a.ply", element), HasSubstr("at element '?[31m' 0 of 1"));
}

TEST(BrokenMesh, AnEmptyFile) {
    for (const char* name : {"a.stl", "a.obj", "a.ply", "a.3mf", "a.off", "a"}) {
        EXPECT_THAT(refusal(name, ""), HasSubstr("empty")) << name;
    }
}

TEST(BrokenMesh, ABinaryStlCutShort) {
    const std::string bytes = mesh_files::binary_stl(cylinder());
    EXPECT_THAT(refusal("a.stl", bytes.substr(0, bytes.size() - 1)), HasSubstr("announces 240 facets"));
    EXPECT_THAT(refusal("a.stl", bytes.substr(0, 84)), HasSubstr("truncated"));
    EXPECT_THAT(refusal("a.stl", bytes.substr(0, 50)), HasSubstr("truncated"));
}

TEST(BrokenMesh, ABinaryStlBeginningWithSolidCutShort) {
    const std::string bytes = mesh_files::binary_stl(cylinder(), 240, "solid");
    EXPECT_THAT(refusal("a.stl", bytes.substr(0, 5000)), HasSubstr("truncated"));
}

TEST(BrokenMesh, ABinaryStlWithoutFacets) {
    EXPECT_THAT(refusal("a.stl", mesh_files::binary_stl(Mesh{}, 0)), HasSubstr("no facets"));
    EXPECT_THAT(refusal("a.stl", mesh_files::binary_stl(Mesh{}, 0xFFFFFFFFU)), HasSubstr("no facets"));
}

TEST(BrokenMesh, AnAsciiStlWithoutFacets) {
    EXPECT_THAT(refusal("a.stl", "solid nothing\nendsolid nothing\n"), HasSubstr("no facets"));
}

TEST(BrokenMesh, AnAsciiStlCutInTheMiddleOfAFacet) {
    const std::string text = mesh_files::ascii_stl(cylinder());
    const std::size_t middle = text.find("endloop", text.size() / 2);
    EXPECT_THAT(refusal("a.stl", text.substr(0, middle)), HasSubstr("ends in the middle of a facet"));
    const std::size_t vertex = text.find("vertex", text.size() / 2);
    EXPECT_THAT(refusal("a.stl", text.substr(0, vertex + 9)), HasSubstr("ends in the middle of a facet"));
}

TEST(BrokenMesh, AnAsciiStlNamesTheLineThatIsWrong) {
    const std::string start = "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 zero 0\n";
    EXPECT_THAT(refusal("a.stl", start), HasSubstr("line 5: 'zero' is not a number"));
    EXPECT_THAT(refusal("a.stl", "solid x\nfacet normal 0 0 1\nouter loop\nvortex 0 0 0\n"),
                HasSubstr("line 4: 'vortex'"));
    EXPECT_THAT(refusal("a.stl", "solid x\nfacet normal 0 0 1\nendfacet\n"),
                HasSubstr("line 3: a facet needs three vertices"));
}

TEST(BrokenMesh, AnAsciiStlWithoutItsLastLineIsReadWithAWarning) {
    std::string text = mesh_files::ascii_stl(cylinder());
    text.resize(text.rfind("endsolid"));
    EXPECT_THAT(loaded(text).warnings, Contains(HasSubstr("without endsolid")));
}

TEST(BrokenMesh, AnAsciiStlCutBetweenTwoFacetsIsTruncated) {
    std::string text = mesh_files::ascii_stl(cylinder());
    text.resize(text.find("endfacet", text.size() / 2) + 9);
    EXPECT_THAT(refusal("a.stl", text), HasSubstr("truncated: it ends without endsolid"));
}

TEST(BrokenMesh, FewNanVerticesAreDroppedAndCounted) {
    Mesh mesh = cylinder();
    mesh.triangles[3].vertices[1][2] = std::numeric_limits<float>::quiet_NaN();
    mesh.triangles[70].vertices[0][0] = std::numeric_limits<float>::infinity();
    const Mesh sut = loaded(mesh_files::binary_stl(mesh));
    EXPECT_EQ(sut.triangles.size(), 238U);
    EXPECT_EQ(sut.facts.dropped_count, 2U);
    EXPECT_THAT(sut.warnings, Contains(HasSubstr("2 facets with a NaN or infinite coordinate")));
}

TEST(BrokenMesh, EveryPlaceOfANanOrAnInfinityIsSeen) {
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity()}) {
        for (std::size_t place = 0; place < 9; ++place) {
            Mesh mesh = cylinder();
            mesh.triangles[5].vertices[place / 3][place % 3] = bad;
            EXPECT_EQ(loaded(mesh_files::binary_stl(mesh)).facts.dropped_count, 1U) << bad << " at " << place;
        }
    }
}

TEST(BrokenMesh, ManyNanVerticesAreRefused) {
    Mesh mesh = cylinder();
    for (std::size_t i = 0; i < 13; ++i) {
        mesh.triangles[i].vertices[2][1] = std::numeric_limits<float>::quiet_NaN();
    }
    EXPECT_THAT(refusal("a.stl", mesh_files::binary_stl(mesh)), HasSubstr("13 of 240 facets have NaN"));
}

TEST(BrokenMesh, AnAsciiStlWithNanAndInfinityDropsThem) {
    std::string text = mesh_files::ascii_stl(cylinder());
    const std::string facet =
        "facet normal nan nan nan\nouter loop\nvertex nan 0 0\nvertex 1 inf 0\n"
        "vertex 1e999 0 0\nendloop\nendfacet\n";
    text.insert(text.rfind("endsolid"), facet);
    EXPECT_EQ(loaded(text).facts.dropped_count, 1U);
}

TEST(BrokenMesh, RandomBytes) {
    std::mt19937 random(7);
    std::string bytes(20000, ' ');
    for (char& c : bytes) c = static_cast<char>(random());
    for (const char* name : {"a.stl", "a.obj", "a.ply", "a.3mf", "a.off", "a.png", "a"}) {
        EXPECT_NE(refusal(name, bytes), "") << name;
    }
}

TEST(BrokenMesh, TextThatIsNoMesh) {
    EXPECT_THAT(refusal("a.txt", "Dear reader, this is a letter.\n"),
                HasSubstr("nothing that can be read here: a mesh"));
    EXPECT_THAT(refusal("a.step", "ISO-10303-21;\nHEADER;\n"),
                HasSubstr("a.step: a STEP model, which is not read; save it as STL or 3MF"));
    EXPECT_THAT(refusal("a.pdf", "%PDF-1.4\n"),
                HasSubstr("a PDF drawing, which is not read; save it as SVG"));
    for (const char* name : {"a.stl", "a.obj", "a.ply", "a.3mf", "a.off"}) {
        EXPECT_NE(refusal(name, "Dear reader, this is a letter.\n"), "") << name;
    }
}

TEST(BrokenMesh, OtherFormatsCutShort) {
    const Mesh mesh = cylinder();
    const std::string ply = mesh_files::ply(mesh);
    const std::string three_mf = mesh_files::three_mf(mesh);
    EXPECT_NE(refusal("a.ply", ply.substr(0, 60)), "");
    EXPECT_NE(refusal("a.3mf", three_mf.substr(0, three_mf.size() / 2)), "");
    EXPECT_NE(refusal("a.off", "OFF\n3 1 0\n0 0 0\n"), "");
}

TEST(BrokenMesh, AFlatMeshHasNoVolume) {
    const Mesh flat = shapes::Builder().quad({0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}).mesh();
    EXPECT_THAT(refusal("a.stl", mesh_files::binary_stl(flat)), HasSubstr("no volume"));
}

TEST(BrokenMesh, ATiltedFlatMeshHasNoVolume) {
    const Mesh flat = shapes::Builder().quad({0, 0, 0}, {9, 0, 4}, {9, 9, 8}, {0, 9, 4}).mesh();
    EXPECT_THAT(refusal("a.stl", mesh_files::binary_stl(flat)), HasSubstr("no volume"));
}

TEST(BrokenMesh, ASheetWithTwoFacesHasNoVolume) {
    shapes::Builder sheet;
    sheet.quad({0, 0, 0}, {9, 0, 4}, {9, 9, 8}, {0, 9, 4}).quad({0, 0, 0}, {0, 9, 4}, {9, 9, 8}, {9, 0, 4});
    EXPECT_THAT(refusal("a.stl", mesh_files::binary_stl(sheet.mesh())), HasSubstr("no volume"));
}

TEST(BrokenMesh, HolesAreCounted) {
    Mesh mesh = cylinder();
    mesh.triangles.erase(mesh.triangles.begin() + 8);
    const Mesh sut = loaded(mesh_files::binary_stl(mesh));
    EXPECT_FALSE(sut.facts.closed);
    EXPECT_EQ(sut.facts.open_edge_count, 3U);
    EXPECT_THAT(sut.warnings, Contains(HasSubstr("the mesh has holes: 3 edges")));
}

TEST(BrokenMesh, FlippedFacetsAreCounted) {
    Mesh mesh = cylinder();
    std::swap(mesh.triangles[8].vertices[0], mesh.triangles[8].vertices[1]);
    const Mesh sut = loaded(mesh_files::binary_stl(mesh));
    EXPECT_TRUE(sut.facts.closed);
    EXPECT_EQ(sut.facts.turned_edge_count, 3U);
    EXPECT_THAT(sut.warnings, Contains(HasSubstr("flipped: along 3 edges")));
}

TEST(BrokenMesh, AnInsideOutMeshIsNoted) {
    const Mesh mesh = shapes::moved(cylinder(), [](const shapes::Point& p) {
        return shapes::Point{p[0], -p[1], p[2]};
    });
    EXPECT_THAT(loaded(mesh_files::binary_stl(mesh)).warnings, Contains(HasSubstr("inside out")));
}

TEST(BrokenMesh, DegenerateFacetsAreCounted) {
    Mesh mesh = cylinder();
    Triangle thin = mesh.triangles[0];
    thin.vertices[2] = thin.vertices[1];
    mesh.triangles.push_back(thin);
    const Mesh sut = loaded(mesh_files::binary_stl(mesh));
    EXPECT_EQ(sut.facts.degenerate_count, 1U);
    EXPECT_TRUE(sut.facts.closed);
    EXPECT_THAT(sut.warnings, Contains(HasSubstr("1 facet without area")));
}

TEST(BrokenMesh, VerticesThatStandThereTwiceAreCounted) {
    const std::string text =
        "v 0 0 0\nv 5 0 0\nv 0 5 0\nv 0 0 5\nv 0 0 5\n"
        "f 1 3 2\nf 1 2 4\nf 2 3 5\nf 3 1 4\n";
    const Mesh sut = loaded(text, "a.obj");
    EXPECT_EQ(sut.facts.doubled_vertex_count, 1U);
    EXPECT_TRUE(sut.facts.closed);
    EXPECT_THAT(sut.warnings, Contains(HasSubstr("1 vertex is a duplicate")));
}

TEST(BrokenMesh, FacesThatNameNoVertexAreRefused) {
    EXPECT_THAT(refusal("a.obj", "v 0 0 0\nv 5 0 0\nv 0 5 0\nf 1 2 4\n"),
                HasSubstr("line 4: the face names"));
    EXPECT_THAT(refusal("a.obj", "v 0 0 0\nf 0 1 1\n"), HasSubstr("line 2"));
    EXPECT_THAT(refusal("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"), HasSubstr("line 6"));
    EXPECT_THAT(refusal("a.off", "OFF\n3 1 0\n0 0 0\n"), HasSubstr("1 of 3 vertices"));
    EXPECT_THAT(refusal("a.off", "# made\nOFF\n3 1 0\n0 0 x\n"), HasSubstr("line 4"));
    EXPECT_THAT(refusal("a.off", std::string("OFF BINARY\n\0\0\0\3", 15)), HasSubstr("save it as text"));
    EXPECT_THAT(refusal("a.off", "# nothing\n# else"), HasSubstr("not a number of vertices"));
}

TEST(BrokenMesh, NumbersOfVerticesThatAreNoneAreRefused) {
    const std::string points = "v 0 0 0\nv 5 0 0\nv 0 5 0\n";
    for (const char* corner : {"0", "1.5", "-1.5", "two", "1e0", "99999999999999999999"}) {
        EXPECT_THAT(refusal("a.obj", points + "f 1 2 " + corner + "\n"),
                    HasSubstr("is not the number of a vertex"))
            << corner;
    }
    EXPECT_THAT(refusal("a.obj", points + "f 1 2 -4\n"), HasSubstr("names a vertex that is not there"));
    for (const char* corner : {"-1", "1.5", "two", "99999999999999999999"}) {
        EXPECT_THAT(refusal("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 " + std::string(corner) + "\n"),
                    HasSubstr("line 6: '" + std::string(corner) + "' is not the number of a vertex"));
    }
    const std::string ply =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 ";
    for (const char* corner : {"-1", "1.5", "3", "nan", "1e30"}) {
        EXPECT_THAT(refusal("a.ply", ply + corner + "\n"),
                    HasSubstr("face 0 names a vertex that is not there"))
            << corner;
    }
    EXPECT_THAT(refusal("a.ply", ply.substr(0, ply.size() - 6) + "2.5 0 1\n"),
                HasSubstr("damaged at element 'face'"));
}

TEST(BrokenMesh, MinusZeroIsTheSamePlaceAsZero) {
    Mesh mesh = shapes::box({0, 0, 0}, {5, 5, 5});
    for (auto& v : mesh.triangles[0].vertices) {
        for (float& c : v) c = c == 0.0F ? -0.0F : c;
    }
    const Mesh sut = loaded(mesh_files::binary_stl(mesh));
    EXPECT_TRUE(sut.facts.closed);
    EXPECT_TRUE(sut.warnings.empty());
}

}  // namespace
}  // namespace psicarve::model
