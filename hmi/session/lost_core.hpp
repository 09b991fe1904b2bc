// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "hmi/session/alarm_text.hpp"
#include "hmi/session/machine_sight.hpp"

namespace psicarve::session {

/// The core is gone or silent and was at work when it was heard last: nobody knows what the machine does, and
/// nothing in the window reaches it.
bool is_lost_at_work(const MachineSight& machine) noexcept;

/// What has to be read before anything else is done: an emergency stop that nobody heard, a core that was
/// lost at work or in alarm, an alarm. Nothing: there is nothing of that kind.
std::optional<AlarmText> loud_text(const MachineSight& machine);

/// "The core has ended in layer 14, point 7": what a core that was lost at work left behind.
AlarmText lost_core_text(const MachineSight& machine);

}  // namespace psicarve::session
