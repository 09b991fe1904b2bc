// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/preflight.hpp"

#include <optional>
#include <string>

#include "hmi/phrase/axis_letter.hpp"
#include "hmi/session/display_text.hpp"
#include "hmi/session/tick_health.hpp"
#include "shared/base/units.hpp"

namespace psicarve::session {
namespace {

using V = Check::Verdict;

Check core_check(const MachineView& machine) {
    const Phrase name = phrase("Core alive");
    if (machine.life == CoreLife::none) return {name, phrase("no core"), V::fail};
    if (!machine.is_heard() || !machine.status) return {name, phrase("silent"), V::fail};
    const double tick_us = static_cast<double>(machine.status->period_ns) / static_cast<double>(kNsPerUs);
    return {name, phrase("%1 µs", number_text(tick_us, 0)), V::pass};
}

Check alarm_check(const MachineView& machine) {
    const bool is_alarm =
        machine.state() == MachineState::alarm || machine.state() == MachineState::backing_off;
    return {phrase("No alarm"), is_alarm ? phrase("reset first") : phrase("none"),
            is_alarm ? V::fail : V::pass};
}

Check limits_check(const MachineView& machine) {
    std::string closed;
    for (const Axis axis : {Axis::r1, Axis::r2, Axis::y}) {
        if (machine.is_active(sensor_of(axis)))
            closed += (closed.empty() ? "" : ", ") + std::string{axis_letter(axis)};
    }
    const Phrase name = phrase("Limits clear");
    if (!closed.empty()) return {name, phrase("%1 closed", closed), V::fail};
    return {name, phrase("3 of 3"), V::pass};
}

Check homed_check(const MachineView& machine) {
    std::string missing;
    for (const Axis axis : kAllAxes) {
        if (!machine.is_homed(axis)) missing += (missing.empty() ? "" : " ") + std::string{axis_letter(axis)};
    }
    const Phrase name = phrase("Axes homed");
    if (!missing.empty()) return {name, phrase("%1", missing), V::fail};
    if (machine.state() == MachineState::off) return {name, phrase("drives off"), V::fail};
    return {name, phrase("R1 R2 Ψ Y"), V::pass};
}

Check made_check(const OpenJobView& job, bool core_has_job) {
    const Phrase name = phrase("Job in travel");
    switch (job.state) {
        case OpenJobState::opening:
        case OpenJobState::slicing:
            return {name, phrase("being made"), V::fail};
        case OpenJobState::model:
            return {name, phrase("slice first"), V::fail};
        case OpenJobState::empty:
            if (!core_has_job) return {name, phrase("no job"), V::fail};
            break;
        case OpenJobState::job:
        case OpenJobState::publishing:
        case OpenJobState::published:
            break;
    }
    return {name, phrase("checked"), V::pass};
}

/// A job that violates it is never made, nor accepted by the core: shows what is kept.
Check clearance_check(const MachineView& machine, const Check& made) {
    const Phrase name = phrase("Head clearance");
    if (made.verdict != V::pass) return {name, phrase("–"), V::info};
    if (!machine.profile) return {name, phrase("not known"), V::info};
    return {name, phrase("≥ %1 mm", number_text(machine.profile->head_clearance_mm, 1)), V::pass};
}

Check published_check(const MachineView& machine, const OpenJobView& job) {
    const Phrase name = phrase("Job published");
    const std::uint64_t generation = machine.status ? machine.status->job_generation : 0;
    if (job.state == OpenJobState::publishing) return {name, phrase("under way"), V::fail};
    const bool is_ours = job.state == OpenJobState::published || job.state == OpenJobState::empty;
    if (generation == 0 || !is_ours) return {name, phrase("publish first"), V::fail};
    return {name, phrase("no. %1", std::to_string(generation)), V::pass};
}

/// The core accepts such a job with a remark: only the person who mounted the blank knows what stands on the
/// table. That may well be the blank that was chosen for the job instead of the profile's.
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

/// The core refuses a job that was made for another machine; this check shows it before.
Check profile_check(const MachineView& machine, const OpenJobView& job) {
    const Phrase name = phrase("Profile matches job");
    const bool has_core_job = machine.status && machine.status->job_generation != 0;
    if (job.state == OpenJobState::empty && !has_core_job) return {name, phrase("no job"), V::info};
    if (!job.profile_difference.empty()) return {name, phrase("%1", job.profile_difference), V::fail};
    const bool is_accepted = job.state == OpenJobState::published || job.state == OpenJobState::empty;
    if (!job.has_job() && !is_accepted) return {name, phrase("–"), V::info};
    if (!machine.profile) return {name, phrase("not known"), V::info};
    if (job.blank_difference) {
        const Phrase of_blank =
            job.blank_difference->is_in_the_way ? phrase("Blank in the way?") : phrase("Blank matches job");
        return {of_blank, blank_detail(*job.blank_difference), V::warning};
    }
    return {name, phrase("%1", machine.profile->name), V::pass};
}

constexpr std::uint64_t kTicksPerMissed = 100'000;  // one in five seconds of a tick of 50 us

/// In the words of the command line for the alarm.
Phrase missed_remedy(const MachineView& machine) {
    if (machine.is_simulator())
        return phrase("start the core with --clock virtual, or raise tick.missed_alarm_per_s");
    return phrase("give the core real-time rights, lengthen tick.period_us or raise tick.missed_alarm_per_s");
}

/// By the rule of the core's alarm once something moves; nothing while no tick is missed.
std::optional<Check> missed_check(const MachineView& machine) {
    if (machine.missed_per_s == 0 || !machine.profile || machine.is_profile_of_job) return std::nullopt;
    const std::int64_t allowed_per_s = machine.profile->tick.missed_alarm_per_s;
    if (allowed_per_s <= 0) return std::nullopt;
    const bool is_over = machine.missed_per_s > static_cast<std::uint64_t>(allowed_per_s);
    Check check{phrase("Ticks in time"),
                phrase("missed %1 of %2 a second", counted(machine.missed_per_s),
                       counted(static_cast<std::uint64_t>(allowed_per_s))),
                is_over ? V::warning : V::pass};
    if (is_over) check.remedy = missed_remedy(machine);
    return check;
}

/// On a simulated machine a busy computer does no harm.
Check ticks_check(const MachineView& machine) {
    const CoreStatus& status = *machine.status;
    const Phrase name = phrase("Real-time rights");
    const bool has_rights = status.has_realtime_rights != 0;
    const auto missed = missed_check(machine);
    if (missed && (missed->verdict == V::warning || machine.is_simulator())) return *missed;
    if (!has_rights) {
        if (machine.is_simulator()) return {name, phrase("not needed"), V::info};
        return {name, phrase("missing"), V::warning};
    }
    const Phrase in_time = phrase("Ticks in time");
    if (!machine.is_simulator() && status.missed_ticks > status.tick / kTicksPerMissed)
        return {in_time, phrase("%1 missed", counted(status.missed_ticks)), V::warning};
    const std::int64_t late_ns = late_p99_ns(status);
    if (!machine.is_simulator() && late_ns > status.period_ns)
        return {in_time, phrase("1 % later than %1", duration_text(late_ns)), V::warning};
    return {name, phrase("granted"), V::pass};
}

Check override_check(const MachineView& machine) {
    const std::uint32_t percent = machine.status->override_percent;
    const Phrase name = phrase("Feed override");
    if (percent == 0) return {name, phrase("not known"), V::info};
    return {name, phrase("%1 %", std::to_string(percent)), percent == 100 ? V::pass : V::warning};
}

}  // namespace

std::vector<Check> preflight_checks(const MachineView& machine, const OpenJobView& job) {
    // While a job runs the checks are about that one, whatever has been opened or sliced since.
    const OpenJobView shown = machine.runs_job() ? OpenJobView{OpenJobState::published} : job;
    std::vector<Check> checks{core_check(machine)};
    if (!machine.status || !machine.is_heard()) return checks;
    checks.push_back(alarm_check(machine));
    checks.push_back(limits_check(machine));
    checks.push_back(homed_check(machine));
    checks.push_back(made_check(shown, machine.status->job_generation != 0));
    checks.push_back(clearance_check(machine, checks.back()));
    checks.push_back(profile_check(machine, shown));
    checks.push_back(published_check(machine, shown));
    checks.push_back(ticks_check(machine));
    checks.push_back(override_check(machine));
    return checks;
}

}  // namespace psicarve::session
