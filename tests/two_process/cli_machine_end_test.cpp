// SPDX-License-Identifier: GPL-3.0-or-later
// The end of a core, or of a command that waits for one: killed, stopped, interrupted.
#include "tests/thoroughness.hpp"
#include "tests/two_process/cli_machine_rig.hpp"
#include "tests/two_process/quick_planning.hpp"

namespace psicarve::test {
namespace {

TEST_F(Machine, AKilledCoreIsSaidWhileCarving) {
    constexpr std::size_t kKills = 3;
    std::vector<milliseconds> times;
    while (times.size() < kKills) {
        start_core();
        RunningProgram carve{"psicarve", {"carve", long_job(), "--segment", segment_, "--json"}};
        ASSERT_TRUE(makes_it_carve(carve));
        const auto killed = std::chrono::steady_clock::now();
        core_->send(SIGKILL);
        EXPECT_EQ(carve.wait(), 5) << carve.error();
        times.push_back(std::chrono::duration_cast<milliseconds>(std::chrono::steady_clock::now() - killed));
        // The state may be seen before the answer to the last command was.
        const bool is_said = carve.error().find("no core serves") != std::string::npos ||
                             carve.error().find("the core ended before it answered") != std::string::npos;
        EXPECT_TRUE(is_said) << carve.error();
        EXPECT_EQ(nlohmann::json::parse(carve.out())["error"]["code"], "no_core");
        core_.reset();
    }
    // The spec's number. A busy computer may take itself away for as long, but not in most cases.
    std::ranges::sort(times);
    std::printf("said after %lld ms\n", static_cast<long long>(times[kKills / 2].count()));
    // A sanitizer takes its time at a program's end.
    if (!kIsSanitized) {
        EXPECT_LT(times[kKills / 2], milliseconds{500});
    }
}

TEST_F(Machine, AStoppedCoreIsCalledSilent) {
    start_core();
    core_->send(SIGSTOP);
    const Outcome outcome = run({"status"});
    core_->send(SIGCONT);
    EXPECT_EQ(outcome.exit_code, 5);
    EXPECT_NE(outcome.error.find("silent"), std::string::npos) << outcome.error;
}

TEST_F(Machine, AnInterruptedCarveStopsTheRunningCoreInOrder) {
    const QuickPlanning quick{file("quick.toml")};
    start_core();
    RunningProgram carve{"psicarve", {"carve", long_job(), "--segment", segment_}};
    ASSERT_TRUE(makes_it_carve(carve));
    carve.send(SIGINT);
    EXPECT_EQ(carve.wait(), 4) << carve.error();
    EXPECT_NE(carve.error().find("stopped by the operator"), std::string::npos) << carve.error();
    EXPECT_TRUE(core_pid().has_value());
    EXPECT_EQ(state(), MachineState::ready);
}

TEST_F(Machine, APrivateCoreEndsWithAKilledCarve) {
    const QuickPlanning quick{file("quick.toml")};
    RunningProgram carve{"psicarve", {"carve", long_job(), "--segment", segment_}};
    ASSERT_TRUE(makes_it_carve(carve));
    carve.send(SIGKILL);
    carve.wait();
    EXPECT_TRUE(eventually([&] { return !core_pid().has_value(); }));
}

TEST_F(Machine, ACoreOnTheRealClockCarvesOnWhenItsCarveIsKilled) {
    Profile profile = two_process::slow_machine();
    two_process::leave_one_sensor(profile);
    write("slow.toml", profile_to_toml(profile));
    const auto status = [&] { return run({"status", "--json"}).json(); };
    const auto is_at_rest = [&] {
        return !core_pid() || state() == MachineState::ready || state() == MachineState::alarm;
    };
    std::optional<std::uint32_t> pid;
    nlohmann::json end;
    // Again, should the host take this computer away for longer than a rotor coasts.
    for (int tries = 1; tries <= kMostTries; ++tries) {
        RunningProgram carve{
            "psicarve",
            {"carve", box_stl("box.stl"), "--layers", "4", "--points", "9", "--real-time", "--trace",
             file("pins.trace"), "--profile", file("slow.toml"), "--segment", segment_}};
        const auto has_begun = makes_it_carve(carve);
        if (!has_begun && carve.error().find("tick gap") != std::string::npos) continue;
        ASSERT_TRUE(has_begun);
        pid = core_pid();
        ASSERT_TRUE(pid.has_value());
        carve.send(SIGKILL);
        EXPECT_EQ(carve.wait(), 128 + SIGKILL) << carve.error();
        EXPECT_TRUE(eventually(is_at_rest));
        ASSERT_EQ(core_pid(), pid) << "the core ended with the carve";
        end = status();
        if (end["alarm_cause"] != "tick gap") break;
        kill(static_cast<pid_t>(*pid), SIGTERM);
        EXPECT_TRUE(eventually([&] { return !core_pid(); }));
    }
    ASSERT_TRUE(pid.has_value());
    EXPECT_EQ(end["points_done"], 4 * 9) << end;
    EXPECT_EQ(end["alarm_cause"], nullptr) << end;
    kill(static_cast<pid_t>(*pid), SIGTERM);
    EXPECT_TRUE(eventually([&] { return !core_pid(); }));
    const Outcome verified = run({"verify", published_job(), file("pins.trace")});
    // A tick that the host did not let run delays pulses: then it is not their times that can be judged.
    if (end["missed_ticks"] == 0) {
        EXPECT_EQ(verified.exit_code, 0) << verified.error << verified.out;
    }
    EXPECT_NE((verified.error + verified.out).find("points 36 of 36, largest deviation 0 pulses"),
              std::string::npos)
        << verified.error << verified.out;
}

TEST_F(Machine, AnInterruptedCarveEndsItsOwnCoreInOrder) {
    const QuickPlanning quick{file("quick.toml")};
    RunningProgram carve{"psicarve",
                         {"carve", long_job(), "--segment", segment_, "--picture", file("out.png")}};
    ASSERT_TRUE(makes_it_carve(carve));
    carve.send(SIGTERM);
    EXPECT_EQ(carve.wait(), 4) << carve.error();
    EXPECT_FALSE(core_pid().has_value());
    EXPECT_FALSE(std::filesystem::exists(file("out.png")));
    EXPECT_NE(carve.error().find("stopped by the operator"), std::string::npos) << carve.error();
}

}  // namespace
}  // namespace psicarve::test
