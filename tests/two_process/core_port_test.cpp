// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cerrno>

#include "tests/thoroughness.hpp"
#include "tests/two_process/port_rig.hpp"

namespace psicarve::two_process {
namespace {

using fake_port::Pulse;
using fake_port::Register;
using fake_port::Write;

class CorePort : public PortRig {};

TEST_F(CorePort, CarvesAJobWithExactlyThePulsesOfTheSimulatedPort) {
    // Each sensor takes seconds: dev looks for all four.
    if (!test::is_thorough()) home_by_one_sensor();
    const JobTable table = coarse_job(2);
    const std::vector<Pulse> wanted = pulses_of_the_simulated_run(table);
    ASSERT_GT(wanted.size(), 100U);
    start_port_core();
    home();
    for (const Axis axis : kAllAxes) {
        if (axis_motion(profile_, axis).home == HomeSensor::none) continue;  // a count of its own
        EXPECT_EQ(port_.state().axes[index_of(axis)].position_pulses.load(),
                  status().position_pulses[index_of(axis)])
            << name_of(axis);
    }
    ASSERT_EQ(publish(table), "");
    start_carving();
    ASSERT_TRUE(
        eventually([&] { return status().job_end_tick != 0 || status().state == MachineState::alarm; }));
    const CoreStatus end = status();
    EXPECT_EQ(end.state, MachineState::ready) << name_of(end.alarm_cause);
    EXPECT_EQ(end.is_simulator, 0);
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    const std::string said = text_of(file("core.err"));
    EXPECT_EQ(core_->wait_for_exit(), 0) << said;
    EXPECT_NE(said.find(": can do SPP"), std::string::npos) << said;
    EXPECT_NE(said.find("; plain register access\n"), std::string::npos) << said;
    EXPECT_EQ(fake_port::pulses_with_spindle(fake_port::levels_of(port_.writes(), profile_)), wanted);
    expect_safe_first_and_last();
    EXPECT_EQ(port_.state().claimed_by.load(), 0U) << "given back";
}

TEST_F(CorePort, AMachineWithoutAnySensorIsHomedWhereItStandsAndCarvesTheSame) {
    const std::vector<Pulse> wanted = pulses_of_the_simulated_run(coarse_job(2));
    home_where_it_stands();
    start_port_core();
    home();
    EXPECT_EQ(pulses_on_the_cable(), 0U) << "there is nothing to look for";
    ASSERT_EQ(publish(coarse_job(2)), "");
    start_carving();
    ASSERT_TRUE(
        eventually([&] { return status().job_end_tick != 0 || status().state == MachineState::alarm; }));
    EXPECT_EQ(status().state, MachineState::ready) << name_of(status().alarm_cause);
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    EXPECT_EQ(core_->wait_for_exit(), 0) << text_of(file("core.err"));
    EXPECT_EQ(fake_port::pulses_with_spindle(fake_port::levels_of(port_.writes(), profile_)), wanted);
}

TEST_F(CorePort, APulseWithinATickLastsLongEnoughAndIsTheSamePulse) {
    home_where_it_stands();
    const std::vector<Pulse> wanted = pulses_of_the_simulated_run(coarse_job(2));
    profile_.port.pulses = PulseForm::within_tick;
    write_profile();
    start_port_core();
    home();
    ASSERT_EQ(publish(coarse_job(2)), "");
    start_carving();
    ASSERT_TRUE(
        eventually([&] { return status().job_end_tick != 0 || status().state == MachineState::alarm; }));
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    EXPECT_EQ(core_->wait_for_exit(), 0);
    const std::vector<Write> writes = port_.writes();
    const auto levels = fake_port::levels_of(writes, profile_);
    EXPECT_EQ(fake_port::pulses_with_spindle(levels), wanted);
    // The tick waits from the end of one write to the begin of the other: between them lies at least that.
    std::array<std::uint64_t, kAxisCount> rose_ns{};
    for (std::size_t i = 1; i < writes.size(); ++i) {
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            const bool was_high = (levels[i - 1] >> k & 1U) != 0;
            const bool is_high = (levels[i] >> k & 1U) != 0;
            if (is_high && !was_high) rose_ns[k] = writes[i].time_ns;
            if (!is_high && was_high) {
                EXPECT_GE(writes[i].time_ns - rose_ns[k],
                          static_cast<std::uint64_t>(profile_.port.step_high_ns));
            }
        }
    }
}

TEST_F(CorePort, WritesOnlyRegistersThatChange) {
    home_by_one_sensor();
    start_port_core();
    home();
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    EXPECT_EQ(core_->wait_for_exit(), 0);
    std::array<int, 2> held{-1, -1};
    const std::vector<Write> writes = port_.writes();
    // The core's safe state, and the guard's after its last tick and after its end, are written whatever the
    // registers hold.
    constexpr std::size_t kLastWords = 6;
    ASSERT_GT(writes.size(), 2 * kLastWords);
    for (std::size_t i = 0; i + kLastWords < writes.size(); ++i) {
        int& register_holds = held[static_cast<std::size_t>(writes[i].reg)];
        EXPECT_NE(register_holds, writes[i].value) << "write " << i;
        register_holds = writes[i].value;
    }
}

TEST_F(CorePort, AnEmergencyStopEndsPulsesWithItsTick) {
    home_where_it_stands();
    start_port_core();
    home();
    ASSERT_EQ(publish(coarse_job(40)), "");
    start_carving();
    ASSERT_TRUE(eventually([&] { return status().points_done > 3; }));
    // Well ahead of now, so that it is a write of the tick's own choosing.
    const std::uint64_t at = port_.state().write_count.load() + 200;
    port_.state().flip_to.store(kEstopStatusBit);
    port_.state().flip_at_write.store(at);
    ASSERT_TRUE(reaches(MachineState::alarm));
    EXPECT_EQ(status().alarm_cause, AlarmCause::emergency_stop);
    expect_safe_after(at + 1);
    EXPECT_NE(refusal_of(CommandKind::reset_alarm).find("estop"), std::string::npos);
}

TEST_F(CorePort, ALimitPlayedWhileCarvingStopsAndNamesItsAxis) {
    home_where_it_stands();
    start_port_core();
    home();
    ASSERT_EQ(publish(coarse_job(40)), "");
    start_carving();
    ASSERT_TRUE(eventually([&] { return status().points_done > 3; }));
    constexpr std::uint32_t kR2LimitBit = 0x80;
    port_.state().status_flip.store(kR2LimitBit);
    ASSERT_TRUE(reaches(MachineState::alarm));
    EXPECT_EQ(status().alarm_cause, AlarmCause::limit);
    EXPECT_EQ(status().alarm_axis, index_of(Axis::r2));
}

TEST_F(CorePort, ALimitThatChattersFromTickToTickStopsNothing) {
    home_where_it_stands();
    start_port_core();
    home();
    ASSERT_EQ(publish(coarse_job(2)), "");
    constexpr std::uint32_t kR1LimitBit = 0x10;
    port_.state().status_chatter.store(kR1LimitBit);
    start_carving();
    ASSERT_TRUE(
        eventually([&] { return status().job_end_tick != 0 || status().state == MachineState::alarm; }));
    EXPECT_EQ(status().state, MachineState::ready) << name_of(status().alarm_cause);
}

TEST_F(CorePort, HoweverManyAccessesFailTheMachineIsSwitchedOffOnceThePortAnswers) {
    for (const int faults : test::is_thorough() ? std::vector<int>{1, 2, 5, 50} : std::vector<int>{1, 50}) {
        start_port_core();
        ASSERT_EQ(refusal_of(CommandKind::home), "");
        ASSERT_TRUE(eventually([&] { return pulses_on_the_cable() > 10; }));
        EXPECT_NE(status().signals & kEnableMask, 0U);
        fail_port(EIO, faults);
        ASSERT_TRUE(reaches(MachineState::alarm));
        EXPECT_EQ(status().alarm_cause, AlarmCause::port_error);
        EXPECT_TRUE(eventually([&] { return is_safe(); })) << faults << " accesses failed";
        EXPECT_TRUE(eventually([&] { return status().is_port_silent == 0; }));
        EXPECT_EQ(status().signals & (kEnableMask | bit_of(Signal::spindle)), 0U);
        const std::uint64_t writes = port_.state().write_count.load();
        const std::uint64_t tick = status().tick;
        ASSERT_TRUE(eventually([&] { return status().tick > tick + 100; }));
        EXPECT_EQ(port_.state().write_count.load(), writes) << "what was taken is not written again";
        EXPECT_NE(refusal_of(CommandKind::home), "");
        // As the remedy says.
        ASSERT_EQ(refusal_of(CommandKind::reset_alarm), "");
        EXPECT_EQ(status().state, MachineState::off);
        ASSERT_EQ(refusal_of(CommandKind::home), "");
        kill(core_->pid(), SIGTERM);
        EXPECT_EQ(core_->wait_for_exit(), 0);
        expect_safe_registers();
        port_.stand(profile_);
        for (auto& axis : port_.state().axes) axis.pulses.store(0);
    }
}

TEST_F(CorePort, AnOutageWhileCarvingEndsWithTheMachineSwitchedOff) {
    home_where_it_stands();
    start_port_core();
    home();
    ASSERT_EQ(publish(coarse_job(40)), "");
    start_carving();
    ASSERT_TRUE(eventually([&] { return status().points_done > 3; }));
    fail_port(EIO, -1);
    ASSERT_TRUE(reaches(MachineState::alarm));
    ASSERT_TRUE(eventually([&] { return status().is_port_silent == 1; }));
    EXPECT_NE(status().signals & bit_of(Signal::spindle), 0U) << "it has not been switched off";
    EXPECT_NE(refusal_of(CommandKind::reset_alarm).find("its own switch"), std::string::npos);
    EXPECT_FALSE(is_safe());
    const std::uint64_t pulses = pulses_on_the_cable();
    mend_port();
    EXPECT_TRUE(eventually([&] { return is_safe(); }));
    EXPECT_TRUE(eventually([&] { return status().is_port_silent == 0; }));
    EXPECT_EQ(status().signals & (kEnableMask | bit_of(Signal::spindle)), 0U);
    // Once more, in alarm: what it took may be lost, and an emergency stop is no less.
    fail_port(EIO, -1);
    ASSERT_TRUE(eventually([&] { return status().is_port_silent == 1; }));
    port_.state().data.store(0x70);
    segment_->header().estop_requests.fetch_add(1);
    mend_port();
    EXPECT_TRUE(eventually([&] { return is_safe(); }));
    EXPECT_EQ(pulses_on_the_cable(), pulses);
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    EXPECT_EQ(core_->wait_for_exit(), 0);
}

TEST_F(CorePort, APortThatVanishesWhileCarvingIsAnAlarmAndTheGuardWaitsForIt) {
    home_where_it_stands();
    start_port_core();
    home();
    ASSERT_EQ(publish(coarse_job(40)), "");
    start_carving();
    ASSERT_TRUE(eventually([&] { return status().points_done > 3; }));
    fail_port(ENODEV, -1);
    ASSERT_TRUE(reaches(MachineState::alarm));
    EXPECT_EQ(status().alarm_cause, AlarmCause::port_error);
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    ASSERT_TRUE(eventually(
        [&] { return text_of(file("core.err")).find("the port does not answer") != std::string::npos; }));
    EXPECT_FALSE(is_safe());
    mend_port();
    EXPECT_EQ(core_->wait_for_exit(), 0);
    expect_safe_registers();
    EXPECT_NE(text_of(file("core.err")).find("the port answers again"), std::string::npos);
}

TEST_F(CorePort, AtRestAPortThatVanishesIsFoundByReadingAndAnOrderEndsTheGuardsWaiting) {
    home_where_it_stands();
    start_port_core();
    home();
    fail_port(ENODEV, -1);
    ASSERT_TRUE(reaches(MachineState::alarm));
    EXPECT_EQ(status().alarm_cause, AlarmCause::port_error);
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    ASSERT_TRUE(eventually(
        [&] { return text_of(file("core.err")).find("the port does not answer") != std::string::npos; }));
    kill(core_->pid(), SIGTERM);
    EXPECT_EQ(core_->wait_for_exit(), 4) << "nobody may take it for safe";
}

TEST_F(CorePort, ASecondCoreIsRefusedWithThePidOfTheFirst) {
    start_port_core();
    const fake_port::FakePortFile::Preload preload{port_};
    const std::string other_segment = segment_name_ + "-other";
    CoreProcess second{port_arguments(other_segment), file("second.err")};
    EXPECT_EQ(second.wait_for_exit(), 4);
    const std::string said = text_of(file("second.err"));
    EXPECT_NE(said.find("busy"), std::string::npos) << said;
    EXPECT_NE(said.find("pid " + std::to_string(core_->pid())), std::string::npos) << said;
    [[maybe_unused]] const auto removed = Segment::remove(other_segment);
}

// Without a guard, which would write it as well.
TEST_F(CorePort, AFatalSignalLeavesTheSafeStateBehind) {
    home_where_it_stands();
    for (const int number : {SIGSEGV, SIGRTMIN + 6}) {
        start_port_core({"--no-guard"});
        ASSERT_EQ(core_pid_, core_->pid());
        home();
        ASSERT_EQ(publish(coarse_job(40)), "");
        start_carving();
        ASSERT_TRUE(eventually([&] { return status().points_done > 3; }));
        kill(core_pid_, number);
        EXPECT_EQ(core_->wait_for_exit(), 128 + number);
        expect_safe_registers();
    }
}

}  // namespace
}  // namespace psicarve::two_process
