// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/profile/toml_edit.hpp"

#include <gtest/gtest.h>

namespace psicarve::profile {
namespace {

constexpr const char* kText =
    "# my machine\n"
    "name = \"a # b\"  # not a comment before this\n"
    "\n"
    "[axis.r1]   # left\n"
    "speed_mm_s = 10   # mind the spindle\n"
    "  home=\"max\"\n"
    "\n"
    "[axis.r2]\n"
    "speed_mm_s = 11";

TEST(TomlEdit, ChangesOneValueAndNothingElse) {
    EXPECT_EQ(with_value(kText, "axis.r1.speed_mm_s", "12.5"),
              "# my machine\nname = \"a # b\"  # not a comment before this\n\n[axis.r1]   # left\n"
              "speed_mm_s = 12.5 # mind the spindle\n  home=\"max\"\n\n[axis.r2]\nspeed_mm_s = 11\n");
    const std::string home = with_value(kText, "axis.r1.home", "\"none\"");
    EXPECT_NE(home.find("  home= \"none\"\n"), std::string::npos) << home;
    const std::string name = with_value(kText, "name", "\"c\"");
    EXPECT_NE(name.find("\nname = \"c\"      # not a comment before this\n"), std::string::npos) << name;
}

TEST(TomlEdit, AddsALineToItsTable) {
    const std::string text = with_value(kText, "axis.r1.accel_mm_s2", "90.0");
    EXPECT_NE(text.find("  home=\"max\"\naccel_mm_s2 = 90.0\n\n[axis.r2]"), std::string::npos) << text;
    EXPECT_EQ(with_value(text, "axis.r1.accel_mm_s2", "91.0").find("90.0"), std::string::npos);
    const std::string top = with_value(kText, "core_radius_mm", "2.0");
    EXPECT_NE(top.find("before this\ncore_radius_mm = 2.0\n\n[axis.r1]"), std::string::npos) << top;
}

TEST(TomlEdit, AddsATableAtTheEnd) {
    const std::string text = with_value(kText, "tick.period_us", "50.0");
    EXPECT_TRUE(text.ends_with("speed_mm_s = 11\n\n[tick]\nperiod_us = 50.0\n")) << text;
    EXPECT_EQ(with_value("", "tick.period_us", "50.0"), "[tick]\nperiod_us = 50.0\n");
    EXPECT_EQ(with_value("", "name", "\"x\""), "name = \"x\"\n");
}

TEST(TomlEdit, ReadsWhatItWouldReplace) {
    EXPECT_EQ(value_in(kText, "name"), "\"a # b\"");
    EXPECT_EQ(value_in(kText, "axis.r2.speed_mm_s"), "11");
    EXPECT_EQ(value_in(kText, "axis.y.speed_mm_s"), std::nullopt);
    EXPECT_EQ(value_in("axis.r1.home = \"min\"\n", "axis.r1.home"), "\"min\"");
}

}  // namespace
}  // namespace psicarve::profile
