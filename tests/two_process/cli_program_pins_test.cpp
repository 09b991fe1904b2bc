// SPDX-License-Identifier: GPL-3.0-or-later
// What `psicarve gcode run` records of a program, and how `psicarve verify --program` judges it.
#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "shared/base/units.hpp"
#include "shared/job/job.hpp"
#include "shared/profile/profile.hpp"
#include "shared/record/snapshot_file.hpp"
#include "tests/places.hpp"
#include "tests/two_process/cli_machine_rig.hpp"
#include "tests/two_process/table_program.hpp"

namespace psicarve::test {
namespace {

/// Lines, arcs, corners under all modes, a rest, the spindle.
constexpr const char* kMixed =
    "G21 G90 G94 F1200\nM3\nG0 X50 Z50 Y10 C0\nG64 P0.05\nG1 X48 C20\nG1 X48.5 Z49 C25 Y10.5\nG1 Y12\n"
    "G17 G3 X46.5 Y14 I-2 J0\nG1 X46 C60\nG61\nG1 X45.5 Z48 C70\nG2 X45.5 Y14 I1 J0 C90\nG4 P0.2\n"
    "G64\nG1 X45 Y13\nG1 X45.01 Y13.01\nG1 X45.02\nG1 X44 C120\nM5\nG0 X50\nM2\n";

class ProgramPins : public Machine {
protected:
    std::string program(const std::string& name, const std::string& text) const {
        write(name, text);
        return file(name);
    }
    int verified(const std::string& trace, const std::string& program_path) const {
        return psicarve({"verify", trace, "--program", program_path}).exit_code;
    }
    /// Of a file as standard input, once `before` has read of it.
    int streamed(const std::string& name, const std::string& more, const std::string& before = {}) const {
        const std::string command = "( " + before + "exec " + in_build("bin/psicarve") +
                                    " gcode run - --segment " + segment_ + " " + more + " ) < " + file(name) +
                                    " > /dev/null 2> " + file("said");
        return WEXITSTATUS(std::system(command.c_str()));
    }
    /// Of a program that holds once, until `meanwhile` is done.
    Outcome held_run(std::vector<std::string> arguments, const std::vector<std::string>& meanwhile) const {
        arguments.insert(arguments.begin(), {"gcode", "run"});
        arguments.insert(arguments.end(), {"--json", "--segment", segment_});
        RunningProgram program{"psicarve", arguments};
        EXPECT_TRUE(eventually([&] { return state() == MachineState::held || program.has_ended(); }));
        if (!meanwhile.empty()) {
            EXPECT_EQ(run(meanwhile).exit_code, 0);
        }
        EXPECT_EQ(run({"resume"}).exit_code, 0);
        return program.outcome();
    }
    /// A text with one of its parts replaced.
    static std::string changed(std::string text, const std::string& from, const std::string& to) {
        const std::size_t at = text.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        return at == std::string::npos ? text : text.replace(at, from.size(), to);
    }
};

TEST_F(ProgramPins, AreSimulatedRecordedAndJudged) {
    const std::string path = program("mixed.ngc", kMixed);
    for (const char* name : {"pins.vcd", "pins.trace"}) {
        const Outcome done = run({"gcode", "run", path, "--simulate", "--trace", file(name), "--json"});
        ASSERT_EQ(done.exit_code, 0) << done.error;
        EXPECT_NE(done.out.find("\"verified\":true"), std::string::npos) << done.out;
        EXPECT_NE(done.out.find("\"starvations\":0"), std::string::npos) << done.out;
        EXPECT_NE(done.error.find("the machine is simulated"), std::string::npos) << done.error;
        EXPECT_EQ(verified(file(name), path), 0);
    }
    EXPECT_FALSE(core_pid());
    // Judged by another program they are wrong: another feed, place, order, corner, arc, rest.
    const std::vector<std::array<std::string, 2>> changes{{"F1200", "F30"},
                                                          {"X48 C20", "X47.8 C20"},
                                                          {"G1 Y12\n", "G1 X48.8\nG1 X48.5 Y12\n"},
                                                          {"G64 P0.05", "G64 P0.005"},
                                                          {"I-2 J0", "I0 J2"},
                                                          {"P0.2", "P0.4"},
                                                          {"Z48 C70", "Z48.0025 C70"},
                                                          {"M5\nG0 X50\n", "M5\n"},
                                                          {"G3 X46.5", "G2 X46.5"}};
    for (const auto& [from, to] : changes)
        EXPECT_EQ(verified(file("pins.trace"), program("other.ngc", changed(kMixed, from, to))), 6)
            << from << " -> " << to;
}

// A square with a round corner in the cross-section, a circle and a slanted line on the cylinder.
constexpr const char* kDrawn =
    "G21 G90 F900\nG0 X45 Z55 Y40 C0\nM3\nG12.1\nG1 X30\nG1 C25\nG3 X25 C30 I-5 J0\nG1 X-30\nC-30\nG61\n"
    "X30\nG64\nC0\nG0 X40\nG13.1\nG0 C0\nG7.1 C38\nG1 X38\nG2 I8 J0\nG1 C20 Y45\nG61\nG3 C0 Y40 R30\n"
    "G7.1 C0\nG64\nG0 X45\nM5\nM2\n";

TEST_F(ProgramPins, OfADrawingAreSimulatedRecordedAndJudged) {
    const std::string path = program("drawn.ngc", kDrawn);
    const Outcome done = run({"gcode", "run", path, "--simulate", "--trace", file("pins.trace"), "--json"});
    ASSERT_EQ(done.exit_code, 0) << done.error;
    EXPECT_EQ(done.json()["verification"]["verified"], true) << done.out;
    EXPECT_EQ(done.json()["starvations"], 0) << done.out;
    EXPECT_EQ(verified(file("pins.trace"), path), 0);
    // Another corner, side, radius, plane and tolerance are not what was carved.
    const std::vector<std::array<std::string, 2>> changes{
        {"G3 X25", "G2 X25"}, {"X-30", "X-29.9"}, {"G7.1 C38", "G7.1 C37.9"},
        {"G2 I8", "G3 I8"},   {"R30", "R25"},     {"F900", "F9000\nG64 P.001"}};
    for (const auto& [from, to] : changes)
        EXPECT_EQ(verified(file("pins.trace"), program("other.ngc", changed(kDrawn, from, to))), 6)
            << from << " -> " << to;
}

// A square whose ways a machine with tips elsewhere than counted draws as any other.
TEST_F(ProgramPins, OfADrawingCarveItWithTheTip) {
    Profile profile;
    profile.r1.tip_offset_mm = 4.5;
    profile.r1.tool_wear_mm = 0.5;
    profile.blank.radius_mm = 47.0;
    profile.blank.height_mm = 60.0;
    write("tip.toml", profile_to_toml(profile));
    const std::string path = program("square.ngc",
                                     "G21 G90 F1800\nG0 X50 Z60 Y40 C0\nG12.1\nG1 X30\nC30\nX-30\nC-30\nX30\n"
                                     "C0\nG0 X50\nG13.1\nM2\n");
    start_core({"--profile", file("tip.toml"), "--piece", file("piece.csv")});
    ASSERT_EQ(run({"home"}).exit_code, 0);
    const Outcome done = run({"gcode", "run", path, "--profile", file("tip.toml")});
    ASSERT_EQ(done.exit_code, 0) << done.error;
    core_->send(SIGTERM);
    ASSERT_EQ(core_->wait(), 0) << core_->error();
    core_.reset();
    std::ifstream csv(file("piece.csv"));
    std::string line;
    std::getline(csv, line);
    std::size_t cuts = 0;
    while (std::getline(csv, line)) {
        double direction_deg = 0.0, height_mm = 0.0, radius_mm = 0.0;
        ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf", &direction_deg, &height_mm, &radius_mm), 3)
            << line;
        // Elsewhere it is what homing has cut.
        if (std::abs(height_mm - 40.0) > 0.02) continue;
        const double angle_rad = rad_from_deg(direction_deg);
        const double out_mm =
            radius_mm * std::max(std::abs(std::cos(angle_rad)), std::abs(std::sin(angle_rad)));
        // The path's tolerance, 0.01 mm; a pulse of psi at a corner, 0.03 mm; one of r1, and half a cell.
        ASSERT_NEAR(out_mm, 30.0, 0.05) << line;
        ++cuts;
    }
    EXPECT_GT(cuts, 3000U);
}

// Lines, arcs of both heads, a whole circle, several turns, a helix that stays chords.
constexpr const char* kStepped =
    "G21 G90 G94 F600\nM3\nG0 X50 Z50 Y40 C0\nG1 X48 Y41\nG17 G3 X46.003 Y43.003 I-2 J0\nG2 J1 P2\n"
    "G19 G2 Y45.003 Z48 J2 K0\nG4 P0.05\nG1 Z47.5\nG1 Y44 Z47 C20\nG17 G3 X45 Y45 I-1 J0 Z47.5\nG64 P.05\n"
    "G1 X44.5\nG0 X50\nM5\nM2\n";

TEST_F(ProgramPins, StepByStepAreSimulatedRecordedAndJudged) {
    Profile profile;
    profile.gcode.is_stepwise = true;
    write("stepwise.toml", profile_to_toml(profile));
    const std::string path = program("stepped.ngc", kStepped);
    const Outcome done = run({"gcode", "run", path, "--simulate", "--trace", file("pins.trace"), "--json",
                              "--profile", file("stepwise.toml")});
    ASSERT_EQ(done.exit_code, 0) << done.error;
    EXPECT_EQ(done.json()["verification"]["verified"], true) << done.out;
    EXPECT_EQ(done.json()["starvations"], 0) << done.out;
    const auto judged = [&](const std::string& text) {
        return psicarve({"verify", file("pins.trace"), "--program", program("other.ngc", text), "--profile",
                         file("stepwise.toml")})
            .exit_code;
    };
    EXPECT_EQ(judged(kStepped), 0);
    const std::vector<std::array<std::string, 2>> changes{{"I-2 J0", "I0 J2"},
                                                          {"G2 J1 P2", "G2 J1 P1"},
                                                          {"G2 J1 P2", "G3 J1 P2"},
                                                          {"X48 Y41", "X48.01 Y41"},
                                                          {"F600", "F60"}};
    for (const auto& [from, to] : changes) EXPECT_EQ(judged(changed(kStepped, from, to)), 6) << from << to;
}

// At an end of a circle one axis waits for three steps of the other; here they are three of its own apart.
TEST_F(ProgramPins, StepByStepAskNoMoreOfAMotorThanItHasAtACirclesEnd) {
    write("stepwise.toml", "[gcode]\ninterpolation = \"stepwise\"\n");
    const std::string path = program("end.ngc",
                                     "G21 G90 F1200\nG0 X49.3281 Z52.3024 Y34.7349 C0\n"
                                     "G19 G2 Z53.7814 Y36.6004 K2.8974 J-0.778\nM2\n");
    const Outcome done = run({"gcode", "run", path, "--simulate", "--profile", file("stepwise.toml")});
    EXPECT_EQ(done.exit_code, 0) << done.out << done.error;
}

// On a lathe's letters, in its plane; with screws that have backlash; and from a line on.
TEST_F(ProgramPins, StepByStepAreThoseOfOtherMachinesToo) {
    const std::string stepwise = "[gcode]\ninterpolation = \"stepwise\"\n";
    write("turning.toml", stepwise + "letters = \"turning\"\n");
    write("worn.toml", "[axis.r1]\nbacklash_mm = 0.02\n[axis.y]\nbacklash_mm = 0.03\n" + stepwise);
    const std::string turned = program("turned.ngc",
                                       "G21 G18 G90 F600\nG0 X50 U50 Z40 C0\nG1 X48 Z41\nG2 X46 Z43 I-2 K0\n"
                                       "G3 X48 Z41 I0 K-2 P2\nG1 U49\nG1 U48.5 Z41.5\nM2\n");
    const std::string stepped = program("stepped.ngc", kStepped);
    const std::vector<std::vector<std::string>> runs{{turned, "turning.toml"}, {stepped, "worn.toml"}};
    for (const auto& of : runs) {
        const Outcome done = run({"gcode", "run", of[0], "--simulate", "--json", "--profile", file(of[1])});
        EXPECT_EQ(done.exit_code, 0) << done.error;
        EXPECT_EQ(done.json()["verification"]["verified"], true) << done.out;
    }
    const Outcome late = run({"gcode", "run", stepped, "--simulate", "--from-line", "7", "--trace",
                              file("late.trace"), "--profile", file("worn.toml")});
    ASSERT_EQ(late.exit_code, 0) << late.error;
    const std::string rest = program("rest.ngc",
                                     "G21 G90 F600\nG61\nG0 X60 Z60\nC0\nY43.003\nX46.003 Z50\nG64\n"
                                     "G19 G2 Y45.003 Z48 J2 K0\nG4 P0.05\nG1 Z47.5\nG1 Y44 Z47 C20\n"
                                     "G17 G3 X45 Y45 I-1 J0 Z47.5\nG64 P.05\nG1 X44.5\nG0 X50\nM2\n");
    const Outcome judged =
        psicarve({"verify", file("late.trace"), "--program", rest, "--profile", file("worn.toml")});
    EXPECT_EQ(judged.exit_code, 0) << judged.out;
}

// A stream is run as it comes, but a drawn way only once all of it is known to be right.
TEST_F(ProgramPins, OfAStreamHaveNothingOfADrawnWayThatIsRefused) {
    const std::string begin = "G21 G90 F900\nG0 X40 Z55 C0 Y40\nG61\nG12.1\n";
    const std::vector<std::array<std::string, 2>> blocks{{"G1 X45 C50\n", ":5:4: "},
                                                         {"G3 I-1 P100000\n", ":5:1: "}};
    for (const auto& [block, place] : blocks) {
        program("stream.ngc", begin + block + "G13.1\nM2\n");
        EXPECT_EQ(streamed("stream.ngc", "--simulate --trace " + file("new.trace")), 3);
        EXPECT_NE(text_of(file("said")).find(place), std::string::npos) << text_of(file("said"));
        EXPECT_EQ(verified(file("new.trace"), program("right.ngc", begin + "G13.1\nM2\n")), 0) << block;
    }
}

// Neither a cycle's begin, nor the way to the point in between, nor what a block switches before it moves.
TEST_F(ProgramPins, OfAStreamHaveNothingOfABlockThatIsRefused) {
    start_core();
    ASSERT_EQ(run({"home"}).exit_code, 0);
    const std::vector<std::array<std::string, 2>> blocks{{"G81 X40 Y30 Z-5 R45\n", "outside_travel"},
                                                         {"G83 X40 Y30 Z-5 R45 Q20\n", "outside_travel"},
                                                         {"G91 G81 X-9 Y0 Z-.5 R0 L6\n", "outside_travel"},
                                                         {"G28 X40 M98\n", "word_missing"},
                                                         {"M3 G0 X99\n", "outside_travel"},
                                                         {"G0 X40 M98\n", "word_missing"}};
    for (const auto& [block, code] : blocks) {
        program("stream.ngc", "G21 G90 F300\nG0 X50 Z50 Y20\n" + block + "M2\n");
        program("right.ngc", "G21 G90 F300\nG0 X50 Z50 Y20\nM2\n");
        EXPECT_EQ(streamed("stream.ngc", "--trace " + file("new.trace")), 3) << block;
        EXPECT_NE(text_of(file("said")).find(code), std::string::npos) << block;
        EXPECT_EQ(verified(file("new.trace"), file("right.ngc")), 0) << block;
    }
}

TEST_F(ProgramPins, AreRecordedFromARunningCore) {
    start_core();
    ASSERT_EQ(run({"home"}).exit_code, 0);
    ASSERT_EQ(run({"move", "r1=58"}).exit_code, 0);
    const std::string path = program("mixed.ngc", kMixed);
    const Outcome done = run({"gcode", "run", path, "--trace", file("pins.trace")});
    ASSERT_EQ(done.exit_code, 0) << done.error;
    EXPECT_NE(done.out.find("verified   yes"), std::string::npos) << done.out;
    EXPECT_EQ(verified(file("pins.trace"), path), 0);
    EXPECT_EQ(state(), MachineState::ready);
    const Outcome served = run({"gcode", "run", path, "--simulate"});
    EXPECT_EQ(served.exit_code, 2);
    EXPECT_NE(served.error.find("a core serves"), std::string::npos) << served.error;
}

TEST_F(ProgramPins, OfASimulatedMachineSaySoAndLeaveNothing) {
    const std::string path = program("mixed.ngc", kMixed);
    const Outcome json = run({"gcode", "run", path, "--simulate", "--json"});
    EXPECT_EQ(json.json()["simulated"], true) << json.out;
    EXPECT_FALSE(Segment::attach(segment_));
    const Outcome text = run({"gcode", "run", path, "--simulate"});
    EXPECT_NE(text.out.find("done on the simulated machine"), std::string::npos) << text.out;
    start_core();
    ASSERT_EQ(run({"home"}).exit_code, 0);
    EXPECT_EQ(run({"gcode", "run", path, "--json"}).json()["simulated"], false);
}

// What was run before the wrong block is recorded, and a file of old stays where nothing was run.
TEST_F(ProgramPins, AreKeptOfAStreamThatBreaksOff) {
    start_core();
    ASSERT_EQ(run({"home"}).exit_code, 0);
    write("old.trace", "of old");
    const std::string wrong = program("wrong.ngc", "G21 G90 F300\nG1 X&\nM2\n");
    EXPECT_EQ(run({"gcode", "run", wrong, "--trace", file("old.trace")}).exit_code, 3);
    EXPECT_EQ(text_of(file("old.trace")), "of old");
    program("stream.ngc", "G21 G90 F600\nG0 X55\nG4 P0.1\nG1 X&\nM2\n");
    EXPECT_EQ(streamed("stream.ngc", "--trace " + file("new.trace")), 3);
    EXPECT_EQ(verified(file("new.trace"), program("right.ngc", "G21 G90\nG0 X55\nM2\n")), 0);
}

TEST_F(ProgramPins, OfASimulatedMachineLeaveAnOldFileToAWrongProgram) {
    write("old.trace", "of old");
    const std::string wrong = program("wrong.ngc", "G21 G90 F300\nG1 X&\nM2\n");
    EXPECT_EQ(run({"gcode", "run", wrong, "--simulate", "--trace", file("old.trace")}).exit_code, 3);
    EXPECT_EQ(text_of(file("old.trace")), "of old");
}

TEST_F(ProgramPins, OfASimulatedMachineAreToldWhereTheirTraceHasNoRoom) {
    program("stream.ngc", "G21 G90\nG0 X55\nG4 P0.1\nM2\n");
    EXPECT_EQ(streamed("stream.ngc", "--simulate --trace /dev/full"), 3);
    EXPECT_NE(text_of(file("said")).find("not complete"), std::string::npos) << text_of(file("said"));
}

// Standard input is read from where it stands.
TEST_F(ProgramPins, OfAStreamAreThoseOfWhatIsLeftOfIt) {
    start_core();
    ASSERT_EQ(run({"home"}).exit_code, 0);
    program("rest.ngc", "G0 X&\nG21 G90\no1 repeat [2]\nG91 G0 X-1\no1 endrepeat\nM2\n");
    EXPECT_EQ(streamed("rest.ngc", "--trace " + file("rest.trace"), "read first; "), 0)
        << text_of(file("said"));
    EXPECT_EQ(verified(file("rest.trace"), program("right.ngc", "G91 G0 X-1\nG0 X-1\nM2\n")), 0);
}

TEST_F(ProgramPins, AreNotJudgedWhereAHoldLiftsTheHeads) {
    write("lift.toml", "[job]\non_hold = \"lift\"\n");
    const std::string path = program("held.ngc", "G21 G90\nG0 X50 Z50\nM0\nG0 X49\nM2\n");
    start_core({"--profile", file("lift.toml")});
    ASSERT_EQ(run({"home"}).exit_code, 0);
    const Outcome done = held_run({path, "--trace", file("pins.trace"), "--profile", file("lift.toml")}, {});
    EXPECT_EQ(done.exit_code, 0) << done.error;
    EXPECT_EQ(done.json()["unverified_reason"], "the heads were lifted while it was held") << done.out;
}

TEST_F(ProgramPins, OfASimulatedMachineAreNotJudgedByAFeedThatWasRaised) {
    const std::string path = program("held.ngc", "G21 G90 F300\nG0 X50 Z50\nM0\nG1 X45\nM2\n");
    const Outcome raised = held_run({path, "--simulate"}, {"override", "150"});
    EXPECT_EQ(raised.exit_code, 0) << raised.error;
    EXPECT_EQ(raised.json()["unverified_reason"], "the feed was raised to 150 % while it ran") << raised.out;
    const Outcome as_it_is = held_run({path, "--simulate"}, {});
    EXPECT_EQ(as_it_is.json()["verified"], true) << as_it_is.out;
}

// The highest that there was, and not the highest that there is.
TEST_F(ProgramPins, OfARunningCoreAreJudgedByTheFeedThatWasRaised) {
    start_core();
    ASSERT_EQ(run({"home"}).exit_code, 0);
    const std::string path = program("held.ngc", "G21 G90 F300\nG0 X50 Z50\nM0\nG1 X45\nM2\n");
    const Outcome done = held_run({path, "--trace", file("pins.trace")}, {"override", "150"});
    EXPECT_EQ(done.json()["verified"], true) << done.out;
    EXPECT_EQ(verified(file("pins.trace"), path), 6);
}

// Nobody who means the machine is shown a simulated one.
TEST_F(ProgramPins, AreNotSimulatedUnasked) {
    EXPECT_EQ(run({"gcode", "run", program("mixed.ngc", kMixed)}).exit_code, 5);
    EXPECT_FALSE(core_pid());
}

TEST_F(ProgramPins, AreAskedForOnlyWhereTheyCanBeWritten) {
    const std::string path = program("mixed.ngc", kMixed);
    const Outcome refused = run({"gcode", "run", path, "--trace", file("no folder/pins.vcd")});
    EXPECT_EQ(refused.exit_code, 3);
    EXPECT_EQ(refused.error_lines(), 1U) << refused.error;
}

// The spindle goes off though the machine rests before that and after it; with two timers a tick later.
TEST_F(ProgramPins, AreSwitchedOffByTheEndBehindAHold) {
    start_core({"--profile", example("original.toml")});
    ASSERT_EQ(run({"home"}).exit_code, 0);
    const std::string path = program("end.ngc", "G21 G90 F300\nM3\nG1 X41\nM0\nM2\n");
    const Outcome done = held_run({path, "--trace", file("end.trace")}, {});
    EXPECT_EQ(done.exit_code, 0) << done.error << done.out;
    EXPECT_NE(done.out.find("\"verified\":true"), std::string::npos) << done.out;
}

TEST_F(ProgramPins, AreJudgedByAProgramInsteadOfAJob) {
    const std::string path = program("mixed.ngc", kMixed);
    EXPECT_EQ(psicarve({"verify", path, path, "--program", path}).exit_code, 2);
    const std::string wrong = program("wrong.ngc", "G21 G90 F300\nG1 X999\nM2\n");
    EXPECT_EQ(psicarve({"verify", path, "--program", wrong}).exit_code, 3);
}

// A table, written out as a program: its pins carve the very job, judged as one.
TEST_F(ProgramPins, OfATableAreThoseOfItsJob) {
    const std::string job_path = job("3", "40");
    const auto snapshot = load_snapshot(job_path);
    ASSERT_TRUE(snapshot) << snapshot.error().message;
    const JobView table = JobView::check(snapshot->job_blob).value();
    const std::string path = program("table.ngc", program_of_table(table, Profile{}, "G61"));
    const Outcome done = run({"gcode", "run", path, "--simulate", "--trace", file("pins.trace")});
    ASSERT_EQ(done.exit_code, 0) << done.error << done.out;
    const Outcome judged = psicarve({"verify", job_path, file("pins.trace")});
    EXPECT_EQ(judged.exit_code, 0) << judged.out << judged.error;
    EXPECT_NE(judged.out.find("largest deviation 0 pulses at points"), std::string::npos) << judged.out;
}

}  // namespace
}  // namespace psicarve::test
