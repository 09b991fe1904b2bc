// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "hmi/session/alarm_text.hpp"
#include "hmi/session/machine_view.hpp"

namespace psicarve::session {

/// The core is gone or silent and was at work when it was last heard: the machine's state is not known, and
/// no order reaches it.
bool is_lost_at_work(const MachineView& machine) noexcept;

/// What the operator must read before anything else: an emergency stop that no core heard, a core that was
/// lost at work or in alarm, an alarm. Nothing: there is none of these.
std::optional<AlarmText> loud_text(const MachineView& machine);

/// "The core has ended in layer 14, point 7": the state that a core lost at work left behind.
AlarmText lost_core_text(const MachineView& machine);

}  // namespace psicarve::session
