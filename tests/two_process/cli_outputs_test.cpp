// SPDX-License-Identifier: GPL-3.0-or-later
// Coolant and digital outputs of a program: two real processes.
#include <memory>
#include <string>
#include <vector>

#include "shared/segment/segment_program.hpp"
#include "tests/two_process/cli_machine_rig.hpp"

namespace psicarve::test {
namespace {

constexpr SignalWord kMist = bit_of(Signal::mist);
constexpr SignalWord kFlood = bit_of(Signal::flood);
constexpr SignalWord kOutput3 = bit_of(Signal::output_3);

/// A machine with coolant and an output wired: all its enables are on pin 6, and the spindle has none.
class ProgramOutputs : public Machine {
protected:
    void write_machine(bool is_wired = true) const {
        Profile profile;
        for (const Axis axis : kAllAxes) profile.port.pins[index_of(enable_of(axis))] = 6;
        profile.port.pins[index_of(Signal::spindle)] = 0;
        if (is_wired) {
            profile.port.pins[index_of(Signal::mist)] = 1;
            profile.port.pins[index_of(Signal::flood)] = -7;
            profile.port.pins[index_of(Signal::output_3)] = 16;
        }
        write("machine.toml", profile_to_toml(profile));
    }
    void start_homed(bool is_wired = true) {
        write_machine(is_wired);
        start_core({"--profile", file("machine.toml")});
        ASSERT_EQ(run({"home"}).exit_code, 0);
    }
    std::unique_ptr<RunningProgram> begin(const std::string& text) const {
        write("program.ngc", text);
        return std::make_unique<RunningProgram>(
            "psicarve", std::vector<std::string>{"gcode", "run", file("program.ngc"), "--segment", segment_});
    }
    SignalWord on() const {
        const auto segment = Segment::attach(segment_);
        const auto status = segment ? read_record(segment->header().status) : std::nullopt;
        return status ? status->signals & kSwitchedMask : ~SignalWord{0};
    }
    bool is_held() const {
        return eventually([&] { return state() == MachineState::held; });
    }
};

TEST_F(ProgramOutputs, GoOnAndOffWhereTheProgramSaysSo) {
    start_homed();
    const auto running =
        begin("G21 G90 F600\nG0 X50 Y5\nM7\nG1 X48\nM8\nM64 P3\nM0\nM9\nG1 X47\nM0\nM8\nG1 X46\nM0\nM2\n");
    ASSERT_TRUE(is_held());
    EXPECT_EQ(on(), kMist | kFlood | kOutput3);
    const std::string said = run({"status"}).out;
    EXPECT_NE(said.find("on: mist flood output_3"), std::string::npos) << said;
    EXPECT_NE(run({"status", "--json"}).out.find("\"flood\""), std::string::npos);
    EXPECT_NE(run({"pins"}).out.find("  7  flood        out  high"), std::string::npos) << run({"pins"}).out;
    ASSERT_EQ(run({"resume"}).exit_code, 0);
    ASSERT_TRUE(is_held());
    EXPECT_EQ(on(), kOutput3);
    ASSERT_EQ(run({"resume"}).exit_code, 0);
    ASSERT_TRUE(eventually([&] { return on() == (kFlood | kOutput3) && is_held(); }));
    ASSERT_EQ(run({"resume"}).exit_code, 0);
    EXPECT_EQ(running->wait(), 0) << running->error();
    EXPECT_EQ(on(), 0U) << "M2";
}

TEST_F(ProgramOutputs, GoOffWhereTheProgramIsStoppedAndByAnEmergencyStop) {
    start_homed();
    for (const char* command : {"stop", "estop"}) {
        const auto running = begin("G21 G90\nM8\nG0 X50\nM62 P3\nM0\nM2\n");
        ASSERT_TRUE(is_held());
        ASSERT_EQ(on(), kFlood | kOutput3) << command;
        EXPECT_EQ(run({command}).exit_code, 0);
        EXPECT_NE(running->wait(), 0) << command;
        EXPECT_EQ(on(), 0U) << command;
    }
    EXPECT_EQ(state(), MachineState::alarm);
}

TEST_F(ProgramOutputs, AreNeverOnInADryRun) {
    start_homed();
    write("program.ngc", "G21 G90\nM8\nG0 X50 Y5\nM64 P3\nM0\nM2\n");
    RunningProgram running{"psicarve",
                           {"gcode", "run", file("program.ngc"), "--dry-run", "--segment", segment_}};
    ASSERT_TRUE(is_held());
    EXPECT_EQ(on(), 0U);
    EXPECT_EQ(run({"resume"}).exit_code, 0);
    EXPECT_EQ(running.wait(), 0) << running.error();
}

TEST_F(ProgramOutputs, AreOnWhereAProgramBeginsWithALaterLine) {
    start_homed();
    write("program.ngc", "G21 G90 F600\nM7\nG0 X50 Y5\nM8\nM9\nM64 P3\nM7\nG1 X48\nM0\nM2\n");
    RunningProgram running{
        "psicarve",
        {"gcode", "run", file("program.ngc"), "--from-line", "8", "--unattended", "--segment", segment_}};
    ASSERT_TRUE(is_held());
    EXPECT_EQ(on(), kMist | kOutput3);
    EXPECT_EQ(run({"resume"}).exit_code, 0);
    EXPECT_EQ(running.wait(), 0) << running.error();
    EXPECT_NE(running.error().find("outputs go on: mist output_3"), std::string::npos) << running.error();
}

// The checks of the program's reader are not the core's.
TEST_F(ProgramOutputs, WithoutAPinAreRefusedByTheCoreWithTheirLine) {
    start_homed(false);
    auto segment = Segment::attach(segment_);
    ASSERT_TRUE(segment);
    auto writer = ProgramWriter::claim(*segment);
    ASSERT_TRUE(writer && writer->begin(milliseconds{60'000}));
    MotionRecord output{};
    output.kind = MotionKind::output;
    output.line = 3;
    output.code = 1;
    output.outputs = switched_bit(Signal::flood);
    ASSERT_EQ(writer->put(output), ProgramPut::done);
    Command command{};
    command.kind = CommandKind::program;
    command.value2 = writer->program();
    const auto status = read_record(segment->header().status);
    ASSERT_TRUE(status);
    for (std::size_t k = 0; k < kAxisCount; ++k)
        command.target[k] = static_cast<double>(status->position_pulses[k]);
    ASSERT_TRUE(send_command(*segment, command, milliseconds{60'000}));
    ASSERT_TRUE(is_held());
    EXPECT_EQ(on(), 0U);
    const std::string said = run({"status"}).out;
    EXPECT_NE(said.find("line 3: flood is not wired to any pin"), std::string::npos) << said;
    EXPECT_EQ(run({"stop"}).exit_code, 0);
}

TEST_F(ProgramOutputs, AreTracedAndLeaveTheProgramsPinsRight) {
    write_machine();
    write("program.ngc",
          "G21 G90 F900 G64 P0.05\nG0 X50 Y5 C0\nM8\nG1 X48 C20\nG1 X48.5 C40\nM64 P3\nG1 Y6 C60\nM9\n"
          "G1 X49 C90\nM65 P3\nG1 X50\nM2\n");
    for (const char* name : {"pins.vcd", "pins.trace"}) {
        const Outcome done = run({"gcode", "run", file("program.ngc"), "--simulate", "--profile",
                                  file("machine.toml"), "--trace", file(name), "--json"});
        ASSERT_EQ(done.exit_code, 0) << done.error;
        EXPECT_NE(done.out.find("\"verified\":true"), std::string::npos) << done.out;
        EXPECT_EQ(psicarve({"verify", file(name), "--program", file("program.ngc"), "--profile",
                            file("machine.toml")})
                      .exit_code,
                  0);
    }
    const std::string dump = text_of(file("pins.vcd"));
    for (const Signal signal : {Signal::flood, Signal::output_3}) {
        const std::string code{static_cast<char>('!' + index_of(signal))};
        EXPECT_NE(dump.find("\n1" + code + "\n"), std::string::npos) << name_of(signal);
        EXPECT_LT(dump.find("\n1" + code + "\n"), dump.rfind("\n0" + code + "\n")) << name_of(signal);
    }
    const std::string mist{static_cast<char>('!' + index_of(Signal::mist))};
    EXPECT_EQ(dump.find("\n1" + mist + "\n"), std::string::npos);
}

}  // namespace
}  // namespace psicarve::test
