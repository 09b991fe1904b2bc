// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "hmi/session/message_log.hpp"

namespace psicarve::session {

/// The alarms that the core has in its status and that were not there at the look before, oldest first, each
/// with its own time. Of a core that was not heard before these are all that it still knows; those that came
/// before somebody looked are marked, also those without a time of a core that was there already. Requires a
/// status in `after`.
std::vector<Message> fresh_alarms(const MachineSight& before, const MachineSight& after);

}  // namespace psicarve::session
