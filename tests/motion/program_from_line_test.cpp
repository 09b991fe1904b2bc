// SPDX-License-Identifier: GPL-3.0-or-later
// A program run from each of its lines: from that line's end on its pulses are those of the whole program.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "rtcore/program/record_rules.hpp"
#include "tests/hmi/gcode/made_records.hpp"
#include "tests/rtcore/cycle/program_rig.hpp"

namespace psicarve::motion {
namespace {

using cycle::program_profile;
using cycle::ProgramRig;
using cycle::Refusal;

/// Axes that stepped together, and the program's line that they stepped for.
struct LinedStep {
    std::uint32_t axes;
    std::uint64_t line;
    friend bool operator==(const LinedStep&, const LinedStep&) = default;
};

std::vector<plan::ProgramStep> steps_from_line(const std::string& text, std::uint64_t line,
                                               const Profile& profile, plan::Pulses4 at) {
    gcode::RunOptions how;
    how.from_line = line;
    const gcode::MadeRecords made = gcode::made_records(text, how, profile);
    EXPECT_EQ(made.faults, gcode::Faults{});
    EXPECT_EQ(made.failure, "");
    const program::RecordRules rules{profile};
    std::vector<plan::ProgramStep> steps;
    for (const MotionRecord& record : made.records) {
        plan::ProgramStep step;
        EXPECT_TRUE(rules.judge(record, at, step).is_none()) << "line " << record.line;
        at = step.target_pulses;
        steps.push_back(step);
    }
    return steps;
}

std::vector<LinedStep> run_from_line(const std::string& text, std::uint64_t line) {
    ProgramRig sut;
    sut.give(steps_from_line(text, line, sut.profile, sut.positions()));
    EXPECT_EQ(sut.start(), Refusal::none);
    cycle::PinCounter pins{{}};
    std::vector<LinedStep> all;
    EXPECT_TRUE(sut.run_while([&] {
        for (const cycle::PortWrite& write : sut.port->writes) {
            const std::uint32_t axes = pins.take(write.levels);
            if (axes != 0) all.push_back({axes, sut.program().line});
        }
        sut.port->writes.clear();
        if (sut.cycle->state() == MachineState::held) sut.ask(cycle::RequestKind::resume);
        return sut.cycle->state() != MachineState::ready && sut.cycle->state() != MachineState::alarm;
    }));
    EXPECT_EQ(sut.cycle->state(), MachineState::ready) << "from line " << line;
    return all;
}

std::vector<std::uint32_t> behind_line(const std::vector<LinedStep>& all, std::uint64_t line) {
    std::vector<std::uint32_t> order;
    for (const LinedStep& step : all) {
        if (step.line > line) order.push_back(step.axes);
    }
    return order;
}

/// `rests`: the lines at whose ends the machine rests; none: at those of all.
void expect_tails(const std::string& text, const std::vector<std::uint64_t>& rests) {
    const std::vector<LinedStep> whole = run_from_line(text, 0);
    const auto lines = static_cast<std::uint64_t>(std::ranges::count(text, '\n'));
    std::vector<std::uint64_t> lines_without_tail;
    for (std::uint64_t line = 1; line < lines; ++line) {
        const auto rest = std::ranges::lower_bound(rests, line);
        const std::uint64_t from = rest == rests.end() ? line : *rest;
        const auto wanted = behind_line(whole, from);
        if (wanted.empty()) lines_without_tail.push_back(line);
        const auto made = behind_line(run_from_line(text, line), from);
        const auto [left, made_left] = std::ranges::mismatch(wanted, made);
        EXPECT_TRUE(left == wanted.end() && made_left == made.end())
            << "from line " << line << ": " << made.size() << " instead of " << wanted.size()
            << " steps, other ones from the one with number " << left - wanted.begin() << " on";
    }
    EXPECT_EQ(lines_without_tail, std::vector<std::uint64_t>{lines - 1}) << "behind the last move is none";
}

TEST(ProgramFromLine, HasTheSamePulsesFromThatLinesEndOnUnderG61) {
    expect_tails(
        "G21 G90 F900 G61\nG0 X18 Z18.5 Y1 C0\nM3\nG1 X17.5 C20\nY1.5\nX17 Z18 Y2 C25\nG4 P.01\nG91\n"
        "X.25 C-40\nG90\nG1 Z17.5\nM0\nG17 G3 X17.5 Y2.25 I0 J.25\nG55 G1 X17.5\nG54\nG93 G1 Y2 F60\nM5\n"
        "G94\nG0 X18 Z18 C0\nM2\n",
        {});
}

// How a curve goes through a line's end hangs on the lines before it, too, unless it rests there.
TEST(ProgramFromLine, HasTheSamePulsesFromTheNextRestOnUnderG64) {
    expect_tails(
        "G21 G90 F900 G64 P.05\nG0 X18 Z18.5 Y1 C0\nM3\nG1 X17.5 C20\nY1.5\nX17 Z18 Y2 C25\nM0\n"
        "X17.25 Y2.1\nX17.5 Y2.3\nX17.6 Y2.6\nG4 P.02\nX17.5 C30\nX17.2 Y2.4\nM5\nG0 X18 Z18 C0\nM2\n",
        {3, 7, 11, 14, 15});
}

}  // namespace
}  // namespace psicarve::motion
