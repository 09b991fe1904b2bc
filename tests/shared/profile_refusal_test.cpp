// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "shared/profile/profile.hpp"
#include "shared/profile/profile_table.hpp"
#include "tests/parameter_name.hpp"
#include "tests/places.hpp"

namespace psicarve {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string refusal_of(const std::string& toml) {
    const auto result = parse_profile(toml, "m.toml");
    return result ? "accepted" : result.error().message;
}

struct Refusal {
    const char* toml;
    const char* beginning;  ///< file, line and key
    const char* holds;
};

class ProfileRefusals : public testing::TestWithParam<Refusal> {};

TEST_P(ProfileRefusals, NameLineKeyAndRemedy) {
    const std::string message = refusal_of(GetParam().toml);
    EXPECT_THAT(message, StartsWith(GetParam().beginning));
    EXPECT_THAT(message, HasSubstr(GetParam().holds));
    EXPECT_THAT(message, HasSubstr("; ")) << "no remedy";
    EXPECT_EQ(message.find('\n'), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(
    OneKey, ProfileRefusals,
    testing::Values(
        Refusal{"name = \"x\"\ncore_radius_mm = = 2\n", "m.toml:2: ", "not TOML"},
        Refusal{"name = \"x\"\nname = \"y\"\n", "m.toml:2: ", "not TOML"},
        Refusal{"\n[!\n", "m.toml:2: ", "not TOML"}, Refusal{"\n[[ \x07]]\n", "m.toml:2: ", "not TOML"},
        Refusal{"\n[axis.r1]\nspeed_mms = 3\n", "m.toml:3: axis.r1.speed_mms: unknown key",
                "did you mean axis.r1.speed_mm_s?"},
        Refusal{"[axis.x]\n", "m.toml:1: axis.x: unknown key", "see profile show for all keys"},
        Refusal{"[tick]\nfeed_mm_s = 3\n", "m.toml:2: tick.feed_mm_s: unknown key",
                "see profile show for all keys"},
        Refusal{"[tool]\nradius_mm = 3\n", "m.toml:2: tool.radius_mm: unknown key",
                "see profile show for all keys"},
        Refusal{"[axis.r1]\nspeed_deg_s = 3\n", "m.toml:2: axis.r1.speed_deg_s: unknown key",
                "did you mean axis.r1.speed_mm_s?"},
        Refusal{"[blnk]\nradius_mm = 3\n", "m.toml:1: blnk: unknown key", "did you mean blank?"},
        Refusal{"[axis.r3]\n", "m.toml:1: axis.r3: unknown key", "did you mean axis.r1?"},
        Refusal{"[axis.y]\n\ntip_offset = 3\n", "m.toml:3: axis.y.tip_offset: unknown key",
                "did you mean axis.y.tip_offset_mm?"},
        Refusal{"\"axis.r1.speed_mm_s\" = 3\n", "m.toml:1: axis.r1.speed_mm_s: unknown key", ""},
        Refusal{"\"a\\nb\" = 3\n", "m.toml:1: a?b: unknown key", "see profile show for all keys"},
        Refusal{"axis = 3\n", "m.toml:1: axis: a whole number", "the table [axis] is expected"},
        Refusal{"[[axis.r1]]\nspeed_mm_s = 3\n", "m.toml:1: axis.r1: an array", "the table [axis.r1]"},
        Refusal{"[job.feed_mm_s]\n", "m.toml:1: job.feed_mm_s: a table", "a number is expected"},
        Refusal{"[job]\nfeed_mm_s = \"20\"\n", "m.toml:2: job.feed_mm_s: a string", "a number is expected"},
        Refusal{"[port]\nstep_high_ns = 1e4\n", "m.toml:2: port.step_high_ns: a number with a fraction",
                "a whole number is expected"},
        Refusal{"[axis.psi]\npulses_per_rev = 6400.0\n",
                "m.toml:2: axis.psi.pulses_per_rev: ", "a whole number is expected"},
        Refusal{"[port.pins]\nestop = true\n", "m.toml:2: port.pins.estop: true or false", "a whole number"},
        Refusal{"[axis.r1]\ntravel_mm = [0, 60, 70]\n", "m.toml:2: axis.r1.travel_mm: an array",
                "an array of two numbers"},
        Refusal{"[axis.r1]\ntravel_mm = [0,\n \"60\"]\n", "m.toml:2: axis.r1.travel_mm: a string",
                "a number is expected"},
        Refusal{"name = 3\n", "m.toml:1: name: a whole number", "a string is expected"},
        Refusal{"name = \"\"\n", "m.toml:1: name: a text of 0 bytes", "1 to 64 bytes"},
        Refusal{"name = \"a\\u001bb\"\n", "m.toml:1: name: a control character", "remove it"},
        Refusal{"[job]\nfeed_mm_s = nan\n", "m.toml:2: job.feed_mm_s: nan", "finite"},
        Refusal{"[job]\nfeed_mm_s = inf\n", "m.toml:2: job.feed_mm_s: inf", "finite"},
        Refusal{"[job]\nfeed_mm_s = 0\n", "m.toml:2: job.feed_mm_s: 0 mm/s is impossible",
                "from 0.001 to 10000 mm/s"},
        Refusal{"[port.pins]\nestop = 9223372036854775807\n",
                "m.toml:2: port.pins.estop: ", "from -17 to 17"},
        Refusal{"[tick]\nschedule = \"triple\"\n", "m.toml:2: tick.schedule: \"triple\"",
                "single or two-timer"},
        Refusal{"[axis.psi]\nhome = \"max\"\n", "m.toml:2: axis.psi.home: \"max\"", "index or none"},
        Refusal{"[axis.r1]\nhome = \"index\"\n", "m.toml:2: axis.r1.home: \"index\"", "min, max or none"},
        Refusal{"[axis.y]\npositive = \"up\"\n", "m.toml:2: axis.y.positive: \"up\"", "high or low"},
        Refusal{"[axis.y]\npositive = true\n", "m.toml:2: axis.y.positive: true or false", "high or low"},
        Refusal{"[job]\nplanner = \"Angle\"\n", "m.toml:2: job.planner: ", "lookahead or angle"},
        Refusal{"[job]\njoining = \"snake\"\n", "m.toml:2: job.joining: ", "continuous, zigzag or spiral"}),
    [](const auto& named) { return psicarve::test::parameter_name(named.param.toml, named.index); });

INSTANTIATE_TEST_SUITE_P(
    KeysTogether, ProfileRefusals,
    testing::Values(
        Refusal{"[axis.psi]\npulses_per_rev = 6401\n", "m.toml:2: axis.psi.pulses_per_rev: 6401 is odd",
                "even"},
        Refusal{"[axis.psi]\nindex_tolerance_pulses = 3200\n",
                "m.toml:2: axis.psi.index_tolerance_pulses: ", "lower it"},
        Refusal{"[axis.r2]\ntravel_mm = [60, 0]\n", "m.toml:2: axis.r2.travel_mm: ", "reversed"},
        Refusal{"[axis.r2]\nhome_position_mm = 61.5\n", "m.toml:2: axis.r2.home_position_mm: 61.5 mm",
                "overtravel"},
        Refusal{"\n\n[axis.r1]\nhome_position_mm = 0\n", "m.toml:4: axis.r1.home_position_mm: 0 mm",
                "leaves nothing of the travel"},
        Refusal{"[axis.y]\nhome = \"max\"\n", "m.toml:2: axis.y.home_position_mm: 0 mm", "axis.y.home"},
        Refusal{"[axis.y]\nstart_stop_mm_s = 11\n", "m.toml:2: axis.y.start_stop_mm_s: 11 mm/s",
                "raise axis.y.speed_mm_s"},
        Refusal{"[axis.r1]\nspeed_mm_s = 0.5\n", "m.toml:2: axis.r1.start_stop_mm_s: 1 mm/s", "0.5 mm/s"},
        Refusal{"[axis.psi]\nhome_speed_deg_s = 300\n", "m.toml:2: axis.psi.home_speed_deg_s: 300 deg/s",
                "225 deg/s"},
        Refusal{"head_clearance_mm = 500\n", "m.toml:1: head_clearance_mm: 500 mm is more than",
                "with both heads out, 120 mm; lower it"},
        Refusal{"head_clearance_mm = 120\n", "m.toml:1: head_clearance_mm: 120 mm", "lower it"},
        Refusal{"head_clearance_mm = 100\n[axis.r2]\ntravel_mm = [0, 40]\nhome_position_mm = 40\n",
                "m.toml:1: head_clearance_mm: 100 mm", "with both heads out, 100 mm"},
        Refusal{"core_radius_mm = 60\n", "m.toml:1: core_radius_mm: 60 mm", "axis.r1.travel_mm"},
        // 50 us: one tick high, one low, so 10 000 pulses/s or 25 mm/s.
        Refusal{"[axis.r1]\nspeed_mm_s = 25.01\n",
                "m.toml:2: axis.r1.speed_mm_s: axis r1 would need 10004 pulses/s",
                "allow 10000 pulses/s; lower it to 25 mm/s"},
        Refusal{"[axis.psi]\nspeed_deg_s = 562.6\n", "m.toml:2: axis.psi.speed_deg_s: axis psi would need",
                "lower it to 562.5 deg/s"},
        // Two ticks low: 150 us.
        Refusal{"[port]\nstep_low_ns = 50001\n[axis.y]\nspeed_mm_s = 17\n",
                "m.toml:4: axis.y.speed_mm_s: axis y would need 6800 pulses/s", "allow 6666.7 pulses/s"},
        // A tick has no room for so much and the writes.
        Refusal{"[port]\nstep_low_ns = 47501\n[axis.y]\nspeed_mm_s = 17\n",
                "m.toml:4: axis.y.speed_mm_s: axis y would need 6800 pulses/s", "allow 6666.7 pulses/s"},
        Refusal{"[tick]\nperiod_us = 24\n[port]\npulses = \"within-tick\"\n",
                "m.toml:4: port.pulses: a pulse, its gap and the writes take 25 us",
                "lengthen tick.period_us"},
        Refusal{"[port]\npulses = \"within-tick\"\n[axis.r1]\nspeed_mm_s = 50.1\n",
                "m.toml:4: axis.r1.speed_mm_s: axis r1 would need 20040 pulses/s", "allow 20000 pulses/s"},
        Refusal{"[tick]\nschedule = \"two-timer\"\n", "m.toml:2: axis.r1.speed_mm_s: axis r1 would need 4000",
                "the two-timer schedule allows 2000 pulses/s; lower it to 5 mm/s, or shorten tick.io_us"},
        Refusal{"[tick]\nschedule = \"two-timer\"\nio_us = 60\nperiod_us = 50\ninterpolation_us = 50\n",
                "m.toml:3: tick.io_us: 60 us", "a multiple of tick.period_us"},
        Refusal{"[blank]\nradius_mm = 5\noffset_z_mm = -5\n",
                "m.toml:3: blank.offset_z_mm: the table's axis would be outside", "lesser offset"},
        Refusal{"[blank]\noffset_x_mm = 1\n", "m.toml:2: blank.offset_x_mm: the table's axis",
                "set blank.radius_mm"},
        Refusal{"[tool]\nshape = \"ball\"\ndiameter_mm = 2\n[roughing]\nstepover_mm = 2.5\n",
                "m.toml:5: roughing.stepover_mm: 2.5 mm is more than the tool is wide, 2 mm",
                "set it lower, or to 0"},
        Refusal{"[blank]\ndepth_limit_mm = 2\n", "m.toml:2: blank.depth_limit_mm: is counted from",
                "set blank.radius_mm"},
        Refusal{"[tick]\nschedule = \"two-timer\"\nio_us = 50\nperiod_us = 50\ninterpolation_us = 50\n",
                "m.toml:3: tick.io_us: 50 us are too short", "100 us"},
        Refusal{"[tick]\nschedule = \"two-timer\"\nio_us = 500\nperiod_us = 50\ninterpolation_us = 1000\n",
                "m.toml:5: tick.interpolation_us: 1000 us is longer than the 500 us", "lengthen tick.io_us"}),
    [](const auto& named) { return psicarve::test::parameter_name(named.param.toml, named.index); });

INSTANTIATE_TEST_SUITE_P(
    Pins, ProfileRefusals,
    testing::Values(
        Refusal{"[port.pins]\nspindle = 17\n", "m.toml:2: port.pins.spindle: ", "output pin 17"},
        Refusal{"[port.pins]\nspindle = 16\ny_dir = 9\nr1_dir = 16\n",
                "m.toml:4: port.pins.r1_dir: ", "output pin 16"},
        Refusal{"[port.pins]\nr1_dir = 16\ny_dir = 9\nspindle = 16\n",
                "m.toml:4: port.pins.spindle: ", "output pin 16"},
        Refusal{"[port.pins]\nestop = 13\n", "m.toml:2: port.pins.estop: ", "would be an emergency stop"},
        Refusal{"[port.pins]\nr1_enable = 16\n", "m.toml:2: port.pins.r1_enable: ", "only enables may share"},
        Refusal{"[port.pins]\nr1_enable = -6\n", "m.toml:2: port.pins.r1_enable: ", "the same sign"},
        Refusal{"[port.pins]\nspindle = 10\n", "m.toml:2: port.pins.spindle: an output cannot be on pin 10",
                "1 to 9, 14, 16 or 17"},
        Refusal{"[port.pins]\nestop = 16\n", "m.toml:2: port.pins.estop: an input cannot be on pin 16",
                "10 to 13 or 15"},
        Refusal{"[port.pins]\nspindle = -15\n", "m.toml:2: port.pins.spindle: an output", "pin 15"},
        Refusal{"[port.pins]\ncharge_pump = 1\n",
                "m.toml:2: port.pins.charge_pump: port.pins.y_enable and port.pins.charge_pump are both",
                "output pin 1"},
        Refusal{"[port.pins]\ncharge_pump = 15\n",
                "m.toml:2: port.pins.charge_pump: an output cannot be on pin 15", "use pin 1 to 9"},
        Refusal{"[port.pins]\nflood = 16\n",
                "m.toml:2: port.pins.flood: port.pins.spindle and port.pins.flood are both", "output pin 16"},
        Refusal{"[port.pins]\nr2_enable = 6\nmist = 7\noutput_3 = -7\n",
                "m.toml:4: port.pins.output_3: port.pins.mist and port.pins.output_3 are both",
                "only enables may share"},
        Refusal{"[port.pins]\noutput_0 = 11\n", "m.toml:2: port.pins.output_0: an output cannot be on pin 11",
                "1 to 9, 14, 16 or 17"},
        Refusal{"[port.pins]\nspindle = 18\n", "m.toml:2: port.pins.spindle: 18", "from -17 to 17"},
        Refusal{"[port.pins]\ny_step = 0\n", "m.toml:2: port.pins.y_step: is not wired",
                "axis y cannot move"},
        Refusal{"[port.pins]\npsi_dir = 0\n", "m.toml:2: port.pins.psi_dir: is not wired", "give its pin"},
        Refusal{"[axis.r1]\nhome = \"max\"\n[port.pins]\nr1_limit = 0\n",
                "m.toml:4: port.pins.r1_limit: is not wired, but axis.r1.home = \"max\" needs it",
                "set axis.r1.home = \"none\""},
        Refusal{"[port.pins]\npsi_index = 0\n",
                "m.toml:2: port.pins.psi_index: ", "set axis.psi.home = \"none\""}),
    [](const auto& named) { return psicarve::test::parameter_name(named.param.toml, named.index); });

TEST(ProfileRefusal, TellsTheFirstProblemOfTheFile) {
    EXPECT_THAT(refusal_of("[tick]\nperiod_us = 0\n[axis.r1]\nbogus = 1\nspeed_mm_s = -1\n"),
                StartsWith("m.toml:2: tick.period_us"));
    EXPECT_THAT(refusal_of("[tick]\nperiod_us = 5\n[axis.r1]\nzebra = 1\nspeed_mm_s = -1\n"),
                StartsWith("m.toml:4: axis.r1.zebra"));
}

TEST(ProfileProblems, AreAllOfTheKeysOrElseTheFirstOfSeveralTogether) {
    const auto problems = profile_problems("[tick]\nperiod_us = 0\n[axis.r1]\nspeed_mm_s = -1\nhome = 3\n");
    ASSERT_EQ(problems.size(), 3U);
    EXPECT_EQ(problems[0].key, "tick.period_us");
    EXPECT_EQ(problems[1].key, "axis.r1.speed_mm_s");
    EXPECT_EQ(problems[1].line, 4);
    EXPECT_EQ(problems[2].key, "axis.r1.home");
    const auto together = profile_problems("[axis.r1]\nspeed_mm_s = 1\nstart_stop_mm_s = 2\n");
    ASSERT_EQ(together.size(), 1U);
    EXPECT_EQ(together[0].key, "axis.r1.start_stop_mm_s");
    EXPECT_TRUE(profile_problems("").empty());
    EXPECT_EQ(profile_problems("[").at(0).key, "");
}

TEST(ProfileRefusal, EveryNumberIsBoundedOnBothSides) {
    for (const auto& key : profile_detail::key_table()) {
        if (!key.words.empty() || key.path == "name") continue;
        const bool pair = key.path.ends_with(".travel_mm");
        const bool whole = profile_detail::value_as_toml(key, Profile{}).find('.') == std::string::npos;
        for (const double beyond : {key.bounds.least - 1.0, key.bounds.greatest + 1.0}) {
            std::string value = whole ? std::to_string(static_cast<std::int64_t>(beyond))
                                      : profile_detail::number_as_toml(beyond);
            if (pair) value = "[" + value + ", " + value + "]";
            const auto dot = key.path.rfind('.');
            const std::string header =
                dot == std::string::npos ? "\n" : "[" + key.path.substr(0, dot) + "]\n";
            const std::string leaf = dot == std::string::npos ? key.path : key.path.substr(dot + 1);
            const std::string message = refusal_of(header + leaf + " = " + value + "\n");
            EXPECT_THAT(message, StartsWith("m.toml:2: " + key.path + ": "));
            EXPECT_THAT(message, HasSubstr("is impossible"));
        }
    }
}

TEST(ProfileRefusal, LongTextsAreRefusedByTheirLength) {
    EXPECT_THAT(refusal_of("name = \"" + std::string(65, 'x') + "\"\n"), HasSubstr("65 bytes"));
    EXPECT_EQ(refusal_of("name = \"" + std::string(64, 'x') + "\"\n"), "accepted");
    EXPECT_EQ(refusal_of(std::string(kProfileTextBytes, '\n')), "accepted");
    EXPECT_THAT(refusal_of(std::string(kProfileTextBytes + 1, '\n')), HasSubstr("bytes long"));
    EXPECT_LT(refusal_of(std::string(40000, 'x') + " = 1\n").size(), 400U);
    EXPECT_LT(refusal_of("x = \"" + std::string(40000, 'x') + "\n").size(), 400U);
}

TEST(ProfileRefusal, DeepNestingIsRefusedAndDoesNotCrash) {
    EXPECT_THAT(refusal_of("a = " + std::string(20000, '[')), StartsWith("m.toml:1: "));
    std::string inline_tables = "a = ";
    for (int i = 0; i < 8000; ++i) inline_tables += "{a=";
    EXPECT_THAT(refusal_of(inline_tables), StartsWith("m.toml:1: "));
}

TEST(ProfileRefusal, AMissingFileIsNamed) {
    const auto result = load_profile("/nonexistent/machine.toml");
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::bad_input);
    EXPECT_THAT(result.error().message, StartsWith("/nonexistent/machine.toml: "));
}

TEST(ProfileRefusal, AFolderIsNoProfile) {
    const auto result = load_profile(in_source("examples"));
    ASSERT_FALSE(result);
    EXPECT_THAT(result.error().message, HasSubstr("examples"));
}

TEST(ProfileAccepts, WholeNumbersWhereFractionsAreWanted) {
    EXPECT_EQ(refusal_of("[job]\nfeed_mm_s = 20\n[axis.r1]\ntravel_mm = [0, 60]\n"), "accepted");
}

TEST(ProfileRefusal, CharactersBeyondAsciiOutsideOfStrings) {
    EXPECT_THAT(refusal_of("\n\nname\u00e9 = 1\n"), StartsWith("m.toml:3: this is not TOML"));
    EXPECT_THAT(refusal_of("[job]\nfeed_mm_s = 1\u00a02\n"), StartsWith("m.toml:2: this is not TOML"));
    EXPECT_THAT(refusal_of("# \" not a string\nx = '\\'\u00e9\n"), StartsWith("m.toml:2: this is not TOML"));
}

// A broken value before it: what looks like a string is none to the parser.
TEST(ProfileRefusal, LettersBeyondAsciiWhereTheParserIsOutOfStep) {
    EXPECT_THAT(refusal_of("x = [ 0x0, 0b1111\"Fr\u00e4se\" # \u03a8\n"),
                StartsWith("m.toml:1: this is not TOML"));
    for (std::uint32_t code = 0x80; code < 0xD800; ++code) {
        std::string letter{static_cast<char>(0xE0U | (code >> 12U)),
                           static_cast<char>(0x80U | ((code >> 6U) & 0x3FU)),
                           static_cast<char>(0x80U | (code & 0x3FU))};
        if (code < 0x800) {
            letter = {static_cast<char>(0xC0U | (code >> 6U)), static_cast<char>(0x80U | (code & 0x3FU))};
        }
        ASSERT_THAT(refusal_of("x = 0b1" + letter + "\n"), StartsWith("m.toml:1: ")) << code;
    }
}

TEST(ProfileAccepts, AnyCharacterInCommentsAndStrings) {
    EXPECT_EQ(refusal_of("name = \"\"\"\na \\\n\u0483\"\"\"\n"), "accepted");
    EXPECT_EQ(refusal_of("\xEF\xBB\xBF# \u03a8 isn't \"quoted\nname = \"Fr\u00e4se \\\" \u03a8\" # \u00e9\n"),
              "accepted");
    EXPECT_EQ(refusal_of("name = 'M\u00fchle \\' # \u00e9\n"), "accepted");
    EXPECT_EQ(refusal_of("name = \"\"\"a \"\" b\"\"\"\"\" # \u00e9\n"), "accepted");
}

TEST(ProfileAccepts, SpeedsOfExactlyWhatTheTickAllows) {
    EXPECT_EQ(refusal_of("[axis.r1]\nspeed_mm_s = 25\n"), "accepted");
    EXPECT_EQ(refusal_of("[tick]\nschedule = \"two-timer\"\n[axis]\nr1.speed_mm_s = 5\nr2.speed_mm_s = 5\n"
                         "y.speed_mm_s = 5\npsi.speed_deg_s = 112.5\n"),
              "accepted");
}

TEST(ProfileAccepts, SensorsThatNobodyNeedsUnwired) {
    EXPECT_EQ(refusal_of("[axis.r1]\nhome = \"none\"\n[axis.psi]\nhome = \"none\"\n"
                         "[port.pins]\nr1_limit = 0\npsi_index = 0\nspindle = 0\ny_enable = 0\n"),
              "accepted");
}

}  // namespace
}  // namespace psicarve
