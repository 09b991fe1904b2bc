// SPDX-License-Identifier: GPL-3.0-or-later
// What `psicarve status` tells of a program that runs: what holds where the machine is, not where its reader
// is.
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "shared/segment/segment_program.hpp"
#include "tests/two_process/cli_machine_rig.hpp"

namespace psicarve::test {
namespace {

class ToldModes : public Machine {
protected:
    void start_homed_core(const std::vector<std::string>& more = {}) {
        start_core(more);
        ASSERT_EQ(run({"home"}).exit_code, 0);
    }
    std::unique_ptr<RunningProgram> begin_program(const std::string& text,
                                                  const std::vector<std::string>& more = {}) const {
        write("modes.ngc", text);
        std::vector<std::string> arguments{"gcode", "run", file("modes.ngc"), "--segment", segment_};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return std::make_unique<RunningProgram>("psicarve", arguments);
    }
    nlohmann::json told() const { return run({"status", "--json"}).json()["program"]; }
    /// It holds in this line, and what is told is of it. Both come a moment later.
    testing::AssertionResult holds_and_tells(std::uint64_t line) const {
        nlohmann::json last;
        const bool does = eventually([&] {
            if (state() != MachineState::held) return false;
            last = told();
            return last.is_object() && last["line"] == line && last["modes"].is_object() &&
                   last["modes"]["is_at_hand"] == true && last["modes"]["line"] == line;
        });
        return does ? testing::AssertionSuccess() : testing::AssertionFailure() << last.dump();
    }
    static void expect_at_end(const nlohmann::json& program) {
        ASSERT_TRUE(program["to_go"].is_object()) << program.dump();
        for (const char* axis : {"r1_mm", "r2_mm", "psi_deg", "y_mm"}) EXPECT_EQ(program["to_go"][axis], 0.0);
    }
};

TEST_F(ToldModes, AreThoseOfTheLineWhereItHoldsThoughAllIsRead) {
    start_homed_core();
    const auto running = begin_program(
        "G21 G90 G94 G10 L2 P2 X30 Y4 C90\nG0 X40 Z41 Y5\nM0\n"
        "G20 G91 G55 F10\nG1 X-0.1\nS900 M3\nM0\n"
        "G21 G90 G92 X5\nG61 G1 X6 F120\nM0\nG92.1 G54 M5\nG0 X40\nM2\n");
    ASSERT_TRUE(holds_and_tells(3));
    const auto first = told();
    EXPECT_EQ(first["modes"]["codes"], "G0 G17 G21 G90 G94 G54 G64 G40 G49 G99 G91.1 G13.1 M5 M9 M48");
    EXPECT_EQ(first["modes"]["zero"],
              (nlohmann::json{{"r1_mm", 0.0}, {"r2_mm", 0.0}, {"psi_deg", 0.0}, {"y_mm", 0.0}}));
    EXPECT_EQ(first["modes"]["feed"], 0.0);
    expect_at_end(first);
    EXPECT_EQ(first["queue"]["of"], 8192);
    EXPECT_EQ(first["starvations"], 0);

    ASSERT_EQ(run({"resume"}).exit_code, 0);
    ASSERT_TRUE(holds_and_tells(7));
    const auto second = told();
    EXPECT_EQ(second["modes"]["codes"], "G1 G17 G20 G91 G94 G55 G64 G40 G49 G99 G91.1 G13.1 M3 M9 M48");
    EXPECT_EQ(second["modes"]["zero"],
              (nlohmann::json{{"r1_mm", 30.0}, {"r2_mm", 0.0}, {"psi_deg", 90.0}, {"y_mm", 4.0}}));
    EXPECT_EQ(second["modes"]["feed"], 10.0);
    EXPECT_EQ(second["modes"]["speed_rpm"], 900.0);
    EXPECT_EQ(second["modes"]["system"], "G55");
    expect_at_end(second);
    const std::string text = run({"status"}).out;
    EXPECT_NE(
        text.find(
            "modes      G1 G17 G20 G91 G94 G55 G64 G40 G49 G99 G91.1 G13.1 M3 M9 M48; F 10, S 900, T 0\n"
            "zero       G55: r1 30.000 mm, r2 0.000 mm, psi 90.000 deg, y 4.000 mm\n"
            "to go      r1 0.000 mm, r2 0.000 mm, psi 0.000 deg, y 0.000 mm\n"
            "queue      0 of 8192 records; it had to wait for more 0 times\n"),
        std::string::npos)
        << text;

    ASSERT_EQ(run({"resume"}).exit_code, 0);
    ASSERT_TRUE(holds_and_tells(10));
    const auto third = told();
    EXPECT_EQ(third["modes"]["codes"], "G1 G17 G21 G90 G94 G55 G61 G40 G49 G99 G91.1 G13.1 M3 M9 M48");
    EXPECT_NEAR(third["modes"]["zero"]["r1_mm"].get<double>(), 40.0 - 2.54 - 5.0, 1e-9);
    EXPECT_EQ(third["modes"]["feed"], 120.0);
    EXPECT_GT(third["sequence"], second["sequence"]);

    ASSERT_EQ(run({"resume"}).exit_code, 0);
    EXPECT_EQ(running->wait(), 0) << running->error();
    EXPECT_TRUE(told().is_null());
    // The last told is of the program's end.
    const auto segment = Segment::attach(segment_);
    ASSERT_TRUE(segment);
    const ProgramReport report = program_report(*segment);
    ASSERT_TRUE(report.modes);
    EXPECT_EQ(report.modes->sequence, report.status.sequence);
    EXPECT_EQ(report.modes->m_codes[0], 5);
}

TEST_F(ToldModes, SayHowFarItIsToTheEndOfTheWayAtHand) {
    start_homed_core();
    // Nearly a day: it cannot be over before it is held, by the virtual clock neither.
    const auto running = begin_program("G21 G90 F0.002\nG0 X40 Z41 Y5 C0\nG1 X38 Y6\nM2\n");
    ASSERT_TRUE(eventually([&] {
        const auto program = told();
        return program.is_object() && program["line"] == 3 && program["to_go"].is_object() &&
               program["to_go"]["r1_mm"] > -2.0;
    }));
    ASSERT_EQ(run({"hold"}).exit_code, 0);
    ASSERT_TRUE(holds_and_tells(3));
    const auto program = told();
    const auto position = run({"status", "--json"}).json()["position"];
    const double r1_mm = program["to_go"]["r1_mm"];
    EXPECT_LT(r1_mm, 0.0);
    EXPECT_GT(r1_mm, -2.0);
    EXPECT_NEAR(r1_mm, 38.0 - position["r1_mm"].get<double>(), 1e-9);
    EXPECT_NEAR(program["to_go"]["y_mm"].get<double>(), 6.0 - position["y_mm"].get<double>(), 1e-9);
    ASSERT_EQ(run({"stop"}).exit_code, 0);
    running->wait();
}

TEST_F(ToldModes, AreOfThePassOfALoopThatIsAtHand) {
    start_homed_core();
    const auto running =
        begin_program("G21 G91 F300\nG0 X-20\no1 repeat [3]\nG1 X-1\nM0\no1 endrepeat\nM2\n");
    std::uint64_t sequence = 0;
    for (int pass = 0; pass < 3; ++pass) {
        ASSERT_TRUE(eventually([&] {
            const auto program = told();
            return program.is_object() && program["sequence"] > sequence &&
                   program["hold"] == "program stop" && program["modes"]["is_at_hand"] == true;
        })) << told().dump();
        const auto program = told();
        EXPECT_EQ(program["line"], 5);
        expect_at_end(program);
        sequence = program["sequence"];
        EXPECT_EQ(sequence, 3U + 2U * static_cast<std::uint64_t>(pass));
        ASSERT_EQ(run({"resume"}).exit_code, 0);
    }
    EXPECT_EQ(running->wait(), 0) << running->error();
}

// What it had put is run without it: what it told last stays, but is not passed off as what holds.
TEST_F(ToldModes, AreOfTheirLineOnceTheirWriterWasKilled) {
    start_homed_core();
    const auto running = begin_program("G21 G90 F300\nG0 X40\nM0\nG55 G1 X39\nG91 G1 X-1\nM0\nM2\n");
    ASSERT_TRUE(holds_and_tells(3));
    running->send(SIGKILL);
    running->wait();
    ASSERT_EQ(run({"resume"}).exit_code, 0);
    ASSERT_TRUE(eventually([&] {
        const auto program = told();
        return program.is_object() && program["line"] == 6 && program["hold"] == "program stop";
    })) << told().dump();
    const auto program = told();
    EXPECT_EQ(program["modes"]["line"], 3);
    EXPECT_EQ(program["modes"]["is_at_hand"], false);
    EXPECT_EQ(program["modes"]["system"], "G54");
    EXPECT_TRUE(program["to_go"].is_null()) << program.dump();
    const std::string text = run({"status"}).out;
    EXPECT_NE(text.find("(of line 3)"), std::string::npos) << text;
    EXPECT_EQ(text.find("to go"), std::string::npos) << text;
    ASSERT_EQ(run({"stop"}).exit_code, 0);
    const auto next = begin_program("G21 G90 F300\nG0 X45\nM0\nM2\n");
    ASSERT_TRUE(holds_and_tells(3));
    EXPECT_EQ(told()["modes"]["system"], "G54");
    ASSERT_EQ(run({"resume"}).exit_code, 0);
    EXPECT_EQ(next->wait(), 0) << next->error();
}

// A small ring is full at all times: its writer waits, and what holds is told all the same.
TEST_F(ToldModes, KeepUpWhileTheRingIsFull) {
    start_homed_core({"--program-ring", "64"});
    std::string text = "G21 G90 F600\nG0 X50 Z50 Y10 C0\n";
    for (int i = 0; i < 30'000; ++i)
        text += "G1 X" + std::to_string(50 - i % 2) + " F" + std::to_string(600 + i % 7) + "\n";
    text += "M2\n";
    const auto running = begin_program(text);
    // Of 30'000, which pass in seconds: what is told follows the machine, and the ring is full meanwhile.
    constexpr std::uint64_t kNear_lines = 1'000;
    constexpr int kEnough = 20;
    std::uint64_t last_line = 100;
    std::uint64_t widest_lines = 0;
    int told_near = 0;
    EXPECT_TRUE(eventually([&] {
        const auto segment = Segment::attach(segment_);
        if (!segment) return false;
        const ProgramReport report = program_report(*segment);
        if (report.modes && report.status.line > 100 && report.modes->line > last_line) {
            const auto feed = static_cast<double>(600 + (report.modes->line - 3) % 7);
            EXPECT_EQ(report.modes->feed, feed) << report.modes->line;
            EXPECT_LE(report.modes->line, report.status.line) << "never ahead of the machine";
            last_line = report.modes->line;
            const std::uint64_t behind_lines = report.status.line - last_line;
            widest_lines = std::max(widest_lines, behind_lines);
            if (behind_lines < kNear_lines && report.queued > report.ring_records / 2) ++told_near;
        }
        return told_near >= kEnough || running->has_ended();
    }));
    EXPECT_GE(told_near, kEnough) << "at most " << widest_lines << " lines behind";
    running->send(SIGINT);
    running->wait();
}

}  // namespace
}  // namespace psicarve::test
