// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/piece/piece_mesh.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "hmi/model/load_mesh.hpp"
#include "hmi/piece/tool_cut.hpp"
#include "shared/base/units.hpp"
#include "shared/file/atomic_file.hpp"
#include "tests/parameter_name.hpp"

namespace psicarve::piece {
namespace {

/// A blank with a groove, so that volume tells inside from outside.
StockMap grooved() {
    StockMap stock(10.0, 2.0, 0.1, 60, 720);
    ToolCut cut({tool::Shape::flat, 1.0, 0.0}, stock);
    for (int step = 0; step < 3600; ++step) cut.at(step * 2.0 * kPi / 3600.0, 5.0, 7.0);
    return stock;
}

class PieceMesh : public ::testing::TestWithParam<const char*> {};

TEST_P(PieceMesh, IsClosedAndHasThePiecesVolume) {
    const StockMap stock = grooved();
    const std::string path = ::testing::TempDir() + "psicarve_piece_mesh_" + GetParam();
    ASSERT_TRUE(write_piece(path, stock));
    const auto mesh = model::load_mesh(path);
    ASSERT_TRUE(mesh) << mesh.error().message;
    EXPECT_TRUE(mesh->facts.closed);
    const double wanted_mm3 = kPi * 100.0 * 6.0 - stock.removed_mm3();
    // Walls slope from row to row, and a polygon is less than its circle.
    EXPECT_NEAR(mesh->facts.signed_volume, wanted_mm3, 0.002 * wanted_mm3);
    EXPECT_NEAR(mesh->facts.max[2] - mesh->facts.min[2], 6.0, 1e-4);
    std::filesystem::remove(path);
}

INSTANTIATE_TEST_SUITE_P(Formats, PieceMesh, ::testing::Values("a.stl", "b.ply"),
                         [](const auto& named) { return psicarve::test::parameter_name(named.param); });

TEST(PieceMeshFile, IsStlOrPly) {
    EXPECT_TRUE(mesh_format_of("a.stl"));
    EXPECT_TRUE(mesh_format_of("a.PLY"));
    const auto other = mesh_format_of("a.obj");
    ASSERT_FALSE(other);
    EXPECT_EQ(other.error().code, ErrorCode::bad_input);
}

}  // namespace
}  // namespace psicarve::piece
