// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "hmi/report/lost_steps.hpp"
#include "shared/machine/status.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::report {

/// Every field of the status. `table`: see alarm_json().
nlohmann::ordered_json status_json(const CoreStatus& status, const TableSize& table = {});
/// The table's angle within a turn, and the number of whole turns counted.
struct TableAngle {
    double within_deg;  ///< 0 <= angle < 360
    std::int64_t turns;
};
TableAngle table_angle(std::int64_t pulses, const Profile& profile);
/// {"r1_mm", "r2_mm", "psi_deg", "psi_turns", "y_mm"} of the machine whose profile this is.
nlohmann::ordered_json position_json(const CoreStatus& status, const Profile& profile);
/// {"cause": ..., "axis": ... or null, "tick": ...}. `table`: for the amount of lost steps in degrees and mm.
nlohmann::ordered_json alarm_json(const AlarmRecord& alarm, const TableSize& table = {});

/// The alarms that the status still holds, oldest first, from alarm number `first` on.
std::vector<AlarmRecord> alarms_of(const CoreStatus& status, std::uint64_t first = 0);

/// The signals of a word that are active, of those in `mask`: "r1_step spindle", or "none".
std::string signals_text(SignalWord levels, SignalWord mask);

}  // namespace psicarve::report
