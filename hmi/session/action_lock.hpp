// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "hmi/phrase/phrase.hpp"
#include "hmi/session/machine_view.hpp"

namespace psicarve::session {

/// The actions that an operator may ask for. Emergency stop is not here: it is never locked.
enum class Action : std::uint8_t {
    home,
    jog,
    start,
    one_layer,
    from_layer,
    hold,
    resume,
    stop,
    override_feed,
    reset_alarm,
    back_off,
    slice,
    publish,
};

/// Why the action is not allowed; nothing when it is. "Start: axis Y is not homed".
std::optional<Phrase> lock_of(Action action, const MachineView& machine, const OpenJobView& job);

}  // namespace psicarve::session
