// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/job/job.hpp"
#include "shared/machine/command.hpp"
#include "shared/machine/recorded_program.hpp"
#include "shared/record/snapshot_file.hpp"
#include "tests/hmi/cli/program_run.hpp"

namespace psicarve::test {
namespace {

/// Two layers of three points, every number another.
JobTable small_table(Joining joining = Joining::continuous) {
    JobTable table;
    table.layer_count = 2;
    table.point_count = 3;
    table.psi_sweep_pulses = 3200;
    table.joining = joining;
    table.feed_mm_s = 20.0;
    table.layer_height_pulses = {100, 300};
    table.r_left_pulses = {4001, 4002, 4003, 4004, 4005, 4006};
    table.r_right_pulses = {5001, 5002, 5003, 5004, 5005, 5006};
    table.source_name = "small.stl";
    table.source_hash = 0x1234;
    table.profile_toml = profile_to_toml(Profile{});
    table.report_json = R"({"undercut_share":0.25,"open_points":7})";
    return table;
}

class SnapshotCommand : public CliTest {
protected:
    std::string save(const std::string& name, const JobTable& table, const Snapshot& rest = {}) {
        Snapshot snapshot = rest;
        snapshot.job_blob = job_blob_from_table(table);
        const auto saved = save_snapshot(snapshot, file(name));
        EXPECT_TRUE(saved.has_value()) << saved.error().message;
        return file(name);
    }
};

TEST_F(SnapshotCommand, ExportsCsvWithOneRowAPoint) {
    const Outcome outcome = psicarve({"snapshot", "export", save("a.job", small_table()), "--format", "csv"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
    EXPECT_EQ(outcome.error, "");
    EXPECT_EQ(outcome.out,
              "layer,point,y_pulses,psi_pulses,r_left_pulses,r_right_pulses\n"
              "0,0,100,0,4001,5001\n"
              "0,1,100,1600,4002,5002\n"
              "0,2,100,3200,4003,5003\n"
              "1,0,300,3200,4004,5004\n"
              "1,1,300,4800,4005,5005\n"
              "1,2,300,6400,4006,5006\n");
}

TEST_F(SnapshotCommand, ExportsCsvThatIsSlicedToTheSameTables) {
    const std::string box = box_stl("box.stl");
    const auto exported = [](const std::string& job) {
        return psicarve({"snapshot", "export", job, "--format", "csv"}).out;
    };
    for (const char* joining : {"continuous", "zigzag", "spiral"}) {
        const Outcome sliced =
            psicarve({"slice", box, "-o", file("a.job"), "--layers", "8", "--points", "21", "--joining",
                      joining, "--tool", "ball:3", "--blank", "14x8", "--stepdown", "2"});
        ASSERT_EQ(sliced.exit_code, 0) << sliced.error;
        write("a.csv", exported(file("a.job")));
        const Outcome again =
            psicarve({"slice", file("a.csv"), "-o", file("b.job"), "--profile", file("a.job"), "--json"});
        ASSERT_EQ(again.exit_code, 0) << again.error;
        EXPECT_EQ(again.json()["joining"], joining);
        EXPECT_GE(again.json()["passes"].size(), 3U);
        EXPECT_TRUE(exported(file("b.job")) == text_of(file("a.csv"))) << joining;
        // What it cannot be is not left out in silence.
        for (const std::vector<std::string>& asked :
             {std::vector<std::string>{"--finish-only"},
              {"--joining", std::string{joining} == "zigzag" ? "spiral" : "zigzag"}}) {
            std::vector<std::string> arguments{"slice",       file("a.csv"), "-o",
                                               file("c.job"), "--profile",   file("a.job")};
            arguments.insert(arguments.end(), asked.begin(), asked.end());
            const Outcome refused = psicarve(arguments);
            EXPECT_EQ(refused.exit_code, 2) << joining << ' ' << asked.front();
            EXPECT_NE(refused.error.find(asked.front()), std::string::npos) << refused.error;
        }
    }
}

TEST_F(SnapshotCommand, ExportsZigzagWithinOneSweep) {
    const Outcome outcome = psicarve({"snapshot", "export", save("a.job", small_table(Joining::zigzag))});
    EXPECT_NE(outcome.out.find("1,0,300,0,4004,5004\n1,1,300,1600,4005,5005\n1,2,300,3200,4006,5006\n"),
              std::string::npos)
        << outcome.out;
}

TEST_F(SnapshotCommand, ExportsTheHeightOfEveryPointOfASpiral) {
    JobTable table = small_table(Joining::spiral);
    table.layer_height_pulses = {100, 301};
    const std::string job = save("a.job", table);
    const Outcome csv = psicarve({"snapshot", "export", job});
    EXPECT_NE(csv.out.find("0,2,100,3200,4003,5003\n1,0,100,3200,4004,5004\n1,1,201,4800,4005,5005\n"
                           "1,2,301,6400,4006,5006\n"),
              std::string::npos)
        << csv.out;
    const auto json = psicarve({"snapshot", "export", job, "--format", "json"}).json();
    EXPECT_EQ(json["joining"], "spiral");
    EXPECT_EQ(json["y_pulses"], nlohmann::json::parse("[100,301]"));
    EXPECT_EQ(json["point_y_pulses"], nlohmann::json::parse("[[100,100,100],[100,201,301]]"));
    EXPECT_EQ(psicarve({"snapshot", "info", job, "--json"}).json()["job"]["joining"], "spiral");
}

TEST_F(SnapshotCommand, ExportsJsonWithTheSameNumbers) {
    const Outcome outcome =
        psicarve({"snapshot", "export", save("a.job", small_table()), "--format", "json"});
    EXPECT_EQ(outcome.exit_code, 0);
    const auto job = outcome.json();
    ASSERT_TRUE(job.is_object()) << outcome.out;
    EXPECT_EQ(job["layers"], 2);
    EXPECT_EQ(job["points"], 3);
    EXPECT_EQ(job["joining"], "continuous");
    EXPECT_EQ(job["y_pulses"], nlohmann::json::parse("[100,300]"));
    EXPECT_EQ(job["r_left_pulses"], nlohmann::json::parse("[[4001,4002,4003],[4004,4005,4006]]"));
    EXPECT_EQ(job["r_right_pulses"], nlohmann::json::parse("[[5001,5002,5003],[5004,5005,5006]]"));
    EXPECT_EQ(job["slice_report"]["open_points"], 7);
}

TEST_F(SnapshotCommand, DiffFindsNothingBetweenTheSame) {
    const std::string a = save("a.job", small_table());
    const std::string b = save("b.job", small_table());
    const Outcome outcome = psicarve({"snapshot", "diff", a, b});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.out, "no difference\n");
    EXPECT_EQ(psicarve({"snapshot", "diff", a, b, "--json"}).json()["same"], true);
}

TEST_F(SnapshotCommand, DiffNamesPointsProfileKeysAndHowMany) {
    JobTable changed = small_table();
    changed.r_right_pulses[4] += 1;
    changed.r_right_pulses[5] += 2;
    Profile profile;
    profile.r1.speed_mm_s = 8.5;
    changed.profile_toml = profile_to_toml(profile);
    const std::string a = save("a.job", small_table());
    const std::string b = save("b.job", changed);
    const Outcome outcome = psicarve({"snapshot", "diff", a, b});
    EXPECT_EQ(outcome.exit_code, 6);
    EXPECT_NE(
        outcome.out.find("r_right_pulses (2 points differ, the first of layer 1, point 1): 5005 | 5006"),
        std::string::npos)
        << outcome.out;
    EXPECT_NE(outcome.out.find("profile axis.r1.speed_mm_s: 10.0 | 8.5"), std::string::npos) << outcome.out;
    EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 2);
    EXPECT_EQ(psicarve({"snapshot", "diff", a, b, "--json"}).json()["differences"].size(), 2U);
}

TEST_F(SnapshotCommand, DiffComparesStatusAndRecorder) {
    Snapshot before;
    before.status = CoreStatus{};
    before.status->state = MachineState::ready;
    before.status->heartbeat = 1;
    FlightRecord record{};
    record.tick = 12;
    record.kind = RecordKind::command;
    record.code = static_cast<std::uint16_t>(CommandKind::home);
    before.records = {record};
    Snapshot after = before;
    after.status->state = MachineState::alarm;
    after.status->alarm_cause = AlarmCause::limit;
    after.records[0].tick = 13;
    const Outcome outcome = psicarve(
        {"snapshot", "diff", save("a.snap", small_table(), before), save("b.snap", small_table(), after)});
    EXPECT_EQ(outcome.exit_code, 6);
    EXPECT_NE(outcome.out.find("status state: \"ready\" | \"alarm\""), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("flight recorder entry 0: tick 12  command home"), std::string::npos)
        << outcome.out;
}

FlightRecord of_program(ProgramEvent event, std::int64_t value, std::uint32_t sequence = 0,
                        std::uint8_t detail = 0) {
    FlightRecord record{};
    record.kind = RecordKind::program;
    record.code = recorded_code(event, detail);
    record.axis = kNoAxis;
    record.value = value;
    record.answer = sequence;
    return record;
}

TEST_F(SnapshotCommand, InfoTellsWhereAProgramWas) {
    Snapshot rest;
    rest.status = CoreStatus{};
    rest.status->state = MachineState::held;
    rest.records = {of_program(ProgramEvent::begun, 7, 0, 1), of_program(ProgramEvent::line, 4, 9),
                    of_program(ProgramEvent::held, 8, 34, 3)};
    const std::string held = save("a.snap", small_table(), rest);
    const Outcome plain = psicarve({"snapshot", "info", held});
    EXPECT_NE(plain.out.find("program    line 8: held, tool change\n"), std::string::npos) << plain.out;
    EXPECT_NE(plain.out.find("tick 0  program begun no. 7, single block  r1 0"), std::string::npos);
    EXPECT_NE(plain.out.find("tick 0  program line 4 (record 9)  r1 0"), std::string::npos) << plain.out;
    EXPECT_NE(plain.out.find("program line 8 (record 34): held, tool change  r1"), std::string::npos);
    const auto info = psicarve({"snapshot", "info", held, "--json"}).json();
    EXPECT_EQ(info["program"], nlohmann::json::parse(R"({"number":7,"line":8,"sequence":34,"is_running":true,
                                                         "hold":"tool change","is_done":false})"));
    EXPECT_EQ(info["records"][0]["kind"], "program");
    EXPECT_EQ(info["records"][0]["code"], "begun");
    EXPECT_EQ(info["records"][0]["program"],
              nlohmann::json::parse(R"({"number":7,"optional_stop":false,"single":true})"));
    EXPECT_EQ(info["records"][1]["program"], nlohmann::json::parse(R"({"line":4,"sequence":9})"));
    EXPECT_EQ(info["records"][2]["code"], "held");
    EXPECT_EQ(info["records"][2]["program"]["hold"], "tool change");

    rest.status->state = MachineState::alarm;
    rest.records.push_back(of_program(ProgramEvent::ended, 8, 34, 2));
    const std::string ended = save("b.snap", small_table(), rest);
    const Outcome broken = psicarve({"snapshot", "info", ended});
    EXPECT_NE(broken.out.find("program    the last one ended in line 8 of its program; gcode run FILE "
                              "--from-line 8 begins where"),
              std::string::npos)
        << broken.out;
    EXPECT_NE(broken.out.find("program line 8 (record 34): ended, alarm"), std::string::npos) << broken.out;
    EXPECT_EQ(psicarve({"snapshot", "info", ended, "--json"}).json()["records"][3]["program"]["how"],
              "alarm");
    EXPECT_TRUE(
        psicarve({"snapshot", "info", save("c.job", small_table()), "--json"}).json()["program"].is_null());
}

TEST_F(SnapshotCommand, InfoTellsWhatWasSwitchedAndHowOftenAProgramStarved) {
    Snapshot rest;
    rest.status = CoreStatus{};
    rest.records = {of_program(ProgramEvent::begun, 7), of_program(ProgramEvent::held, 8, 34, 5)};
    rest.records.back().axis = 3;
    for (const CommandKind kind :
         {CommandKind::rapid_override, CommandKind::single, CommandKind::optional_stop}) {
        FlightRecord record{};
        record.kind = RecordKind::command;
        record.code = static_cast<std::uint16_t>(kind);
        record.axis = kNoAxis;
        record.value = kind == CommandKind::rapid_override ? 40 : 1;
        record.answer = static_cast<std::uint32_t>(AnswerKind::done);
        rest.records.push_back(record);
    }
    const std::string path = save("a.snap", small_table(), rest);
    const Outcome plain = psicarve({"snapshot", "info", path});
    for (const char* told :
         {"program line 8 (record 34): held, starved 3 times  r1", "command override of rapids done 40  r1",
          "command single done on  r1", "command optional-stop done on  r1"})
        EXPECT_NE(plain.out.find(told), std::string::npos) << told << "\n" << plain.out;
    const auto info = psicarve({"snapshot", "info", path, "--json"}).json();
    EXPECT_EQ(info["records"][1]["program"]["starvations"], 3);
    EXPECT_TRUE(info["records"][1]["axis"].is_null());
}

// It goes on without a word, and its line is told a second later at the latest.
TEST_F(SnapshotCommand, InfoSaysThatAProgramStarvesOnlyWhileTheMachineRests) {
    for (const MachineState state : {MachineState::held, MachineState::carving}) {
        Snapshot rest;
        rest.status = CoreStatus{};
        rest.status->state = state;
        rest.records = {of_program(ProgramEvent::begun, 7), of_program(ProgramEvent::held, 8, 34, 5)};
        const std::string path = save("a.snap", small_table(), rest);
        const bool starves = state == MachineState::held;
        const auto program = psicarve({"snapshot", "info", path, "--json"}).json()["program"];
        EXPECT_EQ(program["hold"].is_null(), !starves) << program;
        const Outcome text = psicarve({"snapshot", "info", path});
        EXPECT_EQ(text.out.find("line 8: held, starved") != std::string::npos, starves) << text.out;
        EXPECT_NE(text.out.find("program    line 8"), std::string::npos) << text.out;
    }
}

TEST_F(SnapshotCommand, InfoTellsJobStatusAndTheNewestRecords) {
    Snapshot rest;
    rest.status = CoreStatus{};
    rest.status->state = MachineState::held;
    rest.status->heartbeat = 1;
    for (std::uint64_t tick = 1; tick <= 30; ++tick) {
        FlightRecord record{};
        record.tick = tick;
        record.kind = RecordKind::state_change;
        record.code = static_cast<std::uint16_t>(MachineState::held);
        record.axis = kNoAxis;
        rest.records.push_back(record);
    }
    const std::string path = save("a.snap", small_table(), rest);
    const auto info = psicarve({"snapshot", "info", path, "--json", "--records", "5"}).json();
    ASSERT_TRUE(info.is_object());
    EXPECT_EQ(info["kind"], "snapshot");
    EXPECT_EQ(info["job"]["layers"], 2);
    EXPECT_EQ(info["job"]["r_pulses"], nlohmann::json::parse("[4001,5006]"));
    EXPECT_EQ(info["job"]["profile_name"], "default");
    EXPECT_EQ(info["status"]["state"], "held");
    EXPECT_EQ(info["record_count"], 30);
    ASSERT_EQ(info["records"].size(), 5U);
    EXPECT_EQ(info["records"][0]["tick"], 26);
    EXPECT_EQ(info["records"][4]["code"], "held");
    const Outcome plain = psicarve({"snapshot", "info", path});
    EXPECT_EQ(plain.exit_code, 0);
    EXPECT_NE(plain.out.find("the last 20 of 30 entries"), std::string::npos) << plain.out;
    EXPECT_NE(plain.out.find("small.stl"), std::string::npos);
}

}  // namespace
}  // namespace psicarve::test
