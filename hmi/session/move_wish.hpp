// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "hmi/phrase/phrase.hpp"
#include "hmi/session/machine_sight.hpp"
#include "shared/machine/command.hpp"

namespace psicarve::session {

/// Where an operator wants the axes to go, and how.
struct MoveWish {
    std::array<std::optional<double>, kAxisCount>
        target{};  ///< by axis [mm; psi: deg]; those that are to move
    MoveShape shape = MoveShape::straight;
    std::array<double, kAxisCount> centre{};  ///< of an arc, likewise
};

/// What stands in the way of it; nothing when the core can be asked. Travel and clearance are the core's to
/// judge.
std::optional<Phrase> move_lock(const MachineSight& machine, const MoveWish& wish);
/// Requires that nothing stands in the way.
Command move_command(const MoveWish& wish);

/// What stands in the way of switching the spindle by hand.
std::optional<Phrase> spindle_lock(const MachineSight& machine);

}  // namespace psicarve::session
