// SPDX-License-Identifier: GPL-3.0-or-later
// What the readers of drawings, pictures and tables say, as they say it.
#include "hmi/phrase/flat_phrase.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "hmi/cam/job_builder.hpp"
#include "hmi/cam/table_job.hpp"
#include "hmi/flat/load_model.hpp"
#include "hmi/phrase/error_phrase.hpp"
#include "hmi/phrase/warning_phrase.hpp"
#include "tests/shared/temporary_folder.hpp"

namespace psicarve::session {
namespace {

class FlatPhrase : public ::testing::Test {
protected:
    std::string written(const std::string& name, const std::string& content) const {
        std::ofstream{folder_.path(name), std::ios::binary} << content;
        return folder_.path(name);
    }
    void expect_refusal(const std::string& name, const std::string& content,
                        const flat::FlatOptions& options = {}) const {
        const auto mesh = flat::load_model(written(name, content), options);
        ASSERT_FALSE(mesh) << name;
        expect_known(mesh.error().message);
    }
    void expect_table_refusal(const std::string& content) const {
        const auto job = cam::job_from_table(written("table.csv", content), Profile{}, std::nullopt);
        ASSERT_FALSE(job) << content;
        expect_known(job.error().message);
    }
    static void expect_known(const std::string& message) {
        const Phrase shown = error_phrase(message);
        EXPECT_STRNE(shown.english, "%1") << message;
        EXPECT_EQ(in_english(shown).find("--"), std::string::npos) << message;
    }
    void expect_warnings(const std::string& name, const std::string& content, std::size_t count,
                         const flat::FlatOptions& options = {}) const {
        const auto mesh = flat::load_model(written(name, content), options);
        ASSERT_TRUE(mesh) << mesh.error().message;
        EXPECT_EQ(mesh->warnings.size(), count) << name << ": " << ::testing::PrintToString(mesh->warnings);
        for (const std::string& warning : mesh->warnings) {
            EXPECT_STRNE(warning_phrase(warning).english, "%1") << warning;
            EXPECT_EQ(in_english(warning_phrase(warning)).find("--"), std::string::npos);
        }
    }
    /// A picture of one row, brightness 0 to 9.
    static std::string pgm(const std::string& row, int width) {
        return "P2 " + std::to_string(width) + " 1 9\n" + row + "\n";
    }

    const psicarve::test::TemporaryFolder folder_;
};

TEST_F(FlatPhrase, KnowsWhyADrawingIsRefused) {
    expect_refusal("cut.svg", "<svg><path d='M 0 0 L 1 1'");
    expect_refusal("wrong.svg", "<svg><path></svg>");
    expect_refusal("other.svg", "<html></html>");
    expect_refusal("empty.svg", "");
    expect_refusal("none.svg", "<svg width='10mm' height='10mm'></svg>");
    expect_refusal("open.svg", "<svg width='9mm' height='9mm'><path d='M 0 0 L 5 5'/></svg>");
    expect_refusal("flat.svg", "<svg width='0mm' height='9mm'><path d='M 0 0 L 5 5'/></svg>");
    expect_refusal("line.svg", "<svg width='9mm' height='9mm'><path d='M 0 0 L 5 5 Z'/></svg>");
    expect_refusal("binary.dxf", std::string{"AutoCAD Binary DXF\r\n\x1a\0\0\0SECTION", 31});
    expect_refusal("other.dxf", "nothing of a drawing\n");
    expect_refusal("cut.dxf", "0\nSECTION\n2\nENTITIES\n");
    expect_refusal("number.dxf", "0\nSECTION\n2\nENTITIES\n0\nLINE\n10\nx\n0\nENDSEC\n0\nEOF\n");
}

TEST_F(FlatPhrase, KnowsWhatIsNotReadAtAllAndWhyThereAreNoLines) {
    for (const char* head : {"\x1f\x8b\x08", "GIF89a", "%PDF-1.4", "%!PS", "AC1027", "ISO-10303-21;", "glTF",
                             "Kaydara FBX", "BLENDER", "8BPS", "words", "0123ftypavif", "0123ftypheic"}) {
        expect_refusal("foreign.foo", head);
    }
    expect_refusal("text.off", "OFF BINARY\n");
    const std::string no_lines = "<svg width='9mm' height='9mm'>\n<path d='M nan'/></svg>";
    expect_refusal("nan.svg", no_lines);
    flat::FlatOptions engraved;
    engraved.engraving = {1.0, 0.0, false, {}};
    expect_refusal("nan.svg", no_lines, engraved);
    const auto mesh = flat::load_model(written("nan.svg", no_lines), {});
    const std::string shown = in_english(error_phrase(mesh.error().message));
    EXPECT_TRUE(
        shown.ends_with("nan.svg: holds no line that can be carved (SVG): line 2: <path> is not right; what "
                        "follows the fault is left out."))
        << shown;
    expect_refusal("solid.dxf", "0\nSECTION\n2\nENTITIES\n0\nSOLID\n8\n0\n0\nENDSEC\n0\nEOF\n");
}

TEST_F(FlatPhrase, KnowsWhyAPictureIsRefused) {
    expect_refusal("other.png", "nothing of a picture");
    expect_refusal("cut.png", "\x89PNG\r\n\x1a\n and no more");
    expect_refusal("cut.jpg", "\xff\xd8\xff and no more");
    expect_refusal("cut.bmp", "BM and no more");
    expect_refusal("cut.tif", std::string{"II*\0 and no more", 16});
    // A directory of a width, a height and a depth that is not read; and one of nothing.
    const auto tiff = [](char bits) {
        return std::string("II*\0\x08\0\0\0\x04\0", 10) + std::string("\0\1\3\0\1\0\0\0\1\0\0\0", 12) +
               std::string("\1\1\3\0\1\0\0\0\1\0\0\0", 12) + std::string("\2\1\3\0\1\0\0\0", 8) + bits +
               std::string(3, '\0') + std::string("\6\1\3\0\1\0\0\0\1\0\0\0\0\0\0\0", 16);
    };
    expect_refusal("wide.tif", tiff(32));
    expect_refusal("none.tif", tiff(8));
    expect_refusal("entries.tif", std::string("II*\0\x08\0\0\0\0\0\0\0\0\0", 14));
    expect_refusal("head.bmp",
                   std::string("BM\0\0\0\0\0\0\0\0\x01\0\0\0\x28\0\0\0\1\0\0\0\1\0\0\0\1\0\x18\0", 30) +
                       std::string(28, '\0'));
    expect_refusal("cut.pgm", "P2 4 1 9\n1 2\n");
    expect_refusal("size.pgm", "P2 x\n");
    expect_refusal("white.pgm", "P2 1 1 99999\n1\n");
    expect_refusal("none.pgm", "P2 0 4 9\n");
    expect_refusal("large.pgm", "P2 60000 60000 9\n");
    flat::FlatOptions deep;
    deep.depth_mm = 30.0;
    expect_refusal("deep.pgm", pgm("0 9 0 9", 4), deep);
    flat::FlatOptions high;
    high.height_mm = 100.0;
    expect_refusal("wide.pgm", pgm("0 9 0 9", 4), high);
}

TEST_F(FlatPhrase, KnowsWhyLinesAreNotEngravedAndWhatIsWarnedOf) {
    const std::string line =
        "<svg width='90mm' height='90mm' viewBox='0 0 90 90'><path d='M 0 0 L 50 30'/></svg>";
    flat::FlatOptions options;
    options.engraving = {1.0, 0.0, true, ToolProfile{ToolShape::flat, 2.0}};
    options.diameter_mm = 9.0;
    expect_refusal("wide.svg", line, options);
    options.engraving->depth_mm = 9.0;
    expect_refusal("deep.svg", line, options);
    options.diameter_mm = 40.0;
    options.height_mm = 12.0;
    expect_refusal("high.svg", line, options);
    options.is_full_turn = true;
    expect_refusal("none.svg", "<svg width='9mm' height='9mm'></svg>", options);
    expect_refusal("upright.svg", "<svg width='9mm' height='9mm'><path d='M 1 1 V 2'/></svg>", options);
    options = {};
    options.engraving = {1.0, 0.0, true, ToolProfile{ToolShape::flat, 2.0}};
    const auto mesh = flat::load_model(written("lines.svg", line), options);
    ASSERT_TRUE(mesh) << mesh.error().message;
    ASSERT_EQ(mesh->warnings.size(), 1U);
    EXPECT_STRNE(warning_phrase(mesh->warnings[0]).english, "%1") << mesh->warnings[0];
    Profile profile;
    const auto other = cam::build_job(*mesh, profile, {});
    ASSERT_FALSE(other);
    expect_known(other.error().message);
    profile.tool = options.engraving->tool;
    profile.core_radius_mm = 19.5;
    cam::JobOptions coarse;
    coarse.layer_count = 4;
    const auto job = cam::build_job(*mesh, profile, coarse);
    ASSERT_TRUE(job) << job.error().message;
    EXPECT_EQ(job->report.warnings.size(), 3U);
    for (const std::string& warning : job->report.warnings)
        EXPECT_STRNE(warning_phrase(warning).english, "%1") << warning;
    ASSERT_EQ(job->report.notes.size(), 1U);
    expect_known(job->report.notes[0]);
}

TEST_F(FlatPhrase, KnowsWhyNothingWouldBeCarved) {
    const auto mesh = flat::load_model(
        written("square.svg", "<svg width='9mm' height='9mm'><rect width='5' height='5'/></svg>"), {});
    ASSERT_TRUE(mesh);
    cam::JobOptions options;
    options.point_count = 11;
    options.axis_at = cam::AxisAt::point;
    options.axis_x = 500.0;
    const auto beside = cam::build_job(*mesh, Profile{}, options);
    ASSERT_FALSE(beside);
    expect_known(beside.error().message);
    Profile profile;
    profile.job.base_height_mm = 2.0;
    profile.blank = {20.0, 1.0};
    const auto above = cam::build_job(*mesh, profile, {});
    ASSERT_FALSE(above);
    expect_known(above.error().message);
}

TEST_F(FlatPhrase, KnowsWhyATableIsRefused) {
    expect_table_refusal(
        "layer,point,y_pulses,psi_pulses,r_left_pulses,r_right_pulses\n"
        "0,0,5,0,900,900\n0,1,5,3200,900,900\n1,0,5,3200,900,900\n1,1,5,6400,900,900\n");
    expect_table_refusal("y_mm,r_mm\n");
    expect_table_refusal("height,radius\n");
    expect_table_refusal("y_mm,r_mm\n1,2\n");
    expect_table_refusal("y_mm,r_mm\n1,5,x\n");
    expect_table_refusal("y_mm,r_mm\n1,5,5\n2,5,5,5\n");
    expect_table_refusal("y_mm,r_mm\n1,0.2,5\n");
    expect_table_refusal("y_mm,r_mm\n1,500,5\n");
    expect_table_refusal("y_mm,r_mm\n2,5,5\n1,5,5\n");
    const std::string exported = "layer,point,y_pulses,psi_pulses,r_left_pulses,r_right_pulses\n";
    expect_table_refusal(exported);
    expect_table_refusal(exported + "0,0,1\n");
    expect_table_refusal(exported + "0,0,400,0,4000,4000\n");
    expect_table_refusal(exported + "0,0,5,0,900,900\n0,1,6,3200,900,900\n");
    expect_table_refusal(exported +
                         "0,0,400,0,900,900\n0,1,400,3200,900,900\n1,0,400,3200,900,900\n"
                         "1,1,800,6400,900,900\n");
    const std::string passes = exported.substr(0, exported.size() - 1) +
                               ",run,pass,allowance_mm,depth_mm,clear_mm\n0,0,400,0,4000,4000,1,1,0,0,9\n";
    expect_table_refusal(passes + "0,1,400,3200,4000,4000,2,2,0,0,9\n");
    expect_table_refusal(passes + "1,0,400,3200,4000,4000,3,2,0,0,9\n");
    expect_table_refusal(passes + "1,0,400,3200,4000,4000,2,2,-1,0,9\n");
    expect_table_refusal(passes + "1,0,400,3200,4000,4000,2,2,0,0,900\n");
    expect_table_refusal(exported + "0,0,1.5,0,4000,4000\n");
    expect_table_refusal(exported + "0,1,400,0,4000,4000\n");
    expect_table_refusal(exported + "0,0,400,0,4000,4000\n0,1,400,100,4000,4000\n0,2,400,3200,4000,4000\n");
}

TEST_F(FlatPhrase, KnowsWhyATableOfASpiralIsNotRoughed) {
    Profile profile;
    profile.blank.radius_mm = 12.0;
    profile.roughing.stepdown_mm = 2.0;
    const std::string spiral =
        "layer,point,y_pulses,psi_pulses,r_left_pulses,r_right_pulses\n"
        "0,0,400,0,4000,4000\n0,1,400,3200,4000,4000\n1,0,400,3200,4000,4000\n"
        "1,1,800,6400,4000,4000\n2,0,800,6400,4000,4000\n2,1,800,9600,4000,4000\n";
    const auto job = cam::job_from_table(written("table.csv", spiral), profile, std::nullopt);
    ASSERT_FALSE(job);
    expect_known(job.error().message);
}

TEST_F(FlatPhrase, KnowsWhatIsWarnedOf) {
    const std::string square = "<rect width='5' height='5'/>";
    expect_warnings("beyond.svg", "<svg width='1mm' height='9mm'>" + square + "</svg>", 1);
    expect_warnings("bare.svg", "<svg>" + square + "</svg>", 1);
    expect_warnings("text.svg", "<svg width='9mm' height='9mm'>" + square + "<text>a</text><image/></svg>",
                    2);
    expect_warnings("open.svg",
                    "<svg width='9mm' height='9mm'>" + square + "<path fill='none' d='M 6 6 L 8 8'/></svg>",
                    1);
    expect_warnings("opens.svg",
                    "<svg width='9mm' height='9mm'>" + square +
                        "<path fill='none' d='M 6 6 L 8 8'/><path fill='none' d='M 7 6 L 8 6'/></svg>",
                    1);
    expect_warnings("wrong.svg",
                    "<svg width='9mm' height='9mm'>" + square +
                        "<path d='M 0 0 L x'/><use href='#none'/><g transform='turn(3)'/><circle r='-1'/>"
                        "<g mask='url(#m)'/></svg>",
                    5);
    expect_warnings("style.svg",
                    "<svg width='9mm' height='9mm'><style>g rect {fill:none}</style>" + square + "</svg>", 1);
    expect_warnings("colour.ppm", "P3 2 1 9\n9 0 0 9 0 0\n", 1);
    expect_warnings("seam.pgm", pgm("0 1 2 3 4 5 6 7 8 9", 10), 1);
    flat::FlatOptions patch;
    patch.height_mm = 5.0;
    expect_warnings("edges.pgm", pgm("0 1 2 3 4 5 6 7 8 9", 10), 1, patch);
}

TEST_F(FlatPhrase, NamesTheLineOfADrawing) {
    const auto mesh = flat::load_model(written("a line b.svg", "<svg>\n<path></svg>"), {});
    ASSERT_FALSE(mesh);
    EXPECT_TRUE(in_english(error_phrase(mesh.error().message))
                    .ends_with("a line b.svg: line 2: this is not well-formed XML"))
        << in_english(error_phrase(mesh.error().message));
}

}  // namespace
}  // namespace psicarve::session
