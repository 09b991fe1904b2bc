// SPDX-License-Identifier: GPL-3.0-or-later
// Stops while the thread that takes commands stands still.
#include <algorithm>
#include <future>
#include <iterator>
#include <string>

#include "tests/two_process/port_rig.hpp"
#include "tests/two_process/stopped_thread.hpp"

namespace psicarve::two_process {
namespace {

class CoreStops : public PortRig {
protected:
    using Refused = std::future<std::string>;

    CoreStops() { home_where_it_stands(); }
    std::ptrdiff_t pending_count() const {
        const auto& slots = segment_->header().commands;
        return std::count_if(std::begin(slots), std::end(slots), [](const CommandSlot& slot) {
            return static_cast<std::uint32_t>(slot.state_and_sender.load()) ==
                   static_cast<std::uint32_t>(SlotState::pending);
        });
    }
    /// Pending when this returns.
    Refused post(const Command& command) {
        const auto before = pending_count();
        auto refused = std::async(std::launch::async, [this, command] { return refusal_of(command); });
        EXPECT_TRUE(eventually([&] { return pending_count() > before; }));
        return refused;
    }
    Refused post(CommandKind kind, double value = 0.0) {
        Command command{};
        command.kind = kind;
        command.value = value;
        return post(command);
    }
    bool is_spindle_pin_on() {
        constexpr std::uint32_t kSpindle = 1U << 2U;  // pin 16
        return (port_.state().control.load() & kSpindle) != 0;
    }
    /// Without a second of ticks the tick itself notices, and stops for another reason.
    void expect_an_emergency_stop_while_the_supervisor_stands_still() {
        ASSERT_TRUE(is_spindle_pin_on());
        StoppedThread supervisor{core_pid_};
        ASSERT_TRUE(supervisor.is_stopped());
        request_emergency_stop(*segment_);
        EXPECT_TRUE(eventually([&] { return !is_spindle_pin_on(); }));
        supervisor.let_go();
        ASSERT_TRUE(reaches(MachineState::alarm));
        EXPECT_EQ(status().alarm_cause, AlarmCause::emergency_stop);
    }
};

TEST_F(CoreStops, AreHeardWhileTheSupervisorStandsStill) {
    start_port_core();
    home();
    ASSERT_EQ(refusal_of(CommandKind::spindle, 1.0), "");
    expect_an_emergency_stop_while_the_supervisor_stands_still();
}

TEST_F(CoreStops, AreHeardInASegmentThatReplacedARemovedOne) {
    start_port_core();
    home();
    for (int i = 0; i < 3; ++i) request_stop(*segment_);
    ASSERT_TRUE(Segment::remove(segment_name_));
    ASSERT_TRUE(eventually([&] {
        const auto fresh = Segment::attach(segment_name_);
        return fresh && fresh->core_pid() == static_cast<std::uint32_t>(core_pid_);
    }));
    attach();
    ASSERT_TRUE(reaches(MachineState::alarm));
    EXPECT_EQ(status().alarm_cause, AlarmCause::segment_lost);
    ASSERT_EQ(refusal_of(CommandKind::reset_alarm), "");
    home();
    ASSERT_EQ(refusal_of(CommandKind::spindle, 1.0), "");
    expect_an_emergency_stop_while_the_supervisor_stands_still();
}

TEST_F(CoreStops, RefuseWhatWasAskedForBeforeThem) {
    start_port_core();
    home();
    const std::uint64_t pulses = pulses_on_the_cable();
    StoppedThread supervisor{core_pid_};
    ASSERT_TRUE(supervisor.is_stopped());
    Command turn{};
    turn.kind = CommandKind::move;
    turn.axis = 1U << index_of(Axis::psi);
    turn.target[index_of(Axis::psi)] = 90.0;
    Refused moved = post(turn);
    Refused homed = post(CommandKind::home);
    Refused switched_on = post(CommandKind::spindle, 1.0);
    Refused switched_off = post(CommandKind::spindle, 0.0);
    request_stop(*segment_);
    Refused later = post(CommandKind::spindle, 1.0);
    supervisor.let_go();
    EXPECT_EQ(moved.get(), "move: a stop came after it; ask again");
    EXPECT_EQ(homed.get(), "home: a stop came after it; ask again");
    EXPECT_EQ(switched_on.get(), "spindle: a stop came after it; ask again");
    EXPECT_EQ(switched_off.get(), "");
    EXPECT_EQ(later.get(), "");
    EXPECT_TRUE(eventually([&] { return is_spindle_pin_on(); }));
    EXPECT_EQ(status().state, MachineState::ready);
    EXPECT_EQ(pulses_on_the_cable(), pulses);
    EXPECT_EQ(refusal_of(turn), "");
    EXPECT_TRUE(eventually([&] { return pulses_on_the_cable() > pulses; }));
}

TEST_F(CoreStops, KeepAnAlarmThatWasToBeLeftBeforeThem) {
    start_port_core();
    home();
    request_emergency_stop(*segment_);
    ASSERT_TRUE(reaches(MachineState::alarm));
    StoppedThread supervisor{core_pid_};
    ASSERT_TRUE(supervisor.is_stopped());
    Refused reset = post(CommandKind::reset_alarm);
    Refused homed = post(CommandKind::home);
    request_emergency_stop(*segment_);
    Refused off = post(CommandKind::spindle, 0.0);
    supervisor.let_go();
    EXPECT_EQ(reset.get(), "reset-alarm: a stop came after it; ask again");
    EXPECT_EQ(homed.get(), "home: a stop came after it; ask again");
    [[maybe_unused]] const std::string ignored = off.get();
    EXPECT_EQ(status().state, MachineState::alarm);
    EXPECT_EQ(refusal_of(CommandKind::reset_alarm), "");
    home();
}

// Nothing of it ran meanwhile: it finds all of it at once, on the virtual clock, too.
TEST_F(CoreStops, RefuseWhatACoreThatWasStoppedFindsBehindThem) {
    start_core();
    core_->send_signal(SIGSTOP);
    Refused before = post(CommandKind::home);
    request_stop(*segment_);
    Refused later = post(CommandKind::home);
    core_->send_signal(SIGCONT);
    EXPECT_EQ(before.get(), "home: a stop came after it; ask again");
    EXPECT_EQ(later.get(), "");
    EXPECT_TRUE(reaches(MachineState::ready));
}

}  // namespace
}  // namespace psicarve::two_process
