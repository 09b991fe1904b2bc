// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/escape_key.hpp"

namespace psicarve::session {

EscapeOrder escape_order(const MachineView& machine, bool has_orders) {
    if (!machine.is_heard() || !machine.status) return EscapeOrder::none;
    switch (machine.state()) {
        case MachineState::carving:
            return EscapeOrder::hold;
        case MachineState::waiting:
            // Between the two commands of a start: the hold reaches the core behind the second.
            return has_orders ? EscapeOrder::hold : EscapeOrder::none;
        case MachineState::homing:
        case MachineState::moving:
        case MachineState::positioning:
        case MachineState::finishing:
        case MachineState::backing_off:
        case MachineState::testing:
            return EscapeOrder::stop;
        case MachineState::off:
        case MachineState::ready:
        case MachineState::holding:
        case MachineState::held:
        case MachineState::stopping:
        case MachineState::alarm:
            break;
    }
    return EscapeOrder::none;
}

}  // namespace psicarve::session
