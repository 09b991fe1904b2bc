// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cam/table_job.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/hmi/cam/built_job.hpp"
#include "tests/shared/temporary_folder.hpp"

namespace psicarve::cam {
namespace {

using testing::Contains;
using testing::EndsWith;
using testing::HasSubstr;

class TableJob : public ::testing::Test {
protected:
    std::string file(const std::string& content) const {
        const std::string path = folder_.path("t.csv");
        std::ofstream(path, std::ios::binary) << content;
        return path;
    }
    BuiltJob read(const std::string& content, const Profile& profile = {}) const {
        const std::string path = file(content);
        EXPECT_TRUE(is_table_file(path));
        auto job = job_from_table(path, profile, {});
        EXPECT_TRUE(job.has_value()) << (job ? "" : job.error().message);
        return job ? std::move(*job) : BuiltJob{};
    }
    std::string refusal(const std::string& content) const {
        const auto job = job_from_table(file(content), {}, {});
        EXPECT_FALSE(job.has_value());
        return job ? "" : job.error().message;
    }
    test::TemporaryFolder folder_;
};

TEST_F(TableJob, MayBePartedBySemicolonsOrTabsWithCommasBeforeDecimals) {
    const std::string commas = "y_mm,r_mm\n1,5,5.25,6,6\n1.5,5,5,6,6\n";
    const JobTable wanted = read(commas).table;
    const auto parted = [&commas](char separator, char point) {
        std::string text = commas;
        for (char& c : text) c = c == ',' ? separator : c == '.' ? point : c;
        return text;
    };
    for (const char separator : {';', '\t'}) {
        for (const char point : {'.', ','}) {
            const JobTable found = read(parted(separator, point)).table;
            EXPECT_EQ(found.r_left_pulses, wanted.r_left_pulses) << separator << point;
            EXPECT_EQ(found.layer_height_pulses, wanted.layer_height_pulses) << separator << point;
        }
    }
    EXPECT_EQ(read("y_mm ; r_mm\n1;5;5,25;6;6;\n1,5;5;5;6;6;\n").table.r_left_pulses, wanted.r_left_pulses);
    EXPECT_EQ(read("y_mm,r_mm\n1;5;5.25;6;6\n1.5,5;5,6,6\n").table.r_left_pulses, wanted.r_left_pulses);
    EXPECT_THAT(refusal("y_mm;r_mm\n1,5,5,6,6\n"),
                EndsWith("line 2: '1.5.5.6.6' is not a number that a table can hold"));
    const std::string exported =
        "layer;point;y_pulses;psi_pulses;r_left_pulses;r_right_pulses\n"
        "0;0;400;0;4000;4000\n0;1;400;3200;4000;4000\n";
    EXPECT_EQ(read(exported).table.point_count, 2U);
}

TEST_F(TableJob, WithAHeadThatIsNoneSaysWhatItShouldBe) {
    for (const char* text : {"y;r\n1;2;3\n", "1,2,3\n", "height\tradius\n", "layer,point\n"}) {
        EXPECT_TRUE(is_table_file(file(text))) << text;
        EXPECT_THAT(refusal(text),
                    HasSubstr("is no head of a table: y_mm,r_mm or y_pulses,r_pulses, or what snapshot "
                              "export writes"))
            << text;
    }
    EXPECT_FALSE(is_table_file(file("nothing of a table\n"))) << "what a file is its content says";
}

TEST_F(TableJob, IsRoughedAsTheProfileAsks) {
    const std::string table = "y_mm,r_mm\n1,5,5,6,6\n1.5,5,5,6,6\n";
    Profile profile;
    profile.roughing = {2.0, 0.5, 0.0};
    const auto refused = job_from_table(file(table), profile, {});
    ASSERT_FALSE(refused) << "nobody says where the blank's surface is";
    EXPECT_THAT(refused.error().message, HasSubstr("roughing begins at the blank's surface"));
    profile.blank.radius_mm = 9.0;
    // 7 and 5.5 mm, two layers each, and the finishing pass.
    const BuiltJob job = read(table, profile);
    ASSERT_EQ(job.table.passes.size(), 3U);
    EXPECT_EQ(job.table.layer_count, 6U);
    EXPECT_THAT(job.table.report_json, HasSubstr("\"pass_count\":2"));
    profile.roughing.stepdown_mm = 0.0;
    EXPECT_TRUE(read(table, profile).table.passes.empty());
}

TEST_F(TableJob, IsWarnedOfABlankThatIsTooSmall) {
    const std::string table = "y_mm,r_mm\n1,5,5,12,6\n3,5,5,6,6\n";
    Profile profile;
    profile.blank.radius_mm = 11.0;
    profile.blank.height_mm = 2.0;
    const auto warnings = read(table, profile).report.warnings;
    EXPECT_THAT(warnings,
                Contains(HasSubstr("the blank's radius of 11.00 mm is less than the model's, 12.00")));
    EXPECT_THAT(warnings,
                Contains(HasSubstr("the blank's top stands 2.00 mm above the table, the model's 3.00")));
    profile.blank = {12.0, 3.0};
    EXPECT_THAT(read(table, profile).report.warnings, testing::IsEmpty());
    profile.blank.offset_x_mm = 1.5;
    EXPECT_THAT(read(table, profile).report.warnings,
                Contains(HasSubstr("by up to 1.50 mm in direction 180 deg")));
}

TEST_F(TableJob, TellsThatTheToolMeetsTheTable) {
    const std::string table = "y_mm,r_mm\n1,5,5,6,6\n3,5,5,6,6\n";
    Profile profile;
    EXPECT_THAT(read(table, profile).report.notes, testing::IsEmpty()) << "a point has no width";
    profile.tool = {ToolShape::ball, 2.0};
    EXPECT_THAT(read(table, profile).report.notes, testing::IsEmpty());
    profile.tool.diameter_mm = 3.0;
    EXPECT_THAT(read(table, profile).report.notes,
                Contains(HasSubstr("the tool reaches 0.50 mm below the table's top")));
}

TEST_F(TableJob, AFullCircleGoesToBothHeadsWhereverTheLayerBegins) {
    // 0, 90, 180, 270 degrees. Layer 1 begins half a turn on: its R1 has what R2 had.
    const auto job = read("y_mm,r_mm\n# two layers\n1, 10,11,12,13\n2; 20;21;22;23;\n");
    const Profile profile;
    const auto pulses = [&](double mm) { return static_cast<std::int32_t>(mm * profile.r1.pulses_per_mm); };
    ASSERT_EQ(job.table.layer_count, 2U);
    ASSERT_EQ(job.table.point_count, 3U);
    EXPECT_EQ(job.table.layer_height_pulses[1], static_cast<std::int64_t>(2 * profile.y.pulses_per_mm));
    for (std::size_t j = 0; j < 3; ++j) {
        const auto way = static_cast<double>(j);
        EXPECT_EQ(left(job.table, 0, j), pulses(10 + way));
        EXPECT_EQ(right(job.table, 0, j), pulses(j == 2 ? 10 : 12 + way));
        EXPECT_EQ(left(job.table, 1, j), pulses(j == 2 ? 20 : 22 + way));
    }
    EXPECT_TRUE(job.report.notes.empty());
}

TEST_F(TableJob, PulsesStayAsTheyAre) {
    const auto job = read("y_pulses,r_pulses\n7,4001,4003\n");
    EXPECT_EQ(job.table.layer_height_pulses[0], 7);
    EXPECT_EQ(left(job.table, 0, 0), 4001);
    EXPECT_EQ(right(job.table, 0, 0), 4003);
}

TEST_F(TableJob, AnOddCircleIsEvenedByOnePoint) {
    EXPECT_EQ(evened({1.0, 4.0, 7.0}), (std::vector<double>{1.0, 3.25, 5.5, 5.5}));
    const auto job = read("y_mm,r_mm\n1,10,13,16\n");
    EXPECT_EQ(job.table.point_count, 3U);
    EXPECT_EQ(left(job.table, 0, 1), static_cast<std::int32_t>(12.25 * Profile{}.r1.pulses_per_mm));
    ASSERT_EQ(job.report.notes.size(), 1U);
    EXPECT_EQ(job.report.notes[0], "the table's 3 points a circle are evened to 4");
}

TEST_F(TableJob, ReportsNothingThatATableHasNot) {
    Profile profile;
    profile.tool = {ToolShape::ball, 2.0};
    const auto report = nlohmann::json::parse(read("y_mm,r_mm\n1,5,5\n2,5,5\n", profile).table.report_json);
    for (const char* key : {"bounding_box_mm", "scale", "up", "axis", "axis_at", "undercut_share",
                            "open_points", "layers_without_axis", "triangles"}) {
        EXPECT_FALSE(report.contains(key)) << key;
    }
    EXPECT_EQ(report["format"], "CSV");
    EXPECT_EQ(report["tool"], "ball 2 mm");
    EXPECT_EQ(report["layers"], 2);
}

TEST_F(TableJob, BrokenTablesAreOneClearLine) {
    EXPECT_THAT(refusal("y_mm,r_mm\n1,2,3,4\n2,5,6\n"),
                EndsWith("t.csv line 3: 2 radii, but the layers before have 3"));
    EXPECT_THAT(refusal("y_mm,r_mm\n1,2,x\n"), EndsWith("line 2: 'x' is not a number that a table can hold"));
    EXPECT_THAT(refusal("y_mm,r_mm\n1,2,nan\n"), EndsWith("'nan' is not a number that a table can hold"));
    EXPECT_THAT(refusal("y_mm,r_mm\n1,2,1e300\n"), HasSubstr("is not a number that a table can hold"));
    EXPECT_THAT(refusal("y_mm,r_mm\n"), EndsWith("the table has no layers"));
    EXPECT_THAT(refusal("y_mm,r_mm\n1,5,0.5\n"),
                EndsWith("layer 0, point 1: a radius of 0.5000 mm, less than core_radius_mm, 1.5000 mm"));
    // What helps a model does not help a table.
    EXPECT_THAT(refusal("y_mm,r_mm\n1,5,5,5,5\n2,5,5,500,5\n"),
                EndsWith("t.csv: layer 1, point 0: axis r1 would have to go to 500.0000 mm, but goes from "
                         "0.0000 mm to 60.0000 mm"));
    EXPECT_THAT(
        refusal("y_mm,r_mm\n1,5,5\n500,5,5\n"),
        EndsWith("layer 1, point 0: axis y would have to go to 500.0000 mm, but goes from 0.0000 mm to "
                 "150.0000 mm"));
    EXPECT_THAT(refusal("y_mm,r_mm\n2,5,5\n2,5,5\n"), EndsWith("layer 1 lies no higher than the one before"));
    const std::string head = "layer,point,y_pulses,psi_pulses,r_left_pulses,r_right_pulses\n";
    EXPECT_THAT(refusal(head + "0,0,0,0,5,5\n0,1,0,8,5,5\n1,0,3,8,5,5\n"),
                HasSubstr("last layer is not whole"));
    EXPECT_THAT(refusal(head + "0,0,0,0,5,5\n0,1,0,8,5,5\n1,0,3,8,5,5\n1,1,3,17,5,5\n"),
                HasSubstr("layer 1, point 1: psi is not where"));
    EXPECT_THAT(refusal(head + "0,1,0,0,5,5\n"), HasSubstr("points do not follow each other"));
    EXPECT_THAT(refusal(head + "0,0,0,0,5,5\n0,1,9,8,5,5\n"),
                HasSubstr("layer 0, point 0: the height is neither its layer's nor on a spiral's way up"));
    EXPECT_THAT(refusal(head + "0,0,0,0,5\n"), HasSubstr("5 numbers, not 6"));
    EXPECT_THAT(refusal(head + "0,0,0,0.5,5,5\n"), HasSubstr("whole numbers"));
}

}  // namespace
}  // namespace psicarve::cam
