// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "rtcore/cycle/cycle_io.hpp"
#include "shared/machine/command.hpp"

namespace psicarve::cycle {

struct RequestCommand {
    RequestKind request;
    CommandKind command;
};

/// The requests that operators make by commands of the segment. Those of the supervisor itself (job_loaded,
/// fail, end_jog) and the command for it (shutdown) have no partner.
inline constexpr std::array kRequestCommands{
    RequestCommand{RequestKind::home, CommandKind::home},
    RequestCommand{RequestKind::start, CommandKind::start},
    RequestCommand{RequestKind::start_interpolation, CommandKind::start_interpolation},
    RequestCommand{RequestKind::hold, CommandKind::hold},
    RequestCommand{RequestKind::resume, CommandKind::resume},
    RequestCommand{RequestKind::reset_alarm, CommandKind::reset_alarm},
    RequestCommand{RequestKind::back_off, CommandKind::back_off},
    RequestCommand{RequestKind::reset_height, CommandKind::reset_height},
    RequestCommand{RequestKind::jog, CommandKind::jog},
    RequestCommand{RequestKind::jog_on, CommandKind::jog_on},
    RequestCommand{RequestKind::move, CommandKind::move},
    RequestCommand{RequestKind::spindle, CommandKind::spindle},
    RequestCommand{RequestKind::override, CommandKind::override},
    RequestCommand{RequestKind::record, CommandKind::record},
    RequestCommand{RequestKind::test_pin, CommandKind::test_pin},
    RequestCommand{RequestKind::drives_off, CommandKind::drives_off},
    RequestCommand{RequestKind::run_program, CommandKind::program},
    RequestCommand{RequestKind::rapid_override, CommandKind::rapid_override},
    RequestCommand{RequestKind::single, CommandKind::single},
    RequestCommand{RequestKind::optional_stop, CommandKind::optional_stop},
};

/// Nothing: the tick has no such request.
constexpr std::optional<RequestKind> request_of(CommandKind command) noexcept {
    for (const RequestCommand& pair : kRequestCommands) {
        if (pair.command == command) return pair.request;
    }
    return std::nullopt;
}

/// CommandKind::none: no operator made this request. RT: yes.
constexpr CommandKind command_of(RequestKind request) noexcept {
    for (const RequestCommand& pair : kRequestCommands) {
        if (pair.request == request) return pair.command;
    }
    return CommandKind::none;
}

}  // namespace psicarve::cycle
