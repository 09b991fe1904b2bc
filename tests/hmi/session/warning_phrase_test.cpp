// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/phrase/warning_phrase.hpp"

#include <gtest/gtest.h>

#include "hmi/cam/job_builder.hpp"
#include "hmi/model/load_mesh.hpp"
#include "tests/hmi/model/shapes.hpp"
#include "tests/places.hpp"

namespace psicarve::session {
namespace {

TEST(WarningPhrase, NamesTheWindowsFieldsInsteadOfOptions) {
    const Phrase shown = warning_phrase(
        "2.4 % of the surface lies behind another part and cannot be reached; --axis-at best would lose 2.3 "
        "% of "
        "the surface and 0.0 % of the layers, by the same look this axis 2.5 % and 40.0 %");
    EXPECT_EQ(shown.arguments, (std::vector<std::string>{"2.4 %", "2.3 %", "0.0 %", "2.5 %", "40.0 %"}));
    EXPECT_EQ(in_english(shown).find("--"), std::string::npos);
    EXPECT_EQ(
        in_english(warning_phrase("20 of 500 layers do not contain the axis; --axis-at best looks for an "
                                  "axis that loses less")),
        "20 of 500 layers do not contain the axis. Axis at: least lost looks for an axis that loses less.");
    EXPECT_EQ(
        in_english(warning_phrase("2.4 % of the surface lies behind another part and cannot be reached; "
                                  "--axis-at best looks for an axis that loses less")),
        "2.4 % of the surface lies behind another part and cannot be reached. Axis at: least lost looks for "
        "an axis that loses less.");
    EXPECT_EQ(in_english(warning_phrase("20 of 500 layers do not contain the axis")),
              "20 of 500 layers do not contain the axis.");
    EXPECT_EQ(
        in_english(warning_phrase("the model is only 0.50 mm high: are its units inches (--scale 25.4) or "
                                  "metres (--scale 1000)?")),
        "The model is only 0.50 mm high: are its units inches or metres? Height makes it larger.");
    EXPECT_EQ(
        in_english(warning_phrase("the layers lie 2.00 mm apart, but the tool is only 1.00 mm wide: "
                                  "between them material stays, as high as the blank; more layers "
                                  "leave less")),
        "The layers lie 2.00 mm apart, but the tool is only 1.00 mm wide: between them material stays, as "
        "high as the blank; more layers leave less.");
    for (const std::string_view of_r2 :
         {"R2's height error draws the rows up to 1.80 mm apart, but the tool is only 1.50 mm wide: between "
          "them material stays, as high as the blank; zigzag joining avoids it",
          "R2's height error makes the rows uneven: up to 1.80 mm apart instead of 1.00 mm; zigzag joining "
          "avoids it",
          "R2 stands 0.80 mm lower than R1 and is under the model in 1 of its layers: there it cuts what "
          "holds the model down to a radius of 1.50 mm"}) {
        const auto phrase_of_r2 = warning_phrase(std::string(of_r2));
        EXPECT_STRNE(phrase_of_r2.english, "%1") << of_r2;
        EXPECT_EQ(in_english(phrase_of_r2), std::string(of_r2) + ".");
    }
    EXPECT_EQ(in_english(warning_phrase(
                  "roughing cannot keep its stepover of 1.50 mm: the job's layers lie 2.00 mm apart")),
              "Roughing cannot keep its stepover of 1.50 mm: the job's layers lie 2.00 mm apart.");
}

TEST(WarningPhrase, LeavesWhatItDoesNotKnow) {
    EXPECT_EQ(in_english(warning_phrase("something else")), "something else");
    EXPECT_EQ(in_english(warning_phrase("")), "");
    EXPECT_EQ(in_english(warning_phrase("20 of 500 layers do not contain the axis, and more")),
              "20 of 500 layers do not contain the axis, and more");
}

// The slicer's sentences as they are.
TEST(WarningPhrase, KnowsWhatTheSlicerSays) {
    const auto mesh = model::load_mesh(example("figurine.stl"));
    ASSERT_TRUE(mesh);
    cam::JobOptions options;
    options.layer_count = 60;
    options.point_count = 60;
    const auto built = cam::build_job(*mesh, Profile{}, options);
    ASSERT_TRUE(built) << built.error().message;
    ASSERT_FALSE(built->report.warnings.empty());
    for (const std::string& warning : built->report.warnings)
        EXPECT_STRNE(warning_phrase(warning).english, "%1") << warning;
}

TEST(WarningPhrase, KnowsOfLayersAboveTheBlank) {
    Profile profile;
    profile.blank = {20.0, 4.0};
    cam::JobOptions options;
    options.layer_count = 10;
    options.point_count = 9;
    const auto job = cam::build_job(shapes::box({-3, -3, 0}, {3, 3, 8}), profile, options);
    ASSERT_TRUE(job) << job.error().message;
    bool is_told = false;
    for (const std::string& warning : job->report.warnings) {
        EXPECT_STRNE(warning_phrase(warning).english, "%1") << warning;
        is_told = is_told || in_english(warning_phrase(warning)).starts_with("Above the blank's top");
    }
    EXPECT_TRUE(is_told);
}

TEST(WarningPhrase, EachWarningIsOnceThoughMeshAndJobHaveIt) {
    EXPECT_EQ(other_warnings({"a", "b", "c"}, {"b"}), (std::vector<std::string>{"a", "c"}));
    EXPECT_TRUE(other_warnings({"a"}, {"a", "b"}).empty());
}

/// A tetrahedron; of its last facet the corners are in the other order, or it is missing.
model::Mesh tetrahedron(bool is_open, bool is_flipped) {
    shapes::Builder body;
    body.facet({0, 0, 0}, {0, 9, 0}, {9, 0, 0}).facet({0, 0, 0}, {9, 0, 0}, {0, 0, 9});
    body.facet({0, 0, 0}, {0, 0, 9}, {0, 9, 0});
    if (!is_open && !is_flipped) body.facet({9, 0, 0}, {0, 9, 0}, {0, 0, 9});
    if (!is_open && is_flipped) body.facet({0, 9, 0}, {9, 0, 0}, {0, 0, 9});
    model::Mesh mesh = body.mesh();
    EXPECT_TRUE(model::judge_mesh(mesh, "test"));
    return mesh;
}

TEST(WarningPhrase, KnowsWhatReadersSayOfHolesAndFlippedFacets) {
    const auto told = [](const model::Mesh& mesh) {
        return mesh.warnings.empty() ? std::string{} : in_english(warning_phrase(mesh.warnings.front()));
    };
    EXPECT_EQ(told(tetrahedron(false, false)), "");
    EXPECT_EQ(told(tetrahedron(true, false)),
              "The mesh has holes, which are carved down to what lies behind them, or to the core.");
    EXPECT_EQ(told(tetrahedron(false, true)),
              "Some facets are flipped against their neighbours; carved as if they were not.");
}

}  // namespace
}  // namespace psicarve::session
