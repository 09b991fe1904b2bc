// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/program_phrase.hpp"

namespace psicarve::session {

Phrase hold_phrase(ProgramHold hold) {
    switch (hold) {
        case ProgramHold::none:
            break;
        case ProgramHold::program:
            return phrase("stop (M0)");
        case ProgramHold::optional:
            return phrase("optional stop (M1)");
        case ProgramHold::tool_change:
            return phrase("tool change (M6)");
        case ProgramHold::single:
            return phrase("single block");
        case ProgramHold::starved:
            return phrase("waits for more of it");
        case ProgramHold::feeder_lost:
            return phrase("its reader is gone");
        case ProgramHold::refused:
            return phrase("a record was refused");
    }
    return {};  // a number from shared memory may be anything
}

Phrase program_place(const ProgramStatus& program) {
    Phrase hold = hold_phrase(program.hold);
    if (!hold.is_empty()) return hold;
    return program.line == 0 ? phrase("Before its first line") : phrase("Line %1", line_text(program));
}

Phrase program_line(const ProgramStatus& program) {
    if (program.line == 0) return phrase("Program, before its first line");
    return phrase("Program, line %1", line_text(program));
}

Phrase program_way_on(const ProgramStatus& program) {
    return phrase("psicarve gcode run FILE --from-line %1", line_text(program));
}

}  // namespace psicarve::session
