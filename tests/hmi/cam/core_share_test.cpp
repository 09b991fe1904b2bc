// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "hmi/cam/job_builder.hpp"
#include "hmi/cam/table_job.hpp"
#include "hmi/phrase/error_phrase.hpp"
#include "hmi/phrase/warning_phrase.hpp"
#include "hmi/report/job_export.hpp"
#include "shared/job/job.hpp"
#include "tests/hmi/cam/built_job.hpp"
#include "tests/shared/temporary_folder.hpp"

namespace psicarve::cam {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// The window knows a message if it has more to say of it than the message itself.
std::string in_window(const std::string& message) {
    const session::Phrase phrase = session::error_phrase(message);
    EXPECT_STRNE(phrase.english, "%1") << message;
    for (const session::Phrase& part : phrase.inner)
        EXPECT_EQ(session::in_english(part).find("--"), std::string::npos) << message;
    return session::in_english(phrase);
}

/// Wide over a share of its height, and inside the core radius over the rest.
model::Mesh thin_below(double height) {
    return shapes::Builder()
        .add(shapes::cylinder(1.0, 0.0, height, 40))
        .add(shapes::cylinder(6.0, height, 20.0, 40))
        .mesh();
}

std::string core_warning(const SliceReport& report) {
    for (const std::string& warning : report.warnings)
        if (warning.find("core radius") != std::string::npos) return warning;
    return "";
}

TEST(CoreShare, ASphereInsideTheCoreRadiusIsRefusedAndItsUnitGuessed) {
    const Error sut = refused(shapes::sphere(1.0, 20, 40), Profile{}, small(10, 20));
    EXPECT_EQ(sut.code, ErrorCode::bad_input);
    EXPECT_THAT(sut.message, AllOf(HasSubstr("lies wholly within the core radius of 1.50 mm"),
                                   HasSubstr("2.00 x 2.00 x 2.00 mm"), HasSubstr("inches (--scale 25.4)")));
    EXPECT_THAT(in_window(sut.message), AllOf(HasSubstr("2.00 x 2.00 x 2.00 mm"), HasSubstr("inches")));
}

TEST(CoreShare, MetresAreGuessedWhereTheyFit) {
    const Error sut = refused(shapes::sphere(0.02, 20, 40), Profile{}, small(4, 20));
    EXPECT_THAT(sut.message, AllOf(HasSubstr("metres (--scale 1000)"), Not(HasSubstr("inches"))));
    EXPECT_THAT(in_window(sut.message), HasSubstr("metres"));
}

TEST(CoreShare, NoUnitIsGuessedWhereASizeWasAskedForOrNoneFits) {
    JobOptions options = small(10, 20);
    options.scale = 0.5;
    const Error scaled = refused(shapes::sphere(2.0, 20, 40), Profile{}, options);
    EXPECT_THAT(scaled.message, AllOf(HasSubstr("2.00 x 2.00 x 2.00 mm"), HasSubstr("--height"),
                                      HasSubstr("core_radius_mm"), Not(HasSubstr("inches"))));
    EXPECT_THAT(in_window(scaled.message), HasSubstr("core_radius_mm"));
    const Error needle = refused(shapes::cylinder(1.0, 0.0, 140.0, 40), Profile{}, small(10, 20));
    EXPECT_THAT(needle.message, AllOf(HasSubstr("lies wholly within"), Not(HasSubstr("inches"))));
}

/// Tips that stand 5 mm out where their axes end.
Profile stopped_by_travel() {
    Profile profile;
    profile.r1.tip_offset_mm = profile.r2.tip_offset_mm = 5.0;
    return profile;
}

TEST(CoreShare, NamesTheTravelWhereThatIsTheLimit) {
    const Error sut = refused(shapes::cylinder(1.52, 0.0, 30.0, 40), stopped_by_travel(), small(10, 20));
    EXPECT_THAT(sut.message,
                AllOf(HasSubstr("lies wholly within the radius of 5.00 mm at which the heads' travel ends"),
                      HasSubstr("travel_mm"), Not(HasSubstr("core radius"))));
    EXPECT_THAT(in_window(sut.message), AllOf(HasSubstr("5.00 mm"), HasSubstr("travel")));
    // One that is larger than the core, and not than where the heads stop: 25.4 times it is carved.
    const Error inches = refused(shapes::sphere(1.0, 20, 40), stopped_by_travel(), small(10, 20));
    EXPECT_THAT(inches.message, HasSubstr("inches (--scale 25.4)"));
    EXPECT_THAT(in_window(inches.message), AllOf(HasSubstr("5.00 mm"), HasSubstr("inches")));
    const Error metres = refused(shapes::sphere(0.02, 20, 40), stopped_by_travel(), small(4, 20));
    EXPECT_THAT(in_window(metres.message), AllOf(HasSubstr("5.00 mm"), HasSubstr("metres")));
}

TEST(CoreShare, WarnsOfTheTravelWhereThatIsTheLimit) {
    const BuiltJob sut = built(thin_below(8.0), stopped_by_travel(), small(20, 20));
    EXPECT_EQ(core_warning(sut.report), "");
    ASSERT_THAT(sut.report.warnings,
                Contains(HasSubstr("40.0 % of the points stand at the radius of 5.00 mm at which the heads' "
                                   "travel ends")));
    for (const std::string& warning : sut.report.warnings) {
        if (warning.find("travel ends") == std::string::npos) continue;
        const session::Phrase phrase = session::warning_phrase(warning);
        EXPECT_STRNE(phrase.english, "%1") << warning;
        EXPECT_THAT(session::in_english(phrase), AllOf(HasSubstr("5.00 mm"), Not(HasSubstr("--"))));
    }
}

TEST(CoreShare, ARingAboutTheAxisIsNotBesideIt) {
    const auto ring = [](double far) {
        return shapes::Builder()
            .add(shapes::box({-1.0, -far, 0}, {1.0, -far + 0.2, 8}))
            .add(shapes::box({-1.0, far - 0.2, 0}, {1.0, far, 8}))
            .mesh();
    };
    JobOptions options = small(4, 20);
    options.axis_at = AxisAt::origin;
    for (const ToolShape shape : {ToolShape::point, ToolShape::ball}) {
        Profile profile;
        profile.tool.shape = shape;
        profile.tool.diameter_mm = 0.2;
        const Error sut = refused(ring(1.1), profile, options);
        EXPECT_THAT(sut.message, AllOf(HasSubstr("lies wholly within the core radius of 1.50 mm"),
                                       Not(HasSubstr("beside"))));
    }
}

TEST(CoreShare, HeadsKeptApartAndADepthLimitHideNothing) {
    Profile apart;
    apart.core_radius_mm = 1.0;
    apart.head_clearance_mm = 4.0;
    EXPECT_THAT(refused(shapes::sphere(0.9, 20, 40), apart, small(4, 9)).message,
                HasSubstr("lies wholly within the core radius of 1.00 mm"));
    Profile shallow;
    shallow.blank = {20.0, 30.0};
    shallow.blank.depth_limit_mm = 2.0;
    EXPECT_THAT(refused(shapes::sphere(1.0, 20, 40), shallow, small(4, 9)).message,
                HasSubstr("lies wholly within the core radius"));
}

TEST(CoreShare, EveryJoiningAndToolRefusesIt) {
    for (const Joining joining : {Joining::continuous, Joining::zigzag, Joining::spiral}) {
        for (const ToolShape shape : {ToolShape::point, ToolShape::ball}) {
            Profile profile;
            profile.tool.shape = shape;
            profile.tool.diameter_mm = 0.5;
            JobOptions options = small(8, 20);
            options.joining = joining;
            EXPECT_THAT(refused(shapes::sphere(1.0, 20, 40), profile, options).message,
                        HasSubstr("lies wholly within the core radius"))
                << static_cast<int>(joining) << static_cast<int>(shape);
        }
    }
}

TEST(CoreShare, MoreThanATenthIsWarnedOfWithItsShare) {
    const BuiltJob few = built(thin_below(2.0), Profile{}, small(20, 20));
    EXPECT_EQ(core_warning(few.report), "") << "a tenth is not more than that";
    const BuiltJob sut = built(thin_below(8.0), Profile{}, small(20, 20));
    EXPECT_THAT(core_warning(sut.report),
                AllOf(HasSubstr("40.0 % of the points stand at the core radius of 1.50 mm"),
                      HasSubstr("--scale"), HasSubstr("core_radius_mm")));
    const std::string shown = session::in_english(session::warning_phrase(core_warning(sut.report)));
    EXPECT_THAT(shown, AllOf(HasSubstr("40.0 %"), Not(HasSubstr("--"))));
    EXPECT_THAT(sut.table.report_json, HasSubstr("40.0 % of the points"));
}

TEST(CoreShare, OfAJobWithRoughingIsThatOfItsFinishedSurface) {
    Profile profile;
    profile.blank = {12.0, 30.0};
    profile.tool.shape = ToolShape::ball;
    profile.tool.diameter_mm = 3.0;
    profile.roughing.stepdown_mm = 2.0;
    Profile finishing = profile;
    finishing.roughing.stepdown_mm = 0.0;
    const BuiltJob sut = built(thin_below(8.0), profile, small(20, 20));
    const BuiltJob alone = built(thin_below(8.0), finishing, small(20, 20));
    ASSERT_FALSE(sut.table.passes.empty());
    EXPECT_THAT(core_warning(sut.report), HasSubstr(" % of the points stand at the core radius"));
    EXPECT_EQ(core_warning(sut.report), core_warning(alone.report));
}

class CoreShareOfATable : public ::testing::Test {
protected:
    Result<BuiltJob> read(const std::string& text, const Profile& profile = {}) const {
        const std::string path = folder_.path("t.csv");
        std::ofstream(path, std::ios::binary) << text;
        return job_from_table(path, profile, {});
    }
    test::TemporaryFolder folder_;
};

TEST_F(CoreShareOfATable, IsRefusedWhereItIsAllOfIt) {
    const auto sut = read("y_mm,r_mm\n1,1.5,1.5,1.5,1.5\n2,1.5,1.5,1.5,1.5\n");
    ASSERT_FALSE(sut);
    EXPECT_EQ(sut.error().code, ErrorCode::bad_input);
    EXPECT_THAT(
        sut.error().message,
        HasSubstr("all radii are the core radius of 1.50 mm: nothing but a plain rod would be carved"));
    EXPECT_THAT(in_window(sut.error().message), HasSubstr("plain rod"));
}

TEST_F(CoreShareOfATable, NamesTheTravelWhereThatIsTheLimit) {
    const auto sut = read("y_mm,r_mm\n1,2,2,2,2\n2,2,2,2,2\n", stopped_by_travel());
    ASSERT_FALSE(sut);
    EXPECT_THAT(sut.error().message,
                HasSubstr("no radius is beyond that of 5.00 mm at which the heads' travel ends"));
    EXPECT_THAT(in_window(sut.error().message), HasSubstr("plain rod"));
}

TEST_F(CoreShareOfATable, IsWarnedOfWhereItIsMoreThanATenth) {
    const auto sut = read("y_mm,r_mm\n1,1.5,1.5,1.5,1.5\n2,5,5,5,5\n");
    ASSERT_TRUE(sut) << sut.error().message;
    EXPECT_THAT(core_warning(sut->report), HasSubstr("50.0 % of the points stand at the core radius"));
    const auto none = read("y_mm,r_mm\n1,5,5,5,5\n2,5,5,5,5\n");
    ASSERT_TRUE(none);
    EXPECT_EQ(core_warning(none->report), "");
}

TEST_F(CoreShareOfATable, OfExportedRowsIsThatOfTheLastPass) {
    Profile profile;
    profile.blank = {12.0, 30.0};
    profile.tool.shape = ToolShape::ball;
    profile.tool.diameter_mm = 3.0;
    profile.roughing.stepdown_mm = 2.0;
    const BuiltJob job = built(thin_below(8.0), profile, small(20, 20));
    ASSERT_GE(job.table.passes.size(), 2U);
    const std::string path = folder_.path("exported.csv");
    std::FILE* out = std::fopen(path.c_str(), "w");
    report::write_csv(JobView::check(job_blob_from_table(job.table)).value(), out);
    std::fclose(out);
    const auto sut = job_from_table(path, profile, {});
    ASSERT_TRUE(sut) << sut.error().message;
    EXPECT_EQ(sut->report.core_points, job.report.core_points);
    EXPECT_EQ(core_warning(sut->report), core_warning(job.report));
}

}  // namespace
}  // namespace psicarve::cam
