// SPDX-License-Identifier: GPL-3.0-or-later
// Spindle, coolant and outputs of programs, judged by their wires.
#include "tests/hmi/verify/program_machine.hpp"

namespace psicarve::verify {
namespace {

Profile wired_profile() {
    Profile profile;
    profile.port.pins[index_of(Signal::flood)] = 1;
    profile.port.pins[index_of(Signal::output_0)] = 14;
    return profile;
}

constexpr const char* kText =
    "G21 G90 G94 G61 F300\nM3\nM8\nG1 X39\nM64 P0\nG1 X38\nM9\nG4 P.1\nM5\nG1 X39\nM2\n";

/// The rest at which each wire is switched, and how much later than that [s].
struct Moved {
    Signal wire = Signal::r1_limit;
    double by_s = 0.0;
};

/// Pins that are right for the text, but for one wire whose every edge is moved.
PlacedMachine switched(const Moved& moved) {
    PlacedMachine machine{wired_profile()};
    machine.pins().start.present |= kSwitchedMask;
    machine.spindle(true).pins().set(Signal::flood, true);
    machine.rest(1.0).to({39, 41, 0, 0}).rest(0.01).pins().set(Signal::output_0, true);
    machine.rest(0.01).to({38, 41, 0, 0}).rest(0.01).pins().set(Signal::flood, false);
    machine.rest(0.15).spindle(false).rest(0.01).to({39, 41, 0, 0}).rest(0.01);
    machine.pins().set(Signal::output_0, false);
    machine.rest(0.1);
    auto& events = machine.pins().events;
    const SignalWord bit = bit_of(moved.wire);
    const auto level_at = [&, old = events](std::int64_t time_ns) {
        SignalWord level = 0;
        for (const TraceEvent& event : old)
            if (event.time_ns <= time_ns) level = event.levels & bit;
        return level;
    };
    if (moved.by_s != 0.0)
        for (TraceEvent& event : events)
            event.levels = (event.levels & ~bit) | level_at(event.time_ns - std::llround(moved.by_s * 1e9));
    return machine;
}

ProgramVerifyReport judged_as(const Moved& moved) {
    PlacedMachine machine = switched(moved);
    return judged(kText, machine, wired_profile());
}

TEST(ProgramSwitches, AreRightAtTheRestsThatTheProgramAsksFor) {
    EXPECT_EQ(verdict(judged_as({})), "ok");
}

TEST(ProgramSwitches, AreWrongOnTheWayBeforeAndOnTheOneBehind) {
    for (const auto& [wire, by_s, expected] : {std::tuple{Signal::flood, -0.3, "output 6"},
                                               {Signal::flood, 0.3, "output 10"},
                                               {Signal::output_0, -0.3, "output 4"},
                                               {Signal::output_0, 0.3, "output 6"},
                                               {Signal::spindle, -0.3, "spindle 6"},
                                               {Signal::spindle, 0.3, "spindle 10"}}) {
        const auto report = judged_as({wire, by_s});
        EXPECT_EQ(verdict(report), expected) << name_of(wire) << by_s << program_report_text(report);
    }
    const auto report = judged_as({Signal::flood, 0.3});
    EXPECT_NE(report.rules[0].first->sentence.find("flood is on on"), std::string::npos);
    EXPECT_NE(report.rules[0].first->sentence.find("off by line 7"), std::string::npos)
        << report.rules[0].first->sentence;
}

TEST(ProgramSwitches, AreOffWhereTheProgramIsOver) {
    PlacedMachine machine = switched({});
    machine.pins().set(Signal::output_0, true);
    EXPECT_EQ(verdict(judged(kText, machine, wired_profile())).substr(0, 6), "output");
}

TEST(ProgramSwitches, ThatASpindleTurnsOnBehindTheProgramIsWrong) {
    PlacedMachine machine = switched({Signal::spindle, 0.3});
    EXPECT_EQ(verdict(judged(kText, machine, wired_profile())), "spindle 10");
    const std::string ends_on = "G21 G90 G94 G61 F300\nM3\nG1 X39\nM2\n";
    PlacedMachine on{wired_profile()};
    on.spindle(true).rest(1.0).to({39, 41, 0, 0}).rest(0.1);
    EXPECT_EQ(verdict(judged(ends_on, on, wired_profile())).substr(0, 7), "spindle");
    on.spindle(false).rest(0.1);
    EXPECT_EQ(verdict(judged(ends_on, on, wired_profile())), "ok");
    on.spindle(true).rest(0.1);
    EXPECT_EQ(verdict(judged(ends_on, on, wired_profile())), "ok") << "by hand, afterwards";
}

// Drives alone settle nothing when they go off: what the core forgot is on in the last levels.
TEST(ProgramSwitches, ThatStayOnWithoutDrivesAreWrong) {
    for (const bool is_on : {false, true}) {
        PlacedMachine machine{wired_profile()};
        PerfectMachine& pins = machine.pins();
        pins.start.present |= kSwitchedMask;
        if (is_on) pins.set(Signal::flood, true);
        machine.rest(0.1).to({39.5, 41, 0, 0});
        for (const Axis axis : kAllAxes) pins.set(enable_of(axis), false);
        machine.rest(0.1);
        const std::string text =
            std::string{"G21 G90 G94 G61 F300\n"} + (is_on ? "M8\n" : "") + "G1 X39\nM2\n";
        const auto report = judged(text, machine, wired_profile());
        EXPECT_EQ(report.rules[0].first->fault, "ends-early");
        EXPECT_EQ(report.rules[0].offences, is_on ? 2U : 1U) << program_report_text(report);
    }
}

TEST(ProgramSwitches, ThatATraceDoesNotHaveAreNotJudged) {
    PlacedMachine machine = switched({Signal::flood, 0.3});
    machine.pins().start.present &= ~bit_of(Signal::flood);
    EXPECT_EQ(verdict(judged(kText, machine, wired_profile())), "ok");
}

}  // namespace
}  // namespace psicarve::verify
