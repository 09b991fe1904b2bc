// SPDX-License-Identifier: GPL-3.0-or-later
// The least that ways of a program take, where they are of the size of a pulse.
#include <array>
#include <cstdio>

#include "tests/hmi/verify/program_machine.hpp"

namespace psicarve::verify {
namespace {

constexpr double kWay_mm = 9.0;

/// Whose heads may go at any speed at once.
Profile prompt_profile() {
    Profile profile;
    for (LinearAxisProfile* head : {&profile.r1, &profile.r2}) head->start_stop_mm_s = head->speed_mm_s;
    return profile;
}

std::string text_of_lines(double length_mm, const std::string& begin) {
    std::string text = begin;
    const auto lines = static_cast<int>(std::llround(kWay_mm / length_mm));
    for (int n = 1; n <= lines; ++n) {
        std::array<char, 48> line{};
        std::snprintf(line.data(), line.size(), "G1 X%.5f\n", 40.0 - kWay_mm * n / lines);
        text += line.data();
    }
    return text + "M2\n";
}

ProgramVerifyReport judged_in(const std::string& text, double seconds) {
    PlacedMachine machine{prompt_profile()};
    machine.pins().iteration_ns = std::llround(seconds * 1e9 / (kWay_mm * 400.0));
    machine.to({40.0 - kWay_mm, 41, 0, 0});
    return judged(text, machine, prompt_profile());
}

// Pulses that lines are without are no reason to hurry.
TEST(ProgramTimes, HoldFHoweverShortTheLinesAre) {
    for (const double length_mm : {0.0005, 0.0009, 0.0015, 0.00225, 0.004, 9.0}) {
        const std::string text = text_of_lines(length_mm, "G21 G90 G94 G64 F300\n");
        const auto right = judged_in(text, 1.80);
        EXPECT_EQ(verdict(right), "ok") << length_mm;
        EXPECT_EQ(right.lowered_count, 0U) << length_mm << ": " << right.lowered_seconds;
        const auto hasty = judged_in(text, 1.0);
        EXPECT_EQ(verdict(hasty).substr(0, 5), "feed ") << length_mm;
        EXPECT_GT(hasty.rules[0].offences, 5U * (length_mm < 1.0 ? 1U : 0U)) << length_mm;
    }
}

// A line from rest to rest each is timed by its own pulses.
TEST(ProgramTimes, HoldFFromRestToRest) {
    const std::string text = text_of_lines(0.00225, "G21 G90 G94 G61 F300\n");
    EXPECT_EQ(verdict(judged_in(text, 1.80)), "ok");
}

// A hundredth of a pulse that rounding makes a pulse of has no time that pins could show.
TEST(ProgramTimes, AskNothingOfASinglePulse) {
    PlacedMachine machine;
    machine.to({40, 41, -0.05625, 0}).rest(0.01).to({40, 41, -0.1125, 0});
    EXPECT_EQ(verdict(judged("G21 G90 G94 G61 F300\nG1 C-0.0279\nG1 C-0.0283\nG1 C-0.1125\nM2\n", machine)),
              "ok");
}

// Ten minutes for a fifth of a pulse are none: there is nothing that could take them.
TEST(ProgramTimes, AskNothingOfWaysWithoutAPulse) {
    const std::string text = "G21 G90 G64\nG93 G1 X39.9995 F0.1\nG94 G1 X31 F300\nM2\n";
    const auto report = judged_in(text, 1.80);
    EXPECT_EQ(verdict(report), "ok");
    EXPECT_EQ(report.lowered_count, 0U);
    EXPECT_EQ(verdict(judged_in(text, 1.0)), "feed 3");
}

// Rounding makes a staircase longer than the line through it: no feed is lowered by that.
TEST(ProgramTimes, CallNoStaircaseALoweredFeed) {
    std::string text = "G21 G90 G94 G64 P.01 F300\n";
    std::vector<ProgramPlace> places;
    for (int n = 1; n <= 1000; ++n) {
        const ProgramPlace place{40.0 - 0.0015 * n, 41, 0, 0.0013 * n};
        places.push_back(place);
        std::array<char, 64> line{};
        std::snprintf(line.data(), line.size(), "G1 X%.4f Y%.4f\n", place[0], place[3]);
        text += line.data();
    }
    Profile profile = prompt_profile();
    profile.y.start_stop_mm_s = profile.y.speed_mm_s;
    PlacedMachine machine{profile};
    machine.pins().iteration_ns = 500'000;
    // As the records are rounded: first one axis, then the other.
    for (const ProgramPlace& place : places) machine.to({place[0], 41, 0, place[3]});
    const auto report = judged(text + "M2\n", machine, profile);
    EXPECT_EQ(verdict(report), "ok");
    EXPECT_EQ(report.lowered_count, 0U) << report.lowered_seconds;
}

}  // namespace
}  // namespace psicarve::verify
