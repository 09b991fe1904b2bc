// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes that others made for other ends, from the packages of `scripts/deps.sh test`, whole and defective,
// each from its file to pins that are verified.
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

#include "tests/hmi/cli/program_run.hpp"
#include "tests/hmi/model/real_meshes.hpp"
#include "tests/thoroughness.hpp"

namespace psicarve::test {
namespace {

struct RealWork {
    std::string name;
    RealMesh mesh;
    std::size_t triangles;
    std::string options;
    std::vector<std::string> warnings;  ///< what some line of the slicer's speaks of
    bool is_roughed = false;

    friend void PrintTo(const RealWork& work, std::ostream* out) { *out << work.mesh.path; }
};

class RealMeshes : public CliTest, public ::testing::WithParamInterface<RealWork> {
protected:
    std::string job() const { return file("real.job"); }

    nlohmann::json slice(const RealWork& work) const {
        const bool is_fine = is_thorough();
        std::vector<std::string> words{
            "slice",    file_of(work.mesh, folder_), "-o",    job(), "--layers", is_fine ? "24" : "8",
            "--points", is_fine ? "73" : "25",       "--json"};
        for (const std::string& word : words_of(work.options)) words.push_back(word);
        const Outcome sliced = psicarve(words);
        EXPECT_EQ(sliced.exit_code, 0) << sliced.error;
        for (const std::string& warning : work.warnings) {
            EXPECT_NE(sliced.error.find(warning), std::string::npos) << warning << '\n' << sliced.error;
        }
        EXPECT_LE(sliced.error_lines(), 9U) << sliced.error;
        return sliced.exit_code == 0 ? sliced.json() : nlohmann::json{};
    }
};

TEST_P(RealMeshes, AreSlicedCarvedAndVerified) {
    const RealWork& work = GetParam();
    const nlohmann::json sliced = slice(work);
    ASSERT_FALSE(sliced.is_null());
    const nlohmann::json& report = sliced["report"];
    EXPECT_EQ(report["triangles"], work.triangles);
    EXPECT_GT(report["r_max_mm"].get<double>(), report["r_min_mm"].get<double>() + 1.0);
    EXPECT_EQ(sliced["passes"].size() > 1, work.is_roughed) << sliced["passes"];
    const Outcome carved =
        psicarve({"carve", job(), "--segment", segment_, "--trace", file("pins.trace"), "--json"});
    ASSERT_EQ(carved.exit_code, 0) << carved.error;
    const Outcome verified = psicarve({"verify", job(), file("pins.trace"), "--json"});
    ASSERT_EQ(verified.exit_code, 0) << verified.error << verified.out;
    EXPECT_EQ(verified.json()["max_deviation_pulses"], 0);
    EXPECT_EQ(verified.json()["points_visited"], verified.json()["points_total"]);
    EXPECT_EQ(verified.json()["layers"], sliced["layers"]);
    EXPECT_EQ(carved.json()["pulses"], verified.json()["pulses"]);
}

const std::string kHoles = "the mesh has holes";
const std::string kFlipped = "some facets are flipped";
const std::string kThin = "without area (degenerate)";

INSTANTIATE_TEST_SUITE_P(
    FromPackages, RealMeshes,
    ::testing::Values(
        RealWork{"elephant", of_cgal("refined_elephant.off"), 88'928, "--height 20 --up y --tool ball:1", {}},
        RealWork{"armadillo_at_its_best_axis",
                 of_cgal("armadillo.off"),
                 52'000,
                 "--height 20 --up y --axis-at best --tool ball:2",
                 {}},
        RealWork{"camel", of_cgal("camel.off"), 19'536, "--height 20 --up y --tool flat:1", {}},
        RealWork{"pig", of_cgal("pig.stl"), 16'848, "--height 12 --tool vee:2:60 --joining zigzag", {kHoles}},
        RealWork{"elephant_with_holes",
                 of_cgal("elephant-with-holes.off"),
                 4'463,
                 "--height 20 --up y --tool ball:1",
                 {kHoles}},
        RealWork{"shark_with_holes",
                 of_cgal("mech-holes-shark.off"),
                 10'192,
                 "--height 20 --tool ball:1",
                 {kHoles}},
        RealWork{
            "comments_before_off", of_cgal("blobby-shuffled.off"), 4'050, "--height 12 --tool ball:2", {}},
        RealWork{"bunny_roughed",
                 of_glmark("bunny.obj"),
                 69'666,
                 "--height 20 --up y --tool ball:3 --blank 12x20 --stepdown 4",
                 {},
                 true},
        RealWork{"dragon_roughed",
                 of_cgal("ChineseDragon-10kv.off"),
                 19'994,
                 "--height 20 --up y --tool flat:3 --blank 11x20 --stepdown 5 --stepover 2.5",
                 {kHoles},
                 true},
        RealWork{"bearing_in_a_spiral",
                 of_opencascade("bearing.stl"),
                 24'696,
                 "--height 10 --tool ball:1 --joining spiral",
                 {kHoles, kFlipped, kThin}},
        RealWork{
            "propeller", of_opencascade("propeller.stl"), 7'375, "--height 10 --tool ball:1", {kFlipped}}),
    [](const auto& chosen) { return chosen.param.name; });

}  // namespace
}  // namespace psicarve::test
