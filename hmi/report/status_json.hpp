// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "shared/status.hpp"

namespace psicarve::report {

/// Every field of the status.
nlohmann::ordered_json status_json(const CoreStatus& status);
/// {"cause": ..., "axis": ... or null, "tick": ...}
nlohmann::ordered_json alarm_json(const AlarmRecord& alarm);

/// The alarms that the status still holds, oldest first, from alarm number `first` on.
std::vector<AlarmRecord> alarms_of(const CoreStatus& status, std::uint64_t first = 0);

/// The signals of a word that are active, of those in `mask`: "r1_step spindle", or "none".
std::string signals_text(SignalWord levels, SignalWord mask);

}  // namespace psicarve::report
