// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "hmi/session/machine_sight.hpp"

namespace psicarve::session {

/// What Esc asks of the machine where no dialog and no menu takes it.
enum class EscapeOrder : std::uint8_t {
    none,
    hold,  ///< what is carved: Resume goes on
    stop,  ///< what cannot be held: there is nothing to lose by its end
};

/// Never resumes, never ends what is carved; at rest it is none, on hold too. `has_orders`: one is on its way
/// to the core.
EscapeOrder escape_order(const MachineSight& machine, bool has_orders);

}  // namespace psicarve::session
