// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "shared/machine/recorded_program.hpp"

namespace psicarve::report {

/// What an entry of the flight recorder tells of a program: "begun no. 7, single block", "line 8 (record
/// 34)", "line 8 (record 34): held, tool change", "before its first line: ended, stopped".
std::string program_record_text(const FlightRecord& record);
/// "begun", "line", "held"...
std::string program_event_text(const FlightRecord& record);
/// Number, line, sequence and what else it tells; null for entries of other kinds.
nlohmann::ordered_json program_record_json(const FlightRecord& record);

}  // namespace psicarve::report
