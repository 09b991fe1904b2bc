// SPDX-License-Identifier: GPL-3.0-or-later
// Work offsets that outlive a program and a core: `psicarve gcode offsets`, `check`, `run` and `verify`.
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "shared/segment/segment_program.hpp"
#include "tests/two_process/cli_machine_rig.hpp"

namespace psicarve::test {
namespace {

class KeptOffsetsOf : public Machine {
protected:
    KeptOffsetsOf() { setenv("PSICARVE_STATE", file("state").c_str(), 1); }
    ~KeptOffsetsOf() override { setenv("PSICARVE_STATE", "", 1); }

    void start_homed() {
        start_core();
        ASSERT_EQ(run({"home"}).exit_code, 0);
    }
    std::string program(const std::string& text, const std::string& name = "a.ngc") const {
        write(name, text);
        return file(name);
    }
    std::unique_ptr<RunningProgram> begin(const std::vector<std::string>& arguments) const {
        std::vector<std::string> all{"gcode", "run", "--segment", segment_};
        all.insert(all.end(), arguments.begin(), arguments.end());
        return std::make_unique<RunningProgram>("psicarve", all);
    }
    /// What these commands of a shell say is run as a program.
    int streamed(const std::string& commands) const {
        const std::string reader = in_build("bin/psicarve") + " gcode run - --segment " + segment_;
        const std::string whole = "( " + commands + " ) | " + reader + " > /dev/null 2> " + file("said");
        return WEXITSTATUS(std::system(whole.c_str()));
    }
    nlohmann::json shown() const {
        const Outcome outcome = run({"gcode", "offsets", "--json"});
        EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
        return outcome.json();
    }
    bool is_pending() const {
        const std::string path = file("state" + segment_ + ".simulated-offsets");
        return std::filesystem::exists(path) && text_of(path).find("pending") != std::string::npos;
    }
    bool has_file() const { return std::filesystem::exists(shown()["file"].get<std::string>()); }
    std::int64_t r1_pulses() const {
        std::int64_t pulses = 0;
        EXPECT_TRUE(eventually([&] {
            const auto segment = Segment::attach(segment_);
            const auto status = segment ? read_record(segment->header().status) : std::nullopt;
            if (status) pulses = status->position_pulses[0];
            return status.has_value();
        }));
        return pulses;
    }
    bool comes_to_line(std::uint64_t line) const {
        return eventually([&] {
            const auto segment = Segment::attach(segment_);
            return state() == MachineState::held && segment && program_report(*segment).status.line == line;
        });
    }
};

const std::string kStopped =
    "G21 G90 F300\nG0 X40\nG10 L2 P1 X[#5221+1]\nG92 Y0\nG0 X41\nM0\nG10 L2 P1 X[#5221+1]\nG0 X42\nM2\n";

TEST_F(KeptOffsetsOf, AProgramAreThoseOfTheNextAlsoOfAnotherCore) {
    start_homed();
    ASSERT_EQ(run({"gcode", "run", program("G21 G90\nG10 L2 P1 X5\nG10 L2 P9 C90 R3\nG0 X30\nG30.1\nM2\n")})
                  .exit_code,
              0);
    EXPECT_EQ(r1_pulses(), 35 * 400);
    EXPECT_EQ(run({"gcode", "run", program("G0 X31\nM2\n", "b.ngc")}).exit_code, 0);
    EXPECT_EQ(r1_pulses(), 36 * 400);
    core_->send(SIGTERM);
    core_->wait();
    start_homed();
    EXPECT_EQ(run({"gcode", "run", program("G0 X30 C#5386\nM2\n")}).exit_code, 0);
    EXPECT_EQ(r1_pulses(), 35 * 400);
    const auto offsets = shown();
    EXPECT_EQ(offsets["systems"]["G59.3"]["R"], 3.0);
    EXPECT_EQ(offsets["g30"]["X"], 35.0);
    EXPECT_TRUE(offsets["simulator"]);
    // The real machine is another one.
    core_->send(SIGTERM);
    core_->wait();
    EXPECT_EQ(shown()["systems"]["G54"]["X"], 0.0);
}

TEST_F(KeptOffsetsOf, AProgramThatIsStoppedAreThoseThatItBeganWith) {
    start_homed();
    ASSERT_EQ(run({"gcode", "offsets", "set", "G54", "X=1"}).exit_code, 0);
    const std::string before = text_of(shown()["file"]);
    const std::string path = program(kStopped);
    const auto running = begin({path});
    ASSERT_TRUE(comes_to_line(6));
    ASSERT_EQ(run({"stop"}).exit_code, 0);
    EXPECT_EQ(running->wait(), 4) << running->error();
    EXPECT_NE(running->error().find("work offsets are not kept: it did not end"), std::string::npos)
        << running->error();
    EXPECT_EQ(text_of(shown()["file"]), before);
    // From a line on it begins as it began.
    const Outcome rest = run({"gcode", "run", path, "--from-line", "7", "--unattended"});
    ASSERT_EQ(rest.exit_code, 0) << rest.error;
    EXPECT_NE(rest.error.find("begins in G54 with the work offsets of "), std::string::npos) << rest.error;
    EXPECT_EQ(r1_pulses(), 45 * 400);
    const auto offsets = shown();
    EXPECT_EQ(offsets["systems"]["G54"]["X"], 3.0);
    EXPECT_TRUE(offsets["g92"]["in_force"]);
}

TEST_F(KeptOffsetsOf, AProgramWhoseTerminalEndsAreThoseThatItBeganWith) {
    start_homed();
    const auto running = begin({program(kStopped)});
    ASSERT_TRUE(comes_to_line(6));
    running->send(SIGHUP);
    EXPECT_EQ(running->wait(), 4);
    EXPECT_NE(running->error().find("not kept: it did not end"), std::string::npos) << running->error();
    EXPECT_EQ(state(), MachineState::ready);
    EXPECT_FALSE(is_pending());
    EXPECT_EQ(run({"gcode", "offsets"}).error, "");
}

TEST_F(KeptOffsetsOf, AProgramWhoseReaderIsKilledAreKeptOnceTheCoreHasEndedIt) {
    start_homed();
    const auto running = begin({program(kStopped)});
    ASSERT_TRUE(comes_to_line(6));
    ASSERT_TRUE(eventually([&] { return is_pending(); }));
    running->send(SIGKILL);
    running->wait();
    EXPECT_EQ(shown()["systems"]["G54"]["X"], 0.0);
    EXPECT_EQ(run({"gcode", "offsets", "set", "G54", "X=7"}).exit_code, 4);
    EXPECT_TRUE(is_pending());
    ASSERT_EQ(run({"resume"}).exit_code, 0);
    ASSERT_TRUE(eventually([&] { return state() == MachineState::ready; }));
    const Outcome next = run({"gcode", "run", program("G0 X30 Y1\nM2\n", "b.ngc")});
    ASSERT_EQ(next.exit_code, 0) << next.error;
    EXPECT_EQ(r1_pulses(), 32 * 400);
    EXPECT_FALSE(is_pending());
    EXPECT_EQ(shown()["systems"]["G54"]["X"], 2.0);
}

TEST_F(KeptOffsetsOf, AProgramWhoseReaderIsKilledAreDroppedWithOneWarningWhereItIsStopped) {
    start_homed();
    const auto running = begin({program(kStopped)});
    ASSERT_TRUE(comes_to_line(6));
    ASSERT_TRUE(eventually([&] { return is_pending(); }));
    running->send(SIGKILL);
    running->wait();
    ASSERT_EQ(run({"stop"}).exit_code, 0);
    const Outcome warned = run({"gcode", "offsets", "--json"});
    EXPECT_EQ(warned.json()["systems"]["G54"]["X"], 0.0);
    EXPECT_NE(warned.error.find("are not kept"), std::string::npos) << warned.error;
    EXPECT_EQ(warned.error_lines(), 1U);
    EXPECT_EQ(run({"gcode", "offsets"}).error, "");
}

TEST_F(KeptOffsetsOf, AProgramOfACoreThatDiedAreDropped) {
    start_homed();
    const auto running = begin({program(kStopped)});
    ASSERT_TRUE(comes_to_line(6));
    ASSERT_TRUE(eventually([&] { return is_pending(); }));
    running->send(SIGKILL);
    running->wait();
    core_->send(SIGKILL);
    core_->wait();
    start_homed();
    const Outcome warned = run({"gcode", "offsets", "--json"});
    EXPECT_EQ(warned.json()["systems"]["G54"]["X"], 0.0);
    EXPECT_NE(warned.error.find("are not kept"), std::string::npos) << warned.error;
}

TEST_F(KeptOffsetsOf, AProgramOfManyDwellsAreNotKeptWhereItIsStopped) {
    start_homed();
    std::string text = "G21 G90\nG10 L2 P2 X3\nG0 X40\nM0\n";
    for (int n = 0; n < 20'000; ++n) text += "G4 P0.001\n";
    const auto running = begin({program(text + "G10 L2 P1 X5\nG0 X41\nM2\n")});
    ASSERT_TRUE(comes_to_line(4));
    ASSERT_EQ(run({"stop"}).exit_code, 0);
    EXPECT_EQ(running->wait(), 4) << running->error();
    EXPECT_EQ(shown()["systems"]["G54"]["X"], 0.0);
    EXPECT_EQ(shown()["systems"]["G55"]["X"], 0.0);
    EXPECT_FALSE(is_pending());
    EXPECT_EQ(run({"gcode", "run", program(text.erase(text.find("M0"), 3) + "G10 L2 P1 X5\nM2\n")}).exit_code,
              0);
    EXPECT_EQ(shown()["systems"]["G54"]["X"], 5.0);
}

TEST_F(KeptOffsetsOf, AProgramWhoseBlockIsRefusedAreNotKept) {
    start_homed();
    write("p", "G10 L2 P1 X5\nG0 X35\nG92.1 G0 X9999\n");
    EXPECT_EQ(streamed("cat " + file("p")), 3);
    const std::string said = text_of(file("said"));
    EXPECT_NE(said.find("not kept: it did not end"), std::string::npos) << said;
    EXPECT_FALSE(has_file());
}

TEST_F(KeptOffsetsOf, AStreamAreReadOnceItBegins) {
    start_homed();
    write("p", "G0 X30\nG10 L2 P2 X8\nM2\n");
    const std::string set = in_build("bin/psicarve") + " gcode offsets set G54 X=5 --segment " + segment_;
    ASSERT_EQ(streamed(set + " > /dev/null; cat " + file("p")), 0) << text_of(file("said"));
    EXPECT_EQ(r1_pulses(), 35 * 400);
    EXPECT_EQ(shown()["systems"]["G55"]["X"], 8.0);
}

TEST_F(KeptOffsetsOf, NothingMovesWhereNoneCanBeWritten) {
    start_homed();
    const std::int64_t before = r1_pulses();
    std::filesystem::create_directories(shown()["file"].get<std::string>() + ".lock");
    const Outcome refused = run({"gcode", "run", program("G0 X30\nM2\n")});
    EXPECT_EQ(refused.exit_code, 4) << refused.error;
    EXPECT_NE(refused.error.find("nothing has moved"), std::string::npos) << refused.error;
    EXPECT_EQ(r1_pulses(), before);
}

TEST_F(KeptOffsetsOf, AProgramThatCannotBeWrittenAtItsEndAreToldBehindTheReport) {
    start_homed();
    const auto running = begin({program("G10 L2 P1 X5\nG0 X40\nM0\nM2\n")});
    ASSERT_TRUE(comes_to_line(3));
    ASSERT_TRUE(eventually([&] { return is_pending(); }));
    const std::string path = file("state" + segment_ + ".simulated-offsets");
    std::filesystem::remove(path);
    std::filesystem::create_directories(path + "/in-the-way");
    ASSERT_EQ(run({"resume"}).exit_code, 0);
    EXPECT_EQ(running->wait(), 4);
    EXPECT_NE(running->error().find("the program has ended, its work offsets are not kept"),
              std::string::npos)
        << running->error();
}

TEST_F(KeptOffsetsOf, AMachineAreLeftAloneByWhatMovesNothing) {
    start_homed();
    const std::string path = program("G21 G90 F300\nG10 L2 P1 X5\nG0 C10\nM2\n");
    EXPECT_EQ(run({"gcode", "check", path}).exit_code, 0);
    EXPECT_EQ(run({"gcode", "run", path, "--dry-run"}).exit_code, 0);
    EXPECT_FALSE(has_file());
    EXPECT_EQ(run({"gcode", "run", program("G0 X30\nM2\n")}).exit_code, 0);
    EXPECT_FALSE(has_file());
    core_->send(SIGTERM);
    core_->wait();
    EXPECT_EQ(run({"gcode", "run", path, "--simulate"}).exit_code, 0);
    EXPECT_FALSE(has_file());
}

TEST_F(KeptOffsetsOf, AMachineAreWhatAProgramIsCheckedAndSimulatedWith) {
    const std::string path = program("G0 X50\nM2\n");
    EXPECT_EQ(run({"gcode", "check", path}).exit_code, 0);
    ASSERT_EQ(run({"gcode", "offsets", "set", "G54", "X=11"}).exit_code, 0);
    EXPECT_EQ(run({"gcode", "check", path}).exit_code, 3);
    EXPECT_EQ(run({"gcode", "run", path, "--simulate"}).exit_code, 3);
    EXPECT_EQ(run({"gcode", "check", path, "--no-machine"}).exit_code, 0);
    ASSERT_EQ(run({"gcode", "offsets", "clear", "g54"}).exit_code, 0);
    EXPECT_EQ(run({"gcode", "check", path}).exit_code, 0);
    write("state" + segment_ + ".offsets", "{\"psicarve_offsets\":2}");
    for (const char* command : {"check", "run", "offsets"}) {
        std::vector<std::string> arguments{"gcode", command};
        if (std::string{command} != "offsets") arguments.push_back(path);
        if (std::string{command} == "run") arguments.emplace_back("--simulate");
        const Outcome refused = run(arguments);
        EXPECT_EQ(refused.exit_code, 3) << command;
        EXPECT_NE(refused.error.find("clear all"), std::string::npos) << refused.error;
        EXPECT_EQ(refused.error_lines(), 1U) << refused.error;
    }
    ASSERT_EQ(run({"gcode", "offsets", "clear", "all"}).exit_code, 0);
    EXPECT_EQ(text_of(file("state" + segment_ + ".offsets.bak")), "{\"psicarve_offsets\":2}");
    EXPECT_EQ(run({"gcode", "check", path}).exit_code, 0);
}

TEST_F(KeptOffsetsOf, AMachineAreNotChangedByHandWhileAProgramRuns) {
    start_homed();
    const auto running = begin({program("G21 G90\nG0 X40\nM0\nM2\n")});
    ASSERT_TRUE(comes_to_line(3));
    const Outcome refused = run({"gcode", "offsets", "set", "G54", "X=1"});
    EXPECT_EQ(refused.exit_code, 4);
    EXPECT_NE(refused.error.find("a program runs, in line 3"), std::string::npos) << refused.error;
    // Also where its reader is gone.
    running->send(SIGKILL);
    running->wait();
    EXPECT_EQ(run({"gcode", "offsets", "clear", "all"}).exit_code, 4);
    ASSERT_EQ(run({"stop"}).exit_code, 0);
    EXPECT_EQ(run({"gcode", "offsets", "set", "G54", "X=1"}).exit_code, 0);
}

TEST_F(KeptOffsetsOf, ATraceStandBesideItAndJudgeIt) {
    const std::string trace = file("pins.trace");
    const std::string path = program("G21 G90 F300\nG0 X40 Z40\nG1 X39 C20\nM2\n");
    ASSERT_EQ(run({"gcode", "offsets", "set", "G54", "X=4"}).exit_code, 0);
    const Outcome done = run({"gcode", "run", path, "--simulate", "--trace", trace});
    ASSERT_EQ(done.exit_code, 0) << done.error;
    ASSERT_EQ(run({"gcode", "offsets", "set", "G54", "X=1"}).exit_code, 0);
    const Outcome judged = run({"verify", trace, "--program", path});
    EXPECT_EQ(judged.exit_code, 0) << judged.out << judged.error;
    EXPECT_EQ(judged.error, "");
    std::filesystem::rename(trace + ".offsets", file("kept"));
    const Outcome unsure = run({"verify", trace, "--program", path});
    EXPECT_EQ(unsure.exit_code, 6);
    EXPECT_NE(unsure.error.find("judged by the work offsets of now"), std::string::npos) << unsure.error;
    EXPECT_EQ(run({"verify", trace, "--program", path, "--offsets", file("kept")}).exit_code, 0);
    EXPECT_EQ(run({"verify", trace, "--program", path, "--offsets", file("none")}).exit_code, 3);
}

// Pulses that only cross a screw's gap move no tip.
TEST_F(KeptOffsetsOf, ATraceNameTheProfileThatItWasMadeWith) {
    write("worn.toml", "name = \"worn\"\n[axis.r1]\nbacklash_mm = 0.2\n[axis.y]\nbacklash_mm = 0.3\n");
    const std::string trace = file("pins.trace");
    const std::string path = program("G21 G90 F300\nG0 X40 Z40\nG1 X39 C20\nG1 X40 Z39\nG1 X39 Z40\nM2\n");
    ASSERT_EQ(
        run({"gcode", "run", path, "--simulate", "--trace", trace, "--profile", file("worn.toml")}).exit_code,
        0);
    EXPECT_EQ(run({"verify", trace, "--program", path, "--profile", file("worn.toml")}).exit_code, 0);
    const Outcome other = run({"verify", trace, "--program", path});
    EXPECT_EQ(other.exit_code, 6) << other.out;
    EXPECT_NE(other.out.find("  rule 1: "), std::string::npos) << other.out;
    EXPECT_NE(other.error.find("another profile than the trace was made with, which was \"worn\""),
              std::string::npos)
        << other.error;
    EXPECT_NE(other.error.find("--profile FILE"), std::string::npos) << other.error;
    // Another one by which its tips are where they should be judges it.
    write("alike.toml", text_of(file("worn.toml")) + "[job]\nfeed_mm_s = 9\n");
    EXPECT_EQ(run({"verify", trace, "--program", path, "--profile", file("alike.toml")}).exit_code, 0);
}

TEST_F(KeptOffsetsOf, NothingIsSetAndThatIsSaidWhereNoStateIsKept) {
    setenv("PSICARVE_STATE", "", 1);
    const Outcome refused = run({"gcode", "offsets", "set", "G54", "X=1"});
    EXPECT_EQ(refused.exit_code, 3);
    EXPECT_NE(refused.error.find("nothing is kept"), std::string::npos);
    EXPECT_TRUE(shown()["file"].is_null());
}

TEST_F(KeptOffsetsOf, AMachineAreNamedAsTheProfileNamesItsAxes) {
    const auto said = [this](std::vector<std::string> words) {
        words.insert(words.begin(), {"gcode", "offsets"});
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.exit_code, 2) << outcome.out;
        return outcome.error;
    };
    EXPECT_NE(said({"sett"}).find("did you mean 'set'?"), std::string::npos);
    EXPECT_NE(said({"set", "G45", "X=1"}).find("did you mean 'G54'?"), std::string::npos);
    EXPECT_NE(said({"set", "G54", "U=1"}).find("no axis has the letter U"), std::string::npos);
    EXPECT_NE(said({"set", "G54", "X"}).find("LETTER=NUMBER"), std::string::npos);
    EXPECT_NE(said({"set", "G54", "X=1", "Y=2e9"}).find("Y=2e9"), std::string::npos);
    EXPECT_NE(said({"set", "G54"}).find("set SYSTEM"), std::string::npos);
    EXPECT_NE(said({"set", "G54", "X=1", "Y=3", "x=2"}).find("X is given twice"), std::string::npos);
    EXPECT_NE(said({"clear"}).find("clear SYSTEM"), std::string::npos);
    EXPECT_FALSE(has_file());
    write("t.toml", "[gcode]\nletters = \"turning\"\n");
    EXPECT_EQ(run({"gcode", "offsets", "set", "G54", "u=1", "R=5", "--profile", file("t.toml")}).exit_code,
              0);
    // Another letter is another axis there.
    EXPECT_EQ(run({"gcode", "offsets"}).exit_code, 3);
    const Outcome text = run({"gcode", "offsets", "--profile", file("t.toml")});
    EXPECT_NE(text.out.find("U 1.0000  R 5.0000"), std::string::npos) << text.out;
}

}  // namespace
}  // namespace psicarve::test
