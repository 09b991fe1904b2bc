// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/thoroughness.hpp"
#include "tests/two_process/cli_machine_rig.hpp"
#include "tests/two_process/quick_planning.hpp"

namespace psicarve::test {
namespace {

TEST_F(Machine, CarvesStepByStep) {
    start_core();
    const Outcome published = run({"publish", job("3", "9"), "--json"});
    ASSERT_EQ(published.exit_code, 0) << published.error;
    EXPECT_EQ(published.json()["accepted"], true);
    EXPECT_EQ(run({"home"}).out, "home: the machine is ready\n");
    const Outcome started = run({"start", "--json"});
    ASSERT_EQ(started.exit_code, 0) << started.error;
    EXPECT_EQ(started.json()["state"], "waiting");
    EXPECT_EQ(started.json()["homed"]["psi"], true);
    ASSERT_EQ(run({"start-interpolation"}).exit_code, 0);
    ASSERT_TRUE(eventually([&] { return state() == MachineState::ready; }));
    const auto status = run({"status", "--json"}).json();
    EXPECT_EQ(status["points_done"], 27);
    EXPECT_EQ(status["alarm_cause"], nullptr);
}

TEST_F(Machine, CarvesOneLayerAlone) {
    start_core();
    ASSERT_EQ(run({"publish", job("3", "9")}).exit_code, 0);
    ASSERT_EQ(run({"home"}).exit_code, 0);
    const Outcome too_many = run({"start", "--from-layer", "2", "--layers", "2"});
    EXPECT_EQ(too_many.exit_code, 4);
    EXPECT_NE(too_many.error.find("not so many layers: 3, and the first is 0"), std::string::npos)
        << too_many.error;
    const Outcome behind = run({"start", "--from-layer", "60"});
    EXPECT_EQ(behind.exit_code, 4);
    EXPECT_NE(behind.error.find("not so many layers: 3, and"), std::string::npos) << behind.error;
    ASSERT_EQ(run({"start", "--from-layer", "1", "--layers", "1", "--carve"}).exit_code, 0);
    ASSERT_TRUE(eventually([&] { return state() == MachineState::ready; }));
    const auto status = run({"status", "--json"}).json();
    EXPECT_EQ(status["points_done"], 18);
    EXPECT_EQ(status["layer"], 1);
}

TEST_F(Machine, OverrideIsShownByTheStatusUntilAnotherJobIsPublished) {
    start_core();
    EXPECT_EQ(run({"override", "80"}).out, "override: 80 % of the planned feed; the machine is off\n");
    EXPECT_EQ(run({"status", "--json"}).json()["override_percent"], 80);
    EXPECT_NE(run({"status"}).out.find("override   80 %"), std::string::npos);
    ASSERT_EQ(run({"publish", job("3", "9")}).exit_code, 0);
    EXPECT_EQ(run({"status", "--json"}).json()["override_percent"], 100);
    EXPECT_EQ(run({"override", "200", "--json"}).json()["override_percent"], 200);
}

TEST_F(Machine, CarveUsesTheRunningCoreAndLeavesItRunning) {
    start_core();
    const Outcome outcome = run({"carve", job("3", "9"), "--json"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
    EXPECT_EQ(outcome.json()["verified"], true);
    EXPECT_TRUE(core_pid().has_value());
    const Outcome again = run({"carve", file("box.job")});
    EXPECT_EQ(again.exit_code, 0) << again.error;
}

TEST_F(Machine, ARunningCoresPinsAreDrawnTracedAndJudged) {
    start_core();
    const std::string path = job("6", "40");
    for (const char* name : {"pins.vcd", "pins.trace"}) {  // the second time without homing, psi turned on
        const Outcome outcome =
            run({"carve", path, "--trace", file(name), "--picture", file("out.png"), "--json"});
        ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
        const auto report = outcome.json();
        EXPECT_EQ(report["verified"], true);
        EXPECT_EQ(report["verification"]["points_visited"], 240);
        EXPECT_EQ(report["picture"], file("out.png"));
        EXPECT_TRUE(std::filesystem::remove(file("out.png")));
        const Outcome judged = psicarve({"verify", path, file(name), "--json"});
        EXPECT_EQ(judged.exit_code, 0) << judged.error;
        EXPECT_EQ(judged.json()["pulses"], report["pulses"]);
    }
}

TEST_F(Machine, ThePieceOfARunningCoreIsComparedWithTheModelWhenAskedFor) {
    start_core();
    std::vector<std::string> carve{"carve", box_stl("box.stl"), "--layers", "4",     "--points",
                                   "9",     "--tool",           "ball:2",   "--json"};
    EXPECT_FALSE(run(carve).json().contains("deviation")) << "it does not wait for a figure";
    carve.insert(carve.end(), {"--deviation", file("box.png")});
    const auto report = run(carve).json();
    ASSERT_TRUE(report.contains("deviation")) << report;
    EXPECT_GT(report["deviation"]["places"].get<int>(), 100);
}

bool is_tick_gap(const nlohmann::json& report) {
    return !report["alarms"].empty() && report["alarms"].back()["cause"] == "tick gap";
}

// A computer that misses ticks may break rule 3; it must not lose a pulse on the way here.
TEST_F(Machine, ARunningCoreByTheWallClockIsJudgedAsWell) {
    Profile profile = two_process::slow_machine();
    two_process::leave_one_sensor(profile);
    write("slow.toml", profile_to_toml(profile));
    start_core({"--clock", "real", "--profile", file("slow.toml")});
    const std::vector<std::string> slice{
        "slice",     box_stl("box.stl", 1.0), "-o", file("slow.job"), "--layers", "1", "--points", "3",
        "--profile", file("slow.toml")};
    ASSERT_EQ(psicarve(slice).exit_code, 0);
    const auto carve = [&] {
        return run({"carve", file("slow.job"), "--trace", file("pins.vcd"), "--json"}).json();
    };
    nlohmann::json report = carve();
    // A host that takes this computer away for longer than a rotor coasts is rightly an alarm.
    for (int tries = 1; tries < kMostTries && is_tick_gap(report); ++tries) {
        run({"reset-alarm"});
        report = carve();
    }
    ASSERT_TRUE(report["verified"].is_boolean()) << report;
    EXPECT_EQ(report["verification"]["points_visited"], 3) << report;
    const auto judged = psicarve({"verify", file("slow.job"), file("pins.vcd"), "--json"}).json();
    EXPECT_EQ(judged["verified"], report["verification"]["verified"]);
    EXPECT_EQ(judged["pulses"], report["pulses"]);
}

TEST_F(Machine, AKilledReaderOfThePinsHoldsUpNobodyAndLeavesThemToTheNext) {
    const QuickPlanning quick{file("quick.toml")};
    start_core();
    const std::string path = is_thorough() ? long_job() : job("80", "200");
    RunningProgram killed{"psicarve", {"carve", path, "--trace", file("killed.vcd"), "--segment", segment_}};
    ASSERT_TRUE(makes_it_carve(killed));
    killed.send(SIGSTOP);
    ASSERT_TRUE(eventually([&] { return killed.is_stopped(); }));
    // On the virtual clock a trace stays whole: nothing is carved that its reader's pipe has no room for.
    ASSERT_EQ(state(), MachineState::carving) << "it ended before its reader was killed";
    killed.send(SIGKILL);
    killed.wait();
    ASSERT_TRUE(eventually([&] { return state() == MachineState::ready; }));
    ASSERT_TRUE(eventually([&] {
        return run({"carve", job("3", "9"), "--picture", file("out.png")}).exit_code == 0;
    }));
}

/// Has the pins recorded and renews nothing: its lease ends by itself.
TEST_F(Machine, PinsThatAnotherHasRecordedAreRefusedBeforeAnythingMovesOrIsOverwritten) {
    start_core();
    write("old.vcd", "precious");
    auto segment = Segment::attach(segment_);
    ASSERT_TRUE(segment);
    Command record{};
    record.kind = CommandKind::record;
    record.value = static_cast<double>(RecordingForm::binary);
    record.lease_token = 77;
    const auto asked = send_command(*segment, record, milliseconds{10'000});
    ASSERT_TRUE(asked) << asked.error().message;
    const Outcome outcome = run({"carve", job("3", "9"), "--trace", file("old.vcd"), "--json"});
    EXPECT_EQ(outcome.exit_code, 4);
    EXPECT_EQ(outcome.json()["error"]["code"], "machine_refused") << outcome.out;
    EXPECT_NE(outcome.error.find("another process has the pins recorded"), std::string::npos)
        << outcome.error;
    EXPECT_EQ(text_of(file("old.vcd")), "precious");
    EXPECT_EQ(state(), MachineState::off);
    // A piece that was not asked for is no reason to refuse.
    const Outcome unseen =
        run({"carve", box_stl("box.stl"), "--layers", "3", "--points", "9", "--tool", "ball:2", "--json"});
    EXPECT_EQ(unseen.exit_code, 0) << unseen.error;
    EXPECT_TRUE(unseen.json()["verified"] == nullptr || unseen.json()["verified"] == true);
}

TEST_F(Machine, ATraceOfARunningCoreOntoAFullDiskIsAnErrorAfterTheWork) {
    start_core();
    const Outcome outcome = run({"carve", job("3", "9"), "--trace", "/dev/full", "--json"});
    EXPECT_EQ(outcome.exit_code, 4) << outcome.error;
    EXPECT_NE(outcome.error.find("trace /dev/full: No space left on device"), std::string::npos);
    EXPECT_EQ(outcome.json()["verified"], true);
}

// The usage is right; it is the running core that cannot do it.
TEST_F(Machine, TheClockOfARunningCoreIsWhatItIs) {
    start_core();
    const Outcome outcome = run({"carve", job("3", "9"), "--json", "--real-time"});
    EXPECT_EQ(outcome.exit_code, 4);
    EXPECT_EQ(outcome.json()["error"]["code"], "machine_refused") << outcome.out;
    EXPECT_NE(outcome.error.find("served by a running core"), std::string::npos) << outcome.error;
    EXPECT_NE(outcome.error.find("another --segment"), std::string::npos) << outcome.error;
}

/// The report of a job that a core did not begin, after one that it carved.
void expect_nothing_carved(const Outcome& outcome) {
    EXPECT_EQ(outcome.exit_code, 4) << outcome.error;
    const auto report = outcome.json();
    EXPECT_EQ(report["error"]["code"], "machine_refused") << outcome.out;
    EXPECT_EQ(report["carve_seconds"], nullptr);
    EXPECT_EQ(report["total_seconds"], 0.0);
    for (const char* axis : {"r1", "r2", "psi", "y"}) EXPECT_EQ(report["pulses"][axis], 0) << axis;
}

TEST_F(Machine, AJobThatIsNotBegunHasNoFiguresOfTheOneBefore) {
    start_core();
    const std::string path = job("3", "9");
    ASSERT_EQ(run({"carve", path}).exit_code, 0);
    ASSERT_EQ(run({"estop"}).exit_code, 0);
    expect_nothing_carved(run({"carve", path, "--json"}));
    const Outcome text = run({"carve", path});
    EXPECT_NE(text.out.find("pulses     r1 0, r2 0, psi 0, y 0"), std::string::npos) << text.out;
}

TEST_F(Machine, AJobThatIsNotAcceptedHasNoFiguresOfTheOneBefore) {
    start_core();
    ASSERT_EQ(run({"carve", job("3", "9")}).exit_code, 0);
    write("other.toml", "[axis.r1]\nspeed_mm_s = 7.0\n");
    const Outcome refused =
        run({"carve", box_stl("box.stl"), "--layers", "3", "--profile", file("other.toml"), "--json"});
    expect_nothing_carved(refused);
    EXPECT_NE(refused.error.find("axis.r1.speed_mm_s"), std::string::npos) << refused.error;
}

TEST_F(Machine, RefusalsAreReportedWithTheirReason) {
    start_core();
    const Outcome outcome = run({"start", "--json"});
    EXPECT_EQ(outcome.exit_code, 4);
    EXPECT_EQ(outcome.json()["error"]["code"], "machine_refused") << outcome.out;
    EXPECT_EQ(run({"resume"}).exit_code, 4);
    EXPECT_EQ(run({"back-off", "r1"}).exit_code, 4);
}

TEST_F(Machine, AJobForAnotherMachineIsRefusedByTheCoreWithItsKeys) {
    write("other.toml", "[axis.r1]\nspeed_mm_s = 7.0\n");
    start_core({"--profile", file("other.toml")});
    const Outcome outcome = run({"publish", job("3", "9")});
    EXPECT_EQ(outcome.exit_code, 4) << outcome.out;
    EXPECT_NE(outcome.error.find("axis.r1.speed_mm_s"), std::string::npos) << outcome.error;
}

TEST_F(Machine, EmergencyStopAndBack) {
    start_core();
    ASSERT_EQ(run({"home"}).exit_code, 0);
    const Outcome stopped = run({"estop"});
    EXPECT_EQ(stopped.exit_code, 0) << stopped.error;
    EXPECT_NE(stopped.out.find("in alarm (emergency stop"), std::string::npos) << stopped.out;
    EXPECT_EQ(run({"home"}).exit_code, 4);
    EXPECT_EQ(run({"carve", job("3", "9")}).exit_code, 4);
    EXPECT_EQ(run({"reset-alarm"}).exit_code, 0);
    EXPECT_EQ(run({"home"}).exit_code, 0);
    EXPECT_EQ(run({"reset-height"}).exit_code, 0);
    EXPECT_EQ(run({"stop"}).exit_code, 0);
}

TEST_F(Machine, AJobIsHeldResumedAndStopped) {
    const QuickPlanning quick{file("quick.toml")};
    start_core();
    ASSERT_EQ(run({"home"}).exit_code, 0);
    ASSERT_EQ(run({"publish", long_job()}).exit_code, 0);
    ASSERT_EQ(run({"start", "--carve"}).exit_code, 0);
    ASSERT_TRUE(eventually([&] { return state() == MachineState::carving; }));
    const Outcome held = run({"hold", "--json"});
    ASSERT_EQ(held.exit_code, 0) << held.error;
    EXPECT_EQ(held.json()["state"], "held");
    EXPECT_EQ(run({"resume"}).exit_code, 0);
    const Outcome stopped = run({"stop", "--json"});
    EXPECT_EQ(stopped.exit_code, 0) << stopped.error;
    EXPECT_EQ(stopped.json()["state"], "ready");
}

TEST_F(Machine, WatchGoesOnLineByLineUntilInterrupted) {
    start_core();
    RunningProgram watch{"psicarve", {"status", "--watch", "--segment", segment_}};
    ASSERT_EQ(run({"home"}).exit_code, 0);
    EXPECT_TRUE(eventually(
        [&] { return watch.out_so_far().find("ready; job") != std::string::npos || watch.has_ended(); }));
    watch.send(SIGINT);
    EXPECT_EQ(watch.wait(), 0) << watch.error();
    EXPECT_NE(watch.out().find("ready; job"), std::string::npos) << watch.out();
    EXPECT_EQ(watch.out().find('\033'), std::string::npos);
}

TEST_F(Machine, PublishWithoutACoreWaitsForOne) {
    const Outcome published = run({"publish", job("3", "9"), "--json"});
    ASSERT_EQ(published.exit_code, 0) << published.error;
    EXPECT_EQ(published.json()["accepted"], nullptr);
    start_core();
    ASSERT_TRUE(eventually([&] { return run({"status", "--json"}).json()["job_generation"] == 1; }));
    ASSERT_EQ(run({"home"}).exit_code, 0);
    EXPECT_EQ(run({"start"}).exit_code, 0);
}

}  // namespace
}  // namespace psicarve::test
