// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/warning_phrase.hpp"

#include <gtest/gtest.h>

#include "hmi/cam/job_builder.hpp"
#include "hmi/model/load_mesh.hpp"

namespace psicarve::session {
namespace {

TEST(WarningPhrase, NamesTheWindowsFieldsInsteadOfOptions) {
    const Phrase shown = warning_phrase(
        "2.4 % of the surface lies behind another part and cannot be reached; --axis-at best would lose 2.3 "
        "% of "
        "the surface and 0.0 % of the layers");
    EXPECT_EQ(shown.arguments, (std::vector<std::string>{"2.4 %", "2.3 %", "0.0 %"}));
    EXPECT_EQ(in_english(shown).find("--"), std::string::npos);
    EXPECT_EQ(in_english(warning_phrase("20 of 500 layers do not contain the axis")),
              "20 of 500 layers do not contain the axis.");
    EXPECT_EQ(
        in_english(warning_phrase("the model is only 0.50 mm high: are its units inches (--scale 25.4) or "
                                  "metres (--scale 1000)?")),
        "The model is only 0.50 mm high: are its units inches or metres? Height makes it larger.");
}

TEST(WarningPhrase, LeavesWhatItDoesNotKnow) {
    EXPECT_EQ(in_english(warning_phrase("something else")), "something else");
    EXPECT_EQ(in_english(warning_phrase("")), "");
    EXPECT_EQ(in_english(warning_phrase("20 of 500 layers do not contain the axis, and more")),
              "20 of 500 layers do not contain the axis, and more");
}

// The slicer's sentences as they are.
TEST(WarningPhrase, KnowsWhatTheSlicerSays) {
    const auto mesh = model::load_mesh(PSICARVE_EXAMPLES "/figurine.stl");
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

}  // namespace
}  // namespace psicarve::session
