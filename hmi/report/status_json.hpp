// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "shared/machine/status.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::report {

/// Every field of the status. `pulses_per_rev`: see alarm_json().
nlohmann::ordered_json status_json(const CoreStatus& status, std::int64_t pulses_per_rev = 0);
/// The table's angle within a turn, and the number of whole turns counted.
struct TableAngle {
    double within_deg;  ///< 0 <= angle < 360
    std::int64_t turns;
};
TableAngle table_angle(std::int64_t pulses, const Profile& profile);
/// {"r1_mm", "r2_mm", "psi_deg", "psi_turns", "y_mm"} of the machine whose profile this is.
nlohmann::ordered_json position_json(const CoreStatus& status, const Profile& profile);
/// {"cause": ..., "axis": ... or null, "tick": ...}. `pulses_per_rev`: of the table, for the amount of lost
/// steps in degrees; 0: not known.
nlohmann::ordered_json alarm_json(const AlarmRecord& alarm, std::int64_t pulses_per_rev = 0);

/// The alarms that the status still holds, oldest first, from alarm number `first` on.
std::vector<AlarmRecord> alarms_of(const CoreStatus& status, std::uint64_t first = 0);

/// The signals of a word that are active, of those in `mask`: "r1_step spindle", or "none".
std::string signals_text(SignalWord levels, SignalWord mask);

}  // namespace psicarve::report
