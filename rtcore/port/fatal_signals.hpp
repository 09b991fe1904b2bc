// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "rtcore/port/port_access.hpp"

namespace psicarve::port {

/// From here on every signal that would end the process writes the safe state of the watched port, if there
/// is one, and then ends the process as it would have. Call it before any other code handles SIGBUS, so that
/// faults which that code passes on arrive here. SIGKILL cannot be handled.
void handle_fatal_signals();

/// Sets the one port to watch; nothing: there is none any more.
void watch_over(const std::optional<SafeState>& safe_state) noexcept;

/// The process is about to end by a signal: only the signal's handler writes to the port. RT: yes.
bool fatal_signal_came() noexcept;

}  // namespace psicarve::port
