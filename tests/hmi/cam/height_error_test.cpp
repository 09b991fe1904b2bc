// SPDX-License-Identifier: GPL-3.0-or-later
// The messages about an R2 that does not stand as high as R1.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/hmi/cam/built_job.hpp"
#include "tests/hmi/model/shapes.hpp"

namespace psicarve::cam {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

Profile with_r2_lower(double lower_mm, ToolShape shape, double diameter_mm) {
    Profile profile;
    profile.blank = {12.0, 25.0};
    profile.tool = {shape, diameter_mm};
    profile.head_r2_height_error_mm = -lower_mm;
    return profile;
}

std::vector<std::string> words_of_r2(const Profile& profile, Joining joining) {
    JobOptions options = small(20, 61);
    options.joining = joining;
    const SliceReport report = built(shapes::cylinder(8.0, 0.0, 20.0, 720), profile, options).report;
    std::vector<std::string> found;
    for (const auto* words : {&report.warnings, &report.notes}) {
        for (const std::string& word : *words) {
            if (word.find("R2") != std::string::npos || word.find("in the lowest") == 0)
                found.push_back(word);
        }
    }
    return found;
}

// In a direction the heads take turns, so that every second row stands lower.
TEST(HeightError, LeavesTheBlankBetweenRowsThatItDrawsApart) {
    const std::string drawn_apart =
        "R2's height error draws the rows up to 1.80 mm apart, but the tool is only 1.50 mm wide: between "
        "them material stays, as high as the blank; zigzag joining avoids it";
    const std::string uneven =
        "R2's height error makes the rows uneven: up to 1.80 mm apart instead of 1.00 mm; zigzag joining "
        "avoids it";
    for (const Joining joining : {Joining::continuous, Joining::spiral}) {
        for (const double lower_mm : {0.8, -0.8}) {
            EXPECT_THAT(words_of_r2(with_r2_lower(lower_mm, ToolShape::flat, 1.5), joining),
                        Contains(drawn_apart));
            EXPECT_THAT(words_of_r2(with_r2_lower(lower_mm, ToolShape::point, 1.0), joining),
                        Contains(uneven));
            EXPECT_THAT(words_of_r2(with_r2_lower(lower_mm, ToolShape::flat, 1.8), joining),
                        Not(Contains(HasSubstr("height error"))));
        }
        EXPECT_TRUE(words_of_r2(with_r2_lower(0.02, ToolShape::point, 1.0), joining).empty());
    }
    for (const ToolShape shape : {ToolShape::flat, ToolShape::point}) {
        EXPECT_THAT(words_of_r2(with_r2_lower(0.8, shape, 1.5), Joining::zigzag),
                    Not(Contains(HasSubstr("height error"))));
    }
    // Two layers' error: the lowest row of one half is missing.
    EXPECT_THAT(words_of_r2(with_r2_lower(-2.0, ToolShape::flat, 1.5), Joining::continuous),
                Contains(HasSubstr("up to 2.00 mm apart")));
    // Layers too far apart as they are: zigzag would not help.
    EXPECT_THAT(words_of_r2(with_r2_lower(0.8, ToolShape::flat, 0.9), Joining::continuous),
                Not(Contains(HasSubstr("zigzag"))));
}

TEST(HeightError, TellsOfTheFootAndTheTableThatALowerR2Meets) {
    Profile profile = with_r2_lower(0.8, ToolShape::point, 1.0);
    const std::string table =
        "in the lowest layer the tool reaches 0.30 mm below the table's top: the table must be narrower than "
        "the job, or base_height_mm more";
    const std::string foot =
        "R2 stands 0.80 mm lower than R1 and is under the model in 1 of its layers: there it cuts what holds "
        "the model down to a radius of 1.50 mm";
    EXPECT_EQ(words_of_r2(profile, Joining::zigzag), (std::vector<std::string>{foot, table}));
    profile.job.base_height_mm = 5.0;
    EXPECT_EQ(words_of_r2(profile, Joining::zigzag), (std::vector<std::string>{foot}));
    profile.head_r2_height_error_mm = -2.8;
    EXPECT_THAT(words_of_r2(profile, Joining::zigzag), Contains(HasSubstr("in 3 of its layers")));
    // The limit holds the head off.
    profile.blank.depth_limit_mm = 3.0;
    EXPECT_THAT(words_of_r2(profile, Joining::zigzag), Contains(HasSubstr("down to a radius of 9.00 mm")));
    profile.blank.depth_limit_mm = 0.0;
    profile.head_r2_height_error_mm = 0.8;
    EXPECT_TRUE(words_of_r2(profile, Joining::zigzag).empty());
    // A tool this wide still meets the model, with its upper half.
    profile.head_r2_height_error_mm = -0.8;
    profile.tool = {ToolShape::flat, 1.5};
    EXPECT_TRUE(words_of_r2(profile, Joining::zigzag).empty());
    profile.job.base_height_mm = 0.0;
    EXPECT_THAT(words_of_r2(profile, Joining::zigzag),
                Contains(HasSubstr("the tool reaches 1.05 mm below the table's top")));
}

}  // namespace
}  // namespace psicarve::cam
