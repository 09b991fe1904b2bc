// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/profile_differences.hpp"

#include <gtest/gtest.h>

namespace psicarve::session {
namespace {

TEST(ProfileDifferences, AreToldKeyByKey) {
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
