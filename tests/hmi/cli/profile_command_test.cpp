// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/profile/profile.hpp"
#include "tests/hmi/cli/program_run.hpp"
#include "tests/places.hpp"

namespace psicarve::test {
namespace {

class ProfileCommand : public CliTest {};

TEST_F(ProfileCommand, ShowsEveryKeyAsTomlAndNothingElse) {
    const Outcome shown = psicarve({"profile", "show"});
    EXPECT_EQ(shown.exit_code, 0);
    EXPECT_EQ(shown.error, "");
    EXPECT_EQ(shown.out, profile_to_toml(Profile{}));
    const auto read_back = parse_profile(shown.out, "shown");
    ASSERT_TRUE(read_back.has_value()) << read_back.error().message;
    EXPECT_EQ(profile_to_toml(*read_back), shown.out);
}

TEST_F(ProfileCommand, ShowsTheProfileOfAFileAndOfAJob) {
    write("mine.toml", "name = \"mine\"\n[axis.y]\nspeed_mm_s = 7.5\n");
    const Outcome of_file = psicarve({"profile", "show", file("mine.toml")});
    EXPECT_EQ(of_file.exit_code, 0);
    EXPECT_NE(of_file.out.find("name = \"mine\""), std::string::npos);
    const Outcome sliced = psicarve({"slice", box_stl("box.stl"), "-o", file("box.job"), "--layers", "3",
                                     "--points", "5", "--profile", file("mine.toml")});
    ASSERT_EQ(sliced.exit_code, 0) << sliced.error;
    EXPECT_EQ(psicarve({"profile", "show", file("box.job")}).out, of_file.out);
}

TEST_F(ProfileCommand, ChecksAGoodProfile) {
    write("good.toml", "name = \"good\"\n");
    const Outcome plain = psicarve({"profile", "check", file("good.toml")});
    EXPECT_EQ(plain.exit_code, 0);
    EXPECT_NE(plain.out.find("good.toml: OK"), std::string::npos) << plain.out;
    const Outcome as_json = psicarve({"profile", "check", file("good.toml"), "--json"});
    EXPECT_EQ(as_json.json()["ok"], true);
    EXPECT_EQ(as_json.json()["name"], "good");
}

TEST_F(ProfileCommand, RefusesABadProfileWithItsLine) {
    write("bad.toml", "name = \"bad\"\n[axis.r1]\nspeedo_mm_s = 3\n");
    const Outcome outcome = psicarve({"profile", "check", file("bad.toml"), "--json"});
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_NE(outcome.error.find("bad.toml:3"), std::string::npos) << outcome.error;
    EXPECT_EQ(outcome.json()["error"]["code"], "bad_input");
}

TEST_F(ProfileCommand, ExamplesAreGoodProfiles) {
    for (const std::string name : {"/original.toml", "/fine.toml"}) {
        const Outcome outcome = psicarve({"profile", "check", in_source("examples") + name});
        EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
    }
}

}  // namespace
}  // namespace psicarve::test
