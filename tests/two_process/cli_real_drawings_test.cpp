// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings and pictures that others made for other ends, from the packages of `scripts/deps.sh test`, each
// from its file to pins that are verified.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

#include "tests/hmi/cli/refusal.hpp"
#include "tests/thoroughness.hpp"

namespace psicarve::test {
namespace {

constexpr double kUnknown = 0.0;

/// What is known of an input without this program: from its numbers and curves by a script, or its pixels.
struct Known {
    std::array<double, 3> size_mm;  ///< before --fit; kUnknown: not said. Of a cylinder: diameter and height
    double r_min_mm;                ///< kUnknown: not said
    double r_max_mm;
    double most_mean_gouge_mm;  ///< of so few points; a pulse where these allow it
};

struct RealInput {
    std::string name;
    std::string path;
    std::string options;
    std::size_t most_warnings;  ///< lines on standard error
    Known known;
    bool is_carved_by_sanitizers = false;  ///< what others add to these is in their readers

    friend void PrintTo(const RealInput& input, std::ostream* out) { *out << input.path << input.options; }
};

constexpr double kPulse_mm = 0.0025;
constexpr double kRound_mm = 0.005;  // chords instead of a circle, over many pieces of a cylinder

/// A drawing, as wide and high as its lines, once round a cylinder, with what the grooves need above and
/// below.
Known engraved(double diameter_mm, double width, double height) {
    const double around_mm = std::numbers::pi * diameter_mm;
    return {{diameter_mm, diameter_mm, around_mm * height / width + 1.0 + 2.0},
            0.5 * diameter_mm - 0.5,
            0.5 * diameter_mm,
            0.04};
}

/// A picture of so many pixels, once round.
Known relief(double diameter_mm, double columns, double rows, double most_mean_gouge_mm) {
    return {{kUnknown, kUnknown, std::numbers::pi * diameter_mm * rows / columns},
            kUnknown,
            kUnknown,
            most_mean_gouge_mm};
}

const std::string kIcons = "/usr/share/icons/hicolor/scalable/";
const std::string kSigrok = kIcons + "apps/sigrok-cli.svg";
const std::string kTablets = "/usr/share/libwacom/layouts/";
const std::string kLibrecad = "/usr/share/librecad/library/";
const std::string kEngraved = " --engrave 0.5 --tool ball:1";

class RealDrawing : public CliTest, public ::testing::WithParamInterface<RealInput> {
protected:
    static void expect_known(const Known& known, const Json& report) {
        const double scale = report.value("scale", 1.0);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double wanted_mm = known.size_mm[axis];
            if (wanted_mm == kUnknown) continue;
            const double size_mm = report["bounding_box_mm"][axis].get<double>() / scale;
            EXPECT_NEAR(size_mm, wanted_mm, std::max(kRound_mm, 1e-6 * wanted_mm)) << axis;
        }
        // Half as many points may pass by the nearest and the furthest place.
        if (!is_thorough()) return;
        if (known.r_min_mm != kUnknown) {
            EXPECT_NEAR(report["r_min_mm"].get<double>(), known.r_min_mm, kPulse_mm);
        }
        if (known.r_max_mm != kUnknown) {
            EXPECT_NEAR(report["r_max_mm"].get<double>(), known.r_max_mm, kPulse_mm);
        }
    }
};

TEST_P(RealDrawing, IsSlicedCarvedAndVerified) {
    const RealInput& input = GetParam();
    ASSERT_TRUE(std::filesystem::exists(input.path))
        << input.path << " is not there: scripts/deps.sh test installs it";
    const std::string job = file("real.job");
    const bool is_fine = is_thorough();
    std::vector<std::string> slice{"slice",    input.path,           "-o",       job,
                                   "--layers", is_fine ? "16" : "8", "--points", is_fine ? "61" : "31",
                                   "--json"};
    for (const std::string& word : words_of(input.options)) slice.push_back(word);
    const Outcome sliced = psicarve(slice);
    ASSERT_EQ(sliced.exit_code, 0) << sliced.error;
    EXPECT_LE(sliced.error_lines(), input.most_warnings) << sliced.error;
    const auto report = sliced.json()["report"];
    EXPECT_GT(report["r_max_mm"].get<double>(), report["r_min_mm"].get<double>() + 0.1);
    expect_known(input.known, report);
    if (!is_fine && !input.is_carved_by_sanitizers) return;
    const Outcome carved =
        psicarve({"carve", job, "--segment", segment_, "--trace", file("pins.trace"), "--json"});
    ASSERT_EQ(carved.exit_code, 0) << carved.error;
    const Outcome verified = psicarve({"verify", job, file("pins.trace"), "--model", input.path, "--json"});
    ASSERT_EQ(verified.exit_code, 0) << verified.error << verified.out;
    const auto gouge = verified.json()["deviation"]["gouge"];
    // Half as many points cut deeper between them.
    if (is_fine) {
        EXPECT_LE(gouge["mean_mm"].get<double>(), input.known.most_mean_gouge_mm) << gouge;
    }
    EXPECT_EQ(carved.json()["pulses"], verified.json()["pulses"]);
}

INSTANTIATE_TEST_SUITE_P(
    FromPackages, RealDrawing,
    ::testing::Values(
        RealInput{"tablet_extruded",
                  kTablets + "intuos4-6x9.svg",
                  "--height 12 --fit --blank 12x20",
                  9,
                  {{39.5 * 25.4 / 96, 173.0 * 25.4 / 96, 12.0}, kUnknown, 12.0, 0.007},
                  true},
        RealInput{"tablet_as_stroked", kTablets + "intuos-m-p.svg",
                  "--diameter 20 --full-turn --stroke-width" + kEngraved, 9, engraved(20.0, 271.0, 39.0)},
        RealInput{"icon_engraved", kSigrok, "--diameter 20 --full-turn" + kEngraved, 9,
                  engraved(20.0, 43.413555, 47.112846)},
        RealInput{"gradients_engraved", kIcons + "apps/qemu.svg",
                  "--diameter 16 --full-turn --engrave 0.5 --tool ball:1", 9,
                  engraved(16.0, 111.71874, 111.12498)},
        RealInput{"waves_engraved", kIcons + "mimetypes/libsigrok.svg",
                  "--diameter 20 --full-turn" + kEngraved, 9, engraved(20.0, 43.413555, 47.112846)},
        RealInput{"ellipses_extruded",
                  kLibrecad + "plan/architect/Bathroom-toilet-E.dxf",
                  "--fit --blank 12x20",
                  9,
                  {{500.0, 645.0, 20.0}, kUnknown, 12.0, 0.006}},
        RealInput{"linkage_extruded",
                  kLibrecad + "kinetics/kin116.dxf",
                  "--fit --blank 12x20",
                  9,
                  {{26.00208, 14.0, 20.0}, kUnknown, kUnknown, 0.008}},
        RealInput{"block_engraved", kLibrecad + "elektro/transistor/vt31.dxf",
                  "--full-turn --diameter 20" + kEngraved, 9, engraved(20.0, 10.0, 10.0)},
        RealInput{"parts_of_ellipses_engraved", kLibrecad + "elektro/power/pe25.dxf",
                  "--full-turn --diameter 20" + kEngraved, 9, engraved(20.0, 115.382638, 76.924775)},
        RealInput{"splines_engraved", kLibrecad + "kinetics/kin39.dxf",
                  "--full-turn --diameter 20" + kEngraved, 9, engraved(20.0, 12.0, 6.0), true},
        RealInput{"blocks_engraved", kLibrecad + "plan/architect/Complete-Lib-E.dxf",
                  "--full-turn --diameter 10" + kEngraved, 9, engraved(10.0, 4000.0, 16575.0)},
        RealInput{"circuit_engraved", kLibrecad + "elektro/transistor/vt1.dxf",
                  "--full-turn --diameter 20" + kEngraved, 9, engraved(20.0, 12.0, 15.0)},
        RealInput{"tree_engraved", kLibrecad + "plan/vegetation/v1.dxf",
                  "--full-turn --diameter 20" + kEngraved, 9, engraved(20.0, 0.9301153, 1.75)},
        RealInput{"logo_png", "/usr/share/gitweb/static/git-logo.png", "--diameter 20", 9,
                  relief(20.0, 72, 27, kPulse_mm)},
        RealInput{"window_manager_png", "/usr/share/pixmaps/openbox.png", "--diameter 20 --smooth 0.2", 9,
                  relief(20.0, 48, 48, kPulse_mm), true},
        RealInput{"dots_png", "/usr/lib/python3/dist-packages/scipy/ndimage/tests/dots.png", "--diameter 20",
                  9, relief(20.0, 420, 300, 0.01)},
        RealInput{"gradient_jpg",
                  "/usr/share/qt6/doc/global/template/images/Qt-header-bg.jpg",
                  "--diameter 30 --height 10 --full-turn",
                  9,
                  {{kUnknown, kUnknown, 10.0}, kUnknown, kUnknown, 0.006}}),
    [](const auto& chosen) { return chosen.param.name; });

class RealCircuit : public CliTest {};

// A transistor: a circle in a block, beside lines that stay open. What becomes of it is known.
TEST_F(RealCircuit, HasACaseThatIsRound) {
    const Outcome sliced = psicarve({"slice", kLibrecad + "elektro/transistor/vt31.dxf", "-o",
                                     file("real.job"), "--layers", "4", "--points", "61", "--json"});
    ASSERT_EQ(sliced.exit_code, 0) << sliced.error;
    EXPECT_NEAR(sliced.json()["report"]["r_min_mm"].get<double>(), 5.0, 0.003);
    EXPECT_NEAR(sliced.json()["report"]["r_max_mm"].get<double>(), 5.0, 0.003);
    EXPECT_NE(sliced.error.find("4 strokes are not closed and left out"), std::string::npos) << sliced.error;
}

struct Refusal {
    std::string name;
    std::string path;
    std::string options;
    std::string said;

    friend void PrintTo(const Refusal& input, std::ostream* out) { *out << input.path << input.options; }
};

class RealDrawingThatIsNone : public RefusalTest, public ::testing::WithParamInterface<Refusal> {};

TEST_P(RealDrawingThatIsNone, IsRefusedWithItsReason) {
    const Refusal& input = GetParam();
    ASSERT_TRUE(std::filesystem::exists(input.path))
        << input.path << " is not there: scripts/deps.sh test installs it";
    std::vector<std::string> slice{"slice", input.path, "-o", file("real.job")};
    for (const std::string& word : words_of(input.options)) slice.push_back(word);
    expect_refused(slice, input.path.substr(input.path.rfind('/') + 1));
    const Outcome again = psicarve(slice);
    EXPECT_NE(again.error.find(input.said), std::string::npos) << again.error;
}

INSTANTIATE_TEST_SUITE_P(
    FromPackages, RealDrawingThatIsNone,
    ::testing::Values(
        Refusal{"open_splines", kLibrecad + "kinetics/kin39.dxf", "",
                "has no closed outline; the longest stroke goes from (0.000, 3.500) to (12.000, 3.500) mm"},
        Refusal{"open_arcs", kLibrecad + "elektro/grounding/gr6.dxf", "", "has no closed outline"},
        Refusal{"strokes_there_and_back", kLibrecad + "plan/vegetation/v15.dxf", "",
                "its outlines enclose no area"},
        Refusal{
            "leaves_round_an_empty_middle", kLibrecad + "plan/vegetation/v22.dxf", "--fit --blank 12x20",
            "lies wholly within the core radius of 1.50 mm: nothing but a plain rod would be carved; it is "
            "1.60 x 0.40 x 20.00 mm large"},
        Refusal{"a_plan_of_metres", kLibrecad + "plan/architect/Complete-Lib-E.dxf", "",
                "larger than the machine's travel"}),
    [](const auto& chosen) { return chosen.param.name; });

}  // namespace
}  // namespace psicarve::test
