// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/manual/value_completion.hpp"

#include <gmock/gmock.h>

namespace psicarve::manual {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;

ValueCompletion of_option(const char* name, const char* type) {
    return completion_of(OptionRow{{name}, type, "", "", false, false});
}
ValueCompletion of_argument(const char* name, const std::vector<std::string>& words) {
    return completion_of(ArgumentRow{name, "", "", true, false}, words);
}

TEST(ValueCompletion, OffersTheWordsOfAType) {
    EXPECT_THAT(of_option("--up", "x|y|z").words, ElementsAre("x", "y", "z"));
    EXPECT_THAT(of_option("--axis-at", "X,Y|origin|best").words, ElementsAre("origin", "best"));
    EXPECT_THAT(of_option("--language", "en|zh_CN|ru").words, ElementsAre("en", "zh_CN", "ru"));
    EXPECT_TRUE(of_option("--height", "MM").is_empty());
    EXPECT_TRUE(of_option("--blank", "RADIUSxHEIGHT").is_empty());
}

TEST(ValueCompletion, OffersFilesByTheirEnding) {
    EXPECT_THAT(of_option("--picture", "OUT.png").endings, ElementsAre("png"));
    EXPECT_THAT(of_argument("MODEL|JOB", {"psicarve", "carve"}).endings, Contains("stl"));
    EXPECT_THAT(of_argument("MODEL|JOB", {"psicarve", "carve"}).endings, Contains("job"));
    EXPECT_TRUE(of_option("--csv", "FILE").any_file);
}

TEST(ValueCompletion, TakesAFileForWhatItIsNamedAfter) {
    EXPECT_THAT(of_option("--profile", "FILE").endings, Contains("toml"));
    EXPECT_THAT(of_argument("FILE", {"psicarve", "profile", "check"}).endings, Contains("toml"));
    EXPECT_THAT(of_argument("FILE", {"psicarve", "snapshot", "info"}).endings, Contains("snap"));
    EXPECT_TRUE(of_argument("FILE", {"psicarve", "other"}).any_file);
    EXPECT_TRUE(of_option("--group", "NAME").groups);
    EXPECT_TRUE(of_option("--user", "NAME").users);
    EXPECT_TRUE(of_option("--segment", "NAME").is_empty());
}

TEST(ValueCompletion, KnowsAxesSignalsToolsAndKeys) {
    EXPECT_THAT(of_argument("AXIS", {"psicarve", "home"}).words, ElementsAre("r1", "r2", "psi", "y"));
    EXPECT_THAT(of_argument("AXIS=POSITION", {"psicarve", "move"}).words, Contains("psi="));
    EXPECT_THAT(of_argument("SIGNAL", {"psicarve", "pins"}).words, Contains("spindle"));
    EXPECT_THAT(of_option("--tool", "SHAPE:MM").words, ElementsAre("point", "ball:", "flat:", "vee:"));
    EXPECT_THAT(of_argument("KEY", {"psicarve", "profile", "set"}).words, Contains("axis.r1.speed_mm_s"));
    EXPECT_THAT(of_argument("KEY=VALUE", {"psicarve", "profile", "set"}).words,
                Contains("axis.r1.speed_mm_s="));
    EXPECT_THAT(of_argument("KEY=VALUE", {"psicarve", "profile", "set"}).endings, ElementsAre("toml"));
    EXPECT_TRUE(goes_on("ball:"));
    EXPECT_FALSE(goes_on("point"));
}

}  // namespace
}  // namespace psicarve::manual
