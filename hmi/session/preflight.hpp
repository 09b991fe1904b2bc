// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "hmi/session/machine_sight.hpp"
#include "hmi/session/phrase.hpp"

namespace psicarve::session {

struct Check {
    enum class Verdict : std::uint8_t { pass, fail, info };
    Phrase name;
    Phrase detail;
    Verdict verdict = Verdict::fail;
};

/// What must be so before Start, in the order in which it is put right. Travel and head clearance need no
/// line of their own: a job that does not keep them is never made, and never accepted by the core.
std::vector<Check> preflight_checks(const MachineSight& machine, const JobSight& job);

}  // namespace psicarve::session
