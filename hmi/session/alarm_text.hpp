// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "hmi/session/machine_sight.hpp"
#include "hmi/session/phrase.hpp"

namespace psicarve::session {

/// What happened, where, its likely cause, and what to do with the window's own buttons.
struct AlarmText {
    Phrase title;
    Phrase detail;
    std::vector<Phrase> steps;
};

/// Requires a status in alarm, or backing off.
AlarmText alarm_text(const MachineSight& machine);

}  // namespace psicarve::session
