// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "shared/profile.hpp"
#include "shared/status.hpp"

namespace psicarve::cli {

/// "ready", or "in alarm (limit of r1)".
std::string state_text(const CoreStatus& status);

/// A block of lines for a person; positions in mm and degrees too when the machine's profile is known.
std::string status_text(const CoreStatus& status, const Profile* profile);

/// One line that only changes when something a person cares about does.
std::string status_line(const CoreStatus& status);

/// Every field of the status.
nlohmann::ordered_json status_json(const CoreStatus& status);
/// {"cause": ..., "axis": ... or null, "tick": ...}
nlohmann::ordered_json alarm_json(const AlarmRecord& alarm);

/// The alarms that the status still holds, oldest first, from alarm number `first` on.
std::vector<AlarmRecord> alarms_of(const CoreStatus& status, std::uint64_t first = 0);

/// The signals of a word that are active, of those in `mask`: "r1_step spindle", or "none".
std::string signals_text(SignalWord levels, SignalWord mask);

}  // namespace psicarve::cli
