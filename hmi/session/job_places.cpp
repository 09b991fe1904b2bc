// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/job_places.hpp"

#include <string>

#include "hmi/session/display_text.hpp"
#include "shared/machine/machine_state.hpp"

namespace psicarve::session {

JobPlace place_in_question(const MachineView& machine, const OpenJobView& job, bool knows_core_job) {
    if (job.state == OpenJobState::published) return JobPlace::machine;
    const bool runs = machine.is_heard() && machine.runs_job();
    return runs && knows_core_job ? JobPlace::machine : JobPlace::desk;
}

Phrase machine_job_note(const MachineView& machine) {
    if (machine.life == CoreLife::none || !machine.status) return phrase("no core");
    const CoreStatus& status = *machine.status;
    if (status.job_generation == 0) return {};
    const std::string number = std::to_string(status.job_generation);
    if (status.points_done == 0) return phrase("no. %1", number);
    if (machine.runs_program()) return phrase("no. %1", number);
    const std::string percent = std::to_string(static_cast<int>(100.0 * done_ratio(machine)));
    return status.is_dry != 0 ? phrase("no. %1, dry run %2 %", number, percent)
                              : phrase("no. %1, %2 % done", number, percent);
}

Phrase desk_job_note(const OpenJobView& job) {
    switch (job.state) {
        case OpenJobState::empty:
            return phrase("nothing");
        case OpenJobState::opening:
            return phrase("being read");
        case OpenJobState::model:
            return phrase("not sliced");
        case OpenJobState::slicing:
            return phrase("being sliced");
        case OpenJobState::job:
            break;
        case OpenJobState::publishing:
            return phrase("being published");
        case OpenJobState::published:
            return phrase("the same job");
    }
    return job.was_published ? phrase("no longer in the machine") : phrase("not published");
}

}  // namespace psicarve::session
