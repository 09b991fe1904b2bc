// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "hmi/doctor/finding.hpp"
#include "hmi/phrase/phrase.hpp"
#include "shared/machine/status.hpp"

namespace psicarve::session {

/// One thing that keeps the tick punctual, and what to do where it does not.
struct ComputerRow {
    enum class Verdict : std::uint8_t { good, warning, problem };
    Phrase name;
    Verdict verdict = Verdict::good;
    Phrase seen;
    Phrase remedy;  ///< nothing when all is well
};

/// How the core treats its own tick: each step, and whether it was granted. Nothing on the virtual clock.
std::vector<ComputerRow> realtime_rows(const CoreStatus& status);

/// What was looked at on this computer.
std::vector<ComputerRow> finding_rows(const std::vector<doctor::Finding>& findings);

}  // namespace psicarve::session
