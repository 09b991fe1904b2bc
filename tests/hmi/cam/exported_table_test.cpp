// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cam/exported_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hmi/cam/table_job.hpp"
#include "hmi/report/job_export.hpp"
#include "shared/job/outside.hpp"
#include "tests/hmi/cam/built_job.hpp"
#include "tests/shared/temporary_folder.hpp"

namespace psicarve::cam {
namespace {

using testing::Contains;
using testing::EndsWith;
using testing::HasSubstr;

class ExportedTable : public ::testing::Test {
protected:
    std::string exported(const JobTable& table) const {
        const auto blob = job_blob_from_table(table);
        const std::string path = folder_.path("out.csv");
        std::FILE* out = std::fopen(path.c_str(), "w");
        report::write_csv(JobView::check(blob).value(), out);
        std::fclose(out);
        return path;
    }
    static std::string text_of(const std::string& path) {
        std::ostringstream text;
        text << std::ifstream(path).rdbuf();
        return text.str();
    }
    Result<BuiltJob> read(const std::string& text, const Profile& profile = {}) const {
        const std::string path = folder_.path("in.csv");
        std::ofstream(path, std::ios::binary) << text;
        EXPECT_TRUE(is_table_file(path));
        return job_from_table(path, profile, {});
    }
    std::string refusal(const std::string& text) const {
        const auto job = read(text);
        EXPECT_FALSE(job.has_value()) << text;
        return job ? "" : job.error().message;
    }
    /// Written, read, compared to the last byte, and written again to the same file.
    void expect_back(const JobTable& first, const Profile& profile) const {
        const std::string text = text_of(exported(first));
        const auto again = read(text, profile);
        ASSERT_TRUE(again.has_value()) << again.error().message;
        const JobTable& table = again->table;
        EXPECT_EQ(table.layer_count, first.layer_count);
        EXPECT_EQ(table.point_count, first.point_count);
        EXPECT_EQ(table.joining, first.joining);
        EXPECT_EQ(table.psi_sweep_pulses, first.psi_sweep_pulses);
        EXPECT_EQ(table.feed_mm_s, first.feed_mm_s);
        EXPECT_EQ(table.layer_height_pulses, first.layer_height_pulses);
        EXPECT_EQ(table.r_left_pulses, first.r_left_pulses);
        EXPECT_EQ(table.r_right_pulses, first.r_right_pulses);
        ASSERT_EQ(table.passes.size(), first.passes.size());
        const std::size_t bytes = first.passes.size() * sizeof(JobPass);
        EXPECT_TRUE(bytes == 0 || std::memcmp(table.passes.data(), first.passes.data(), bytes) == 0);
        EXPECT_EQ(text_of(exported(table)), text);
        // The machine takes it.
        const auto blob = job_blob_from_table(table);
        const auto view = JobView::check(blob);
        ASSERT_TRUE(view) << view.error().message;
        const auto good = check_job(*view, profile);
        EXPECT_TRUE(good) << good.error().message;
    }
    static JobOptions joined(Joining joining, std::uint32_t layers) {
        JobOptions options = small(layers, 9);
        options.joining = joining;
        return options;
    }
    static Profile roughing() {
        Profile profile;
        profile.blank.radius_mm = 12.0;
        profile.roughing = {4.0 / 3.0, 0.3, 0.0};
        return profile;
    }

    test::TemporaryFolder folder_;
};

TEST_F(ExportedTable, OfEveryJoiningComesBackPulseForPulse) {
    const Profile profile;
    for (const Joining joining : {Joining::continuous, Joining::zigzag, Joining::spiral})
        expect_back(built(oblong(), profile, joined(joining, 5)).table, profile);
}

TEST_F(ExportedTable, OfOneLayerIsJoinedAsTheProfileSays) {
    for (const Joining joining : {Joining::continuous, Joining::zigzag, Joining::spiral}) {
        Profile profile;
        profile.job.joining = joining;
        expect_back(built(oblong(), profile, joined(joining, 1)).table, profile);
    }
}

TEST_F(ExportedTable, OfSeveralPassesKeepsThem) {
    for (const Joining joining : {Joining::continuous, Joining::zigzag, Joining::spiral}) {
        const Profile profile = roughing();
        const JobTable table = built(oblong(), profile, joined(joining, 5)).table;
        ASSERT_GE(table.passes.size(), 3U);
        expect_back(table, profile);
    }
}

/// On how many ways between two points a head keeps to no feed.
int outside_lines(const JobTable& table, const Profile& machine) {
    const auto blob = job_blob_from_table(table);
    const JobView job = JobView::check(blob).value();
    const HeadsOutside outside = heads_outside(job, outside_rule(machine));
    int lines = 0;
    for (std::uint32_t layer = 0; layer < job.layer_count(); ++layer) {
        for (std::uint32_t point = 1; point < job.point_count(); ++point) {
            const auto left = job.r_left_pulses(layer);
            const auto right = job.r_right_pulses(layer);
            lines += outside.holds(0, left[point - 1], left[point]) ? 1 : 0;
            lines += outside.holds(1, right[point - 1], right[point]) ? 1 : 0;
        }
    }
    return lines;
}

TEST_F(ExportedTable, ReadBackGoesOutsideOfItsOwnBlankButNotOfALargerOne) {
    Profile profile;
    profile.blank = {.radius_mm = 14.0, .offset_x_mm = 8.0};
    profile.roughing = {3.0, 0.3, 0.0};
    profile.job.feed_mm_s = 2.0;
    const JobTable table = built(oblong(), profile, small(5, 61)).table;
    const int lines = outside_lines(table, profile);
    EXPECT_GE(lines, 20);
    expect_back(table, profile);
    const std::string text = text_of(exported(table));
    EXPECT_EQ(outside_lines(read(text, profile)->table, profile), lines);
    Profile without = profile;
    without.blank = {};
    // The passes tell of the blank that they are made for.
    EXPECT_EQ(outside_lines(read(text, without)->table, without), lines);
    Profile larger = profile;
    larger.blank.radius_mm = 14.1;
    EXPECT_EQ(outside_lines(read(text, larger)->table, larger), 0);
    EXPECT_EQ(outside_lines(table, larger), 0);
}

TEST_F(ExportedTable, KeepsRunsThatShareAPass) {
    Profile profile = roughing();
    profile.head_r2_angle_error_deg = 0.5;
    JobTable table = built(oblong(), profile, joined(Joining::continuous, 5)).table;
    // An idle layer that lies above all layers of its pass is still a run of its own.
    const auto pass = std::find_if(table.passes.begin(), table.passes.end() - 1,
                                   [](const JobPass& one) { return one.layer_count > 1; });
    ASSERT_NE(pass, table.passes.end() - 1);
    JobPass more = *pass;
    more.first_layer = pass->first_layer + pass->layer_count - 1;
    more.layer_count = 1;
    pass->layer_count -= 1;
    table.passes.insert(pass + 1, more);
    expect_back(table, profile);
}

TEST_F(ExportedTable, TellsOfPassesOnlyWhereThereAreSome) {
    const auto first_line = [this](const JobTable& table) {
        const std::string text = text_of(exported(table));
        return text.substr(0, text.find('\n'));
    };
    EXPECT_EQ(first_line(built(oblong(), Profile{}, small(5, 9)).table),
              "layer,point,y_pulses,psi_pulses,r_left_pulses,r_right_pulses");
    EXPECT_EQ(first_line(built(oblong(), roughing(), small(5, 9)).table),
              "layer,point,y_pulses,psi_pulses,r_left_pulses,r_right_pulses,run,pass,allowance_mm,depth_mm,"
              "clear_mm");
}

TEST_F(ExportedTable, SaysOfABlankWhatItsFinishingPassSays) {
    Profile profile = roughing();
    profile.tool = {ToolShape::ball, 2.0, 60.0, 3.0};
    const BuiltJob first = built(oblong(), profile, small(5, 9));
    const auto again = read(text_of(exported(first.table)), profile);
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_NEAR(again->report.r_max_mm, first.report.r_max_mm, 1e-9);
    EXPECT_NEAR(again->report.r_min_mm, first.report.r_min_mm, 1e-9);
    EXPECT_THAT(again->report.warnings, Contains(HasSubstr("the tool cuts 3.00 mm deep, but the job goes ")));
    EXPECT_THAT(again->report.warnings, testing::Not(Contains(HasSubstr("blank's radius"))))
        << "a head that is parked outside of the blank is no model";
}

TEST_F(ExportedTable, WithPassesIsNotRoughedAgainAndASpiralNotAtAll) {
    const BuiltJob roughed = built(oblong(), roughing(), small(5, 9));
    const auto again = read(text_of(exported(roughed.table)), roughing());
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ(again->table.layer_count, roughed.table.layer_count);
    EXPECT_THAT(again->report.notes, Contains(HasSubstr("roughing passes of its own")));
    const JobTable spiral = built(oblong(), Profile{}, joined(Joining::spiral, 5)).table;
    const auto refused = read(text_of(exported(spiral)), roughing());
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().message, HasSubstr("roughing needs level layers"));
    EXPECT_THAT(refused.error().message, HasSubstr("--finish-only"));
}

TEST_F(ExportedTable, IsJoinedAsItsPointsStandAndNotOtherwise) {
    const std::string path = exported(built(oblong(), Profile{}, joined(Joining::continuous, 5)).table);
    for (const Joining asked : {Joining::zigzag, Joining::spiral}) {
        const auto refused = job_from_table(path, Profile{}, asked);
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().code, ErrorCode::bad_usage);
        EXPECT_THAT(refused.error().message, HasSubstr("stand as a continuous job has them: not --joining "));
    }
    EXPECT_TRUE(job_from_table(path, Profile{}, Joining::continuous));
    Profile usual;
    usual.job.joining = Joining::zigzag;
    EXPECT_TRUE(job_from_table(path, usual, std::nullopt))
        << "what a profile says is for whom it may concern";
}

// As a table of a fine psi has it: the sixteen-thousandth layer begins beyond a thousand million pulses.
TEST_F(ExportedTable, TurnsAsFarAsItsLayersAre) {
    std::string text = "layer,point,y_pulses,psi_pulses,r_left_pulses,r_right_pulses\n";
    constexpr std::int64_t kSweep = 640'000;
    constexpr int kLayers = 2000;
    for (std::int64_t layer = 0; layer < kLayers; ++layer) {
        for (std::int64_t point = 0; point < 2; ++point) {
            text += std::to_string(layer) + "," + std::to_string(point) + "," + std::to_string(layer + 1) +
                    "," + std::to_string((layer + point) * kSweep) + ",4000,4000\n";
        }
    }
    const auto job = read(text);
    ASSERT_TRUE(job) << job.error().message;
    EXPECT_EQ(job->table.psi_sweep_pulses, kSweep);
    EXPECT_EQ(job->table.layer_count, std::uint32_t{kLayers});
    EXPECT_THAT(refusal("layer,point,y_pulses,psi_pulses,r_left_pulses,r_right_pulses\n0,0,1,0,4000,4000\n"
                        "0,1,1,2000000000,4000,4000\n"),
                EndsWith("psi goes further in a layer than any machine"));
    EXPECT_THAT(refusal("layer,point,y_pulses,psi_pulses,r_left_pulses,r_right_pulses\n"
                        "0,0,2000000000,0,4000,4000\n"),
                EndsWith("line 2: a number that no machine has"));
    EXPECT_THAT(refusal("layer,point,y_pulses,psi_pulses,r_left_pulses,r_right_pulses\n"
                        "0,0,1,1e16,4000,4000\n"),
                HasSubstr("is not a number that a table can hold"));
}

TEST_F(ExportedTable, OfMoreRunsThanAnyJobHasIsRefusedWithTheLine) {
    std::string text =
        "layer,point,y_pulses,psi_pulses,r_left_pulses,r_right_pulses,run,pass,allowance_mm,depth_mm,clear_"
        "mm\n";
    for (std::uint32_t run = 0; run <= kMaxJobPasses; ++run) {
        for (std::uint32_t point = 0; point < 2; ++point) {
            text += std::to_string(run) + "," + std::to_string(point) + ",400," +
                    std::to_string((run + point) * 3200) + ",4000,4000," + std::to_string(run + 1) + "," +
                    std::to_string(run + 1) + ",0.3,5,9\n";
        }
    }
    EXPECT_THAT(refusal(text), EndsWith("line 2050: more than 1024 runs, which no job has"));
}

TEST_F(ExportedTable, MayBeginWithALongComment) {
    const std::string text = text_of(exported(built(oblong(), Profile{}, joined(Joining::zigzag, 3)).table));
    EXPECT_TRUE(read("# " + std::string(3000, 'x') + "\n\n" + text));
}

TEST_F(ExportedTable, OfOnePointALayerIsRefused) {
    const std::string head = "layer,point,y_pulses,psi_pulses,r_left_pulses,r_right_pulses\n";
    for (const char* rows : {"0,0,400,0,4000,4000\n", "0,0,400,0,4000,4000\n1,0,500,0,4000,4000\n"})
        EXPECT_THAT(refusal(head + rows), EndsWith("a layer of one point goes nowhere; it needs two"));
}

TEST_F(ExportedTable, DamagedAnywhereIsReadOrRefusedInOneLine) {
    std::mt19937_64 random(11);
    const Profile profile = roughing();
    const std::string whole = text_of(exported(built(oblong(), profile, joined(Joining::spiral, 3)).table));
    constexpr std::string_view kLetters = "0123456789,.-;\n\t#e ";
    int read_count = 0;
    for (int round = 0; round < 400; ++round) {
        std::string text = whole;
        const std::size_t head = text.find('\n') + 1;
        for (std::size_t change = 0; change <= random() % 3; ++change) {
            const std::size_t at = head + random() % (text.size() - head);
            if (random() % 4 == 0) {
                text.erase(at, random() % 40);
            } else {
                text[at] = kLetters[random() % kLetters.size()];
            }
        }
        const auto job = read(text, profile);
        if (!job) {
            EXPECT_EQ(job.error().message.find('\n'), std::string::npos) << job.error().message;
            continue;
        }
        ++read_count;
        const auto blob = job_blob_from_table(job->table);
        const auto view = JobView::check(blob);
        EXPECT_TRUE(view || view.error().message.find('\n') == std::string::npos);
    }
    RecordProperty("read", read_count);
    EXPECT_GT(read_count, 0);
}

TEST_F(ExportedTable, OfSeveralPassesThatDoesNotSayWhereEachBeginsIsRefused) {
    std::string text = text_of(exported(built(oblong(), roughing(), small(5, 9)).table));
    std::string old;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = text.find('\n', at);
        const std::string line = text.substr(at, end - at);
        std::size_t comma = 0;
        for (int column = 0; column < 6; ++column) comma = line.find(',', comma) + 1;
        old += line.substr(0, comma - 1) + "\n";
        at = end + 1;
    }
    EXPECT_THAT(refusal(old),
                HasSubstr("lies no higher than the one before: a table of several passes needs the "
                          "columns run to clear_mm"));
}

TEST_F(ExportedTable, OfMaterialWhereTheHeadsCannotGoIsRefusedWithLineAndColumn) {
    const std::string head =
        "layer,point,y_pulses,psi_pulses,r_left_pulses,r_right_pulses,run,pass,allowance_mm,depth_mm,clear_"
        "mm\n";
    const auto rows = [&head](const std::string& lengths) {
        return head + "# of a larger machine\n0,0,400,0,4000,4000,1,1," + lengths +
               "\n0,1,400,3200,4000,4000,1,1," + lengths + "\n";
    };
    Profile profile;
    profile.r2.travel_mm[1] = 55.0;
    profile.r2.tip_offset_mm = 0.25;  // so far can the tips of both heads go
    for (const auto& [lengths, column] : {std::pair{"0,0,55.3", "clear_mm"},
                                          {"0,0,999999", "clear_mm"},
                                          {"0,60,55", "depth_mm"},
                                          {"56,0,9", "allowance_mm"}}) {
        const auto job = read(rows(lengths), profile);
        ASSERT_FALSE(job) << lengths;
        EXPECT_THAT(job.error().message, HasSubstr(std::string("line 3: column ") + column + ": "));
        EXPECT_THAT(job.error().message, EndsWith("mm, but the heads clear no more than 55.25 mm"));
    }
    EXPECT_TRUE(read(rows("0,0,55.25"), profile));
    EXPECT_FALSE(read(rows("0,0,nan"), profile));
}

TEST_F(ExportedTable, WhosePassesMakeNoSenseIsOneClearLine) {
    const std::string head =
        "layer,point,y_pulses,psi_pulses,r_left_pulses,r_right_pulses,run,pass,allowance_mm,depth_mm,clear_"
        "mm\n";
    const std::string first = "0,0,400,0,4000,4000,1,1,0.3,5,9\n0,1,400,3200,4000,4000,1,1,0.3,5,9\n";
    EXPECT_THAT(refusal(head + "0,0,400,0,4000,4000\n"), EndsWith("line 2: 6 numbers, not 11"));
    EXPECT_THAT(refusal(head + first + "1,0,400,3200,4000,4000,3,2,0,0,9\n"),
                EndsWith("line 4: runs and passes do not count on by one"));
    EXPECT_THAT(refusal(head + "0,0,400,0,4000,4000,1,1,0.3,5,9\n0,1,400,3200,4000,4000,2,2,0.3,5,9\n"),
                EndsWith("line 3: another run than that of the layer's first point"));
    EXPECT_THAT(refusal(head + "0,0,400,0,4000,4000,1,1,-0.3,5,9\n"),
                EndsWith("line 2: column allowance_mm: a pass has no such length"));
    EXPECT_THAT(refusal(head + "0,0,400,0,4000,4000,1.5,1,0.3,5,9\n"), HasSubstr("whole numbers"));
    const std::string plain = "layer,point,y_pulses,psi_pulses,r_left_pulses,r_right_pulses\n";
    EXPECT_THAT(refusal(plain + "0,0,400,0,900,900\n0,1,400,3200,900,900\n1,0,400,3200,900,900\n"
                                "1,1,800,6400,900,900\n"),
                EndsWith("the last row does not close the spiral"));
    // As a spreadsheet cuts off what has more rows than it can hold.
    for (const char* cut : {"1,0,400,3200,4000,4000,2,2,0.3,4,9\n1,1,400,6400,4000,4000,2,2,0.3,4,9\n",
                            "1,0,500,3200,4000,4000,2,1,0,0,9\n1,1,500,6400,4000,4000,2,1,0,0,9\n", ""})
        EXPECT_THAT(refusal(head + first + cut), HasSubstr(": the finishing pass is missing")) << cut;
    EXPECT_THAT(refusal(head + "0,0,400,0,4000,4000,1,1,0.3,5,9\n5,1,400,3200,4000,4000,1,1,0.3,5,9\n"),
                EndsWith("line 3: layers do not count on by one"));
    EXPECT_THAT(refusal(head + first + "3,0,400,3200,4000,4000,2,2,0,0,9\n"),
                EndsWith("line 4: layers do not count on by one"));
    // These may be the last layers of a longer job: runs and passes count anew.
    const auto rest = read(head +
                           "7,0,400,0,4000,4000,4,3,0.3,5,9\n7,1,400,3200,4000,4000,4,3,0.3,5,9\n"
                           "8,0,400,3200,4000,4000,5,4,0,0,9\n8,1,400,6400,4000,4000,5,4,0,0,9\n");
    ASSERT_TRUE(rest) << rest.error().message;
    ASSERT_EQ(rest->table.passes.size(), 2U);
    EXPECT_EQ(rest->table.passes[1].number, 2U);
    EXPECT_EQ(rest->table.passes[1].first_layer, 1U);
}

}  // namespace
}  // namespace psicarve::cam
