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
    /// Ways from a pulse's size on. `pulse_mm`: of the machine.
    RandomProgram random_program(double pulse_mm) {
        RandomProgram made;
        made.lines.push_back(random_() % 2 == 0 ? "G64 P0.01" : "G64 P0.03");
        for (int n = 0; n < 14; ++n) {
            const double angle_rad = between(0.0, 2.0 * kPi);
            const double size_mm = pulse_mm * std::pow(10.0, between(0.3, 1.5));
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
    void write_profile(const std::string& pulses_per_mm) {
        std::string text;
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

}  // namespace
}  // namespace psicarve::test
