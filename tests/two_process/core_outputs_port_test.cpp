// SPDX-License-Identifier: GPL-3.0-or-later
// Coolant on a real port: whatever ends the core's work switches it off.
#include <csignal>

#include "shared/segment/segment_program.hpp"
#include "tests/two_process/port_rig.hpp"

namespace psicarve::two_process {
namespace {

constexpr SignalWord kCoolant = bit_of(Signal::mist) | bit_of(Signal::flood);

class OutputsOnAPort : public PortRig {
protected:
    OutputsOnAPort() {
        for (const Axis axis : kAllAxes) profile_.port.pins[index_of(enable_of(axis))] = 6;
        profile_.port.pins[index_of(Signal::mist)] = 1;
        profile_.port.pins[index_of(Signal::flood)] = -7;
        home_where_it_stands();
    }
    /// Held in a program, with coolant on.
    void bring_coolant_on() {
        start_port_core();
        home();
        writer_.emplace(ProgramWriter::claim(*segment_).value());
        ASSERT_TRUE(writer_->begin(std::chrono::seconds{60}));
        MotionRecord coolant{};
        coolant.kind = MotionKind::output;
        coolant.line = 1;
        coolant.code = 1;
        coolant.outputs = switched_bit(Signal::mist) | switched_bit(Signal::flood);
        MotionRecord stop{};
        stop.kind = MotionKind::stop;
        stop.line = 2;
        stop.code = static_cast<std::uint8_t>(StopReason::program);
        ASSERT_EQ(writer_->put(coolant), ProgramPut::done);
        ASSERT_EQ(writer_->put(stop), ProgramPut::done);
        Command command{};
        command.kind = CommandKind::program;
        command.value2 = writer_->program();
        for (std::size_t k = 0; k < kAxisCount; ++k)
            command.target[k] = static_cast<double>(status().position_pulses[k]);
        ASSERT_EQ(refusal_of(command), "");
        ASSERT_TRUE(eventually([&] { return status().state == MachineState::held; }));
        ASSERT_EQ(on(), kCoolant);
    }
    /// As the cable shows it.
    SignalWord on() {
        const auto levels = fake_port::levels_of(port_.writes(), profile_);
        return levels.empty() ? 0 : levels.back() & kSwitchedMask;
    }

    std::optional<ProgramWriter> writer_;
};

TEST_F(OutputsOnAPort, AreSwitchedOffByTheGuardOfAKilledCore) {
    bring_coolant_on();
    kill(core_pid_, SIGKILL);
    EXPECT_EQ(core_->wait_for_exit(), 128 + SIGKILL);
    expect_safe_registers();
    EXPECT_EQ(on(), 0U);
}

TEST_F(OutputsOnAPort, AreSwitchedOffByTheGuardOfACoreThatHangs) {
    bring_coolant_on();
    kill(core_pid_, SIGSTOP);
    EXPECT_TRUE(eventually([&] { return on() == 0; }));
    kill(core_pid_, SIGKILL);
    EXPECT_EQ(core_->wait_for_exit(), 128 + SIGKILL);
    expect_safe_registers();
}

TEST_F(OutputsOnAPort, GoOffByAnEmergencyStop) {
    bring_coolant_on();
    request_emergency_stop(*segment_);
    EXPECT_TRUE(eventually([&] { return on() == 0; }));
}

TEST_F(OutputsOnAPort, GoOffAtTheCoresEnd) {
    bring_coolant_on();
    kill(core_->pid(), SIGTERM);
    EXPECT_EQ(core_->wait_for_exit(), 0);
    EXPECT_EQ(on(), 0U);
    expect_safe_registers();
}

}  // namespace
}  // namespace psicarve::two_process
