// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/core_profile.hpp"

#include <gtest/gtest.h>

namespace psicarve::session {
namespace {

using namespace std::string_literals;

TEST(CoreProfile, IsNamedInACommandLineOneWayOrTheOther) {
    EXPECT_EQ(profile_named_in("core\0--profile\0/etc/a.toml\0--port\0sim\0"s, "/home"), "/etc/a.toml");
    EXPECT_EQ(profile_named_in("core\0--profile=a.toml\0"s, "/home"), "/home/a.toml");
    EXPECT_EQ(profile_named_in("core\0--profile\0a.toml"s, "/home"), "/home/a.toml") << "cut off behind it";
    EXPECT_EQ(profile_named_in("core\0--profile\0"s, "/home"), "");
    EXPECT_EQ(profile_named_in("core\0--profiles\0a.toml\0"s, "/home"), "");
    EXPECT_EQ(profile_named_in("", "/home"), "");
}

TEST(CoreProfile, IsNoneOfAnotherHashOrOfAProcessThatIsGone) {
    EXPECT_FALSE(find_core_profile(0, 1));
}

TEST(CoreProfile, IsHeldAgainstAnotherKeyByKey) {
    Profile core;
    Profile here;
    EXPECT_TRUE(profile_differences(core, here, 3).empty());
    here.r1.pulses_per_mm = 800.0;
    here.head_clearance_mm = 3.0;
    here.name = "mill";
    const auto told = profile_differences(core, here, 2);
    ASSERT_EQ(told.size(), 3U);
    EXPECT_EQ(in_english(told[0]), "name: core \"default\", here \"mill\"");
    EXPECT_EQ(in_english(told[1]), "head_clearance_mm: core 2.0, here 3.0");
    EXPECT_EQ(in_english(told[2]), "1 more");
}

}  // namespace
}  // namespace psicarve::session
