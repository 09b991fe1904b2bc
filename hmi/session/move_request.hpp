// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "hmi/phrase/phrase.hpp"
#include "hmi/session/machine_view.hpp"
#include "shared/machine/command.hpp"

namespace psicarve::session {

/// The target of a move that an operator asks for, and its manner.
struct MoveRequest {
    std::array<std::optional<double>, kAxisCount>
        target{};  ///< by axis [mm; psi: deg]; the axes that are to move
    MoveShape shape = MoveShape::straight;
    std::array<double, kAxisCount> centre{};  ///< of an arc, by axis
};

/// Why the core cannot be asked; nothing when it can. The core judges travel and clearance.
std::optional<Phrase> move_lock(const MachineView& machine, const MoveRequest& request);
/// Requires that move_lock() gives nothing.
Command move_command(const MoveRequest& request);

/// Why the spindle cannot be switched by hand.
std::optional<Phrase> spindle_lock(const MachineView& machine);

}  // namespace psicarve::session
