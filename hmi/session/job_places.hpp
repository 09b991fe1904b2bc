// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "hmi/phrase/phrase.hpp"
#include "hmi/session/machine_sight.hpp"

namespace psicarve::session {

/// Where a job can be: two places, and often two jobs.
enum class JobPlace : std::uint8_t {
    machine,  ///< the core has accepted it
    desk,     ///< it is open here
};

/// Whose numbers and checks are shown: the machine's while it runs one or has the one that is open, else what
/// is open, as nothing else is started. `knows_core_job`: what the core has was read.
JobPlace place_in_question(const MachineSight& machine, const JobSight& job, bool knows_core_job);
/// Beside the machine's job: "no. 3, 40 % done". Empty: there is none.
Phrase machine_job_note(const MachineSight& machine);
/// Beside what is open: "not sliced", "the same job".
Phrase desk_job_note(const JobSight& job);

}  // namespace psicarve::session
