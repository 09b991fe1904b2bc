// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "shared/machine/command.hpp"
#include "shared/machine/machine_state.hpp"
#include "shared/machine/signal.hpp"
#include "shared/message/message.hpp"

namespace psicarve {

// The machine's words as arguments of a message.

constexpr Argument argument_of(Axis axis) noexcept {
    return argument(ArgumentKind::axis, index_of(axis));
}
constexpr Argument argument_of(Signal signal) noexcept {
    return argument(ArgumentKind::signal, index_of(signal));
}
constexpr Argument signals_argument(SignalWord signals) noexcept {
    return argument(ArgumentKind::signals, signals);
}
constexpr Argument argument_of(MachineState state) noexcept {
    return argument(ArgumentKind::state, static_cast<std::uint64_t>(state));
}
/// "ready or off"; at most 16.
template <typename States>
constexpr Argument states_argument(const States& states) noexcept {
    std::uint64_t bits = 0;
    unsigned shift = 0;
    for (const MachineState state : states) {
        if (shift < 64) bits |= (static_cast<std::uint64_t>(state) + 1) << shift;
        shift += 4;
    }
    return argument(ArgumentKind::states, bits);
}
static_assert(kMachineStateCount < 16, "a state of a list has four bits");
/// What to do in this state: "home first".
constexpr Argument way_out_of(MachineState state) noexcept {
    return argument(ArgumentKind::way_out, static_cast<std::uint64_t>(state));
}
constexpr Argument argument_of(CommandKind kind) noexcept {
    return argument(ArgumentKind::command, static_cast<std::uint64_t>(kind));
}
constexpr Argument argument_of(AlarmCause cause) noexcept {
    return argument(ArgumentKind::alarm_cause, static_cast<std::uint64_t>(cause));
}
/// In place of a cause, where the port has not taken the safe state (kSilentPortRemedy).
inline constexpr std::uint64_t kSilentPortCause = 255;
constexpr Argument alarm_remedy_argument(AlarmCause cause, bool is_port_silent) noexcept {
    return argument(ArgumentKind::alarm_remedy,
                    is_port_silent ? kSilentPortCause : static_cast<std::uint64_t>(cause));
}

}  // namespace psicarve
