// SPDX-License-Identifier: GPL-3.0-or-later
// The pulses of a program hang on the program alone: not on the ring, on its writer's pauses, on an operator.
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "tests/places.hpp"
#include "tests/thoroughness.hpp"
#include "tests/two_process/program_proof_rig.hpp"

namespace psicarve::test {
namespace {

class SamePulses : public ProgramProof {
protected:
    /// The whole trace, of a writer that is stopped at `pauses` random instants.
    std::string trace_through(const std::string& text, const std::string& ring, int pauses) {
        const std::string trace = file("ring.trace");
        start_homed({"--trace", trace, "--program-ring", ring});
        const auto writer = begin(text);
        for (int n = 0; n < pauses && !writer->has_ended(); ++n) {
            std::this_thread::sleep_for(std::chrono::microseconds{random_() % 4'000});
            writer->send(SIGSTOP);
            std::this_thread::sleep_for(std::chrono::microseconds{random_() % 12'000});
            writer->send(SIGCONT);
        }
        EXPECT_EQ(writer->wait(), 0) << writer->error();
        EXPECT_EQ(program_status().starvations, 0U);
        end_core();
        return text_of(trace);
    }

    std::mt19937 random_{20261127};
};

TEST_F(SamePulses, GoThroughRingsOfAnySizeAndWhateverPausesTheirWriterMakes) {
    const std::string text = dense_program(is_long_run() ? 100'000 : kIsSanitized ? 2'000 : 6'000);
    const std::string through_the_least = trace_through(text, "64", 0);
    EXPECT_GT(through_the_least.size(), 10'000U);
    EXPECT_TRUE(through_the_least == trace_through(text, "65536", 0));
    EXPECT_TRUE(through_the_least == trace_through(text, "64", is_long_run() ? 300 : 30));
    EXPECT_TRUE(through_the_least == trace_through(text, "65536", is_long_run() ? 300 : 30));
}

// While, repeat and subroutines on a machine, beside the ways that they come to, one by one.
TEST_F(SamePulses, AreThoseOfALoopsPassesWrittenOut) {
    std::string written_out = "G21 G90 F600\nG0 X50 Z50 Y10 C0\n";
    for (int round = 0; round < 4; ++round) {
        for (int pass = 0; pass < 3; ++pass) written_out += "G91 G1 X-0.2 C5\nY0.1\nG90\n";
        written_out += "G1 X50 C0\nG1 Y10." + std::to_string(round) + "\n";
    }
    written_out += "M2\n";
    const std::string loops =
        "G21 G90 F600\nG0 X50 Z50 Y10 C0\no1 sub\no2 repeat [#1]\nG91 G1 X-0.2 C5\nY0.1\nG90\no2 endrepeat\n"
        "o1 endsub\n#3=0\no3 while [#3 LT 4]\no1 call [3]\nG1 X50 C0\nG1 Y[10+#3/10]\n#3=[#3+1]\n"
        "o3 endwhile\nM2\n";
    const std::string plain = trace_through(written_out, "64", 0);
    EXPECT_GT(plain.size(), 1'000U);
    EXPECT_TRUE(plain == trace_through(loops, "64", 0));
}

TEST_F(SamePulses, KeepTheirOrderUnderHoldsAndOverridesAtRandomInstants) {
    const std::string text = dense_program(3'000);
    std::vector<std::uint8_t> plain;
    const int runs = is_long_run() ? 20 : 1;
    for (int disturbed = 0; disturbed <= runs; ++disturbed) {
        start_homed({"--trace", file("hand.trace")});
        const auto writer = begin(text);
        ASSERT_TRUE(eventually([&] { return program_status().line > 3; }));
        int holds = 0;
        while (disturbed > 0 && program_status().is_done == 0) {
            ASSERT_TRUE(command(CommandKind::override, 10.0 + static_cast<double>(random_() % 191)));
            ASSERT_TRUE(command(CommandKind::rapid_override, 10.0 + static_cast<double>(random_() % 91)));
            if (command(CommandKind::hold)) {
                ++holds;
                // Slowing down; what comes too early is refused.
                ASSERT_TRUE(eventually([&] { return command(CommandKind::resume); }));
            }
            std::this_thread::sleep_for(std::chrono::microseconds{random_() % 3'000});
        }
        EXPECT_EQ(writer->wait(), 0) << writer->error();
        end_core();
        const auto order = order_of_trace(file("hand.trace"));
        if (disturbed == 0) plain = order;
        ASSERT_GT(plain.size(), 1'000U);
        EXPECT_TRUE(order == plain) << "run " << disturbed << ", " << holds << " holds";
        EXPECT_TRUE(disturbed == 0 || holds > 0);
    }
}

/// Ways in the air and in the material, corners and arcs, under G64 and G61.
std::string mixed_program(std::uint32_t seed, int lines) {
    std::mt19937 random{seed};
    std::string text = "G21 G90 G94 F900\nM3\nG0 X50 Z50 Y10 C0\n";
    for (int i = 0; i < lines; ++i) {
        const auto kind = random() % 10;
        std::array<char, 96> line{};
        const double across_mm = 48.0 + 0.01 * static_cast<double>(random() % 400);
        const double up_mm = 10.0 + 0.01 * static_cast<double>(random() % 400);
        if (kind == 0) text += random() % 3 == 0 ? "G61\n" : "G64 P0.03\n";
        if (kind == 1) text += "G4 P0.02\n";
        if (kind == 2 || kind == 7) text += "M1\n";
        const char* const form = kind < 4    ? "G0 X%.3f Y%.3f\n"
                                 : kind == 9 ? "G1 X%.3f\nG2 X%.3f I0.5 J0\n"
                                             : "G1 X%.3f Y%.3f\n";
        if (kind == 9) {
            std::snprintf(line.data(), line.size(), form, across_mm, across_mm + 1.0);
        } else {
            std::snprintf(line.data(), line.size(), form, across_mm, up_mm);
        }
        text += line.data();
    }
    return text + "M2\n";
}

// Both overrides, holds, single block and optional stop, at random instants: as without them, and right as
// the run itself says.
TEST_F(SamePulses, KeepTheirOrderWhateverIsSwitchedAndAreRight) {
    const std::uint32_t seeds = is_long_run() ? 20 : kIsSanitized ? 1 : 3;
    for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
        write("mixed.ngc", mixed_program(seed, 150));
        std::vector<std::uint8_t> plain;
        for (const bool is_disturbed : {false, true}) {
            start_homed();
            RunningProgram writer{"psicarve",
                                  {"gcode", "run", file("mixed.ngc"), "--trace", file("pins.trace"), "--json",
                                   "--segment", segment_}};
            int halts = 0;
            while (is_disturbed && !writer.has_ended() && program_status().is_done == 0) {
                (void)command(CommandKind::override, 10.0 + static_cast<double>(random_() % 91));
                (void)command(CommandKind::rapid_override, 10.0 + static_cast<double>(random_() % 91));
                (void)command(CommandKind::single, random_() % 3 != 0 ? 1.0 : 0.0);
                (void)command(CommandKind::optional_stop, random_() % 2 != 0 ? 1.0 : 0.0);
                if (random_() % 3 == 0) (void)command(CommandKind::hold);
                std::this_thread::sleep_for(std::chrono::microseconds{random_() % 3'000});
                if (program_status().hold == ProgramHold::single) ++halts;
                (void)command(CommandKind::resume);
            }
            const Outcome outcome = writer.outcome();
            EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
            EXPECT_EQ(outcome.json()["verified"], true) << "seed " << seed << outcome.out;
            end_core();
            const auto order = order_of_trace(file("pins.trace"));
            if (!is_disturbed) plain = order;
            ASSERT_GT(plain.size(), 1'000U);
            EXPECT_TRUE(order == plain) << "seed " << seed;
            EXPECT_TRUE(!is_disturbed || halts > 3) << halts;
        }
    }
}

class StandardStreams : public ProgramProof {
protected:
    static int shell(const std::string& words) { return WEXITSTATUS(std::system(words.c_str())); }
    std::string psicarve_words(const std::string& words) const {
        return in_build("bin/psicarve") + " " + words + " --segment " + segment_;
    }
};

// What is said to nobody is not written into the segment, which would get the descriptor's number.
TEST_F(StandardStreams, ThatAreClosedLeaveTheSegmentAsItIs) {
    start_homed();
    for (const char* closed : {" <&-", " >&-", " 2>&-", " <&- >&- 2>&-"}) {
        for (const char* words : {"status", "status --json", "move r1=99999", "gcode run -"})
            (void)shell(psicarve_words(words) + " < /dev/null > /dev/null 2> /dev/null" + closed);
        EXPECT_EQ(state(), MachineState::ready) << closed;
    }
    EXPECT_EQ(run({"move", "r1=50"}).exit_code, 0);
}

// A shell hands its own writing end down to what it starts: whose input would never end then.
TEST_F(StandardStreams, EndWhereTheShellHasClosedItsEndOfAPipe) {
    start_homed();
    const std::string pipe = file("pipe");
    const std::string program = "printf 'G21 G90 F300\\nG0 X50\\n'";
    for (const char* words : {"gcode run -", "gcode check - --no-machine"}) {
        const std::string script = "rm -f " + pipe + "; mkfifo " + pipe + "; exec 9<>" + pipe + "; " +
                                   psicarve_words(words) + " < " + pipe + " 2> " + file("said") + " & " +
                                   program + " >&9; exec 9>&-; wait $!";
        EXPECT_EQ(shell(script), 0) << words << ": " << text_of(file("said"));
    }
    EXPECT_NE(program_status().is_done, 0U);
}

// A file without its end was cut off; who writes a stream may just stop.
TEST_F(StandardStreams, EndAProgramInOrderWhereTheyEnd) {
    start_homed();
    write("open.ngc", "G21 G90 G64 P.05 F600\nM3\nG0 X50 Z50 Y10\nG1 X49 C20\nG1 X48.5 C30\nG1 X48.25\n");
    EXPECT_EQ(run({"gcode", "run", file("open.ngc")}).exit_code, 3);
    EXPECT_EQ(program_status().program, 0U);
    const auto of_stream = [this](const std::string& words) {
        return shell(psicarve_words(words) + " < " + file("open.ngc") + " > " + file("out") + " 2> " +
                     file("said"));
    };
    EXPECT_EQ(of_stream("gcode check -"), 0) << text_of(file("said"));
    EXPECT_EQ(of_stream("gcode run -"), 0) << text_of(file("said"));
    EXPECT_NE(text_of(file("out")).find("done, up to line 6"), std::string::npos) << text_of(file("out"));
    EXPECT_NE(program_status().is_done, 0U);
    EXPECT_EQ(state(), MachineState::ready);
    EXPECT_EQ(status().position_pulses[0], 19'300);
    EXPECT_EQ(status().signals & bit_of(Signal::spindle), 0U);
}

}  // namespace
}  // namespace psicarve::test
