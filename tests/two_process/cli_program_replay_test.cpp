// SPDX-License-Identifier: GPL-3.0-or-later
// A program in G-code that was recorded is run again from its text.
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "shared/machine/recorded_program.hpp"
#include "shared/record/snapshot_file.hpp"
#include "shared/segment/segment_program.hpp"
#include "tests/places.hpp"
#include "tests/shared/job_fixture.hpp"
#include "tests/two_process/cli_machine_rig.hpp"

namespace psicarve::test {
namespace {

using Edge = std::tuple<std::int64_t, std::string, char>;

bool is_step(const Edge& edge) {
    return std::get<1>(edge).ends_with("_step") && std::get<2>(edge) == '1';
}

/// All pins of a value-change dump from its first pulse on, in time from there.
std::vector<Edge> edges_from_first_step(const std::string& dump) {
    std::istringstream lines{dump};
    std::map<std::string, std::string> names;
    std::vector<Edge> edges;
    std::int64_t time = 0;
    std::int64_t first = 0;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("$var")) {
            const auto words = words_of(line);
            names[words[3]] = words[4];
        } else if (line.starts_with("#")) {
            time = std::stoll(line.substr(1));
        } else if (line.size() > 1 && names.contains(line.substr(1))) {
            const Edge edge{time - first, names[line.substr(1)], line[0]};
            if (edges.empty() && !is_step(edge)) continue;
            if (edges.empty()) first = time;
            edges.emplace_back(time - first, std::get<1>(edge), line[0]);
        }
    }
    return edges;
}

/// `count` ways to and fro, a second each.
std::string long_program(int count) {
    std::string text = "G21 G90 F300\nG0 X45 C0\nM3\nG64 P0.02\n";
    for (int i = 0; i < count; ++i) {
        text += i % 2 == 0 ? "G1 X40 Y4\n" : "G1 X44 Y1 C" + std::to_string(15 * i) + "\n";
    }
    return text;
}

class ReplayedProgram : public Machine {
protected:
    ReplayedProgram() { setenv("PSICARVE_STATE", file("state").c_str(), 1); }
    ~ReplayedProgram() override { setenv("PSICARVE_STATE", "", 1); }

    void begin_machine() {
        start_core();
        ASSERT_EQ(run({"home"}).exit_code, 0);
    }
    std::unique_ptr<RunningProgram> begin(const std::string& text, std::vector<std::string> more = {}) const {
        write("run.ngc", text);
        std::vector<std::string> words{"gcode",  "run",     file("run.ngc"), "--segment",
                                       segment_, "--trace", file("run.vcd")};
        words.insert(words.end(), more.begin(), more.end());
        return std::make_unique<RunningProgram>("psicarve", words);
    }
    ProgramStatus program() const {
        const auto segment = Segment::attach(segment_);
        return segment ? program_report(*segment).status : ProgramStatus{};
    }
    bool comes_to(std::uint64_t line) const {
        return eventually([&] { return program().is_running != 0 && program().line >= line; });
    }
    bool comes_to_hold(std::uint64_t line) const {
        return eventually([&] { return state() == MachineState::held && program().line == line; });
    }
    std::string snapshot() const {
        EXPECT_EQ(run({"snapshot", "save", file("run.snap")}).exit_code, 0);
        return file("run.snap");
    }
    Outcome replay(const std::string& text = "run.ngc") const {
        return psicarve(
            {"replay", file("run.snap"), "--program", file(text), "--trace", file("again.vcd"), "--json"});
    }
    /// To the tick, whatever was recorded before the first pulse, or after the recording's end.
    void expect_same_pins() const {
        const auto recorded = edges_from_first_step(text_of(file("run.vcd")));
        const auto again = edges_from_first_step(text_of(file("again.vcd")));
        ASSERT_GT(again.size(), 1000U);
        const std::size_t both = std::min(recorded.size(), again.size());
        const auto [a, b] =
            std::mismatch(recorded.begin(), recorded.begin() + static_cast<long>(both), again.begin());
        EXPECT_EQ(a - recorded.begin(), static_cast<long>(both)) << "at " << std::get<0>(*a) << " ns";
        EXPECT_EQ(std::ranges::count_if(recorded, is_step), std::ranges::count_if(again, is_step));
    }
    void change_snapshot(const std::function<void(Snapshot&)>& change) const {
        auto read = load_snapshot(file("run.snap"));
        ASSERT_TRUE(read);
        change(*read);
        ASSERT_TRUE(save_snapshot(*read, file("run.snap")));
    }
    static void change_source(Snapshot& snapshot, const std::function<void(RecordedSource&)>& change) {
        auto changed = std::make_shared<RecordedSource>(*snapshot.source);
        change(*changed);
        snapshot.source = std::move(changed);
    }
};

// Long enough for commands to come in the middle of it.
TEST_F(ReplayedProgram, HasTheSamePinsWithAHoldAnOverrideAndAProgramStop) {
    begin_machine();
    const auto running = begin(long_program(10) + "M0\n" + long_program(120) + "M2\n");
    ASSERT_TRUE(comes_to_hold(15));
    ASSERT_EQ(run({"override", "60"}).exit_code, 0);
    ASSERT_EQ(run({"resume"}).exit_code, 0);
    ASSERT_TRUE(comes_to(25));
    ASSERT_EQ(run({"hold"}).exit_code, 0);
    ASSERT_EQ(run({"override", "140"}).exit_code, 0);
    ASSERT_EQ(run({"resume"}).exit_code, 0);
    ASSERT_EQ(running->wait(), 0) << running->error();
    (void)snapshot();
    const Outcome again = replay();
    EXPECT_EQ(again.exit_code, 0) << again.error;
    const auto json = again.json();
    EXPECT_EQ(json["as_recorded"], true) << again.out;
    EXPECT_EQ(json["most_ticks_apart"], 0) << again.out;
    EXPECT_EQ(json["line"], 140) << again.out;
    EXPECT_GE(json["events"].get<int>(), 15) << again.out;
    expect_same_pins();
}

// Each tip rests against the flank that homing has left it at.
TEST_F(ReplayedProgram, HasTheSamePinsWhereScrewsHavePlay) {
    Profile profile;
    profile.r1.backlash_mm = 0.02;
    profile.r2.backlash_mm = 0.02;
    profile.y.backlash_mm = 0.02;
    write("play.toml", profile_to_toml(profile));
    start_core({"--profile", file("play.toml")});
    ASSERT_EQ(run({"home"}).exit_code, 0);
    (void)begin(long_program(10) + "M2\n", {"--profile", file("play.toml")})->wait();
    (void)snapshot();
    const Outcome again = replay();
    EXPECT_EQ(again.json()["as_recorded"], true) << again.out;
    EXPECT_EQ(again.json()["most_ticks_apart"], 0) << again.out;
    expect_same_pins();
}

TEST_F(ReplayedProgram, EndsInTheEmergencyStopOfItsRecording) {
    begin_machine();
    const auto running = begin(long_program(200) + "M2\n");
    ASSERT_TRUE(comes_to(20));
    (void)run({"estop"});
    EXPECT_NE(running->wait(), 0);
    (void)snapshot();
    const Outcome again = replay();
    EXPECT_EQ(again.exit_code, 4) << again.error;
    const auto json = again.json();
    EXPECT_EQ(json["as_recorded"], true) << again.out;
    EXPECT_EQ(json["most_ticks_apart"], 0) << again.out;
    EXPECT_NE(again.error.find("emergency stop"), std::string::npos) << again.error;
    expect_same_pins();
}

TEST_F(ReplayedProgram, HasTheSwitchesAndWorkOffsetsOfItsRun) {
    begin_machine();
    ASSERT_EQ(run({"gcode", "offsets", "set", "G54", "X=2", "Y=1"}).exit_code, 0)
        << run({"gcode", "offsets", "set", "G54", "X=2", "Y=1"}).error;
    const auto running =
        begin(long_program(6) + "/G1 Y5\nM1\nG1 X43 Y2\nG10 L2 P1 X9\nM2\n",
              {"--single", "--optional-stop", "--block-delete", "--from-line", "6", "--unattended"});
    while (!running->has_ended()) {
        if (state() == MachineState::held) (void)run({"resume"});
    }
    ASSERT_EQ(running->wait(), 0) << running->error();
    (void)snapshot();
    const auto source = psicarve({"snapshot", "info", file("run.snap"), "--json"}).json()["program_source"];
    EXPECT_EQ(source["name"], file("run.ngc"));
    EXPECT_EQ(source["bytes"], text_of(file("run.ngc")).size());
    EXPECT_EQ(source["options"].dump(), R"(["--single","--optional-stop","--block-delete","--from-line 6"])");
    EXPECT_GT(source["records_taken"], 6);
    const std::string told = psicarve({"snapshot", "info", file("run.snap")}).out;
    EXPECT_NE(told.find("run.ngc: " + std::to_string(text_of(file("run.ngc")).size()) + " bytes, XXH3 " +
                        source["xxh3"].get<std::string>() + "; "),
              std::string::npos)
        << told;
    EXPECT_NE(told.find(" taken; --single --optional-stop --block-delete --from-line 6\n"), std::string::npos)
        << told;
    const Outcome again = replay();
    EXPECT_EQ(again.exit_code, 0) << again.error;
    EXPECT_EQ(again.json()["as_recorded"], true) << again.out;
    EXPECT_EQ(again.json()["most_ticks_apart"], 0) << again.out;
    expect_same_pins();
}

// Its reader was killed: the text is not to be read further than it had been.
TEST_F(ReplayedProgram, EndsWhereItsReaderWasKilled) {
    begin_machine();
    const std::string command =
        in_build("bin/psicarve") + " gcode run - --segment " + segment_ + " >/dev/null 2>&1";
    std::FILE* const stream = popen(command.c_str(), "w");
    ASSERT_NE(stream, nullptr);
    std::fputs((long_program(10) + "M0\n").c_str(), stream);
    std::fflush(stream);
    ASSERT_TRUE(comes_to_hold(15));
    const auto segment = Segment::attach(segment_);
    ASSERT_TRUE(segment);
    kill(static_cast<pid_t>(program_report(*segment).writer_pid), SIGKILL);
    ASSERT_EQ(run({"resume"}).exit_code, 0);
    ASSERT_TRUE(eventually([&] { return program().hold == ProgramHold::feeder_lost; }));
    (void)pclose(stream);
    ASSERT_EQ(run({"stop"}).exit_code, 0);
    (void)snapshot();
    write("run.ngc", long_program(10) + "M0\n" + long_program(10) + "M2\n");
    const Outcome again = replay();
    EXPECT_EQ(again.exit_code, 0) << again.error;
    EXPECT_EQ(again.json()["as_recorded"], true) << again.out;
    EXPECT_EQ(again.json()["most_ticks_apart"], 0) << again.out;
    EXPECT_EQ(again.json()["line"], 15) << again.out;
}

// Its text is nowhere: a file that asks for the same motions will do.
TEST_F(ReplayedProgram, OfAStreamIsOneOfAnyTextWithTheSameMotions) {
    begin_machine();
    write("sent.ngc", long_program(10) + "M2\n");
    const std::string command = in_build("bin/psicarve") + " gcode run - --segment " + segment_ +
                                " --trace " + file("run.vcd") + " <" + file("sent.ngc") + " >/dev/null 2>&1";
    ASSERT_EQ(std::system(command.c_str()), 0);
    (void)snapshot();
    const Outcome info = psicarve({"snapshot", "info", file("run.snap"), "--json"});
    EXPECT_EQ(info.json()["program_source"]["is_stream"], true) << info.out;
    EXPECT_TRUE(info.json()["program_source"]["bytes"].is_null()) << info.out;
    write("same.ngc", "(the same)" + long_program(10) + "M2\n");
    const Outcome again = replay("same.ngc");
    EXPECT_EQ(again.exit_code, 0) << again.error;
    EXPECT_EQ(again.json()["most_ticks_apart"], 0) << again.out;
    EXPECT_EQ(again.json()["unverified_reason"], "it came from standard input");
    expect_same_pins();
    write("other.ngc", long_program(11) + "M2\n");
    EXPECT_EQ(replay("other.ngc").exit_code, 3);
}

TEST_F(ReplayedProgram, IsRefusedWithAnotherTextOrNone) {
    begin_machine();
    ASSERT_EQ(begin(long_program(4) + "M2\n")->wait(), 0);
    (void)snapshot();
    write("other.ngc", long_program(5) + "M2\n");
    const Outcome other = replay("other.ngc");
    EXPECT_EQ(other.exit_code, 3);
    EXPECT_NE(other.error.find("other.ngc: another text than that of " + file("run.ngc")), std::string::npos)
        << other.error;
    const Outcome none = psicarve({"replay", file("run.snap")});
    EXPECT_EQ(none.exit_code, 3);
    EXPECT_NE(none.error.find("psicarve replay SNAPSHOT --program FILE"), std::string::npos) << none.error;
    EXPECT_FALSE(std::filesystem::exists(file("again.vcd")));
    change_snapshot([](Snapshot& taken) {
        change_source(taken, [](RecordedSource& recorded) { recorded.record_sum += 1; });
    });
    const Outcome unlike = replay();
    EXPECT_EQ(unlike.exit_code, 3);
    EXPECT_NE(unlike.error.find("its motions up to line 9 are not those"), std::string::npos) << unlike.error;
}

TEST_F(ReplayedProgram, IsRefusedWhereTheSnapshotDoesNotTellEnough) {
    begin_machine();
    (void)snapshot();
    const Outcome info = psicarve({"snapshot", "info", file("run.snap"), "--json"});
    EXPECT_TRUE(info.json()["program_source"].is_null()) << info.out;
    write("run.ngc", "M2\n");
    const Outcome none = replay();
    EXPECT_EQ(none.exit_code, 3);
    EXPECT_NE(none.error.find("it recorded no program in G-code"), std::string::npos) << none.error;
    ASSERT_EQ(begin(long_program(4) + "M2\n")->wait(), 0);
    (void)snapshot();
    change_snapshot([](Snapshot& taken) {
        FlightRecord starved{};
        starved.kind = RecordKind::program;
        starved.code = static_cast<std::uint16_t>(static_cast<unsigned>(ProgramEvent::held) |
                                                  static_cast<unsigned>(ProgramHold::starved) << 8U);
        starved.value = 7;
        starved.tick = taken.records.back().tick;
        taken.records.push_back(starved);
    });
    const Outcome starved = replay();
    EXPECT_EQ(starved.exit_code, 3);
    EXPECT_NE(starved.error.find("had to wait for the program in line 7;"), std::string::npos)
        << starved.error;
    change_snapshot([](Snapshot& taken) { taken.source.reset(); });
    const Outcome older = replay();
    EXPECT_EQ(older.exit_code, 3);
    EXPECT_NE(older.error.find("it does not say how its program was read"), std::string::npos) << older.error;
    Snapshot job;
    job.job_blob = job_blob_from_table(small_job(Profile{}));
    ASSERT_TRUE(save_snapshot(job, file("run.snap")));
    EXPECT_EQ(replay().exit_code, 3) << "a job has no program";
}

}  // namespace
}  // namespace psicarve::test
