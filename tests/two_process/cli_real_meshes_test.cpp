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

/// How far at most, and on average, the carved piece goes into the model: as it was when this was written,
/// and a tenth more.
struct Gouge {
    double max_mm;
    double mean_mm;
};
struct Gouges {
    Gouge coarse;
    Gouge fine;
};

void expect_within(const nlohmann::json& deviation, const Gouge& most) {
    ASSERT_TRUE(deviation.is_object()) << deviation;
    EXPECT_LT(deviation["gouge"]["max_mm"].get<double>(), 1.1 * most.max_mm) << deviation["gouge"];
    EXPECT_LT(deviation["gouge"]["mean_mm"].get<double>(), 1.1 * most.mean_mm) << deviation["gouge"];
    EXPECT_GT(deviation["places"].get<int>(), 10'000);
}

struct RealWork {
    std::string name;
    RealMesh mesh;
    std::size_t triangles;
    std::string options;
    std::vector<std::string> warnings;  ///< what some line of the slicer's speaks of
    Gouges gouges;                      ///< of 8 layers of 25 points, and of 24 of 73
    bool is_roughed = false;
    bool is_carved_by_sanitizers = false;  ///< what others add to these is in their readers and tools

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
    if (!is_thorough() && !work.is_carved_by_sanitizers) return;
    const Outcome carved =
        psicarve({"carve", job(), "--segment", segment_, "--trace", file("pins.trace"), "--json"});
    ASSERT_EQ(carved.exit_code, 0) << carved.error;
    const Outcome verified =
        psicarve({"verify", job(), file("pins.trace"), "--model", file_of(work.mesh, folder_), "--json"});
    ASSERT_EQ(verified.exit_code, 0) << verified.error << verified.out;
    EXPECT_EQ(verified.json()["max_deviation_pulses"], 0);
    EXPECT_EQ(verified.json()["points_visited"], verified.json()["points_total"]);
    EXPECT_EQ(verified.json()["layers"], sliced["layers"]);
    EXPECT_EQ(carved.json()["pulses"], verified.json()["pulses"]);
    expect_within(verified.json()["deviation"], is_thorough() ? work.gouges.fine : work.gouges.coarse);
}

class FinePiece : public CliTest {
protected:
    /// From a model to a piece of 200 layers of 200 points, judged by its pins.
    nlohmann::json deviation_of(const std::string& model, const std::string& options) const {
        std::vector<std::string> slice{"slice",    model, "-o",       file("fine.job"),
                                       "--layers", "200", "--points", "200"};
        for (const std::string& word : words_of(options)) slice.push_back(word);
        EXPECT_EQ(psicarve(slice).exit_code, 0);
        const Outcome carved =
            psicarve({"carve", file("fine.job"), "--segment", segment_, "--trace", file("pins.trace")});
        EXPECT_EQ(carved.exit_code, 0) << carved.error;
        const Outcome verified =
            psicarve({"verify", file("fine.job"), file("pins.trace"), "--model", model, "--json"});
        EXPECT_EQ(verified.exit_code, 0) << verified.error << verified.out;
        return verified.exit_code == 0 ? verified.json()["deviation"] : nlohmann::json{};
    }
};

TEST_F(FinePiece, OfARealMeshGoesNoDeeper) {
    if (!is_thorough()) GTEST_SKIP() << "under sanitizers only with --long; dev runs it";
    const std::string model = file_of(of_cgal("refined_elephant.off"), folder_);
    expect_within(deviation_of(model, "--height 20 --up y --tool ball:1"), {0.1418, 0.00017});
}

TEST_F(FinePiece, OfARealPictureGoesNoDeeper) {
    if (!is_thorough()) GTEST_SKIP() << "under sanitizers only with --long; dev runs it";
    expect_within(deviation_of("/usr/share/pixmaps/openbox.png", "--diameter 20 --smooth 0.2 --tool ball:1"),
                  {0.01365, 0.0000614});
}

const std::string kHoles = "the mesh has holes";
const std::string kFlipped = "some facets are flipped";
const std::string kThin = "without area (degenerate)";

INSTANTIATE_TEST_SUITE_P(
    FromPackages, RealMeshes,
    ::testing::Values(RealWork{"elephant",
                               of_cgal("refined_elephant.off"),
                               88'928,
                               "--height 20 --up y --tool ball:1",
                               {},
                               {{0.7398, 0.00094}, {0.3504, 0.00013}}},
                      RealWork{"armadillo_at_its_best_axis",
                               of_cgal("armadillo.off"),
                               52'000,
                               "--height 20 --up y --axis-at best --tool ball:2",
                               {},
                               {{0.9356, 0.00135}, {1.7461, 0.00021}}},
                      RealWork{"camel",
                               of_cgal("camel.off"),
                               19'536,
                               "--height 20 --up y --tool flat:1",
                               {},
                               {{0.5201, 0.00140}, {0.3508, 0.00047}}},
                      RealWork{"pig",
                               of_cgal("pig.stl"),
                               16'848,
                               "--height 12 --tool vee:2:60 --joining zigzag",
                               {kHoles},
                               {{0.4375, 0.00170}, {0.2721, 0.00027}}},
                      RealWork{"elephant_with_holes",
                               of_cgal("elephant-with-holes.off"),
                               4'463,
                               "--height 20 --up y --tool ball:1",
                               {kHoles},
                               {{0.7002, 0.00075}, {0.3510, 0.00015}}},
                      RealWork{"shark_with_holes",
                               of_cgal("mech-holes-shark.off"),
                               10'192,
                               "--height 20 --tool ball:1",
                               {kHoles},
                               {{2.3536, 0.00402}, {0.6626, 0.00120}}},
                      RealWork{"comments_before_off",
                               of_cgal("blobby-shuffled.off"),
                               4'050,
                               "--height 12 --tool ball:2",
                               {},
                               {{0.2917, 0.00106}, {0.1063, 0.00022}},
                               false,
                               true},
                      RealWork{"bunny_roughed",
                               of_glmark("bunny.obj"),
                               69'666,
                               "--height 20 --up y --tool ball:3 --blank 12x20 --stepdown 4",
                               {},
                               {{0.7615, 0.00138}, {0.2549, 0.00019}},
                               true},
                      RealWork{"dragon_roughed",
                               of_cgal("ChineseDragon-10kv.off"),
                               19'994,
                               "--height 20 --up y --tool flat:3 --blank 11x20 --stepdown 5 --stepover 2.5",
                               {kHoles},
                               {{0.4614, 0.00091}, {0.1457, 0.00012}},
                               true},
                      RealWork{"bearing_in_a_spiral",
                               of_opencascade("bearing.stl"),
                               24'696,
                               "--height 10 --tool ball:1 --joining spiral",
                               {kHoles, kFlipped, kThin},
                               {{1.0666, 0.01344}, {0.4109, 0.00218}},
                               false,
                               true},
                      RealWork{"propeller",
                               of_opencascade("propeller.stl"),
                               7'375,
                               "--height 10 --tool ball:1",
                               {kFlipped},
                               {{1.6705, 0.00230}, {0.6596, 0.00067}}}),
    [](const auto& chosen) { return chosen.param.name; });

}  // namespace
}  // namespace psicarve::test
