// SPDX-License-Identifier: GPL-3.0-or-later
// Lines engraved into a cylinder, pictures wrapped round one, and the blank that is carved, as psicarve's
// options say.
#include "tests/hmi/cli/program_run.hpp"

namespace psicarve::test {
namespace {

class EngraveCommand : public CliTest {
protected:
    EngraveCommand() {
        write("lines.svg",
              "<svg xmlns='http://www.w3.org/2000/svg' width='40mm' height='10mm' viewBox='0 0 40 10'>"
              "<g fill='none' stroke='black' stroke-width='2'><path d='M0 0 L40 10'/><circle cx='20' cy='5' "
              "r='4'/>"
              "</g></svg>");
    }
    Outcome on_lines(const std::string& command, const std::string& options) const {
        std::vector<std::string> arguments{command, file("lines.svg"), "--layers", "20", "--points", "91"};
        for (const std::string& word : words_of(options)) arguments.push_back(word);
        if (command == "slice") arguments.insert(arguments.end(), {"-o", file("lines.job")});
        return psicarve(arguments);
    }
    void expect_usage(const std::string& model, const std::string& options, const std::string& said) const {
        std::vector<std::string> arguments{"inspect", file(model)};
        for (const std::string& word : words_of(options)) arguments.push_back(word);
        const Outcome outcome = psicarve(arguments);
        EXPECT_EQ(outcome.exit_code, 2) << options;
        EXPECT_EQ(outcome.error_lines(), 1U) << outcome.error;
        EXPECT_NE(outcome.error.find(said), std::string::npos) << outcome.error;
    }
};

TEST_F(EngraveCommand, CutsLinesIntoACylinder) {
    const Outcome sliced = on_lines(
        "slice", "--engrave 0.5 --tool flat:1.5 --start 45 --stroke-width --diameter 30 --height 16 --json");
    ASSERT_EQ(sliced.exit_code, 0) << sliced.error;
    const auto report = sliced.json()["report"];
    EXPECT_EQ(report["body"]["engrave"]["depth_mm"], 0.5);
    EXPECT_EQ(report["body"]["engrave"]["start_deg"], 45.0);
    EXPECT_EQ(report["body"]["engrave"]["stroke_width"], true);
    EXPECT_EQ(report["body"]["engrave"]["tool"], "flat");
    EXPECT_NEAR(report["r_max_mm"].get<double>(), 15.0, 0.003);
    EXPECT_NEAR(report["r_min_mm"].get<double>(), 14.5, 0.003);
    EXPECT_NEAR(report["bounding_box_mm"][2].get<double>(), 16.0, 1e-5);
    EXPECT_NE(sliced.error.find("grooves 0.50 mm deep and 2.00 mm wide"), std::string::npos) << sliced.error;
}

TEST_F(EngraveCommand, CutsIntoTheBlankWhereNoDiameterIsGiven) {
    const Outcome looked = on_lines("inspect", "--engrave 0.5 --tool ball:2 --blank 12x40 --json");
    ASSERT_EQ(looked.exit_code, 0) << looked.error;
    EXPECT_NEAR(looked.json()["report"]["r_max_mm"].get<double>(), 12.0, 0.003);
    EXPECT_EQ(looked.error.find("the blank"), std::string::npos) << looked.error;
    // What the tool takes off the blank is the grooves' volume; no more than what they are wide and deep.
    const double removed_mm3 = looked.json()["expected"]["removed_mm3"].get<double>();
    EXPECT_GT(removed_mm3, 40.0 * 0.5);
    EXPECT_LT(removed_mm3, 90.0 * 3.0 * 0.5);
    const Outcome estimated = on_lines("estimate", "--engrave 0.5 --tool ball:2 --blank 12x40 --json");
    ASSERT_EQ(estimated.exit_code, 0) << estimated.error;
    EXPECT_NEAR(estimated.json()["removed_mm3"].get<double>(), removed_mm3, 0.1 * removed_mm3);
}

TEST_F(EngraveCommand, RefusesWhatDoesNotFitOrBelong) {
    const Outcome wide = on_lines("slice", "--engrave 0.5 --diameter 10");
    EXPECT_EQ(wide.exit_code, 3);
    EXPECT_NE(wide.error.find("lines.svg: the drawing is 40.00 mm wide, and once round the cylinder are only "
                              "31.42 mm: at most --scale 0.7853"),
              std::string::npos)
        << wide.error;
    EXPECT_EQ(on_lines("slice", "--engrave 0.5 --diameter 10 --scale 0.7853").exit_code, 0);
    EXPECT_EQ(on_lines("slice", "--engrave 0.5 --diameter 10 --full-turn").exit_code, 0);
    expect_usage("lines.svg", "--engrave 0.5 --full-turn --scale 2", "--full-turn excludes --scale");
    expect_usage("lines.svg", "--engrave 0.5 --up x", "--rotate and --mirror are not for lines");
    expect_usage("lines.svg", "--engrave 0.5 --start x", "'x' is not a direction in degrees");
    EXPECT_EQ(on_lines("slice", "--engrave 0.5 --start -90").exit_code, 0);
    expect_usage("lines.svg", "--start 5", "--start and --stroke-width are for --engrave");
    expect_usage("lines.svg", "--full-turn", "for drawings with --engrave");
    expect_usage("lines.svg", "--engrave 0.5 --invert", "is not a picture");
    write("grey.pgm", "P2 4 1 9\n1 5 5 1\n");
    expect_usage("grey.pgm", "--diameter 20 --scale 2",
                 "--fit and --scale are not for pictures: --diameter says how large a cylinder is");
    (void)box_stl("box.stl");
    expect_usage("box.stl", "--engrave 0.5", "is not a drawing (SVG, DXF)");
}

TEST_F(EngraveCommand, TakesABlankThatStandsOffTheAxisAndADepthLimit) {
    const std::string model = box_stl("box.stl");
    const Outcome sliced =
        psicarve({"slice", model, "-o", file("box.job"), "--layers", "4", "--points", "17", "--blank",
                  "20x30", "--blank-at", "1.5,-2", "--depth-limit", "12.5", "--json"});
    ASSERT_EQ(sliced.exit_code, 0) << sliced.error;
    EXPECT_GT(sliced.json()["report"]["depth_limit"]["points"].get<int>(), 4);
    EXPECT_NE(sliced.error.find("the depth limit of 12.50 mm below the blank's surface"), std::string::npos)
        << sliced.error;
    const Outcome info = psicarve({"profile", "show", "--profile", file("box.job")});
    EXPECT_NE(info.out.find("offset_x_mm = 1.5"), std::string::npos) << info.out;
    EXPECT_NE(info.out.find("offset_z_mm = -2"), std::string::npos) << info.out;
    EXPECT_NE(info.out.find("depth_limit_mm = 12.5"), std::string::npos) << info.out;
    // A table as well.
    write("radii.csv", "y_mm,r_mm\n5,9,9,4,9\n6,9,9,9,9\n");
    const Outcome table = psicarve({"slice", file("radii.csv"), "-o", file("table.job"), "--blank", "10x9",
                                    "--depth-limit", "3", "--json"});
    ASSERT_EQ(table.exit_code, 0) << table.error;
    EXPECT_EQ(table.json()["report"]["depth_limit"]["points"], 2);
    EXPECT_NEAR(table.json()["report"]["depth_limit"]["most_mm"].get<double>(), 3.0, 0.003);
    expect_usage("box.stl", "--blank 5x9 --blank-at 3,4", "would be outside the blank");
    expect_usage("box.stl", "--blank 5x9 --blank-at 3", "is not X,Z in mm");
    expect_usage("box.stl", "--depth-limit 2", "--blank says where that is");
    expect_usage("box.stl", "--blank 5x9 --depth-limit 0",
                 "--depth-limit: '0' is not a number greater than 0");
}

TEST_F(EngraveCommand, APicturesWhiteMayLieAtTheSurface) {
    write("relief.pgm", "P2 4 4 9\n9 9 9 9 0 0 0 0 9 9 9 9 0 0 0 0\n");
    const Outcome looked = psicarve({"inspect", file("relief.pgm"), "--white-depth", "0", "--depth", "1"});
    EXPECT_EQ(looked.exit_code, 0) << looked.error;
    expect_usage("relief.pgm", "--white-depth -1", "--white-depth: '-1' is not a number from 0 on");
}

}  // namespace
}  // namespace psicarve::test
