// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/program/program_lock.hpp"

#include <string>
#include <utility>

#include "hmi/phrase/axis_letter.hpp"

namespace psicarve::program {
namespace {

using session::Phrase;
using session::phrase;
using S = MachineState;
using Lock = std::optional<Phrase>;

Lock state_lock(const session::MachineView& machine) {
    switch (machine.state()) {
        case S::alarm:
        case S::backing_off:
            return phrase("Start: reset the alarm first");
        case S::held:
        case S::holding:
            return phrase("Start: on hold; resume or stop");
        case S::stopping:
            return phrase("Start: stopping");
        case S::testing:
            return phrase("Start: an output is tested");
        case S::waiting:
            return phrase("Start: the heads wait at the first point of a job; stop first");
        case S::positioning:
        case S::carving:
        case S::finishing:
        case S::homing:
        case S::moving:
            return phrase("Start: the machine moves");
        case S::off:
        case S::ready:
            break;
    }
    for (const Axis axis : kAllAxes) {
        if (!machine.is_homed(axis)) return phrase("Start: axis %1 is not homed", session::axis_letter(axis));
    }
    if (machine.state() == S::off) return phrase("Start: the drives are off; home all axes");
    return std::nullopt;
}

}  // namespace

std::optional<Phrase> machine_lock(const StartGround& ground) {
    const session::MachineView& machine = ground.machine;
    if (ground.is_replay) return phrase("Start: a recording is shown; leave replay first");
    if (machine.life == session::CoreLife::none) return phrase("No core serves the segment");
    if (!machine.is_heard() || !machine.status) return phrase("The core is silent");
    if (ground.report.running != 0 || ground.report.status.is_running != 0)
        return phrase("Start: another program runs; stop it first");
    if (ground.is_own_under_way) return phrase("Start: the program is on its way");
    if (Lock lock = state_lock(machine)) return lock;
    if (!machine.profile || machine.is_profile_of_job)
        return phrase("Start: the core's profile is not known; open it on page Profile");
    return std::nullopt;
}

std::optional<Phrase> start_lock(const StartGround& ground, const Decoded* program, bool is_being_read,
                                 const RunSwitches& switches) {
    if (is_being_read) return phrase("Start: the program is being read");
    if (program == nullptr) return phrase("Start: no program is open");
    if (!program->is_right())
        return phrase("Start: errors in the program: %1", std::to_string(program->problems.error_count()));
    if (switches.from_line > program->facts.line_count)
        return phrase("Start: the program ends in line %1", std::to_string(program->facts.line_count));
    if (ground.is_file_changed)
        return phrase("Start: the file has been changed since it was read; decode it again");
    if (Lock lock = machine_lock(ground)) return lock;
    if (profile_hash(program->request.profile) != profile_hash(*ground.machine.profile))
        return phrase("Start: it was judged for another profile; decode it again");
    if (program->request.skips_deleted != switches.skips_deleted)
        return phrase("Start: it was read with another block delete; decode it again");
    if (switches.is_dry && ground.machine.is_active(Signal::spindle))
        return phrase("Start: a dry run switches nothing; switch the spindle off first");
    return std::nullopt;
}

bool is_read_as_it_is(const Decoded& program, const session::MachineView& machine,
                      const RunSwitches& switches) {
    const DecodeRequest& request = program.request;
    // Both are made of pulses in the same way.
    return machine.profile && profile_hash(request.profile) == profile_hash(*machine.profile) &&
           request.start == known_place(machine) && request.skips_deleted == switches.skips_deleted &&
           request.from_line == switches.from_line;
}

std::optional<Phrase> hold_advice(ProgramHold hold) {
    if (hold == ProgramHold::none) return std::nullopt;
    const std::pair<ProgramHold, Phrase> known[] = {
        {ProgramHold::program, phrase("a stop of the program (M0); Resume goes on")},
        {ProgramHold::optional, phrase("an optional stop (M1); Resume goes on")},
        {ProgramHold::tool_change, phrase("a tool change (M6); Resume goes on")},
        {ProgramHold::single, phrase("single block: this one is done; Resume runs the next")},
        {ProgramHold::starved, phrase("its next lines have not come; it goes on when they do")},
        {ProgramHold::feeder_lost, phrase("the process that feeds it is gone: only Stop is left")},
        {ProgramHold::refused, phrase("the core has refused the next line: only Stop is left")},
    };
    for (const auto& [which, words] : known) {
        if (which == hold) return words;
    }
    return phrase("%1", std::string{name_of(hold)});
}

Phrase place_phrase(const ProgramStatus& status, MachineState state) {
    Phrase told = phrase("Line %1", std::to_string(status.line));
    if (state == MachineState::holding || state == MachineState::held) {
        const auto why = hold_advice(status.hold);
        return session::joined(told, why ? *why : phrase("on hold; Resume goes on"));
    }
    return told;
}

std::optional<std::array<double, kAxisCount>> known_place(const session::MachineView& machine) {
    if (!machine.is_heard() || !machine.status || !machine.profile) return std::nullopt;
    std::array<double, kAxisCount> place{};
    for (const Axis axis : kAllAxes) {
        if (!machine.is_homed(axis)) return std::nullopt;
        place[index_of(axis)] = static_cast<double>(machine.status->position_pulses[index_of(axis)]) /
                                axis_motion(*machine.profile, axis).pulses_per_unit;
    }
    return place;
}

}  // namespace psicarve::program
