// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/machine/core_profile.hpp"

#include <gtest/gtest.h>

namespace psicarve::machine {
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

}  // namespace
}  // namespace psicarve::machine
