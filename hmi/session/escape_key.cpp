// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/escape_key.hpp"

namespace psicarve::session {

EscapeOrder escape_order(const MachineSight& machine, bool has_orders) {
    using S = MachineState;
    if (!machine.is_heard() || !machine.status) return EscapeOrder::none;
    switch (machine.state()) {
        case S::carving:
            return EscapeOrder::hold;
        case S::waiting:
            // Between the two commands of a start: the hold comes to the core behind the second.
            return has_orders ? EscapeOrder::hold : EscapeOrder::none;
        case S::homing:
        case S::moving:
        case S::positioning:
        case S::finishing:
        case S::backing_off:
        case S::testing:
            return EscapeOrder::stop;
        case S::off:
        case S::ready:
        case S::holding:
        case S::held:
        case S::stopping:
        case S::alarm:
            break;
    }
    return EscapeOrder::none;
}

}  // namespace psicarve::session
