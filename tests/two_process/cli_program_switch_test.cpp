// SPDX-License-Identifier: GPL-3.0-or-later
// What is told of a program beside its line, and M1 that is switched while it runs.
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "tests/two_process/program_proof_rig.hpp"

namespace psicarve::test {
namespace {

class SwitchedProgram : public ProgramProof {
protected:
    std::unique_ptr<RunningProgram> begin_file(const std::string& path, const std::string& text,
                                               const std::vector<std::string>& more = {}) const {
        write(path, text);
        std::vector<std::string> arguments{"gcode", "run", file(path), "--segment", segment_};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return std::make_unique<RunningProgram>("psicarve", arguments);
    }
    testing::AssertionResult holds(std::uint64_t line, ProgramHold why) {
        const bool does = eventually([&] {
            return status().state == MachineState::held && program_status().line == line &&
                   program_status().hold == why;
        });
        if (does) return testing::AssertionSuccess();
        return testing::AssertionFailure()
               << "line " << program_status().line << ", hold " << name_of(program_status().hold);
    }
    nlohmann::json told() const { return run({"status", "--json"}).json()["program"]; }
};

constexpr const char* kStops = "G21 G90 F300\nG0 X40\nM0\nG1 X41\nM1\nG1 X42\nM1\nG1 X43\nM1\nM2\n";

TEST_F(SwitchedProgram, IsToldByItsNameWithItsSwitchesAndStarvations) {
    start_homed();
    const auto running = begin_file("pocket.ngc", kStops, {"--single", "--block-delete"});
    ASSERT_TRUE(holds(2, ProgramHold::single));
    const std::string number = std::to_string(program_status().program);
    const std::string text = run({"status"}).out;
    EXPECT_NE(text.find("program    pocket.ngc (no. " + number + "), line 2: held, single block"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("\nswitches   single block, block delete\n"), std::string::npos) << text;
    EXPECT_NE(text.find(" records; it had to wait for more 0 times\n"), std::string::npos) << text;
    const auto json = told();
    EXPECT_EQ(json["name"], "pocket.ngc");
    EXPECT_EQ(json["source"], "file");
    EXPECT_EQ(json["single"], true);
    EXPECT_EQ(json["optional_stop"], false);
    EXPECT_EQ(json["block_delete"], true);
    EXPECT_EQ(json["dry_run"], false);
    EXPECT_EQ(json["from_line"], 1);
    ASSERT_EQ(run({"single", "off"}).exit_code, 0);
    EXPECT_NE(run({"status"}).out.find("\nswitches   block delete\n"), std::string::npos);
    ASSERT_EQ(run({"stop"}).exit_code, 0);
    EXPECT_EQ(running->wait(), 4);
    const auto last = run({"status", "--json"}).json()["last_program"];
    EXPECT_EQ(last["name"], "pocket.ngc");
    EXPECT_NE(run({"status"}).out.find("program    the last one (pocket.ngc) ended in line 2 "),
              std::string::npos)
        << run({"status"}).out;
}

TEST_F(SwitchedProgram, OfALongPathKeepsTheNameOfItsFile) {
    start_homed();
    // Together longer than the segment has room for.
    const std::string folder = std::string(120, 'd');
    const std::string name = std::string(180, 'n') + ".ngc";
    ASSERT_EQ(std::system(("mkdir '" + file(folder) + "'").c_str()), 0);
    const auto running = begin_file(folder + "/" + name, "G21 G90 F300\nG0 X40\nM0\nM2\n");
    ASSERT_TRUE(holds(3, ProgramHold::program));
    EXPECT_EQ(told()["name"], name);
    ASSERT_EQ(run({"resume"}).exit_code, 0);
    EXPECT_EQ(running->wait(), 0) << running->error();
}

TEST_F(SwitchedProgram, IsToldAsAStreamOrAsATypedBlock) {
    start_homed();
    const auto typed = begin_file("block.ngc", "G0 X41\nM0\nM2\n", {"--mdi", "--dry-run"});
    ASSERT_TRUE(holds(2, ProgramHold::program));
    EXPECT_EQ(told()["source"], "typed");
    EXPECT_TRUE(told()["name"].is_null());
    EXPECT_EQ(told()["dry_run"], true);
    EXPECT_NE(run({"status"}).out.find("program    a typed block (no. "), std::string::npos);
    ASSERT_EQ(run({"resume"}).exit_code, 0);
    EXPECT_EQ(typed->wait(), 0) << typed->error();
    const std::string command =
        in_build("bin/psicarve") + " gcode run - --segment " + segment_ + " >/dev/null 2>&1";
    std::FILE* const stream = popen(command.c_str(), "w");
    ASSERT_NE(stream, nullptr);
    std::fputs("G0 X40\nM0\n", stream);
    std::fflush(stream);
    ASSERT_TRUE(holds(2, ProgramHold::program));
    EXPECT_EQ(told()["source"], "stream");
    EXPECT_NE(run({"status"}).out.find("program    standard input (no. "), std::string::npos);
    ASSERT_EQ(run({"resume"}).exit_code, 0);
    EXPECT_EQ(WEXITSTATUS(pclose(stream)), 0);
}

TEST_F(SwitchedProgram, HoldsAtTheNextM1OnceThatIsSwitchedOnAndNoMoreOnceItIsOff) {
    start_homed();
    EXPECT_NE(run({"optional-stop", "on"}).error.find("no program runs"), std::string::npos);
    const auto running = begin_file("stops.ngc", kStops);
    ASSERT_TRUE(holds(3, ProgramHold::program));
    EXPECT_EQ(told()["optional_stop"], false);
    ASSERT_EQ(run({"optional-stop", "on"}).exit_code, 0);
    EXPECT_EQ(told()["optional_stop"], true);
    EXPECT_EQ(program_status().stops_at_optional, 1U);
    ASSERT_EQ(run({"resume"}).exit_code, 0);
    ASSERT_TRUE(holds(4, ProgramHold::optional));
    EXPECT_EQ(status().position_pulses[index_of(Axis::r1)], 16'400);
    EXPECT_EQ(told()["hold"], "optional stop");
    ASSERT_EQ(run({"optional-stop", "off"}).exit_code, 0);
    ASSERT_EQ(run({"resume"}).exit_code, 0);
    EXPECT_EQ(running->wait(), 0) << running->error();
    EXPECT_EQ(status().position_pulses[index_of(Axis::r1)], 17'200);
    EXPECT_NE(running->error().find("line 4: held, optional stop"), std::string::npos) << running->error();
}

TEST_F(SwitchedProgram, BegunWithOptionalStopPassesM1OnceThatIsSwitchedOff) {
    start_homed();
    const auto running = begin_file("stops.ngc", kStops, {"--optional-stop"});
    ASSERT_TRUE(holds(3, ProgramHold::program));
    EXPECT_EQ(told()["optional_stop"], true);
    ASSERT_EQ(run({"resume"}).exit_code, 0);
    ASSERT_TRUE(holds(5, ProgramHold::optional));
    EXPECT_EQ(status().position_pulses[index_of(Axis::r1)], 16'400);
    ASSERT_EQ(run({"optional-stop", "off"}).exit_code, 0);
    ASSERT_EQ(run({"resume"}).exit_code, 0);
    EXPECT_EQ(running->wait(), 0) << running->error();
    // The next begins as it is asked to.
    const auto next = begin_file("stops.ngc", kStops);
    ASSERT_TRUE(holds(3, ProgramHold::program));
    EXPECT_EQ(told()["optional_stop"], false);
    ASSERT_EQ(run({"resume"}).exit_code, 0);
    EXPECT_EQ(next->wait(), 0) << next->error();
}

// At M0 virtual time stands still: the switch falls on the same tick in each run.
TEST_F(SwitchedProgram, GivesTheSamePulsesEachTimeAndThoseOfARunWithoutM1) {
    const auto trace_of = [&](const std::string& text, bool is_switched) {
        start_homed({"--trace", file("switched.trace")});
        const auto running = begin_file("stops.ngc", text);
        EXPECT_TRUE(holds(3, ProgramHold::program));
        if (is_switched) {
            EXPECT_TRUE(command(CommandKind::optional_stop, 1.0));
        }
        EXPECT_TRUE(command(CommandKind::resume));
        for (const std::uint64_t line : {4U, 6U, 8U}) {
            if (!is_switched) break;
            EXPECT_TRUE(holds(line, ProgramHold::optional));
            EXPECT_TRUE(command(CommandKind::resume));
        }
        EXPECT_EQ(running->wait(), 0) << running->error();
        end_core();
        return std::pair{text_of(file("switched.trace")), order_of_trace(file("switched.trace"))};
    };
    std::string without = kStops;
    for (std::size_t at = without.find("M1\n"); at != std::string::npos; at = without.find("M1\n"))
        without.replace(at, 2, "G90");
    const auto plain = trace_of(without, false);
    EXPECT_GT(plain.second.size(), 1'000U);
    EXPECT_TRUE(trace_of(kStops, false).second == plain.second);
    const auto switched = trace_of(kStops, true);
    EXPECT_TRUE(switched.second == plain.second);
    EXPECT_TRUE(switched.first != plain.first);
    EXPECT_TRUE(trace_of(kStops, true).first == switched.first);
}

TEST_F(SwitchedProgram, IsReplayedWithEachTurnOfItsSwitch) {
    start_homed();
    const auto running = begin_file("stops.ngc", kStops);
    ASSERT_TRUE(holds(3, ProgramHold::program));
    ASSERT_EQ(run({"optional-stop", "on"}).exit_code, 0);
    ASSERT_EQ(run({"resume"}).exit_code, 0);
    ASSERT_TRUE(holds(4, ProgramHold::optional));
    ASSERT_EQ(run({"optional-stop", "off"}).exit_code, 0);
    ASSERT_EQ(run({"resume"}).exit_code, 0);
    ASSERT_EQ(running->wait(), 0) << running->error();
    ASSERT_EQ(run({"snapshot", "save", file("run.snap")}).exit_code, 0);
    const std::string info = psicarve({"snapshot", "info", file("run.snap"), "--records", "1000"}).out;
    EXPECT_NE(info.find("command optional-stop done on  r1"), std::string::npos) << info;
    EXPECT_NE(info.find("its text   " + file("stops.ngc") + ": "), std::string::npos) << info;
    const Outcome again = psicarve({"replay", file("run.snap"), "--program", file("stops.ngc"), "--json"});
    EXPECT_EQ(again.exit_code, 0) << again.error;
    EXPECT_EQ(again.json()["as_recorded"], true) << again.out;
    EXPECT_EQ(again.json()["most_ticks_apart"], 0) << again.out;
}

}  // namespace
}  // namespace psicarve::test
