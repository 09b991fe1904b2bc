// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "hmi/phrase/phrase.hpp"
#include "hmi/program/decoding.hpp"
#include "hmi/program/run_request.hpp"
#include "hmi/session/machine_view.hpp"
#include "shared/segment/segment_program.hpp"

namespace psicarve::program {

/// What decides whether a program may start.
struct StartGround {
    const session::MachineView& machine;
    const ProgramReport& report;
    bool is_own_under_way = false;  ///< a process of this window's is there
    bool is_replay = false;         ///< a recording is shown
    bool is_file_changed = false;   ///< the program's, since it was read
};

/// Why no program can be started now, whichever; nothing: one can. "Start: reset the alarm first".
std::optional<session::Phrase> machine_lock(const StartGround& ground);
/// The same for a program of a file. `program`: null: none was read.
std::optional<session::Phrase> start_lock(const StartGround& ground, const Decoded* program,
                                          bool is_being_read, const RunSwitches& switches);

/// The machine stands where it stood when the program was read, and has the profile that it was judged by:
/// what was said of its way holds.
bool is_read_as_it_is(const Decoded& program, const session::MachineView& machine,
                      const RunSwitches& switches);

/// Why the program waits and what goes on, in the operator's words; nothing: it does not wait by itself.
std::optional<session::Phrase> hold_advice(ProgramHold hold);
/// "Line 120" or why it stands there: of the program that runs. Requires that one does.
session::Phrase place_phrase(const ProgramStatus& status, MachineState state);

/// The places of all axes in mm and degrees; nothing: the machine is not homed, or its profile not known.
std::optional<std::array<double, kAxisCount>> known_place(const session::MachineView& machine);

}  // namespace psicarve::program
