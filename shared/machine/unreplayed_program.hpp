// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "shared/machine/status.hpp"

namespace psicarve {

/// Why nothing is replayed of a flight recorder that has a program and no moment for a replay after it;
/// empty: it has none.
std::string unreplayed_program_text(std::span<const FlightRecord> records);

}  // namespace psicarve
