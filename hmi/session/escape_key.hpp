// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "hmi/session/machine_view.hpp"

namespace psicarve::session {

/// The order that Esc gives to the machine where no dialog and no menu takes it.
enum class EscapeOrder : std::uint8_t {
    none,
    hold,  ///< while carving: Resume continues
    stop,  ///< for what cannot be held, and loses nothing by its end
};

/// Never resumes, never ends a carving; none at rest and on hold. `has_orders`: an order is on its way to the
/// core.
EscapeOrder escape_order(const MachineView& machine, bool has_orders);

}  // namespace psicarve::session
