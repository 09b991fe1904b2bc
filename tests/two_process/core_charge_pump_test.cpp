// SPDX-License-Identifier: GPL-3.0-or-later
// The output that toggles while the core ticks, seen from the cable.
#include <algorithm>

#include "tests/thoroughness.hpp"
#include "tests/two_process/port_rig.hpp"

namespace psicarve::two_process {
namespace {

class CoreChargePump : public PortRig {
protected:
    CoreChargePump() {
        // All twelve outputs are in use: Y's drive shares an enable.
        profile_.port.pins[index_of(Signal::y_enable)] = 6;
        profile_.port.charge_pump_pin = -1;
        port_.state().axes[index_of(Axis::y)].enable = port_.state().axes[index_of(Axis::r1)].enable;
        home_where_it_stands();
    }
    /// The pump's level after each write from number `first` on.
    std::vector<bool> levels(std::size_t first = 0) const {
        const PinMap map = PinMap::from_profile(profile_).value();
        OutputRegisters registers = map.encode(0);
        std::vector<bool> result;
        const auto writes = port_.writes();
        for (std::size_t i = 0; i < writes.size(); ++i) {
            (writes[i].reg == fake_port::Register::data ? registers.data : registers.control) =
                writes[i].value;
            if (i >= first) result.push_back((map.outputs_from_registers(registers) & kChargePumpBit) != 0);
        }
        return result;
    }
    std::size_t turns(std::size_t first = 0) const {
        const std::vector<bool> pump = levels(first);
        std::size_t count = 0;
        for (std::size_t i = 1; i < pump.size(); ++i) count += pump[i] != pump[i - 1] ? 1 : 0;
        return count;
    }
    void expect_rest() {
        const std::size_t written = port_.writes().size();
        std::this_thread::sleep_for(milliseconds{50});
        EXPECT_EQ(port_.writes().size(), written);
        EXPECT_FALSE(levels().back());
    }
};

TEST_F(CoreChargePump, TogglesWhileTheCoreTicksAndInNoSafeState) {
    start_port_core();
    ASSERT_TRUE(eventually([&] { return turns() > 100; }));
    home();
    ASSERT_TRUE(eventually([&] { return (status().signals & kChargePumpBit) != 0; }));
    std::size_t written = port_.writes().size();
    ASSERT_TRUE(eventually([&] { return turns(written) > 100; })) << "at rest, homed";

    request_emergency_stop(*segment_);
    ASSERT_TRUE(reaches(MachineState::alarm));
    ASSERT_TRUE(eventually([&] { return (status().signals & kChargePumpBit) == 0; }));
    expect_rest();

    ASSERT_EQ(refusal_of(CommandKind::reset_alarm), "");
    written = port_.writes().size();
    ASSERT_TRUE(eventually([&] { return turns(written) > 100; })) << "after the alarm";

    kill(core_pid_, SIGKILL);
    EXPECT_EQ(core_->wait_for_exit(), 128 + SIGKILL);
    expect_safe_registers();
    expect_rest();
}

TEST_F(CoreChargePump, RestsWhenTheCoreHangsOrEnds) {
    start_port_core();
    ASSERT_TRUE(eventually([&] { return turns() > 100; }));
    kill(core_pid_, SIGSTOP);
    ASSERT_TRUE(
        eventually([&] { return text_of(file("core.err")).find("does not tick") != std::string::npos; }));
    expect_safe_registers();
    expect_rest();
    // It finds that its guard has acted.
    kill(core_pid_, SIGCONT);
    ASSERT_TRUE(reaches(MachineState::alarm));
    expect_rest();
    ASSERT_EQ(refusal_of(CommandKind::reset_alarm), "");
    const std::size_t written = port_.writes().size();
    ASSERT_TRUE(eventually([&] { return turns(written) > 100; }));
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    EXPECT_EQ(core_->wait_for_exit(), 0);
    expect_safe_registers();
    expect_rest();
}

// The pump toggles on the spindle's register: each of its writes puts the spindle's bit out as well.
TEST_F(CoreChargePump, ACoreThatComesBackAtRestTurnsNoSpindleOnAgain) {
    take_enable_lines_away();  // it goes on without being homed again
    start_port_core();
    home();
    ASSERT_EQ(publish(coarse_job(2)), "");
    const int rounds = test::is_thorough() ? 3 : 2;
    int rounds_with_spindle = 0;
    for (int round = 0; round < rounds; ++round) {
        ASSERT_EQ(refusal_of(CommandKind::start), "");
        ASSERT_TRUE(reaches(MachineState::waiting)) << "at rest, the spindle turns";
        // No rotor coasts any more.
        const std::uint64_t rested = status().tick + 1000;
        ASSERT_TRUE(eventually([&] { return status().tick > rested; }));
        kill(core_pid_, SIGSTOP);
        ASSERT_TRUE(eventually([&] {
            return port_.state().data.load() == safe().data && port_.state().control.load() == safe().control;
        }));
        const std::size_t written = port_.writes().size();
        kill(core_pid_, SIGCONT);
        ASSERT_TRUE(reaches(MachineState::alarm));
        EXPECT_EQ(status().alarm_cause, AlarmCause::tick_gap);
        const auto after = fake_port::levels_of(port_.writes(), profile_);
        rounds_with_spindle +=
            std::any_of(after.begin() + static_cast<std::ptrdiff_t>(written), after.end(),
                        [](std::uint32_t now) { return (now & bit_of(Signal::spindle)) != 0; });
        ASSERT_EQ(refusal_of(CommandKind::reset_alarm), "");
        ASSERT_TRUE(reaches(MachineState::ready));
    }
    // One that was stopped in the middle of a tick ends it.
    EXPECT_LE(rounds_with_spindle, 1);
}

}  // namespace
}  // namespace psicarve::two_process
