// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/message_log.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "hmi/session/alarm_text.hpp"

namespace psicarve::session {
namespace {

Message message(Severity severity, Phrase what, Phrase remedy = {}) {
    return {std::chrono::system_clock::now(), severity, std::move(what), std::move(remedy)};
}

void tell_core(const MachineSight& before, const MachineSight& after, std::vector<Message>& told) {
    const bool was_there = before.life != CoreLife::none;
    const bool is_there = after.life != CoreLife::none;
    if (!was_there && is_there) {
        told.push_back(
            message(Severity::info, phrase("Core found, process %1", std::to_string(after.core_pid))));
    } else if (was_there && !is_there) {
        // Where to go on from is known nowhere else once another core has begun.
        const bool has_begun = before.status && before.status->points_done > 0 &&
                               before.status->points_done < before.status->points_total;
        told.push_back(message(
            Severity::warning,
            has_begun ? phrase("The core has ended in layer %1", std::to_string(before.status->layer + 1))
                      : phrase("The core has ended"),
            phrase("Start it again; home before carving on")));
    } else if (before.life != CoreLife::silent && after.life == CoreLife::silent) {
        told.push_back(message(Severity::warning, phrase("The core is silent"),
                               phrase("Use the switch on the machine to stop it")));
    }
    if (!after.segment_problem.empty() && before.segment_problem != after.segment_problem)
        told.push_back(message(Severity::warning, phrase("%1", after.segment_problem)));
}

void tell_alarm(const MachineSight& after, std::vector<Message>& told) {
    const AlarmText text = alarm_text(after);
    told.push_back(message(Severity::alarm, text.title, text.steps.empty() ? Phrase{} : text.steps.front()));
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
}

}  // namespace

std::vector<Message> changes_between(const MachineSight& before, const MachineSight& after) {
    std::vector<Message> told;
    tell_core(before, after, told);
    if (!after.status || !after.is_heard()) return told;
    const bool is_alarm = after.state() == MachineState::alarm;
    if (!before.status || !before.is_heard()) {
        if (is_alarm) tell_alarm(after, told);
        return told;
    }
    // A core that was started anew begins its counts again.
    const bool has_new_alarm = after.status->alarm_count > before.status->alarm_count;
    if (is_alarm && (has_new_alarm || before.state() != MachineState::alarm)) {
        tell_alarm(after, told);
    } else if (before.state() != after.state()) {
        told.push_back(message(Severity::info, phrase("Machine: %1", name_of(after.state()))));
    }
    tell_job(*before.status, *after.status, told);
    return told;
}

void MessageLog::add(Message message) {
    messages_.push_back(std::move(message));
    if (messages_.size() > kMost) messages_.pop_front();
    ++count_;
}

void MessageLog::add(Severity severity, Phrase what, Phrase remedy) {
    add(message(severity, std::move(what), std::move(remedy)));
}

}  // namespace psicarve::session
