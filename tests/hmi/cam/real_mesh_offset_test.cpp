// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of meshes that others made, at places taken by chance from a fixed seed, against the tool's
// definition searched through all facets. Of the code that is judged it takes the reader alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <ostream>
#include <random>
#include <span>
#include <string>

#include "hmi/model/load_mesh.hpp"
#include "tests/hmi/cam/built_job.hpp"
#include "tests/hmi/model/mesh_files.hpp"
#include "tests/hmi/model/real_meshes.hpp"
#include "tests/hmi/tool/brute_mesh.hpp"
#include "tests/thoroughness.hpp"

namespace psicarve::cam {
namespace {

const std::uint32_t kMeshLayers = test::is_thorough() ? 60 : 16;
const std::uint32_t kMeshPoints = test::is_thorough() ? 160 : 40;
constexpr double kHeight_mm = 24.0;
const int kPlaces = test::is_thorough() ? 40 : 12;  // of each head, mesh and tool

struct Chosen {
    std::string name;
    test::RealMesh mesh;
    slice::Up up;
    std::uint32_t seed;

    friend void PrintTo(const Chosen& chosen, std::ostream* out) { *out << chosen.mesh.path; }
};

class RealMeshOffset : public ::testing::TestWithParam<Chosen> {
protected:
    struct Figures {
        int places = 0;
        int above_core = 0;
    };

    void expect_exact(const model::Mesh& mesh, const ToolProfile& tool) {
        Profile profile;
        profile.tool = tool;
        JobOptions options = small(kMeshLayers, kMeshPoints);
        options.up = GetParam().up;
        options.height_mm = kHeight_mm;
        const BuiltJob sut = built(mesh, profile, options);
        ASSERT_EQ(sut.report.clearance_points, 0U);
        const model::Mesh body = brute::standing(mesh, options.up, kHeight_mm);
        const double pi = std::acos(-1.0);
        std::mt19937_64 random{GetParam().seed};
        for (int i = 0; i < kPlaces; ++i) {
            const auto layer = static_cast<std::uint32_t>(random() % kMeshLayers);
            const auto point = static_cast<std::uint32_t>(random() % kMeshPoints);
            const double height_mm = (layer + 0.5) * kHeight_mm / kMeshLayers;
            // Continuous: the table goes on by half a turn each layer, in whole pulses.
            const std::int64_t in_layer =
                (2 * point * sut.table.psi_sweep_pulses + kMeshPoints - 1) / (2 * (kMeshPoints - 1));
            const std::int64_t psi_pulses = layer * sut.table.psi_sweep_pulses + in_layer;
            const double psi_rad =
                2.0 * pi * static_cast<double>(psi_pulses) / static_cast<double>(profile.psi.pulses_per_rev);
            judge(body, profile, psi_rad, height_mm, left(sut.table, layer, point), profile.r1);
            judge(body, profile, psi_rad + pi, height_mm, right(sut.table, layer, point), profile.r2);
        }
    }

    Figures figures_;

private:
    void judge(const model::Mesh& body, const Profile& profile, double direction_rad, double height_mm,
               std::int32_t found_pulses, const LinearAxisProfile& head) {
        const double tip = brute::tip_mm(body, profile.tool, direction_rad, height_mm);
        const double wanted_pulses = head.pulses_per_mm * std::max(tip, profile.core_radius_mm);
        // Half a pulse is the table's rounding, half the single precision of `standing` and the search's.
        EXPECT_NEAR(found_pulses, wanted_pulses, 1.0)
            << "direction " << direction_rad << " height " << height_mm
            << (found_pulses < wanted_pulses ? ": a gouge" : "");
        ++figures_.places;
        figures_.above_core += tip > profile.core_radius_mm ? 1 : 0;
    }
};

TEST_P(RealMeshOffset, IsThatOfTheToolsDefinitionToAPulse) {
    const mesh_files::Folder folder;
    const auto mesh = model::load_mesh(test::file_of(GetParam().mesh, folder.path()));
    ASSERT_TRUE(mesh.has_value()) << mesh.error().message;
    const std::array tools{ToolProfile{ToolShape::ball, 3.0, 60.0, 0.0},
                           ToolProfile{ToolShape::flat, 2.0, 60.0, 0.0},
                           ToolProfile{ToolShape::vee, 4.0, 50.0, 0.0}};
    // Shorter: the meshes take the tools in turn.
    const std::size_t first = test::is_thorough() ? 0 : GetParam().seed % tools.size();
    const std::size_t count = test::is_thorough() ? tools.size() : 1;
    for (const ToolProfile& tool : std::span{tools}.subspan(first, count)) {
        SCOPED_TRACE(static_cast<int>(tool.shape));
        expect_exact(*mesh, tool);
    }
    EXPECT_EQ(figures_.places, static_cast<int>(count) * 2 * kPlaces);
    EXPECT_GT(figures_.above_core, figures_.places / 2) << "the core would hide what is wrong";
}

INSTANTIATE_TEST_SUITE_P(
    FromPackages, RealMeshOffset,
    ::testing::Values(Chosen{"elephant", test::of_cgal("refined_elephant.off"), slice::Up::y, 11},
                      Chosen{"armadillo", test::of_cgal("armadillo.off"), slice::Up::y, 12},
                      Chosen{"shark_with_holes", test::of_cgal("mech-holes-shark.off"), slice::Up::z, 13},
                      Chosen{"bunny", test::of_glmark("bunny.obj"), slice::Up::y, 14},
                      Chosen{"bearing", test::of_opencascade("bearing.stl"), slice::Up::z, 15},
                      Chosen{"propeller", test::of_opencascade("propeller.stl"), slice::Up::z, 16}),
    [](const auto& chosen) { return chosen.param.name; });

}  // namespace
}  // namespace psicarve::cam
