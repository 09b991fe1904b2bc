// SPDX-License-Identifier: GPL-3.0-or-later
#include <png.h>

#include <cstddef>
#include <string>
#include <vector>

#include "tests/hmi/cli/program_run.hpp"

namespace psicarve::test {
namespace {

class InspectCommand : public CliTest {};

TEST_F(InspectCommand, TellsWhatAMeshIsMadeOfAndHowItWouldStand) {
    const Outcome outcome = psicarve({"inspect", box_stl("box.stl"), "--layers", "4", "--points", "17",
                                      "--json", "--scale", "0.5", "--tool", "ball:2"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
    const auto report = outcome.json();
    const auto& mesh = report["mesh"];
    EXPECT_EQ(mesh["triangles"], 12);
    EXPECT_EQ(mesh["components"], 1);
    EXPECT_EQ(mesh["holes"], 0);
    EXPECT_EQ(mesh["inside_out"], 0);
    EXPECT_NEAR(mesh["volume_mm3"].get<double>(), 20.0 * 14.0 * 6.0 / 8.0, 1e-3);
    EXPECT_EQ(mesh["probable_unit"], "mm");
    EXPECT_NEAR(report["report"]["bounding_box_mm"][0].get<double>(), 10.0, 1e-6);
    EXPECT_FALSE(report["report"].contains("open_heights_mm"));
    // The box's corners stand 22.5 degrees apart at most: chords cut them.
    EXPECT_LT(report["expected"]["gouge"]["max_mm"].get<double>(), 1.5);
    EXPECT_GT(report["expected"]["places"].get<int>(), 1000);
}

// Looking for a better axis takes longer than all the slicing.
TEST_F(InspectCommand, LooksForABetterAxisAndSliceNamesTheWay) {
    const std::vector<std::string> beside{box_stl("box.stl"), "--layers", "4",     "--points", "17",
                                          "--axis-at",        "12,0",     "--json"};
    std::vector<std::string> arguments{"inspect"};
    arguments.insert(arguments.end(), beside.begin(), beside.end());
    const Outcome inspected = psicarve(arguments);
    ASSERT_EQ(inspected.exit_code, 0) << inspected.error;
    EXPECT_NE(inspected.error.find("cannot be reached; --axis-at best would lose 0.0 % of the surface"),
              std::string::npos)
        << inspected.error;
    EXPECT_EQ(inspected.json()["report"]["best_axis"]["loss"]["layers_without_axis_share"], 0.0);
    arguments.front() = "slice";
    arguments.insert(arguments.end(), {"-o", file("box.job")});
    const Outcome sliced = psicarve(arguments);
    ASSERT_EQ(sliced.exit_code, 0) << sliced.error;
    EXPECT_NE(sliced.error.find("cannot be reached; --axis-at best looks for an axis that loses less"),
              std::string::npos)
        << sliced.error;
    EXPECT_FALSE(sliced.json()["report"].contains("best_axis"));
}

TEST_F(InspectCommand, DraftsWhatAToolWouldLeaveWithoutSlicing) {
    // A slot 2 mm wide and 3 mm deep in a bar of 10 mm, across the direction 0.
    write("slot.obj",
          "v -5 -5 0\nv 5 -5 0\nv 5 -1 0\nv 2 -1 0\nv 2 1 0\nv 5 1 0\nv 5 5 0\nv -5 5 0\n"
          "v -5 -5 9\nv 5 -5 9\nv 5 -1 9\nv 2 -1 9\nv 2 1 9\nv 5 1 9\nv 5 5 9\nv -5 5 9\n"
          "f 1 2 10 9\nf 2 3 11 10\nf 3 4 12 11\nf 4 5 13 12\nf 5 6 14 13\nf 6 7 15 14\nf 7 8 16 15\n"
          "f 8 1 9 16\nf 9 10 11 12\nf 9 12 13 16\nf 13 14 15 16\nf 4 3 2 1\nf 8 5 4 1\nf 8 7 6 5\n");
    const auto left_mm = [this](const std::string& tool) {
        const Outcome draft = psicarve(
            {"inspect", file("slot.obj"), "--draft", "--tool", tool, "--axis-at", "origin", "--json"});
        EXPECT_EQ(draft.exit_code, 0) << draft.error;
        const auto report = draft.json();
        EXPECT_LT(report["expected"]["gouge"]["max_mm"].get<double>(), 0.5) << tool;
        return report["expected"]["leftover"]["max_mm"].get<double>();
    };
    EXPECT_GT(left_mm("ball:6"), 0.5);
    EXPECT_LT(left_mm("ball:1"), left_mm("ball:6"));
    EXPECT_GT(left_mm("flat:6"), 0.5);
    const Outcome point = psicarve({"inspect", file("slot.obj"), "--draft"});
    EXPECT_EQ(point.exit_code, 2) << point.error;
    EXPECT_NE(point.error.find("a point leaves nothing"), std::string::npos) << point.error;
    const Outcome drawn = psicarve(
        {"inspect", file("slot.obj"), "--draft", "--tool", "ball:6", "--preview", file("draft.png")});
    ASSERT_EQ(drawn.exit_code, 0) << drawn.error;
    EXPECT_EQ(text_of(file("draft.png")).substr(1, 3), "PNG");
    EXPECT_NE(drawn.out.find("tool       ball 6 mm: leaves at most"), std::string::npos) << drawn.out;
}

TEST_F(InspectCommand, NamesHolesAndWhereTheyAre) {
    const Outcome whole = psicarve({"inspect", box_stl("box.stl"), "--layers", "6", "--points", "17"});
    ASSERT_EQ(whole.exit_code, 0) << whole.error;
    EXPECT_NE(whole.out.find("surface    closed"), std::string::npos) << whole.out;
    EXPECT_NE(whole.out.find("\nvolume     1.68 cm3\n"), std::string::npos) << whole.out;
    const Outcome small =
        psicarve({"inspect", box_stl("box.stl"), "--layers", "6", "--points", "17", "--scale", "0.5"});
    EXPECT_NE(small.out.find("\nvolume     210 mm3\n"), std::string::npos) << small.out;
    // A facet is missing on one side.
    write("open.obj",
          "v -5 -5 0\nv 5 -5 0\nv 5 5 0\nv -5 5 0\nv -5 -5 9\nv 5 -5 9\nv 5 5 9\nv -5 5 9\n"
          "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5\n");
    const Outcome open = psicarve({"inspect", file("open.obj"), "--layers", "6", "--points", "17"});
    ASSERT_EQ(open.exit_code, 0) << open.error;
    EXPECT_NE(open.out.find("1 hole (3 open edges)"), std::string::npos) << open.out;
    EXPECT_NE(open.out.find("\nvolume     none: the mesh is open\n"), std::string::npos) << open.out;
    // Closed, with one facet flipped.
    write("flipped.obj",
          "v -5 -5 0\nv 5 -5 0\nv 5 5 0\nv -5 5 0\nv -5 -5 9\nv 5 -5 9\nv 5 5 9\nv -5 5 9\n"
          "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5\nf 8 5 4\n");
    const Outcome flipped = psicarve({"inspect", file("flipped.obj"), "--layers", "6", "--points", "17"});
    EXPECT_NE(flipped.out.find("\nvolume     none: facets are turned both ways\n"), std::string::npos)
        << flipped.out;
    EXPECT_NE(open.out.find("samples, between "), std::string::npos) << open.out;
}

/// A post about the axis and, in the directions 350 to 10 and from 4 to 7 mm high, a wall before it; the wall
/// that looks at direction 90 is missing.
constexpr const char* kPosts =
    "v -2 -2 0\nv 2 -2 0\nv 2 2 0\nv -2 2 0\nv -2 -2 10\nv 2 -2 10\nv 2 2 10\nv -2 2 10\n"
    "v 5 -0.88 4\nv 6 -0.88 4\nv 6 0.88 4\nv 5 0.88 4\nv 5 -0.88 7\nv 6 -0.88 7\nv 6 0.88 7\nv 5 0.88 7\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 4 1 5 8\n"
    "f 12 11 10 9\nf 13 14 15 16\nf 9 10 14 13\nf 10 11 15 14\nf 11 12 16 15\nf 12 9 13 16\n";

TEST_F(InspectCommand, TellsWhereTheModelIsHiddenAndOpenAndWhatTheToolLeaves) {
    write("posts.obj", kPosts);
    const std::vector<std::string> arguments{"inspect", file("posts.obj"), "--axis-at", "origin", "--layers",
                                             "40",      "--points",        "91",        "--tool", "flat:3"};
    auto in_json = arguments;
    in_json.emplace_back("--json");
    const Outcome told = psicarve(in_json);
    ASSERT_EQ(told.exit_code, 0) << told.error;
    const auto hidden = told.json()["hidden"];
    ASSERT_EQ(hidden["directions"].size(), 1U) << hidden;
    EXPECT_EQ(hidden["directions"][0]["from_deg"], 350.0);
    EXPECT_EQ(hidden["directions"][0]["to_deg"], 370.0);
    ASSERT_EQ(hidden["heights"].size(), 1U) << hidden;
    EXPECT_NEAR(hidden["heights"][0]["from_mm"].get<double>(), 4.0, 0.051);
    EXPECT_NEAR(hidden["heights"][0]["to_mm"].get<double>(), 7.0, 0.051);
    EXPECT_EQ(hidden["by_direction"].size(), 36U);
    EXPECT_EQ(hidden["open_directions"][0]["from_deg"], 40.0);
    EXPECT_EQ(hidden["open_directions"][0]["to_deg"], 140.0);
    const auto unreached = told.json()["unreached"];
    EXPECT_GT(unreached["share"].get<double>(), 0.001);
    EXPECT_LT(unreached["share"].get<double>(), 0.9);
    EXPECT_EQ(unreached["largest_mm"], told.json()["expected"]["leftover"]["max_mm"]);
    const Outcome text = psicarve(arguments);
    EXPECT_NE(text.out.find("most in 350-10 deg, through 0 ("), std::string::npos) << text.out;
    EXPECT_NE(text.out.find("and at 4.0-7.0 mm ("), std::string::npos) << text.out;
    EXPECT_NE(text.out.find("most in 40-140 deg ("), std::string::npos) << text.out;
    EXPECT_NE(text.out.find("more than 0.1 mm on "), std::string::npos) << text.out;
}

TEST_F(InspectCommand, TellsOfATableWhatATableHas) {
    write("radii.csv", "y_mm,r_mm\n1,5,5,5,5\n2,5,6,5,6\n");
    const Outcome text = psicarve({"inspect", file("radii.csv")});
    ASSERT_EQ(text.exit_code, 0) << text.error;
    EXPECT_EQ(text.out, "job        2 layers x 3 points\n");
    const Outcome sliced = psicarve({"slice", file("radii.csv"), "-o", file("radii.job")});
    EXPECT_NE(sliced.out.find("radii.job: 2 layers x 3 points\n"), std::string::npos) << sliced.out;
    const auto json = psicarve({"slice", file("radii.csv"), "-o", file("radii.job"), "--json"}).json();
    EXPECT_TRUE(json["undercut_share"].is_null());
    EXPECT_TRUE(json["open_points"].is_null());
    const Outcome carved = run({"carve", file("radii.csv"), "--deviation", file("d.png")});
    EXPECT_EQ(carved.exit_code, 2) << carved.error;
    EXPECT_NE(carved.error.find("radii.csv is a table of radii, which has none"), std::string::npos)
        << carved.error;
}

TEST_F(InspectCommand, DrawsAPreviewAsSliceDoes) {
    const std::string model = box_stl("box.stl");
    ASSERT_EQ(
        psicarve({"inspect", model, "--layers", "4", "--points", "17", "--preview", file("a.png")}).exit_code,
        0);
    ASSERT_EQ(psicarve({"slice", model, "--layers", "4", "--points", "17", "-o", file("a.job"), "--preview",
                        file("b.png")})
                  .exit_code,
              0);
    EXPECT_EQ(text_of(file("a.png")).substr(1, 3), "PNG");
    EXPECT_TRUE(text_of(file("a.png")) == text_of(file("b.png")));
    const Outcome jpeg = psicarve({"inspect", model, "--preview", file("a.jpg")});
    EXPECT_EQ(jpeg.exit_code, 3);
    EXPECT_EQ(jpeg.error_lines(), 1U) << jpeg.error;
    EXPECT_EQ(psicarve({"inspect", file("a.job")}).exit_code, 3);
}

/// How many of a PNG's pixels are wood: redder than blue by more than a shade of grey.
std::size_t wood_in(const std::string& path) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    EXPECT_NE(png_image_begin_read_from_file(&image, path.c_str()), 0) << image.message;
    image.format = PNG_FORMAT_RGB;
    std::vector<png_byte> rgb(PNG_IMAGE_SIZE(image));
    EXPECT_NE(png_image_finish_read(&image, nullptr, rgb.data(), 0, nullptr), 0) << image.message;
    std::size_t count = 0;
    for (std::size_t i = 0; i + 2 < rgb.size(); i += 3) count += rgb[i] > rgb[i + 2] + 25 ? 1 : 0;
    return count;
}

// Both views of the same outline: what is more is wood above the model.
TEST_F(InspectCommand, DrawsWhatIsLeftOfTheBlankAboveTheModel) {
    const auto drawn = [this](const std::string& name, double height_mm, const std::string& tool) {
        const std::string model = box_stl("box" + name + ".stl", height_mm);
        const std::string picture = file(name + ".png");
        const Outcome outcome =
            psicarve({"slice", model, "--layers", "12", "--points", "61", "--blank", "14x30", "--tool", tool,
                      "-o", file(name + ".job"), "--preview", picture});
        EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
        return wood_in(picture);
    };
    for (const char* tool : {"ball:3", "point"}) {
        // The blank is wider than the box: the less of it is carved, the more wood there is.
        const std::size_t high = drawn("high", 29.0, tool);
        const std::size_t low = drawn("low", 6.0, tool);
        EXPECT_GT(low, high) << tool;
    }
}

}  // namespace
}  // namespace psicarve::test
