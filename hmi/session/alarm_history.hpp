// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "hmi/session/message_log.hpp"

namespace psicarve::session {

/// The alarms that are in the core's status and were not in the last one, oldest first, each with its own
/// time. For a core that was not heard before, all that it still has; those from before the window looked are
/// marked, also those without a time of a core that was there already. Requires a status in `after`.
std::vector<Message> fresh_alarms(const MachineView& before, const MachineView& after);

}  // namespace psicarve::session
