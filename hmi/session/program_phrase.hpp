// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "hmi/phrase/phrase.hpp"
#include "hmi/session/machine_view.hpp"

namespace psicarve::session {

// A program in G-code that runs, in the window's words.

inline std::string line_text(const ProgramStatus& program) {
    return std::to_string(program.line);
}
/// "tool change (M6)"; nothing where it is held by a command, or not at all.
Phrase hold_phrase(ProgramHold hold);
/// "tool change (M6)", or "Line 12" where nothing but a command holds it: short, beside program_line().
Phrase program_place(const ProgramStatus& program);
/// "Program, line 12".
Phrase program_line(const ProgramStatus& program);
/// The command that goes on in that line.
Phrase program_way_on(const ProgramStatus& program);

}  // namespace psicarve::session
