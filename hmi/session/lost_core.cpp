// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/lost_core.hpp"

#include <string>
#include <utility>

#include "hmi/session/program_phrase.hpp"
#include "hmi/session/start_place.hpp"

namespace psicarve::session {
namespace {

using S = MachineState;

bool is_in_alarm(const MachineView& machine) noexcept {
    return machine.status && (machine.state() == S::alarm || machine.state() == S::backing_off);
}

/// Whether the guard has reported the core's death, and its own reaction.
bool is_told_by_guard(const MachineView& machine) noexcept {
    return machine.life == CoreLife::none && machine.status &&
           machine.status->alarm_cause == AlarmCause::core_lost;
}

/// The core's own last state; its guard's comes after it.
S own_state(const MachineView& machine) noexcept {
    return machine.heard_state.value_or(machine.state());
}

bool is_silent(const MachineView& machine) noexcept {
    return machine.life == CoreLife::silent;
}

bool is_within_program(const MachineView& machine) noexcept {
    return machine.runs_program() ||
           (machine.program.is_running != 0 && !machine.heard_state && is_told_by_guard(machine));
}

/// Some of the job was carved, and not all.
bool is_within_job(const MachineView& machine) noexcept {
    if (is_within_program(machine)) return false;
    const CoreStatus& status = *machine.status;
    const S state = own_state(machine);
    const bool may_run = runs_job(state) || (!machine.heard_state && is_told_by_guard(machine));
    return may_run && status.points_done > 0 && status.points_done < status.points_total;
}

Phrase lost_title(const MachineView& machine) {
    const bool silent = is_silent(machine);
    if (is_within_program(machine)) {
        const std::string line = line_text(machine.program);
        return silent ? phrase("The core is silent, in line %1 of its program", line)
                      : phrase("The core has ended in line %1 of its program", line);
    }
    if (is_within_job(machine)) {
        const std::string layer = std::to_string(machine.status->layer + 1);
        const std::string point = std::to_string(machine.status->point + 1);
        return silent ? phrase("The core is silent, in layer %1, point %2", layer, point)
                      : phrase("The core has ended in layer %1, point %2", layer, point);
    }
    if (!is_lost_at_work(machine)) return phrase("The core has ended");
    return silent ? phrase("The core is silent in the middle of its work")
                  : phrase("The core has ended in the middle of its work");
}

Phrase outputs_sentence(const MachineView& machine) {
    if (!is_told_by_guard(machine))
        return phrase("Drives and spindle may still be on, and nothing here can switch them off.");
    return machine.status->is_port_silent != 0
               ? phrase("Its guard could not switch drives and spindle off: the port does not answer.")
               : phrase("Its guard has switched drives and spindle off.");
}

Phrase lost_detail(const MachineView& machine) {
    const Phrase outputs = outputs_sentence(machine);
    const bool may_be_in_piece =
        is_within_program(machine) || (is_within_job(machine) && machine.status->is_dry == 0);
    if (!may_be_in_piece) return Phrase{"%1", {}, {outputs}};
    return Phrase{"%1 %2", {}, {outputs, phrase("The heads may stand in the piece.")}};
}

void add_new_core(const MachineView& machine, AlarmText& text) {
    if (is_silent(machine))
        text.steps.push_back(phrase("End psicarve-rtcore, process %1", std::to_string(machine.core_pid)));
    text.steps.push_back(phrase("Start psicarve-rtcore"));
    text.steps.push_back(phrase("Home all"));
}

/// From the checkpoint, which outlives its core; there is none of a program.
void add_way_on(const MachineView& machine, AlarmText& text) {
    if (is_within_program(machine)) return text.steps.push_back(program_way_on(machine.program));
    if (!is_within_job(machine) || machine.status->is_dry != 0) return;
    if (const auto place = place_to_go_on(machine)) {
        text.steps.push_back(continue_text(*place));
    } else {
        text.steps.push_back(phrase("Start: no layer was finished"));
    }
}

AlarmText alarm_of_lost_core(const MachineView& machine) {
    const AlarmText alarm = alarm_text(machine);
    const Phrase since = is_silent(machine)
                             ? phrase("Since then the core is silent: it takes no orders.")
                             : phrase("Since then the core has ended: there is none to take orders.");
    AlarmText text{alarm.title, Phrase{"%1 %2", {}, {alarm.detail, since}}, {}};
    add_new_core(machine, text);
    add_way_on(machine, text);
    return text;
}

AlarmText unheard_text(const std::optional<AlarmText>& rest) {
    AlarmText text{
        phrase("Nobody heard the emergency stop"),
        phrase("No core took it: it has stopped nothing, and drives and spindle are as they were."),
        {}};
    if (rest) text.detail = Phrase{"%1 %2.", {}, {text.detail, rest->title}};
    text.steps.push_back(phrase("Use the wired emergency stop, or the machine's own switch"));
    if (!rest) return text;
    for (const Phrase& step : rest->steps) {
        if (!(step == text.steps.front())) text.steps.push_back(step);
    }
    return text;
}

std::optional<AlarmText> text_of_machine(const MachineView& machine) {
    if (!machine.status) return std::nullopt;
    if (is_lost_at_work(machine) || is_told_by_guard(machine)) return lost_core_text(machine);
    if (!is_in_alarm(machine)) return std::nullopt;
    return machine.is_heard() ? alarm_text(machine) : alarm_of_lost_core(machine);
}

}  // namespace

bool is_lost_at_work(const MachineView& machine) noexcept {
    if (machine.is_heard() || !machine.status) return false;
    switch (own_state(machine)) {
        case S::off:
        case S::ready:
            return false;
        case S::alarm:
        case S::backing_off:
            // A window that comes too late for the core's own state has its guard's.
            return !machine.heard_state && is_told_by_guard(machine) &&
                   (is_within_job(machine) || is_within_program(machine));
        default:
            return true;
    }
}

AlarmText lost_core_text(const MachineView& machine) {
    AlarmText text{lost_title(machine), lost_detail(machine), {}};
    const bool is_safe = is_told_by_guard(machine) && machine.status->is_port_silent == 0;
    text.steps.push_back(is_safe ? phrase("If anything still moves, use the wired emergency stop")
                                 : phrase("Use the wired emergency stop, or the machine's own switch"));
    add_new_core(machine, text);
    add_way_on(machine, text);
    return text;
}

std::optional<AlarmText> loud_text(const MachineView& machine) {
    const auto text = text_of_machine(machine);
    return machine.unheard_stop ? unheard_text(text) : text;
}

}  // namespace psicarve::session
