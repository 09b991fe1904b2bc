// SPDX-License-Identifier: GPL-3.0-or-later
// `psicarve gcode run` on a core: two real processes, and the ring between them.
#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "shared/segment/segment_program.hpp"
#include "tests/places.hpp"
#include "tests/thoroughness.hpp"
#include "tests/two_process/cli_machine_rig.hpp"
#include "tests/two_process/long_programs.hpp"

namespace psicarve::test {
namespace {

/// A core on the virtual clock, homed, and programs for it.
class RunProgram : public Machine {
protected:
    /// Of it the core soon has run what it was given, once nobody gives it more.
    static constexpr const char* kSmallRing = "256";
    void start_homed(const std::vector<std::string>& more = {}) {
        start_core(more);
        ASSERT_EQ(run({"home"}).exit_code, 0);
    }
    std::string program(const std::string& text) const {
        write("program.ngc", text);
        return file("program.ngc");
    }
    std::unique_ptr<RunningProgram> begin(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {"gcode", "run"});
        arguments.insert(arguments.end(), {"--segment", segment_});
        return std::make_unique<RunningProgram>("psicarve", arguments);
    }
    CoreStatus status() const {
        std::optional<CoreStatus> read;
        eventually([&] {
            const auto segment = Segment::attach(segment_);
            if (segment) read = read_record(segment->header().status);
            return read.has_value();
        });
        return read.value_or(CoreStatus{});
    }
    ProgramStatus program_status() const {
        const auto segment = Segment::attach(segment_);
        return segment ? program_report(*segment).status : ProgramStatus{};
    }
    bool comes_to_hold(ProgramHold hold) const {
        return eventually([&] { return state() == MachineState::held && program_status().hold == hold; });
    }
    std::int64_t pulses(Axis axis) const { return status().position_pulses[index_of(axis)]; }
    /// What is written into it is run as it comes.
    std::ofstream begin_stream(const std::string& name) const {
        const std::string pipe = file(name);
        EXPECT_EQ(mkfifo(pipe.c_str(), 0600), 0);
        const std::string command = "exec " + in_build("bin/psicarve") + " gcode run - --segment " +
                                    segment_ + " < " + pipe + " > /dev/null 2> " + file("said");
        EXPECT_EQ(std::system(("( " + command + " ) & echo $! > " + file("pid")).c_str()), 0);
        return std::ofstream{pipe};
    }
    /// With a reader that is stopped now and then, or without: the whole trace.
    std::string trace_of(const std::string& text, bool pauses) {
        const std::string trace = file(pauses ? "paused.trace" : "plain.trace");
        start_homed({"--trace", trace});
        const auto running = begin({program(text)});
        for (int n = 0; pauses && n < 20 && !running->has_ended(); ++n) {
            running->send(SIGSTOP);
            std::this_thread::sleep_for(std::chrono::milliseconds{20});
            running->send(SIGCONT);
            std::this_thread::sleep_for(std::chrono::milliseconds{2});
        }
        EXPECT_EQ(running->wait(), 0) << running->error();
        EXPECT_EQ(program_status().starvations, 0U);
        core_->send(SIGTERM);
        core_->wait();
        return text_of(trace);
    }
};

TEST_F(RunProgram, BringsEveryAxisToThePulseWhereItEnds) {
    start_homed();
    const Outcome done =
        run({"gcode", "run",
             program("G21 G90 G94 G61 F300\nG0 X40 Z41 Y5 C0\nG1 X39.5 C90\nG1 Z38.25 Y6 C400\n"
                     "G17 G3 X40.5 Y7 I1 J0\nM2\n")});
    ASSERT_EQ(done.exit_code, 0) << done.error;
    EXPECT_NE(done.out.find("done, up to line 6"), std::string::npos) << done.out;
    EXPECT_EQ(state(), MachineState::ready);
    EXPECT_EQ(pulses(Axis::r1), 16'200);
    EXPECT_EQ(pulses(Axis::r2), 15'300);
    EXPECT_EQ(pulses(Axis::y), 2'800);
    EXPECT_EQ(pulses(Axis::psi), std::llround(400.0 / 360.0 * 6400.0));
    EXPECT_EQ(status().sim_stalls[index_of(Axis::r1)], 0U);
    EXPECT_EQ(status().signals & bit_of(Signal::spindle), 0U);
}

TEST_F(RunProgram, ChecksAFileToItsEndBeforeAnythingMoves) {
    start_homed();
    const std::int64_t before = pulses(Axis::r1);
    const Outcome refused = run({"gcode", "run", program("G21 G90 F300\nG0 X40\nG1 X30\nG1 X99\nM2\n")});
    EXPECT_EQ(refused.exit_code, 3);
    EXPECT_NE(refused.error.find("program.ngc:4:4: outside_travel"), std::string::npos) << refused.error;
    EXPECT_EQ(pulses(Axis::r1), before);
    EXPECT_EQ(program_status().program, 0U);
}

TEST_F(RunProgram, WantsAHomedMachineAndItsProfile) {
    start_core();
    const std::string path = program("G21 G90 F300\nG0 X40\nM2\n");
    const Outcome unhomed = run({"gcode", "run", path});
    EXPECT_EQ(unhomed.exit_code, 4);
    EXPECT_NE(unhomed.error.find("home first"), std::string::npos) << unhomed.error;
    ASSERT_EQ(run({"home"}).exit_code, 0);
    Profile other;
    other.r1.pulses_per_mm *= 2.0;
    write("other.toml", profile_to_toml(other));
    const Outcome foreign = run({"gcode", "run", path, "--profile", file("other.toml")});
    EXPECT_EQ(foreign.exit_code, 4);
    EXPECT_NE(foreign.error.find("another profile"), std::string::npos) << foreign.error;
    EXPECT_EQ(run({"gcode", "run", path}).exit_code, 0);
}

TEST_F(RunProgram, HoldsAtItsStopsUntilTheOperatorResumes) {
    start_homed();
    const auto running =
        begin({program("G21 G90 F300\nM3\nG0 X40\nM0\nG0 X41\nM1\nG0 X42\nT1 M6\nG0 X43\nM2\n"),
               "--optional-stop"});
    ASSERT_TRUE(comes_to_hold(ProgramHold::program));
    EXPECT_EQ(pulses(Axis::r1), 16'000);
    EXPECT_EQ(program_status().line, 4U);
    EXPECT_NE(status().signals & bit_of(Signal::spindle), 0U);
    ASSERT_EQ(run({"resume"}).exit_code, 0);
    ASSERT_TRUE(comes_to_hold(ProgramHold::optional));
    EXPECT_EQ(pulses(Axis::r1), 16'400);
    ASSERT_EQ(run({"resume"}).exit_code, 0);
    ASSERT_TRUE(comes_to_hold(ProgramHold::tool_change));
    EXPECT_EQ(pulses(Axis::r1), 16'800);
    ASSERT_EQ(run({"resume"}).exit_code, 0);
    EXPECT_EQ(running->wait(), 0) << running->error();
    EXPECT_EQ(pulses(Axis::r1), 17'200);
    EXPECT_NE(running->error().find("line 8: held, tool change"), std::string::npos) << running->error();
}

TEST_F(RunProgram, HoldsAfterEachBlockWhereOneAtATimeIsAskedFor) {
    start_homed();
    const auto running = begin({program("G21 G90 F300\nG0 X40\nG1 X41\nM2\n"), "--single"});
    for (const std::int64_t at : {16'000, 16'400}) {
        ASSERT_TRUE(comes_to_hold(ProgramHold::single));
        EXPECT_EQ(pulses(Axis::r1), at);
        ASSERT_EQ(run({"resume"}).exit_code, 0);
    }
    EXPECT_EQ(running->wait(), 0) << running->error();
}

TEST_F(RunProgram, BeginsWithALineAsIfTheOthersHadRun) {
    start_homed();
    const std::int64_t r1_before = pulses(Axis::r1);
    const std::int64_t r2_before = pulses(Axis::r2);
    const std::string path = program("G21 G91 F300\nG0 X-20 Z-20\nG1 X-1 C90\nG1 X-1\nG90\nG1 C180\nM2\n");
    const Outcome done = run({"gcode", "run", path, "--from-line", "4", "--unattended"});
    ASSERT_EQ(done.exit_code, 0) << done.error;
    EXPECT_EQ(pulses(Axis::r1), r1_before - 22 * 400);
    EXPECT_EQ(pulses(Axis::r2), r2_before - 20 * 400);
    EXPECT_EQ(pulses(Axis::psi), 3'200);
}

TEST_F(RunProgram, StopsWithItsOperatorAndCanBeRunAgain) {
    start_homed();
    const auto running = begin({program(zigzag_program(200'000))});
    ASSERT_TRUE(eventually([&] { return state() == MachineState::carving && program_status().line > 3; }));
    running->send(SIGINT);
    EXPECT_EQ(running->wait(), 4) << running->error();
    EXPECT_EQ(state(), MachineState::ready);
    EXPECT_EQ(run({"gcode", "run", program("G21 G90 F300\nG0 X45\nM2\n")}).exit_code, 0);
    EXPECT_EQ(pulses(Axis::r1), 18'000);
}

TEST_F(RunProgram, IsFedThroughARingOfTheSizeThatTheCoreWasAskedFor) {
    start_homed({"--program-ring", "64"});
    const auto segment = Segment::attach(segment_);
    ASSERT_TRUE(segment);
    EXPECT_EQ(segment->header().capacity_records, 64U);
    const Outcome done = run({"gcode", "run", program(zigzag_program(1000))});
    EXPECT_EQ(done.exit_code, 0) << done.error;
    EXPECT_EQ(program_status().line, 1003U);
}

TEST_F(RunProgram, RefusesASecondWriterAndNamesTheFirst) {
    start_homed();
    const auto running = begin({program(zigzag_program(200'000))});
    ASSERT_TRUE(eventually([&] { return state() == MachineState::carving; }));
    const Outcome second = run({"gcode", "run", program("G21 G90\nG0 X45\nM2\n")});
    EXPECT_EQ(second.exit_code, 4);
    const std::string first = std::to_string(running->pid());
    EXPECT_NE(second.error.find("process " + first + " is writing a program"), std::string::npos)
        << second.error;
    running->send(SIGKILL);
    running->wait();
    const Outcome third = run({"gcode", "run", program("G21 G90\nG0 X45\nM2\n")});
    EXPECT_EQ(third.exit_code, 4);
    EXPECT_NE(third.error.find("program: not while "), std::string::npos) << third.error;
    EXPECT_EQ(run({"stop"}).exit_code, 0);
}

// What the core has is run; then it stands on the path, spindle on, until somebody decides.
TEST_F(RunProgram, HoldsWhereItsReaderWasKilled) {
    start_homed({"--program-ring", kSmallRing});
    const auto running = begin({program(zigzag_program(400'000))});
    ASSERT_TRUE(eventually([&] { return state() == MachineState::carving && program_status().line > 3; }));
    running->send(SIGKILL);
    running->wait();
    ASSERT_TRUE(comes_to_hold(ProgramHold::feeder_lost));
    EXPECT_NE(run({"resume"}).exit_code, 0);
    ASSERT_EQ(run({"stop"}).exit_code, 0);
    EXPECT_EQ(state(), MachineState::ready);
    EXPECT_EQ(run({"gcode", "run", program("G21 G90 F300\nG0 X45\nM2\n")}).exit_code, 0);
}

TEST_F(RunProgram, TellsInWhichLineItsCoreDied) {
    start_homed();
    const auto running = begin({program("G21 G90 F300\nM3\nG0 X40\nM0\nG0 X41\nM2\n")});
    ASSERT_TRUE(comes_to_hold(ProgramHold::program));
    core_->send(SIGKILL);
    core_->wait();
    const Outcome status = run({"status"});
    EXPECT_EQ(status.exit_code, 5);
    EXPECT_NE(status.error.find("the last one left it held in line 4 of its program"), std::string::npos)
        << status.error;
    EXPECT_EQ(running->wait(), 5) << running->error();
}

// As where its reader is killed, but that line and reason are told.
TEST_F(RunProgram, HoldsWhereTheCoreRefusesARecord) {
    const std::vector<std::string> kept{"--state", file("state")};
    start_homed(kept);
    auto segment = Segment::attach(segment_);
    ASSERT_TRUE(segment);
    auto writer = ProgramWriter::claim(*segment);
    ASSERT_TRUE(writer && writer->begin(milliseconds{60'000}));
    MotionRecord spindle{};
    spindle.kind = MotionKind::spindle;
    spindle.line = 2;
    spindle.code = 1;
    MotionRecord dwell{};
    dwell.kind = MotionKind::dwell;
    dwell.line = 3;
    dwell.seconds = -1.0;
    ASSERT_EQ(writer->put(spindle), ProgramPut::done);
    ASSERT_EQ(writer->put(dwell), ProgramPut::done);
    Command command{};
    command.kind = CommandKind::program;
    command.value2 = writer->program();
    for (std::size_t k = 0; k < kAxisCount; ++k)
        command.target[k] = static_cast<double>(status().position_pulses[k]);
    ASSERT_TRUE(send_command(*segment, command, milliseconds{60'000}));
    ASSERT_TRUE(comes_to_hold(ProgramHold::refused));
    EXPECT_NE(status().signals & bit_of(Signal::spindle), 0U);
    const std::string said = "held, program refused (line 3: a way or dwell takes no time below zero";
    EXPECT_NE(run({"status"}).out.find(said), std::string::npos) << run({"status"}).out;
    EXPECT_NE(run({"resume"}).exit_code, 0);
    EXPECT_EQ(program_status().hold, ProgramHold::refused);
    ASSERT_EQ(run({"stop"}).exit_code, 0);
    EXPECT_EQ(state(), MachineState::ready);
    EXPECT_EQ(status().signals & bit_of(Signal::spindle), 0U);
    const auto log = [&] { return run({"log", "--state", file("state"), "--kind", "job"}).out; };
    EXPECT_TRUE(eventually([&] {
        return log().find("program ended: refused at line 2; line 3: a way or dwell") != std::string::npos;
    })) << log();
}

// How quickly the reader writes, and whether it is stopped in between, does not show in the pulses.
TEST_F(RunProgram, GivesTheSamePulsesHoweverItsReaderPauses) {
    const int lines = kIsSanitized ? 9'000 : 30'000;
    for (const std::string& text : {zigzag_program(lines), wavy_program(lines)}) {
        const std::string plain = trace_of(text, false);
        EXPECT_GT(plain.size(), 10'000U);
        EXPECT_TRUE(plain == trace_of(text, true));
    }
}

TEST_F(RunProgram, SaysThatItEndsBeforeTheLineToBeginWith) {
    start_homed();
    const Outcome refused =
        run({"gcode", "run", program("G21 G90 F300\nG0 X40\nM2\n\n\n"), "--from-line", "5", "--unattended"});
    EXPECT_EQ(refused.exit_code, 3);
    EXPECT_NE(refused.error.find("ends before line 5"), std::string::npos) << refused.error;
    EXPECT_EQ(state(), MachineState::ready);
}

TEST_F(RunProgram, ReadsNoFileThatItCouldReadOnlyOnce) {
    start_homed();
    const std::string pipe = file("pipe");
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const Outcome refused = run({"gcode", "run", pipe});
    EXPECT_EQ(refused.exit_code, 3);
    EXPECT_NE(refused.error.find("give it as standard input"), std::string::npos) << refused.error;
}

// What is changed under it is not run, what was read before is.
TEST_F(RunProgram, EndsWhereItsFileIsChanged) {
    start_homed({"--program-ring", kSmallRing});
    const std::string path = program(zigzag_program(400'000));
    const auto running = begin({path});
    ASSERT_TRUE(eventually([&] { return state() == MachineState::carving && program_status().line > 3; }));
    std::ofstream{path, std::ios::app} << "G0 X60\n";
    EXPECT_EQ(running->wait(), 3) << running->error();
    EXPECT_NE(running->error().find("has been changed"), std::string::npos) << running->error();
    EXPECT_EQ(state(), MachineState::ready);
}

// A command that was made for another place is refused, whatever made it.
TEST_F(RunProgram, IsNotBegunElsewhereThanItWasReadFor) {
    start_homed();
    auto segment = Segment::attach(segment_);
    ASSERT_TRUE(segment);
    auto writer = ProgramWriter::claim(*segment);
    ASSERT_TRUE(writer && writer->begin(std::chrono::milliseconds{60'000}));
    Command command{};
    command.kind = CommandKind::program;
    command.value2 = writer->program();
    for (std::size_t k = 0; k < kAxisCount; ++k)
        command.target[k] = static_cast<double>(status().position_pulses[k]);
    command.target[0] -= 1.0;
    const auto refused = send_command(*segment, command, std::chrono::milliseconds{60'000});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().said.id, MessageId::program_start_moved);
    EXPECT_EQ(state(), MachineState::ready);
    // The number stands; asked for again from where the machine is, it runs. Twice it does not.
    command.target[0] += 1.0;
    MotionRecord end{};
    end.kind = MotionKind::end;
    end.line = 1;
    ASSERT_EQ(writer->put(end), ProgramPut::done);
    ASSERT_TRUE(send_command(*segment, command, std::chrono::milliseconds{60'000}));
    const auto again = send_command(*segment, command, std::chrono::milliseconds{60'000});
    ASSERT_FALSE(again);
    EXPECT_EQ(again.error().said.id, MessageId::no_such_program);
    EXPECT_TRUE(eventually([&] { return program_status().is_done != 0; }));
}

// A stream that pauses in the midst of motion: virtual time waits for it, at speed.
TEST_F(RunProgram, GivesTheSamePulsesHoweverItsBlocksCome) {
    const std::string text = wavy_program(2200);
    std::vector<std::string> traces;
    for (const bool pauses : {false, true}) {
        const std::string trace = file(pauses ? "bursts.trace" : "stream.trace");
        start_homed({"--trace", trace});
        std::ofstream out = begin_stream(pauses ? "bursts" : "stream");
        // Enough to set out with, and then more slowly than the core runs it.
        for (std::size_t given = 0, end = 0; given < text.size(); given = end) {
            const std::size_t burst = !pauses ? text.size() : given == 0 ? 31'000 : 2'500;
            end = std::min(text.size(), given + burst);
            out << text.substr(given, end - given) << std::flush;
            if (pauses) std::this_thread::sleep_for(std::chrono::milliseconds{120});
        }
        ASSERT_TRUE(eventually([&] { return program_status().is_done != 0; }));
        EXPECT_EQ(program_status().starvations, 0U);
        core_->send(SIGTERM);
        core_->wait();
        traces.push_back(text_of(trace));
    }
    EXPECT_GT(traces[0].size(), 10'000U);
    EXPECT_TRUE(traces[0] == traces[1]);
}

/// A pipe that stays open: the program comes block by block.
TEST_F(RunProgram, RunsWhatStandardInputGivesAsItComes) {
    start_homed();
    std::ofstream out = begin_stream("pipe");
    out << "G21 G90 F300\nG0 X40\nG1 X41\nG4 P0.1\n" << std::flush;
    ASSERT_TRUE(eventually([&] { return pulses(Axis::r1) == 16'400; }));
    EXPECT_NE(state(), MachineState::ready);
    out << "G1 X42\nG1 X99\nG1 X43\n" << std::flush;
    ASSERT_TRUE(eventually([&] { return state() == MachineState::ready; }));
    EXPECT_EQ(pulses(Axis::r1), 16'800);
    EXPECT_TRUE(eventually([&] {
        return text_of(file("said")).find("standard input:6:4: outside_travel") != std::string::npos;
    })) << text_of(file("said"));
}

}  // namespace
}  // namespace psicarve::test
