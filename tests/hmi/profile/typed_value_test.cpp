// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/profile/typed_value.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/hmi/profile/key_named.hpp"

namespace psicarve::profile {
namespace {

std::string toml_of(const char* path, const char* typed) {
    return toml_from_typed(profile_keys()[key_named(path)], typed).value_or("no value");
}

TEST(TypedValue, EveryBuiltInValueComesBackAsItWas) {
    for (const ProfileKey& key : profile_keys()) {
        EXPECT_EQ(toml_from_typed(key, typed_from_toml(key, key.built_in)), key.built_in) << key.path;
    }
}

TEST(TypedValue, NumbersAsPeopleTypeThem) {
    const char* path = "axis.r1.speed_mm_s";
    EXPECT_EQ(toml_of(path, "12"), "12.0");
    EXPECT_EQ(toml_of(path, " +12,5 "), "12.5");
    EXPECT_EQ(toml_of(path, ".5"), "0.5");
    EXPECT_EQ(toml_of(path, "5."), "5.0");
    EXPECT_EQ(toml_of(path, "-.5e1"), "-0.5e1");
    EXPECT_EQ(toml_of(path, "1e-3"), "1e-3");
    EXPECT_EQ(toml_of(path, "007"), "7.0");
    EXPECT_EQ(toml_of(path, "-00.5"), "-0.5");
    EXPECT_EQ(toml_of(path, "00"), "0.0");
    for (const char* none :
         {"", " ", "12 mm", "1.2.3", "1,000,0", "nan", "inf", "0x10", "- 5", "--5", "1\n2"}) {
        EXPECT_EQ(toml_of(path, none), "no value") << none;
    }
}

TEST(TypedValue, WholeNumbersRangesAndWords) {
    EXPECT_EQ(toml_of("axis.psi.pulses_per_rev", " 6400 "), "6400");
    EXPECT_EQ(toml_of("axis.psi.pulses_per_rev", "6400.0"), "no value");
    EXPECT_EQ(toml_of("axis.psi.pulses_per_rev", "99999999999999999999"), "no value");
    EXPECT_EQ(toml_of("axis.r1.travel_mm", "0..60"), "[0.0, 60.0]");
    EXPECT_EQ(toml_of("axis.r1.travel_mm", "-1,5 ... 60"), "[-1.5, 60.0]");
    EXPECT_EQ(toml_of("axis.r1.travel_mm", "0; 60"), "[0.0, 60.0]");
    EXPECT_EQ(toml_of("axis.r1.travel_mm", "60"), "no value");
    EXPECT_EQ(toml_of("axis.r1.travel_mm", "0 ... x"), "no value");
    EXPECT_EQ(toml_of("axis.r1.home", "max"), "\"max\"");
}

TEST(TypedValue, TextCannotLeaveItsQuotes) {
    EXPECT_EQ(toml_of("name", "Fr\u00e4se \"2\" \\ # x"), "\"Fr\u00e4se \\\"2\\\" \\\\ # x\"");
    EXPECT_EQ(toml_of("name", "a\nb = 1"), "no value");
    const ProfileKey& name = profile_keys()[key_named("name")];
    EXPECT_EQ(typed_from_toml(name, "\"Fr\u00e4se \\\"2\\\" \\\\ # x\""), "Fr\u00e4se \"2\" \\ # x");
}

}  // namespace
}  // namespace psicarve::profile
