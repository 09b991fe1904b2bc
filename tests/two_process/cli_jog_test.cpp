// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <memory>

#include "shared/segment/segment.hpp"
#include "shared/segment/shared_record.hpp"
#include "tests/hmi/cli/program_run.hpp"
#include "tests/two_process/slow_machine.hpp"

namespace psicarve::test {
namespace {

using std::chrono::milliseconds;

/// A core on a segment of its own, homed.
class Jogging : public CliTest {
protected:
    void start_core(const std::vector<std::string>& more) {
        std::vector<std::string> arguments{"--segment", segment_};
        arguments.insert(arguments.end(), more.begin(), more.end());
        core_ = std::make_unique<RunningProgram>("psicarve-rtcore", arguments);
        ASSERT_TRUE(eventually([&] {
            const auto segment = Segment::attach(segment_);
            return segment && segment->core_pid().has_value();
        }));
        ASSERT_EQ(run({"home"}).exit_code, 0);
        true_start_ = status().sim_true_position_pulses[index_of(Axis::psi)];
    }
    /// The core runs on the real clock, so that a lease is what it is for the operator. Without sensors it is
    /// homed at once.
    void start_real_core() {
        Profile profile = two_process::slow_machine();
        two_process::take_sensors_away(profile);
        write("slow.toml", profile_to_toml(profile));
        start_core({"--clock", "real", "--profile", file("slow.toml")});
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
    std::int64_t psi_pulses() const { return status().position_pulses[index_of(Axis::psi)]; }
    std::unique_ptr<RunningProgram> begin_turning() const {
        // The longest lease: a computer that stands still for a while is not what is tried here.
        const std::int64_t before = psi_pulses();
        auto jog = std::make_unique<RunningProgram>(
            "psicarve", std::vector<std::string>{"jog", "psi", "+", "--lease", "2", "--segment", segment_});
        const auto turns = [&] { return psi_pulses() > before + 10; };
        EXPECT_TRUE(eventually([&] { return turns() || jog->has_ended(); }));
        EXPECT_TRUE(turns()) << "the jog ended: " << jog->outcome().error;
        return jog;
    }
    void expect_at_rest_where_the_machine_is() const {
        const CoreStatus end = status();
        EXPECT_EQ(end.alarm_cause, AlarmCause::none);
        // Without an index the count began anywhere; from then on both moved alike.
        EXPECT_EQ(end.sim_true_position_pulses[index_of(Axis::psi)] - true_start_, psi_pulses());
        EXPECT_EQ(end.sim_stalls[index_of(Axis::psi)], 0U);
    }

    std::unique_ptr<RunningProgram> core_;
    std::int64_t true_start_ = 0;
};

TEST_F(Jogging, AKilledClientsJogEndsByItself) {
    start_real_core();
    const auto jog = begin_turning();
    jog->send(SIGKILL);
    ASSERT_TRUE(eventually([&] { return status().state == MachineState::ready; }));
    EXPECT_EQ(status().move_end, MoveEnd::lease_gone);
    expect_at_rest_where_the_machine_is();
    EXPECT_EQ(run({"jog", "psi", "-90"}).exit_code, 0);
}

TEST_F(Jogging, AnOutputIsTestedWithTheDrivesOffWhileTheProgramIsThere) {
    start_real_core();
    const Outcome refused = run({"pins", "spindle"});
    EXPECT_EQ(refused.exit_code, 4);
    EXPECT_NE(refused.error.find("drives-off first"), std::string::npos) << refused.error;
    ASSERT_EQ(run({"drives-off"}).out, "drives-off: the machine is off\n");
    EXPECT_EQ(status().homed_mask, 0);
    {
        RunningProgram held{"psicarve", {"pins", "spindle", "--lease", "2", "--segment", segment_}};
        const auto is_spindle_alone = [&] {
            return (status().signals & kOutputMask) == bit_of(Signal::spindle);
        };
        ASSERT_TRUE(eventually(is_spindle_alone));
        EXPECT_NE(run({"home"}).error.find("end the test first"), std::string::npos);
        held.send(SIGKILL);
        ASSERT_TRUE(eventually([&] { return status().state == MachineState::off; }));
    }
    EXPECT_EQ(status().signals & kOutputMask, 0U);
    const Outcome sent = run({"pins", "r1_step", "--pulses", "20", "--rate", "500", "--lease", "2"});
    ASSERT_EQ(sent.exit_code, 0) << sent.error;
    // The machine's own count may come a look later than the state.
    const auto ignored = [&] { return status().sim_ignored_pulses[index_of(Axis::r1)]; };
    EXPECT_TRUE(eventually([&] { return ignored() == 20; })) << ignored();
    EXPECT_EQ(run({"pins", "--json"}).json()["signals"]["spindle"]["level"], false);
    EXPECT_NE(run({"pins"}).out.find("spindle      out  low"), std::string::npos);
    EXPECT_EQ(run({"pins", "y_limit"}).exit_code, 2);
}

TEST_F(Jogging, AxesAreHomedOneByOne) {
    start_real_core();
    ASSERT_EQ(run({"home", "y", "psi"}).out, "home: the machine is ready\n");
    ASSERT_EQ(run({"drives-off"}).exit_code, 0);
    const Outcome too_early = run({"home", "psi"});
    EXPECT_EQ(too_early.exit_code, 4);
    EXPECT_NE(too_early.error.find("home r1 and r2 first"), std::string::npos) << too_early.error;
    ASSERT_EQ(run({"home", "r2", "r1"}).exit_code, 0);
    EXPECT_EQ(status().homed_mask, 0b0011);
    ASSERT_EQ(run({"home", "psi", "y"}).out, "home: the machine is ready\n");
    EXPECT_EQ(run({"home", "q"}).exit_code, 2);
}

TEST_F(Jogging, AStoppedClientsJogEndsByItselfAndTheClientSaysSo) {
    start_real_core();
    const auto jog = begin_turning();
    jog->send(SIGSTOP);
    ASSERT_TRUE(eventually([&] { return status().state == MachineState::ready; }));
    EXPECT_EQ(status().move_end, MoveEnd::lease_gone);
    expect_at_rest_where_the_machine_is();
    jog->send(SIGCONT);
    EXPECT_EQ(jog->wait(), 4);
    EXPECT_NE(jog->error().find("ended early"), std::string::npos) << jog->error();
    EXPECT_EQ(status().state, MachineState::ready);
}

TEST_F(Jogging, AnInterruptedClientLetsGo) {
    start_real_core();
    const auto jog = begin_turning();
    jog->send(SIGINT);
    EXPECT_EQ(jog->wait(), 0) << jog->error();
    EXPECT_EQ(status().move_end, MoveEnd::released);
    expect_at_rest_where_the_machine_is();
}

TEST_F(Jogging, ALeaseIsAsLongAsTheCoreAllows) {
    for (const std::string lease : {"0.09", "2.1", "-1", "nan"}) {
        const Outcome refused = run({"jog", "psi", "+", "--lease=" + lease});
        EXPECT_EQ(refused.exit_code, 2) << lease;
        EXPECT_EQ(run({"pins", "spindle", "--lease=" + lease}).exit_code, 2) << lease;
    }
    start_core({"--clock", "virtual"});
    const Outcome refused = run({"jog", "psi", "+", "--lease", "3"});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_NE(refused.error.find("--lease: from 0.1 to 2 seconds"), std::string::npos) << refused.error;
    EXPECT_EQ(run({"jog", "psi", "9", "--lease", "2"}).exit_code, 0);
}

TEST_F(Jogging, AStopEndsAJogAndTheClientSaysSo) {
    start_real_core();
    const auto jog = begin_turning();
    EXPECT_EQ(run({"stop"}).exit_code, 0);
    EXPECT_EQ(jog->wait(), 4);
    EXPECT_NE(jog->error().find("somebody stopped"), std::string::npos) << jog->error();
    expect_at_rest_where_the_machine_is();
}

TEST_F(Jogging, ByADistanceAndMovesEndWhereTheyAreSent) {
    start_core({"--clock", "virtual"});
    const Outcome moved = run({"move", "r1=30", "r2=25.5", "psi=90", "y=10", "--json"});
    ASSERT_EQ(moved.exit_code, 0) << moved.error;
    const auto position = [](const Outcome& outcome) { return outcome.json()["position_pulses"]; };
    EXPECT_EQ(position(moved), (nlohmann::json{{"r1", 12000}, {"r2", 10200}, {"psi", 1600}, {"y", 4000}}));
    EXPECT_EQ(moved.json()["command"], "move");
    EXPECT_EQ(moved.json()["move_end"], "reached");
    const Outcome jogged = run({"jog", "y", "-2.5", "--json"});
    ASSERT_EQ(jogged.exit_code, 0) << jogged.error;
    EXPECT_EQ(position(jogged)["y"], 3000);
    EXPECT_EQ(position(run({"jog", "y", "-", "--json"}))["y"], 0);
    EXPECT_EQ(position(run({"status", "--json"}))["r1"], 12000);
    EXPECT_EQ(run({"move", "y=1"}).out, "move: the machine is ready\n");
}

TEST_F(Jogging, ArcsAndStepwiseLinesEndWhereTheyAreSent) {
    start_core({"--clock", "virtual"});
    ASSERT_EQ(run({"move", "r1=30", "y=20"}).exit_code, 0);
    const auto position = [](const Outcome& outcome) { return outcome.json()["position_pulses"]; };
    const Outcome arc = run({"move", "r1=20", "y=30", "--centre", "r1=20,y=20", "--json"});
    ASSERT_EQ(arc.exit_code, 0) << arc.error;
    EXPECT_EQ(position(arc)["r1"], 8000);
    EXPECT_EQ(position(arc)["y"], 12000);
    // Three quarters of a turn back: both axes make three times a quarter's pulses.
    const auto emitted = arc.json()["emitted_pulses"]["y"].get<std::int64_t>();
    const Outcome back = run({"move", "r1=30", "y=20", "--centre", "r1=20,y=20", "--json"});
    ASSERT_EQ(back.exit_code, 0) << back.error;
    EXPECT_EQ(back.json()["emitted_pulses"]["y"], emitted + 3 * 4000);
    const Outcome line = run({"move", "r1=25.5", "y=10", "--stepwise", "--json"});
    ASSERT_EQ(line.exit_code, 0) << line.error;
    EXPECT_EQ(position(line)["r1"], 10200);
    EXPECT_EQ(position(line)["y"], 4000);
    const Outcome none = run({"move", "r1=30", "y=20", "--centre", "r1=20,y=20"});
    EXPECT_EQ(none.exit_code, 4);
    EXPECT_NE(none.error.find("not equally far from its centre"), std::string::npos) << none.error;
}

TEST_F(Jogging, ThePinsOfEveryKindOfMoveObeyTheRules) {
    for (const std::string profile : {"",
                                      "[axis.r1]\nbacklash_mm = 0.03\n[axis.y]\nbacklash_mm = 0.1\n"
                                      "[axis.r2]\nbacklash_mm = 0.05\n[axis.psi]\nbacklash_deg = 0.4\n"}) {
        write("machine.toml", profile);
        const std::string job = file("box.job");
        ASSERT_EQ(psicarve({"slice", box_stl("box.stl"), "-o", job, "--layers", "3", "--points", "9",
                            "--profile", file("machine.toml")})
                      .exit_code,
                  0);
        start_core({"--clock", "virtual", "--profile", file("machine.toml"), "--trace", file("pins.trace")});
        for (const std::string command :
             {"move r1=30 y=20", "move r1=30 y=20 --centre r1=20,y=20",
              "move r1=20 y=30 --centre r1=20,y=20 --clockwise", "move r1=25 y=10 --stepwise",
              "jog psi 123.4", "jog r2 -20 --speed 3", "jog r2 0.07", "jog y -",
              "move r1=50 r2=50 y=20 psi=10"}) {
            const Outcome outcome = run(words_of(command));
            ASSERT_EQ(outcome.exit_code, 0) << command << ": " << outcome.error;
        }
        ASSERT_EQ(run({"publish", job}).exit_code, 0);
        ASSERT_EQ(run({"start", "--carve"}).exit_code, 0);
        ASSERT_TRUE(eventually([&] { return status().job_end_tick != 0; }));
        core_->send(SIGTERM);
        ASSERT_EQ(core_->wait(), 0) << core_->error();
        const Outcome verified = psicarve({"verify", job, file("pins.trace")});
        EXPECT_EQ(verified.exit_code, 0) << verified.error << verified.out;
        core_.reset();
        ASSERT_TRUE(Segment::remove(segment_));
    }
}

TEST_F(Jogging, WhatTheMachineCannotDoIsRefusedWithTheReason) {
    start_core({"--clock", "virtual"});
    const auto expect_refused = [&](std::vector<std::string> arguments, const std::string& reason,
                                    const std::string& id) {
        arguments.emplace_back("--json");
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.exit_code, 4) << outcome.out;
        EXPECT_EQ(outcome.json()["error"]["code"], "machine_refused") << outcome.out;
        EXPECT_EQ(outcome.json()["error"]["id"], id) << outcome.out;
        EXPECT_NE(outcome.error.find(reason), std::string::npos) << outcome.error;
    };
    expect_refused({"move", "r1=61"}, "r1 would leave its travel, 0.000 mm to 60.000 mm", "outside_travel");
    expect_refused({"move", "r1=30", "y=-0.1"}, "y would leave its travel", "outside_travel");
    expect_refused({"jog", "r2", "-59"}, "r2 would go inside the core radius, 1.500 mm",
                   "inside_core_radius");
    expect_refused({"move", "psi=1e15"}, "no axis goes so far", "too_far");
    const auto arguments = run({"move", "r1=61", "--json"}).json()["error"]["arguments"];
    EXPECT_EQ(arguments.dump(), R"({"axis":"r1","command":"move","from_mm":0.0,"to_mm":60.0})");
    ASSERT_EQ(run({"estop"}).exit_code, 0);
    expect_refused({"jog", "r1", "-1"}, "not while alarm", "wrong_state");
    expect_refused({"spindle", "on"}, "not while alarm", "wrong_state");
}

TEST_F(Jogging, ASpeedThatAnAxisDoesNotHaveIsSaid) {
    start_core({"--clock", "virtual"});
    const Outcome fast = run({"jog", "r1", "-2", "--speed", "10.5"});
    EXPECT_EQ(fast.exit_code, 0) << fast.error;
    EXPECT_NE(fast.error.find("jog: r1 goes at 10 mm/s at most"), std::string::npos) << fast.error;
    const Outcome psi = run({"jog", "psi", "5", "--speed", "300"});
    EXPECT_NE(psi.error.find("psi goes at 225 deg/s at most"), std::string::npos) << psi.error;
    EXPECT_EQ(run({"jog", "r1", "-2", "--speed", "10"}).error, "");
    EXPECT_NE(run({"jog", "heads", "-2", "--speed", "11"}).error.find("r1 goes at"), std::string::npos);
}

TEST_F(Jogging, TheSpindleIsSwitchedByHand) {
    start_core({"--clock", "virtual"});
    const auto is_on = [&] {
        const auto outputs = run({"status", "--json"}).json()["outputs"];
        return std::find(outputs.begin(), outputs.end(), "spindle") != outputs.end();
    };
    ASSERT_EQ(run({"spindle", "on"}).exit_code, 0);
    EXPECT_TRUE(is_on());
    ASSERT_EQ(run({"spindle", "off"}).exit_code, 0);
    EXPECT_FALSE(is_on());
}

}  // namespace
}  // namespace psicarve::test
