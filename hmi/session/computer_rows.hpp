// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "hmi/doctor/finding.hpp"
#include "hmi/phrase/phrase.hpp"
#include "shared/machine/status.hpp"

namespace psicarve::session {

/// One condition for a punctual tick, and what to do where it is not met.
struct ComputerRow {
    enum class Verdict : std::uint8_t { good, warning, problem };
    Phrase name;
    Verdict verdict = Verdict::good;
    Phrase seen;
    Phrase remedy;  ///< empty when all is well
};

/// The core's real-time setup: each step, and whether the system granted it. Empty on the virtual clock.
std::vector<ComputerRow> realtime_rows(const CoreStatus& status);

/// The results of the checks of this computer.
std::vector<ComputerRow> finding_rows(const std::vector<doctor::Finding>& findings);

}  // namespace psicarve::session
