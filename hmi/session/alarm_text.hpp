// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "hmi/phrase/phrase.hpp"
#include "hmi/session/machine_view.hpp"

namespace psicarve::session {

/// An alarm's event, place, likely cause, and the steps with the window's own buttons.
struct AlarmText {
    Phrase title;
    Phrase detail;
    std::vector<Phrase> steps;
};

/// Requires a status in alarm, or backing off.
AlarmText alarm_text(const MachineView& machine);

/// The heads at which the operator should look for an alarm: R1 and R2. A limit switch of Y is on the slide
/// that carries both. Empty: there is no alarm, or it has no place.
std::vector<Axis> alarm_heads(const MachineView& machine);

}  // namespace psicarve::session
