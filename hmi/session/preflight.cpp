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
    if (!missing.empty()) return {name, phrase("%1 not homed", missing), V::fail};
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

Check published_check(const MachineSight& machine, const JobSight& job) {
    const Phrase name = phrase("Job published");
    const std::uint64_t generation = machine.status ? machine.status->job_generation : 0;
    if (job.state == DeskState::publishing) return {name, phrase("under way"), V::fail};
    const bool is_ours = job.state == DeskState::published || job.state == DeskState::empty;
    if (generation == 0 || !is_ours) return {name, phrase("publish first"), V::fail};
    return {name, phrase("no. %1", std::to_string(generation)), V::pass};
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
    checks.push_back(published_check(machine, shown));
    checks.push_back(rights_check(machine));
    return checks;
}

}  // namespace psicarve::session
