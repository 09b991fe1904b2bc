// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/machine/unreplayed_program.hpp"

#include "shared/machine/recorded_program.hpp"

namespace psicarve {

std::string unreplayed_program_text(std::span<const FlightRecord> records) {
    const ProgramStatus program = recorded_program(records);
    if (program.program == 0 && program.line == 0) return {};
    const std::string place =
        program.line == 0 ? "before its first line" : "up to line " + std::to_string(program.line);
    return "nothing to replay: it recorded a program in G-code, " + place +
           ", whose file is not in it; 'psicarve replay SNAPSHOT --program FILE' replays it, and "
           "'psicarve snapshot info' tells what happened";
}

}  // namespace psicarve
