// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "hmi/phrase/phrase.hpp"
#include "hmi/session/machine_view.hpp"

namespace psicarve::session {

/// The two places of jobs, which often differ.
enum class JobPlace : std::uint8_t {
    machine,  ///< the core has accepted it
    desk,     ///< it is open here
};

/// The place whose numbers and checks are shown: the machine while it runs a job or has the open one, else
/// the desk, since only the open job can be started. `knows_core_job`: the core's job was read.
JobPlace place_in_question(const MachineView& machine, const OpenJobView& job, bool knows_core_job);
/// Text beside the machine's job: "no. 3, 40 % done". Empty: there is none.
Phrase machine_job_note(const MachineView& machine);
/// Text beside the open job: "not sliced", "the same job".
Phrase desk_job_note(const OpenJobView& job);

}  // namespace psicarve::session
