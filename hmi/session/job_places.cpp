// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/job_places.hpp"

#include <string>

#include "hmi/session/display_text.hpp"
#include "shared/machine/machine_state.hpp"

namespace psicarve::session {

JobPlace place_in_question(const MachineSight& machine, const JobSight& job, bool knows_core_job) {
    if (job.state == DeskState::published) return JobPlace::machine;
    const bool runs = machine.is_heard() && runs_job(machine.state());
    return runs && knows_core_job ? JobPlace::machine : JobPlace::desk;
}

Phrase machine_job_note(const MachineSight& machine) {
    if (machine.life == CoreLife::none || !machine.status) return phrase("no core");
    const CoreStatus& status = *machine.status;
    if (status.job_generation == 0) return {};
    const std::string number = std::to_string(status.job_generation);
    if (status.points_done == 0) return phrase("no. %1", number);
    const std::string percent = std::to_string(static_cast<int>(100.0 * done_ratio(machine)));
    return status.is_dry != 0 ? phrase("no. %1, dry run %2 %", number, percent)
                              : phrase("no. %1, %2 % done", number, percent);
}

Phrase desk_job_note(const JobSight& job) {
    switch (job.state) {
        case DeskState::empty:
            return phrase("nothing");
        case DeskState::opening:
            return phrase("being read");
        case DeskState::model:
            return phrase("not sliced");
        case DeskState::slicing:
            return phrase("being sliced");
        case DeskState::job:
            break;
        case DeskState::publishing:
            return phrase("being published");
        case DeskState::published:
            return phrase("the same job");
    }
    return job.was_published ? phrase("no longer in the machine") : phrase("not published");
}

}  // namespace psicarve::session
