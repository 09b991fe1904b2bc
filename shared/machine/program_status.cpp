// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/machine/program_status.hpp"

namespace psicarve {

std::string_view name_of(ProgramHold hold) noexcept {
    switch (hold) {
        case ProgramHold::none:
            return "";
        case ProgramHold::program:
            return "program stop";
        case ProgramHold::optional:
            return "optional stop";
        case ProgramHold::tool_change:
            return "tool change";
        case ProgramHold::single:
            return "single block";
        case ProgramHold::starved:
            return "starved";
        case ProgramHold::feeder_lost:
            return "program feeder lost";
        case ProgramHold::refused:
            return "program refused";
    }
    return "unknown";  // a number from shared memory may be anything
}

}  // namespace psicarve
