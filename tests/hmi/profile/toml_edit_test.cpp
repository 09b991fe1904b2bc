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

/// The new text, or what was said instead.
std::string edited(std::string_view text, std::string_view path, std::string_view toml) {
    const auto result = with_value(text, path, toml);
    return result ? *result : result.error().message;
}

TEST(TomlEdit, ChangesOneValueAndNothingElse) {
    EXPECT_EQ(edited(kText, "axis.r1.speed_mm_s", "12.5"),
              "# my machine\nname = \"a # b\"  # not a comment before this\n\n[axis.r1]   # left\n"
              "speed_mm_s = 12.5   # mind the spindle\n  home=\"max\"\n\n[axis.r2]\nspeed_mm_s = 11");
    const std::string home = edited(kText, "axis.r1.home", "\"none\"");
    EXPECT_NE(home.find("  home=\"none\"\n"), std::string::npos) << home;
    const std::string name = edited(kText, "name", "\"c\"");
    EXPECT_NE(name.find("\nname = \"c\"  # not a comment before this\n"), std::string::npos) << name;
}

TEST(TomlEdit, AddsALineToItsTable) {
    const std::string text = edited(kText, "axis.r1.accel_mm_s2", "90.0");
    EXPECT_NE(text.find("  home=\"max\"\naccel_mm_s2 = 90.0\n\n[axis.r2]"), std::string::npos) << text;
    EXPECT_EQ(edited(text, "axis.r1.accel_mm_s2", "91.0").find("90.0"), std::string::npos);
    const std::string top = edited(kText, "core_radius_mm", "2.0");
    EXPECT_NE(top.find("before this\ncore_radius_mm = 2.0\n\n[axis.r1]"), std::string::npos) << top;
    EXPECT_TRUE(edited(kText, "axis.r2.home", "\"min\"").ends_with("speed_mm_s = 11\nhome = \"min\""));
    EXPECT_EQ(edited("[a]\n[b]\nx = 1\n", "a.y", "2"), "[a]\ny = 2\n[b]\nx = 1\n");
    EXPECT_EQ(edited("# top\n[b]\nx = 1\n", "y", "2"), "y = 2\n# top\n[b]\nx = 1\n");
}

TEST(TomlEdit, AddsATableAtTheEnd) {
    const std::string text = edited(kText, "tick.period_us", "50.0");
    EXPECT_TRUE(text.ends_with("speed_mm_s = 11\n\n[tick]\nperiod_us = 50.0\n")) << text;
    EXPECT_EQ(edited("", "tick.period_us", "50.0"), "[tick]\nperiod_us = 50.0\n");
    EXPECT_EQ(edited("", "name", "\"x\""), "name = \"x\"\n");
    EXPECT_EQ(edited("[a.b]\nx = 1\n", "a.y", "2"), "[a.b]\nx = 1\n\n[a]\ny = 2\n");
}

TEST(TomlEdit, WritesAsTheTableIsWritten) {
    EXPECT_EQ(edited("axis = { r1 = { speed_mm_s = 8 } }  # all in one line\n", "axis.r1.speed_mm_s", "9.0"),
              "axis = { r1 = { speed_mm_s = 9.0 } }  # all in one line\n");
    EXPECT_EQ(edited("axis = { r1 = { speed_mm_s = 8 } }\n", "axis.r2.speed_mm_s", "9.0"),
              "axis = { r1 = { speed_mm_s = 8 }, r2.speed_mm_s = 9.0 }\n");
    EXPECT_EQ(edited("axis = {}\n", "axis.x", "1"), "axis = { x = 1 }\n");
    EXPECT_EQ(edited("axis = { r1.travel_mm = [0, 1], y.home = \"min\" }\n", "axis.r1.home", "\"max\""),
              "axis = { r1.travel_mm = [0, 1], y.home = \"min\", r1.home = \"max\" }\n");
    EXPECT_EQ(edited("axis . r1.home = \"min\" # near\n", "axis.r1.speed_mm_s", "9.0"),
              "axis . r1.home = \"min\" # near\naxis . r1.speed_mm_s = 9.0\n");
    EXPECT_EQ(edited("[ axis . \"r1\" ]\r\ntravel_mm = [\r\n  0.0, # in\r\n  60.0,\r\n] # out\r\n",
                     "axis.r1.travel_mm", "[1.0, 2.0]"),
              "[ axis . \"r1\" ]\r\ntravel_mm = [1.0, 2.0] # out\r\n");
    EXPECT_EQ(edited("[axis.r1]\r\ntravel_mm = [\r\n  0.0,\r\n  60.0 ]\r\n", "axis.r1.home", "\"min\""),
              "[axis.r1]\r\ntravel_mm = [\r\n  0.0,\r\n  60.0 ]\r\nhome = \"min\"\r\n");
    EXPECT_EQ(edited("name = \"\"\"\n[axis.r1]\nspeed_mm_s = 1\"\"\"\n[axis.r1]\nspeed_mm_s = 2\n",
                     "axis.r1.speed_mm_s", "3"),
              "name = \"\"\"\n[axis.r1]\nspeed_mm_s = 1\"\"\"\n[axis.r1]\nspeed_mm_s = 3\n");
}

TEST(TomlEdit, RefusesByLineWhatHasNoPlace) {
    EXPECT_EQ(edited("a = 1\nb = \n", "a", "2").find("line 2: this is not TOML: "), 0U)
        << edited("a = 1\nb = \n", "a", "2");
    EXPECT_EQ(edited("# one\naxis = 5\n", "axis.r1.home", "\"min\""),
              "line 2: axis.r1.home has no place: a value of that name stands here; rename it");
    EXPECT_EQ(edited("\n\n[axis.r1.home]\nx = 1\n", "axis.r1.home", "\"min\"")
                  .find("line 3: axis.r1.home has no place: a table"),
              0U);
    EXPECT_EQ(edited("[[axis]]\nx = 1\n", "axis.x", "2").find("line 1: axis.x has no place"), 0U);
    EXPECT_EQ(edited("a = 1\n", "a", "2 3"), "2 3 is no value of TOML");
}

TEST(TomlEdit, ReadsWhatItWouldReplace) {
    EXPECT_EQ(value_in(kText, "name"), "\"a # b\"");
    EXPECT_EQ(value_in(kText, "axis.r2.speed_mm_s"), "11");
    EXPECT_EQ(value_in(kText, "axis.y.speed_mm_s"), std::nullopt);
    EXPECT_EQ(value_in(kText, "axis.r1"), std::nullopt);
    EXPECT_EQ(value_in("a = \n", "a"), std::nullopt);
    EXPECT_EQ(value_in("axis.r1.home = \"min\"\n", "axis.r1.home"), "\"min\"");
}

}  // namespace
}  // namespace psicarve::profile
