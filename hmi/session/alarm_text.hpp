// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "hmi/phrase/phrase.hpp"
#include "hmi/session/machine_sight.hpp"

namespace psicarve::session {

/// What happened, where, its likely cause, and what to do with the window's own buttons.
struct AlarmText {
    Phrase title;
    Phrase detail;
    std::vector<Phrase> steps;
};

/// Requires a status in alarm, or backing off.
AlarmText alarm_text(const MachineSight& machine);

/// Where in space an alarm is: the heads at which it is to be looked for, R1 and R2. A limit switch of Y is
/// on the slide that carries both. Empty: there is none, or it is of no place.
std::vector<Axis> alarm_heads(const MachineSight& machine);

}  // namespace psicarve::session
