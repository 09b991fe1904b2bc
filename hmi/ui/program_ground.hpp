// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "hmi/program/program_lock.hpp"
#include "hmi/session/action_lock.hpp"
#include "hmi/ui/window_context.hpp"

namespace psicarve::ui {

/// What decides whether a program may start from this window.
inline program::StartGround program_ground(const WindowContext& context) {
    return {context.machine.view(), context.program_report, context.program.is_under_way(),
            context.replay.is_open(), context.program.text().failure().has_value()};
}

/// Why the program that is open cannot be started; nothing: it can.
inline std::optional<session::Phrase> program_start_lock(const WindowContext& context) {
    const program::ProgramDesk& desk = context.program;
    return program::start_lock(program_ground(context), desk.program().get(), desk.is_reading(),
                               desk.switches);
}

/// Why there is nothing to stop; nothing: there is. A program on its way to the machine can be stopped, too.
inline std::optional<session::Phrase> program_stop_lock(const WindowContext& context) {
    if (context.program.is_under_way()) return std::nullopt;
    return session::lock_of(session::Action::stop, context.machine.view(), context.open_job.view());
}

/// Whatever moves, and what is on its way.
inline void stop_program(WindowContext& context) {
    context.program.give_up(context.program_report);
    if (!session::lock_of(session::Action::stop, context.machine.view(), context.open_job.view()))
        context.machine.stop();
}

}  // namespace psicarve::ui
