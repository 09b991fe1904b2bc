// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/machine/command.hpp"

namespace psicarve {

std::string_view name_of(CommandKind kind) noexcept {
    switch (kind) {
        case CommandKind::none:
            return "none";
        case CommandKind::home:
            return "home";
        case CommandKind::start:
            return "start";
        case CommandKind::start_interpolation:
            return "start-interpolation";
        case CommandKind::hold:
            return "hold";
        case CommandKind::resume:
            return "resume";
        case CommandKind::reset_alarm:
            return "reset-alarm";
        case CommandKind::back_off:
            return "back-off";
        case CommandKind::reset_height:
            return "reset-height";
        case CommandKind::shutdown:
            return "shutdown";
        case CommandKind::jog:
        case CommandKind::jog_on:
            return "jog";
        case CommandKind::move:
            return "move";
        case CommandKind::spindle:
            return "spindle";
        case CommandKind::override:
            return "override";
        case CommandKind::record:
            return "record";
        case CommandKind::test_pin:
            return "pins";
        case CommandKind::drives_off:
            return "drives-off";
        case CommandKind::forget_piece:
            return "forget";
        case CommandKind::program:
            return "program";
        case CommandKind::rapid_override:
            return "override of rapids";
        case CommandKind::single:
            return "single";
        case CommandKind::optional_stop:
            return "optional-stop";
    }
    return "unknown";  // a number from shared memory may be anything
}

}  // namespace psicarve
