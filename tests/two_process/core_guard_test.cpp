// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <ctime>

#include "tests/two_process/port_rig.hpp"

namespace psicarve::two_process {
namespace {

/// A core on a real port, and the process that was started: its guard.
class CoreGuard : public PortRig {
protected:
    pid_t guard_pid() const { return core_->pid(); }

    void carve_for_long() {
        start_port_core();
        ASSERT_NE(core_pid_, guard_pid());
        home();
        ASSERT_EQ(publish(coarse_job(40)), "");
        start_carving();
        ASSERT_TRUE(eventually([&] { return status().points_done > 3; }));
        ASSERT_TRUE(is_spindle_on());
    }
    bool is_spindle_on() {
        const auto levels = fake_port::levels_of(port_.writes(), profile_);
        return !levels.empty() && (levels.back() & bit_of(Signal::spindle)) != 0;
    }
    /// From then to the write after which the outputs stayed safe.
    double milliseconds_until_safe(std::uint64_t from_ns) const {
        const auto writes = port_.writes();
        const auto levels = fake_port::levels_of(writes, profile_);
        std::size_t safe = writes.size() - 1;
        while (safe > 0 && (levels[safe - 1] & ~kDirMask) == 0) --safe;
        return static_cast<double>(writes[safe].time_ns - from_ns) * 1e-6;
    }
    CoreStatus last_status() const { return load_words<CoreStatus>(segment_->header().status.words); }
};

TEST_F(CoreGuard, AKilledCoreLeavesTheMachineSwitchedOffAndSaysSo) {
    carve_for_long();
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    kill(core_pid_, SIGKILL);
    EXPECT_EQ(core_->wait_for_exit(), 128 + SIGKILL);
    expect_safe_registers();
    const std::uint64_t killed_ns =
        static_cast<std::uint64_t>(now.tv_sec) * 1'000'000'000 + static_cast<std::uint64_t>(now.tv_nsec);
    std::printf("safe %.3f ms after the kill\n", milliseconds_until_safe(killed_ns));
    const std::string said = text_of(file("core.err"));
    EXPECT_NE(said.find("pid " + std::to_string(core_pid_)), std::string::npos) << said;
    EXPECT_NE(said.find("switched off"), std::string::npos) << said;
    EXPECT_FALSE(segment_->core_pid());
    const CoreStatus last = last_status();
    EXPECT_EQ(last.state, MachineState::alarm);
    EXPECT_EQ(last.alarm_cause, AlarmCause::core_lost);
    EXPECT_EQ(last.alarm_count, 1U);
    EXPECT_EQ(last.alarms[0].cause, AlarmCause::core_lost);
    EXPECT_EQ(last.homed_mask, 0);
    EXPECT_EQ(last.signals & kOutputMask, 0U);
    EXPECT_GT(last.points_done, 3U);
}

TEST_F(CoreGuard, AfterACrashNothingMovesBeforeItIsHomedAndTheJobGoesOn) {
    carve_for_long();
    ASSERT_TRUE(eventually([&] { return status().layer >= 2; }));
    kill(core_pid_, SIGKILL);
    core_->wait_for_exit();
    const auto layer = static_cast<double>(last_status().layer);
    {
        const fake_port::FakePortFile::Preload preload{port_};
        core_ = std::make_unique<CoreProcess>(port_arguments(segment_name_), file("core.err"));
    }
    ASSERT_TRUE(eventually([&] { return segment_->core_pid() && status().state == MachineState::off; }));
    ASSERT_TRUE(eventually([&] { return status().job_generation != 0; })) << text_of(file("core.err"));
    core_pid_ = static_cast<pid_t>(segment_->core_pid().value_or(0));
    EXPECT_EQ(status().state, MachineState::off);
    EXPECT_NE(refusal_of(CommandKind::start, layer), "");
    home();
    ASSERT_EQ(refusal_of(CommandKind::start, layer), "");
    ASSERT_TRUE(reaches(MachineState::waiting));
    EXPECT_EQ(status().layer, static_cast<std::uint32_t>(layer));
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    core_->wait_for_exit();
}

TEST_F(CoreGuard, WithoutItsGuardACoreStopsInOrderAndMovesNoMore) {
    carve_for_long();
    kill(guard_pid(), SIGKILL);
    core_->wait_for_exit();
    ASSERT_TRUE(reaches(MachineState::alarm));
    EXPECT_EQ(status().alarm_cause, AlarmCause::guard_lost);
    EXPECT_EQ(status().homed_mask, 0xF) << "it slowed down: no step is lost";
    expect_safe_registers_but_directions();
    EXPECT_EQ(segment_->core_pid(), static_cast<std::uint32_t>(core_pid_));
    ASSERT_EQ(refusal_of(CommandKind::reset_alarm), "");
    ASSERT_TRUE(eventually([&] { return status().alarm_count == 2; }));
    ASSERT_TRUE(reaches(MachineState::alarm));
    const std::uint64_t pulses = pulses_on_the_cable();
    EXPECT_NE(refusal_of(CommandKind::home), "");
    EXPECT_EQ(pulses_on_the_cable(), pulses);
}

TEST_F(CoreGuard, AStoppedCoreDoesNotKeepTheSpindleTurning) {
    start_port_core();
    home();
    ASSERT_EQ(publish(coarse_job(40)), "");
    ASSERT_EQ(refusal_of(CommandKind::start), "");
    ASSERT_TRUE(reaches(MachineState::waiting));
    ASSERT_TRUE(is_spindle_on());
    kill(core_pid_, SIGSTOP);
    ASSERT_TRUE(eventually([&] { return !is_spindle_on(); }));
    expect_safe_registers();
    kill(core_pid_, SIGCONT);
    ASSERT_TRUE(reaches(MachineState::alarm));
    EXPECT_EQ(status().alarm_cause, AlarmCause::tick_gap);
    expect_safe_registers_but_directions();
}

TEST_F(CoreGuard, AnOrderToEndGoesOnToTheCore) {
    carve_for_long();
    kill(guard_pid(), SIGTERM);
    EXPECT_EQ(core_->wait_for_exit(), 0);
    expect_safe_registers();
    EXPECT_FALSE(segment_->core_pid());
    EXPECT_NE(last_status().alarm_cause, AlarmCause::core_lost);
}

TEST_F(CoreGuard, WithoutGuardTheCoreIsTheProcessThatWasStarted) {
    std::vector<std::string> arguments = port_arguments(segment_name_);
    arguments.emplace_back("--no-guard");
    {
        const fake_port::FakePortFile::Preload preload{port_};
        core_ = std::make_unique<CoreProcess>(arguments, file("core.err"));
    }
    attach();
    EXPECT_TRUE(eventually([&] { return segment_->core_pid() == static_cast<std::uint32_t>(core_->pid()); }));
    EXPECT_NE(text_of(file("core.err")).find("no guard"), std::string::npos);
}

}  // namespace
}  // namespace psicarve::two_process
