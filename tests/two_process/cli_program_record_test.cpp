// SPDX-License-Identifier: GPL-3.0-or-later
// What is kept of a program: in the flight recorder, in its snapshots, and in the journal.
#include <string>
#include <vector>

#include "shared/record/snapshot_file.hpp"
#include "shared/segment/segment_program.hpp"
#include "tests/shared/job_fixture.hpp"
#include "tests/two_process/cli_machine_rig.hpp"

namespace psicarve::test {
namespace {

class KeptProgram : public Machine {
protected:
    std::unique_ptr<RunningProgram> begin_program(const std::string& text) const {
        write("kept.ngc", text);
        return std::make_unique<RunningProgram>(
            "psicarve", std::vector<std::string>{"gcode", "run", file("kept.ngc"), "--segment", segment_});
    }
    bool comes_to_hold(std::uint64_t line) const {
        return eventually([&] {
            const auto segment = Segment::attach(segment_);
            return segment && state() == MachineState::held && program_report(*segment).status.line == line;
        });
    }
    std::string snapshot() const {
        EXPECT_EQ(run({"snapshot", "save", file("kept.snap")}).exit_code, 0);
        return file("kept.snap");
    }
    /// "held 3": event and line.
    std::vector<std::string> events() const {
        const auto info = psicarve({"snapshot", "info", snapshot(), "--json", "--records", "1000"}).json();
        std::vector<std::string> events;
        for (const auto& record : info["records"]) {
            if (record["kind"] != "program") continue;
            const auto& program = record["program"];
            const std::string place = program.contains("line") ? program["line"].dump() : "-";
            events.push_back(record["code"].get<std::string>() + " " + place);
        }
        return events;
    }
};

using Events = std::vector<std::string>;

TEST_F(KeptProgram, SaysWhereItWasHeldWentOnAndWasBrokenOff) {
    start_core({"--state", file("state")});
    ASSERT_EQ(run({"home"}).exit_code, 0);
    const auto running = begin_program("G21 G90 F300\nG0 X45\nM0\nG1 X44\nM0\nM2\n");
    ASSERT_TRUE(comes_to_hold(3));
    EXPECT_EQ(events(), (Events{"begun -", "line 2", "held 3"}));
    const std::string held = psicarve({"snapshot", "info", snapshot()}).out;
    EXPECT_NE(held.find("program    line 3: held, program stop\n"), std::string::npos) << held;
    ASSERT_EQ(run({"resume"}).exit_code, 0);
    ASSERT_TRUE(comes_to_hold(5));
    (void)run({"estop"});
    EXPECT_NE(running->wait(), 0);
    EXPECT_EQ(events(), (Events{"begun -", "line 2", "held 3", "resumed 3", "held 5", "ended 5"}));
    const std::string broken = psicarve({"snapshot", "info", snapshot()}).out;
    EXPECT_NE(broken.find("program    the last one ended in line 5 of its program; gcode run FILE "),
              std::string::npos)
        << broken;
    const auto log = [&] { return run({"log", "--state", file("state"), "--kind", "job"}).out; };
    EXPECT_TRUE(eventually([&] {
        return log().find("program ended: alarm at line 5\n") != std::string::npos;
    })) << log();
    for (const char* const words :
         {"program started, no. ", "program held: program stop at line 3\n", "program resumed at line 3\n"})
        EXPECT_NE(log().find(words), std::string::npos) << log();
}

// Its file is not in a snapshot.
TEST_F(KeptProgram, IsRefusedByAReplayInWordsOfItsOwn) {
    start_core();
    ASSERT_EQ(run({"home"}).exit_code, 0);
    ASSERT_EQ(begin_program("G21 G90 F300\nG0 X45\nM2\n")->wait(), 0);
    const Outcome without_job = psicarve({"replay", snapshot()});
    EXPECT_EQ(without_job.exit_code, 3);
    EXPECT_NE(without_job.error.find("a program in G-code, up to line 3, whose file"), std::string::npos)
        << without_job.error;
    auto with_job = load_snapshot(file("kept.snap"));
    ASSERT_TRUE(with_job);
    with_job->job_blob = job_blob_from_table(small_job(Profile{}));
    ASSERT_TRUE(save_snapshot(*with_job, file("job.snap")));
    const Outcome refused = psicarve({"replay", file("job.snap")});
    EXPECT_EQ(refused.exit_code, 3);
    EXPECT_NE(refused.error.find("a program in G-code, up to line 3, whose file"), std::string::npos)
        << refused.error;
}

TEST_F(KeptProgram, SaysTheLineInWhichItsCoreDied) {
    start_core();
    ASSERT_EQ(run({"home"}).exit_code, 0);
    const auto running = begin_program("G21 G90 F300\nG0 X45\nM0\nM2\n");
    ASSERT_TRUE(comes_to_hold(3));
    core_->send(SIGKILL);
    core_->wait();
    EXPECT_EQ(running->wait(), 5) << running->error();
    const std::string info = psicarve({"snapshot", "info", snapshot()}).out;
    EXPECT_NE(info.find("program    line 3: held, program stop\n"), std::string::npos) << info;
}

}  // namespace
}  // namespace psicarve::test
