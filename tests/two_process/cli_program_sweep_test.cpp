// SPDX-License-Identifier: GPL-3.0-or-later
// Random programs of short lines and small arcs on the simulated machine: what it does is right, and what
// another program asks is not.
#include <array>
#include <cmath>
#include <cstdio>
#include <random>

#include "shared/base/units.hpp"
#include "tests/thoroughness.hpp"
#include "tests/two_process/cli_machine_rig.hpp"

namespace psicarve::test {
namespace {

/// The speed at which the machine may begin at once: what a program asks is what it takes.
constexpr double kFeed_mm_min = 60.0;

struct RandomProgram {
    std::vector<std::string> lines;
    std::size_t line = 0;    ///< one that is large
    std::size_t circle = 0;  ///< another

    std::string text(double feed_mm_min) const {
        std::array<char, 64> begin{};
        std::snprintf(begin.data(), begin.size(), "G21 G90 G94 G17 F%g\nG0 X40 Z41 Y10 C0\nG91\n",
                      feed_mm_min);
        std::string all = begin.data();
        for (const std::string& each : lines) all += each + "\n";
        return all + "M2\n";
    }
};

class ProgramSweep : public Machine {
protected:
    double between(double least, double most) {
        return std::uniform_real_distribution<double>{least, most}(random_);
    }
    std::string words(const char* form, double first_mm, double second_mm) {
        std::array<char, 80> text{};
        std::snprintf(text.data(), text.size(), form, first_mm, second_mm);
        return text.data();
    }
    /// Ways from a part of a pulse on. `pulse_mm`: of the machine.
    RandomProgram random_program(double pulse_mm) {
        RandomProgram made;
        made.lines.push_back(random_() % 2 == 0 ? "G64 P0.01" : "G64 P0.03");
        for (int n = 0; n < 14; ++n) {
            const double angle_rad = between(0.0, 2.0 * kPi);
            const double size_mm = pulse_mm * std::pow(10.0, between(-0.7, 1.5));
            const double across_mm = size_mm * std::cos(angle_rad);
            const double up_mm = size_mm * std::sin(angle_rad);
            if (random_() % 5 == 0) made.lines.push_back(random_() % 2 == 0 ? "G4 P0.05" : "G61");
            if (random_() % 5 == 0) made.lines.push_back("G64 P0.02");
            if (random_() % 2 == 0) {
                made.lines.push_back(words("G1 X%.4f Y%.4f", across_mm, up_mm));
            } else {
                const char* const form = random_() % 2 == 0 ? "G2 I%.5f J%.5f" : "G3 I%.5f J%.5f";
                made.lines.push_back(words(form, 2.0 * across_mm, 2.0 * up_mm) +
                                     (random_() % 4 == 0 ? " C" + std::to_string(between(-9.0, 9.0)) : ""));
            }
        }
        made.line = made.lines.size();
        made.lines.push_back("G1 X-0.7 Y0.4");
        made.circle = made.lines.size();
        made.lines.push_back("G2 I-0.3 J0.1");
        made.lines.push_back("G1 X0.2 Y0.3");
        return made;
    }
    /// The pins of a program, and whether they were found right while it ran.
    bool runs(const std::string& text) {
        write("run.ngc", text);
        const Outcome done = run({"gcode", "run", file("run.ngc"), "--simulate", "--trace",
                                  file("pins.trace"), "--profile", file("machine.toml")});
        EXPECT_EQ(done.exit_code, 0) << done.error << text;
        said_ = done.out;
        return done.out.find("verified   yes") != std::string::npos;
    }
    bool is_right_for(const std::string& text) {
        write("judge.ngc", text);
        const Outcome judged = psicarve({"verify", file("pins.trace"), "--program", file("judge.ngc"),
                                         "--profile", file("machine.toml")});
        EXPECT_TRUE(judged.exit_code == 0 || judged.exit_code == 6) << judged.error;
        said_ = judged.out;
        return judged.exit_code == 0;
    }
    void write_profile(const std::string& pulses_per_mm, const std::string& more = {}) {
        std::string text = more;
        for (const char* axis : {"r1", "r2", "y"})
            text += "[axis." + std::string{axis} + "]\npulses_per_mm = " + pulses_per_mm + "\n";
        write("machine.toml", text);
    }

    std::mt19937 random_{20261128};
    std::string said_;
};

TEST_F(ProgramSweep, IsRightAsItRunsAndWrongForOtherPrograms) {
    const int count = is_long_run() ? 100 : kIsSanitized ? 2 : 6;
    for (const char* pulses_per_mm : {"50.0", "400.0"}) {
        write_profile(pulses_per_mm);
        for (int n = 0; n < count; ++n) {
            const RandomProgram made = random_program(1.0 / std::stod(pulses_per_mm));
            const std::string text = made.text(kFeed_mm_min);
            ASSERT_TRUE(runs(text)) << pulses_per_mm << "\n" << text << said_;
            EXPECT_TRUE(is_right_for(made.text(3.0 * kFeed_mm_min))) << text << said_;
            EXPECT_FALSE(is_right_for(made.text(kFeed_mm_min / 3.0))) << text;
            RandomProgram other = made;
            other.lines[made.circle] = "G3 I-0.3 J0.1";
            EXPECT_FALSE(is_right_for(other.text(kFeed_mm_min))) << "the other way round\n" << text;
            other = made;
            other.lines[made.line] = "G1 X-0.7 Y-0.4";
            EXPECT_FALSE(is_right_for(other.text(kFeed_mm_min))) << "one axis mirrored\n" << text;
            for (const std::size_t cut : {made.circle, made.line}) {
                other = made;
                other.lines.erase(other.lines.begin() + static_cast<std::ptrdiff_t>(cut));
                EXPECT_FALSE(is_right_for(other.text(kFeed_mm_min))) << "a way too many\n" << text;
            }
            // The last program's pins lack a way that the whole one has.
            ASSERT_TRUE(runs(other.text(kFeed_mm_min))) << said_;
            EXPECT_FALSE(is_right_for(text)) << "a way left out\n" << text;
        }
    }
}

/// Small ways that pass the place of a rest before it, or behind it.
struct WaysRoundRests {
    const char* pulses_per_mm;
    const char* more;
    const char* text;
};
constexpr const char* kBegin = "G21 G90 G94 G17 F60\nG64 P0.05\nG0 X40 Z41 Y10 C0\nG91\n";
constexpr const char* kStepwise = "[gcode]\ninterpolation = \"stepwise\"\n";
constexpr WaysRoundRests kRoundRests[]{
    // Each turn of the second circle comes by where the machine rested.
    {"50.0", "",
     "G64 P0.01\nG1 X0.8929 Y-1.0385\nG1 X-1.1943 Y-1.2670\nG1 X0.0150 Y-0.0208\nG4 P0.05\n"
     "G3 X-0.00618 Y-0.00716 I-0.00309 J-0.00358\nG2 I0.00594 J0.00694 P5\n"
     "G2 X0.05596 Y-0.03354 I0.02798 J-0.01677\n"},
    // The circle comes by the end of the line behind it.
    {"50.0", "",
     "F120 G61\nG1 X-0.2483 Y-0.3200\nG3 I-0.14687 J-0.03942 C-48.654 Z-0.1450\nG1 X0.0308 Y0.0009\n"
     "G1 X-0.0044 Y0.0044\nG3 I-0.01395 J-0.00966\nG1 X-0.0158 Y-0.0178 Z0.0129\nG4 P0.05\n"},
    {"50.0", kStepwise,
     "G3 X-0.00409 Y-0.00367 I-0.00388 J0.00021\nG1 X-0.0015 Y-0.0053 Z-0.0004\n"
     "G1 X0.0040 Y-0.0060 Z-0.0015\nG1 X0.0134 Y0.0125\nG2 I-0.00576 J-0.02129 P3\nG1 X0.0156 Y0.1435\n"},
    {"400.0", kStepwise, "G2 I0.02223 J0.02384\nG4 P0.05\nG3 I-0.02782 J0.02123\nM3\n"},
    // The circle behind M3 needs no pulse, and is gone along once the spindle has come to its speed.
    {"400.0", kStepwise,
     "G64 P0.01\nG1 X0.20739 Y-0.21899\nG1 X0.0310 Y0.0058\nG4 P0.05\nG64 P0.05\n"
     "G2 X0.00371 Y0.00985 I-0.00307 J0.00678\nM3\nG2 I-0.00167 J0.00110 P5\nG1 X0.0579 Y-0.0322\n"
     "G1 X-0.0921 Y-0.0287 C-2.933\n"},
    // A line is come to anew by the arc behind it.
    {"400.0", kStepwise,
     "G61\nG1 X0.017644 Y0.028204\nG3 X-0.00339 Y0.02779 I0.01220 J0.01559\n"
     "G2 X0.03384 Y0.01012 I0.01692 J0.00506\nG1 X-0.0086 Y-0.0015\n"
     "G2 X0.00955 Y-0.00037 I0.00496 J0.00459\nG2 I0.00230 J0.00086\nG2 I0.01971 J0.03595\n"},
};

TEST_F(ProgramSweep, IsRightOnSmallWaysRoundRests) {
    for (const WaysRoundRests& ways : kRoundRests) {
        write_profile(ways.pulses_per_mm, ways.more);
        const std::string text = std::string{kBegin} + ways.text + "M2\n";
        EXPECT_TRUE(runs(text)) << text << said_;
    }
}

}  // namespace
}  // namespace psicarve::test
