// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "shared/machine/status.hpp"

namespace psicarve::report {

/// One entry of the flight recorder on one line: "tick 1234  command home done  r1 0 r2 0 psi 0 y 0".
std::string record_text(const FlightRecord& record);
nlohmann::ordered_json record_json(const FlightRecord& record);

}  // namespace psicarve::report
