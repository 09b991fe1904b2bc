// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/refused_order.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "shared/machine/message_argument.hpp"

namespace psicarve::session {
namespace {

/// The core answers before it writes the status on which the answer depends.
constexpr std::uint64_t kHeartbeatsToSettle = 2;

constexpr SignalWord kSwitches =
    bit_of(Signal::r1_limit) | bit_of(Signal::r2_limit) | bit_of(Signal::y_limit) | bit_of(Signal::estop);

bool rests_in_alarm(const MachineView& machine) noexcept {
    return machine.state() == MachineState::alarm || machine.state() == MachineState::backing_off;
}

bool needs_homing(const MachineView& machine) noexcept {
    return machine.state() == MachineState::off ||
           !std::ranges::all_of(kAllAxes, [&](Axis axis) { return machine.is_homed(axis); });
}

}  // namespace

OrderPlace place_of(CommandKind kind) noexcept {
    switch (kind) {
        case CommandKind::home:
        case CommandKind::reset_height:
            return OrderPlace::position;
        case CommandKind::jog:
        case CommandKind::jog_on:
        case CommandKind::spindle:
            return OrderPlace::jog;
        case CommandKind::move:
            return OrderPlace::move;
        case CommandKind::reset_alarm:
        case CommandKind::back_off:
            return OrderPlace::alarm;
        case CommandKind::test_pin:
        case CommandKind::drives_off:
            return OrderPlace::outputs;
        default:
            return OrderPlace::job;
    }
}

OrderRefusal::Help help_for(const psicarve::Message& why) noexcept {
    using Help = OrderRefusal::Help;
    switch (why.id) {
        case MessageId::alarm:
        case MessageId::alarm_of_axis:
        case MessageId::port_failed:
        case MessageId::port_reset_first:
            return Help::reset_alarm;
        case MessageId::not_homed:
        case MessageId::heads_not_homed:
            return Help::home_all;
        case MessageId::wrong_state:
            break;
        default:
            return Help::none;
    }
    if (why.arguments[1].bits == argument_of(MachineState::alarm).bits) return Help::reset_alarm;
    return why.arguments[1].bits == argument_of(MachineState::off).bits ? Help::home_all : Help::none;
}

RefusedOrder::Ground RefusedOrder::ground_of(const MachineView& machine) noexcept {
    Ground ground;
    ground.is_heard = machine.is_heard();
    ground.core_pid = machine.core_pid;
    if (!machine.status) return ground;
    const CoreStatus& status = *machine.status;
    ground.state = status.state;
    ground.homed_mask = status.homed_mask;
    ground.alarm_count = status.alarm_count;
    ground.job_generation = status.job_generation;
    ground.switches = status.signals & kSwitches;
    if (is_at_rest(status.state))
        std::copy_n(std::begin(status.position_pulses), kAxisCount, ground.position_pulses.begin());
    return ground;
}

bool RefusedOrder::still_helps(const MachineView& machine) const noexcept {
    switch (told_->help) {
        case OrderRefusal::Help::home_all:
            return needs_homing(machine);
        case OrderRefusal::Help::reset_alarm:
            return rests_in_alarm(machine);
        case OrderRefusal::Help::none:
            break;
    }
    return true;
}

void RefusedOrder::note(OrderRefusal refusal, const MachineView& machine) {
    told_ = std::move(refusal);
    ground_ = ground_of(machine);
    settled_heartbeat_ = (machine.status ? machine.status->heartbeat : 0) + kHeartbeatsToSettle;
}

void RefusedOrder::look(const MachineView& machine) {
    if (!told_) return;
    const Ground now = ground_of(machine);
    const bool is_settling =
        machine.status && now.core_pid == ground_.core_pid && machine.status->heartbeat < settled_heartbeat_;
    if (is_settling) {
        ground_ = now;
    } else if (now != ground_ || !still_helps(machine)) {
        forget();
    }
}

}  // namespace psicarve::session
