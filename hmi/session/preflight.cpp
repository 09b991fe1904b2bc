// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/preflight.hpp"

#include <string>

#include "hmi/session/display_text.hpp"
#include "shared/units.hpp"

namespace psicarve::session {
namespace {

using V = Check::Verdict;

Check core_check(const MachineSight& machine) {
    const Phrase name = phrase("Core alive");
    if (machine.life == CoreLife::none) return {name, phrase("no core"), V::fail};
    if (!machine.is_heard() || !machine.status) return {name, phrase("silent"), V::fail};
    const double tick_us = static_cast<double>(machine.status->period_ns) / static_cast<double>(kNsPerUs);
    return {name, phrase("%1 µs", number_text(tick_us, 0)), V::pass};
}

Check alarm_check(const MachineSight& machine) {
    const bool is_alarm =
        machine.state() == MachineState::alarm || machine.state() == MachineState::backing_off;
    return {phrase("No alarm"), is_alarm ? phrase("reset first") : phrase("none"),
            is_alarm ? V::fail : V::pass};
}

Check limits_check(const MachineSight& machine) {
    std::string closed;
    for (const Axis axis : {Axis::r1, Axis::r2, Axis::y}) {
        if (machine.is_active(sensor_of(axis)))
            closed += (closed.empty() ? "" : ", ") + std::string{axis_letter(axis)};
    }
    const Phrase name = phrase("Limits clear");
    if (!closed.empty()) return {name, phrase("%1 closed", closed), V::fail};
    return {name, phrase("3 of 3"), V::pass};
}

Check homed_check(const MachineSight& machine) {
    std::string missing;
    for (const Axis axis : kAllAxes) {
        if (!machine.is_homed(axis)) missing += (missing.empty() ? "" : " ") + std::string{axis_letter(axis)};
    }
    const Phrase name = phrase("Axes homed");
    if (!missing.empty()) return {name, phrase("%1", missing), V::fail};
    return {name, phrase("R1 R2 Ψ Y"), V::pass};
}

Check made_check(const JobSight& job, bool core_has_job) {
    const Phrase name = phrase("Job in travel");
    switch (job.state) {
        case DeskState::opening:
        case DeskState::slicing:
            return {name, phrase("being made"), V::fail};
        case DeskState::model:
            return {name, phrase("slice first"), V::fail};
        case DeskState::empty:
            if (!core_has_job) return {name, phrase("no job"), V::fail};
            break;
        case DeskState::job:
        case DeskState::publishing:
        case DeskState::published:
            break;
    }
    return {name, phrase("checked"), V::pass};
}

/// A job that does not keep it is never made, nor accepted by the core: what is kept is told.
Check clearance_check(const MachineSight& machine, const Check& made) {
    const Phrase name = phrase("Head clearance");
    if (made.verdict != V::pass) return {name, phrase("–"), V::info};
    if (!machine.profile) return {name, phrase("not known"), V::info};
    return {name, phrase("≥ %1 mm", number_text(machine.profile->head_clearance_mm, 1)), V::pass};
}

Check published_check(const MachineSight& machine, const JobSight& job) {
    const Phrase name = phrase("Job published");
    const std::uint64_t generation = machine.status ? machine.status->job_generation : 0;
    if (job.state == DeskState::publishing) return {name, phrase("under way"), V::fail};
    const bool is_ours = job.state == DeskState::published || job.state == DeskState::empty;
    if (generation == 0 || !is_ours) return {name, phrase("publish first"), V::fail};
    return {name, phrase("no. %1", std::to_string(generation)), V::pass};
}

/// The core takes such a job, and says so: what stands on the table is known only to who mounted it.
Phrase blank_detail(const BlankDifference& difference) {
    const std::string job = number_text(difference.job_mm, 1);
    const std::string machine = number_text(difference.machine_mm, 1);
    switch (difference.in) {
        case BlankDifference::In::radius:
            return phrase("r %1 ≠ %2", job, machine);
        case BlankDifference::In::height:
            return phrase("h %1 ≠ %2", job, machine);
        case BlankDifference::In::place:
            break;
    }
    return phrase("%1 mm beside", machine);
}

/// The core refuses a job that was made for another machine; here it is told before.
Check profile_check(const MachineSight& machine, const JobSight& job) {
    const Phrase name = phrase("Profile matches job");
    const bool has_core_job = machine.status && machine.status->job_generation != 0;
    if (job.state == DeskState::empty && !has_core_job) return {name, phrase("no job"), V::info};
    if (!job.profile_difference.empty()) return {name, phrase("%1", job.profile_difference), V::fail};
    const bool is_accepted = job.state == DeskState::published || job.state == DeskState::empty;
    if (!job.has_job() && !is_accepted) return {name, phrase("–"), V::info};
    if (!machine.profile) return {name, phrase("not known"), V::info};
    if (job.blank_difference) {
        const V verdict = job.blank_difference->is_in_the_way ? V::fail : V::info;
        return {phrase("Blank matches job"), blank_detail(*job.blank_difference), verdict};
    }
    return {name, phrase("%1", machine.profile->name), V::pass};
}

Check rights_check(const MachineSight& machine) {
    const Phrase name = phrase("Real-time rights");
    if (machine.status->has_realtime_rights != 0) return {name, phrase("granted"), V::pass};
    if (machine.is_simulator()) return {name, phrase("not needed"), V::info};
    return {name, phrase("missing"), V::info};
}

}  // namespace

std::vector<Check> preflight_checks(const MachineSight& machine, const JobSight& job) {
    // While a job runs the checks are of that one, whatever has been opened or sliced since.
    const JobSight shown = runs_job(machine.state()) ? JobSight{DeskState::published} : job;
    std::vector<Check> checks{core_check(machine)};
    if (!machine.status || !machine.is_heard()) return checks;
    checks.push_back(alarm_check(machine));
    checks.push_back(limits_check(machine));
    checks.push_back(homed_check(machine));
    checks.push_back(made_check(shown, machine.status->job_generation != 0));
    checks.push_back(clearance_check(machine, checks.back()));
    checks.push_back(profile_check(machine, shown));
    checks.push_back(published_check(machine, shown));
    checks.push_back(rights_check(machine));
    return checks;
}

}  // namespace psicarve::session
