// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/message_log.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "hmi/phrase/axis_letter.hpp"
#include "hmi/phrase/message_phrase.hpp"
#include "hmi/session/alarm_history.hpp"
#include "hmi/session/alarm_text.hpp"
#include "hmi/session/lost_core.hpp"
#include "hmi/session/program_phrase.hpp"
#include "hmi/session/saved_piece.hpp"

namespace psicarve::session {
namespace {

Message message(Severity severity, Phrase what, Phrase remedy = {}) {
    return {std::chrono::system_clock::now(), severity, std::move(what), std::move(remedy)};
}

/// A loss that needs action at once is an alarm, even without a core to raise one.
Message lost_message(const MachineView& machine) {
    AlarmText text = lost_core_text(machine);
    return message(Severity::alarm, std::move(text.title), std::move(text.steps.front()));
}

/// Each block of a program in single block would be a message: those are for the status alone.
void tell_program(const MachineView& before, const MachineView& after, std::vector<Message>& told) {
    const ProgramStatus& program = after.program;
    const bool is_on = after.runs_program();
    if (is_on && !before.runs_program()) told.push_back(message(Severity::info, phrase("Program begun")));
    if (!is_on && before.runs_program() && after.state() != MachineState::alarm) {
        told.push_back(message(Severity::info, program.is_done != 0
                                                   ? phrase("Program done, up to line %1", line_text(program))
                                                   : phrase("Program ended in line %1", line_text(program))));
    }
    if (!is_on || program.hold == before.program.hold || program.hold == ProgramHold::single) return;
    Phrase why = hold_phrase(program.hold);
    if (why.is_empty()) return;
    const bool is_broken = is_for_good(program.hold);
    if (is_broken && after.program_refusal) why = message_phrase(*after.program_refusal);
    told.push_back(message(is_broken ? Severity::warning : Severity::info,
                           joined(phrase("Program held in line %1", line_text(program)), std::move(why)),
                           is_broken ? phrase("Nothing is left of it but to stop") : Phrase{}));
}

Message end_message(const MachineView& before) {
    // Once another core has begun, only this message keeps the place to continue from.
    const bool has_begun = before.status && before.status->points_done > 0 &&
                           before.status->points_done < before.status->points_total;
    return message(Severity::warning,
                   has_begun
                       ? phrase("The core has ended in layer %1", std::to_string(before.status->layer + 1))
                       : phrase("The core has ended"),
                   phrase("Start it again; home before carving on"));
}

void tell_core(const MachineView& before, const MachineView& after, std::vector<Message>& told) {
    const bool was_there = before.life != CoreLife::none;
    const bool is_there = after.life != CoreLife::none;
    if (!was_there && is_there) {
        told.push_back(
            message(Severity::info, phrase("Core found, process %1", std::to_string(after.core_pid))));
    } else if (was_there && !is_there) {
        told.push_back(is_lost_at_work(after) ? lost_message(after) : end_message(before));
    } else if (before.life != CoreLife::silent && after.life == CoreLife::silent) {
        told.push_back(is_lost_at_work(after) ? lost_message(after)
                                              : message(Severity::warning, phrase("The core is silent"),
                                                        phrase("Use the switch on the machine to stop it")));
    }
    if (before.life == CoreLife::silent && after.is_heard())
        told.push_back(message(Severity::info, phrase("The core is heard again")));
    if (!after.segment_problem.empty() && before.segment_problem != after.segment_problem)
        told.push_back(message(Severity::warning, phrase("%1", after.segment_problem)));
}

/// "R1 R2": those of `mask`.
std::string axes_text(std::uint32_t mask) {
    std::string text;
    for (const Axis axis : kAllAxes) {
        if ((mask >> index_of(axis) & 1U) == 0) continue;
        text += (text.empty() ? "" : " ") + std::string{axis_letter(axis)};
    }
    return text;
}

void tell_homed(const CoreStatus& before, const CoreStatus& after, std::vector<Message>& told) {
    const std::uint32_t fresh = after.homed_mask & ~static_cast<std::uint32_t>(before.homed_mask);
    const std::uint32_t lost = before.homed_mask & ~static_cast<std::uint32_t>(after.homed_mask);
    const auto tell = [&told](std::uint32_t mask, Severity severity, Phrase what, Phrase remedy) {
        if (mask == 0) return;
        told.push_back(message(severity, std::move(what), std::move(remedy)));
        told.back().axes = axes_text(mask);
    };
    tell(fresh, Severity::info, phrase("Homed"), {});
    // Homing forgets positions that it will find; an alarm says itself what to do.
    if (after.state != MachineState::homing)
        tell(lost, Severity::info, phrase("Position not certain any more"), phrase("Home before carving"));
}

void tell_job(const CoreStatus& before, const CoreStatus& after, std::vector<Message>& told) {
    if (after.job_generation != before.job_generation && after.job_generation != 0)
        told.push_back(
            message(Severity::info, phrase("Job no. %1 accepted", std::to_string(after.job_generation))));
    if (after.override_percent != before.override_percent && before.override_percent != 0) {
        told.push_back(message(Severity::info,
                               phrase("Feed override %1 % → %2 %", std::to_string(before.override_percent),
                                      std::to_string(after.override_percent))));
    }
    const std::uint32_t rapid_before = rapid_override_percent(before);
    const std::uint32_t rapid_after = rapid_override_percent(after);
    if (rapid_before != rapid_after)
        told.push_back(
            message(Severity::info, phrase("Override of rapids %1 % → %2 %", std::to_string(rapid_before),
                                           std::to_string(rapid_after))));
}

void tell_profile(const MachineView& before, const MachineView& after, std::vector<Message>& told) {
    const bool is_new = before.unused_profile != after.unused_profile ||
                        before.core_profile_hash != after.core_profile_hash || !before.is_heard();
    if (after.unused_profile.empty() || !is_new) return;
    told.push_back(
        message(Severity::warning,
                after.profile && !after.is_profile_of_job
                    ? phrase("Profile %1 of --profile is not the machine's, which counts by its own, %2",
                             after.unused_profile, after.profile->name)
                    : phrase("Profile %1 of --profile is not the machine's, which counts by another one",
                             after.unused_profile),
                phrase("Start psicarve-rtcore with that profile, or the window without it")));
}

/// Reports it each time that the disk begins to refuse.
void tell_refusing_disk(const MachineView& before, const MachineView& after, std::vector<Message>& told) {
    if (!after.is_disk_refusing || before.is_disk_refusing) return;
    told.push_back(message(Severity::warning, phrase("The disk does not take how far the piece has come"),
                           phrase("If the power fails, do not go on by it; see to the disk.")));
}

/// Reports it when the core accepts the job, or a window begins to look.
void tell_disagreement(const MachineView& before, const MachineView& after, std::vector<Message>& told) {
    auto both = disagreement(after);
    if (both && disagreement(before) != both)
        told.push_back(message(Severity::warning, *std::move(both),
                               phrase("See how far the piece is carved before it goes on.")));
}

}  // namespace

std::vector<Message> changes_between(const MachineView& before, const MachineView& after) {
    std::vector<Message> told;
    std::vector<Message> alarms;
    if (after.status && after.is_heard()) alarms = fresh_alarms(before, after);
    const auto news = std::find_if(alarms.begin(), alarms.end(),
                                   [](const Message& alarm) { return !alarm.is_from_before; });
    std::move(alarms.begin(), news, std::back_inserter(told));
    tell_core(before, after, told);
    if (!after.status || !after.is_heard()) return told;
    tell_profile(before, after, told);
    std::move(news, alarms.end(), std::back_inserter(told));
    tell_disagreement(before, after, told);
    tell_refusing_disk(before, after, told);
    if (!before.status || !before.is_heard()) return told;
    const bool is_alarm = after.state() == MachineState::alarm;
    if (!is_alarm && before.state() != after.state())
        told.push_back(message(Severity::info, phrase("Machine: %1", name_of(after.state()))));
    tell_program(before, after, told);
    if (!is_alarm) tell_homed(*before.status, *after.status, told);
    tell_job(*before.status, *after.status, told);
    return told;
}

void MessageLog::add(Message message) {
    messages_.push_back(std::move(message));
    if (messages_.size() > kMost) messages_.pop_front();
    ++count_;
}

void MessageLog::add_command(Severity severity, Phrase what) {
    Message told = message(severity, std::move(what));
    told.is_command = true;
    add(std::move(told));
}

void MessageLog::add(Severity severity, Phrase what, Phrase remedy) {
    add(message(severity, std::move(what), std::move(remedy)));
}

}  // namespace psicarve::session
