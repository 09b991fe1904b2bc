// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/two_process/cli_machine_rig.hpp"

namespace psicarve::test {
namespace {

class Status : public Machine {};

TEST_F(Status, TheTableStandsWithinATurnAndItsTurnsAreCounted) {
    start_core();
    ASSERT_EQ(run({"home"}).exit_code, 0);
    ASSERT_EQ(run({"jog", "psi", "765"}).exit_code, 0);
    const auto status = run({"status", "--json"}).json();
    const std::int64_t pulses = status["position_pulses"]["psi"].get<std::int64_t>();
    ASSERT_GT(pulses, 6400);
    EXPECT_EQ(status["position"]["psi_turns"], pulses / 6400);
    EXPECT_DOUBLE_EQ(status["position"]["psi_deg"].get<double>(),
                     static_cast<double>(pulses % 6400) * 360.0 / 6400.0);
    EXPECT_DOUBLE_EQ(status["position"]["y_mm"].get<double>(),
                     status["position_pulses"]["y"].get<double>() / 400.0);
    EXPECT_NE(run({"status"}).out.find(" deg and 2 turns ("), std::string::npos) << run({"status"}).out;
    ASSERT_EQ(run({"jog", "psi", "-1500"}).exit_code, 0);
    const auto below = run({"status", "--json"}).json();
    EXPECT_EQ(below["position"]["psi_turns"], -3);
    EXPECT_GE(below["position"]["psi_deg"].get<double>(), 0.0);
    EXPECT_LT(below["position"]["psi_deg"].get<double>(), 360.0);
    write("other.toml", "[axis.psi]\npulses_per_rev = 3200\n");
    EXPECT_EQ(run({"status", "--json", "--profile", file("other.toml")}).json()["position"], nullptr)
        << "degrees of another machine";
}

TEST_F(Status, WhereNoProfileIsNamedTheCoresIsTheOneThatItWasStartedWith) {
    Profile fine;
    fine.r1.pulses_per_mm = 500.0;
    write("fine.toml", profile_to_toml(fine));
    start_core({"--profile", file("fine.toml")});
    ASSERT_EQ(run({"home"}).exit_code, 0);
    ASSERT_EQ(run({"jog", "r1", "-3"}).exit_code, 0);
    const auto status = run({"status", "--json"}).json();
    EXPECT_DOUBLE_EQ(status["position"]["r1_mm"].get<double>(),
                     status["position_pulses"]["r1"].get<double>() / 500.0);
    EXPECT_NE(run({"status"}).out.find("position   r1 56.748 mm (28374), "), std::string::npos)
        << run({"status"}).out;
    EXPECT_EQ(run({"pins"}).out, run({"pins", "--profile", file("fine.toml")}).out);
    write("default.toml", profile_to_toml(Profile{}));
    EXPECT_EQ(run({"status", "--json", "--profile", file("default.toml")}).json()["position"], nullptr)
        << "the one that is named counts";
    write("fine.toml", profile_to_toml(Profile{}));
    EXPECT_EQ(run({"status", "--json"}).json()["position"], nullptr) << "changed since";
}

TEST_F(Status, AProgramTakesTheProfileThatItsCoreWasStartedWith) {
    Profile fine;
    fine.r1.pulses_per_mm = 500.0;
    write("fine.toml", profile_to_toml(fine));
    write("to.ngc", "G21 G90 F300\nG0 X40.002\nM2\n");
    start_core({"--profile", file("fine.toml")});
    ASSERT_EQ(run({"home"}).exit_code, 0);
    const auto r1_pulses = [&] { return run({"status", "--json"}).json()["position_pulses"]["r1"]; };
    const Outcome done = run({"gcode", "run", file("to.ngc")});
    EXPECT_EQ(done.exit_code, 0) << done.error;
    EXPECT_EQ(r1_pulses(), 20'001);
    write("fine.toml", profile_to_toml(Profile{}));
    const Outcome unknown = run({"gcode", "run", file("to.ngc")});
    EXPECT_EQ(unknown.exit_code, 4);
    EXPECT_NE(unknown.error.find("the core has another profile than the built-in one"), std::string::npos)
        << unknown.error;
    EXPECT_EQ(r1_pulses(), 20'001);
}

TEST_F(Status, NamesTheLineInWhichAnAlarmBrokeAProgramOff) {
    start_core();
    ASSERT_EQ(run({"home"}).exit_code, 0);
    write("stops.ngc", "G21 G90 F300\nG0 X40\nM0\nG1 X39\nM2\n");
    RunningProgram running{"psicarve", {"gcode", "run", file("stops.ngc"), "--segment", segment_}};
    ASSERT_TRUE(eventually([&] { return state() == MachineState::held; }));
    ASSERT_EQ(run({"estop"}).exit_code, 0);
    EXPECT_EQ(running.wait(), 4);
    EXPECT_NE(
        running.error().find("; it ended in line 3 of its program; gcode run FILE --from-line 3 begins "),
        std::string::npos)
        << running.error();
    EXPECT_EQ(running.error().find(".;"), std::string::npos) << running.error();
    EXPECT_NE(run({"status"}).out.find("program    the last one (stops.ngc) ended in line 3 "),
              std::string::npos)
        << run({"status"}).out;
    const auto told = run({"status", "--json"}).json();
    EXPECT_EQ(told["program"], nullptr);
    EXPECT_EQ(told["last_program"]["line"], 3);
    EXPECT_EQ(told["last_program"]["is_done"], false);
}

}  // namespace
}  // namespace psicarve::test
