// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "hmi/program/program_lock.hpp"
#include "hmi/ui/window_context.hpp"

namespace psicarve::ui {

/// What decides whether a program may start from this window.
inline program::StartGround program_ground(const WindowContext& context) {
    return {context.machine.view(), context.program_report, context.program.is_under_way(),
            context.replay.is_open()};
}

/// Why the program that is open cannot be started; nothing: it can.
inline std::optional<session::Phrase> program_start_lock(const WindowContext& context) {
    const program::ProgramDesk& desk = context.program;
    return program::start_lock(program_ground(context), desk.program().get(), desk.is_reading(),
                               desk.switches);
}

}  // namespace psicarve::ui
