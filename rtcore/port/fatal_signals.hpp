// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "rtcore/port/port_access.hpp"

namespace psicarve::port {

/// From here on every signal that would end the process writes the safe state of the port that is watched
/// over, if any, and then ends the process as it would have. Before anybody else handles SIGBUS, so that what
/// they do not want comes here. SIGKILL cannot be handled.
void handle_fatal_signals();

/// The one port of this process; nothing: there is none any more.
void watch_over(const std::optional<SafeState>& safe_state) noexcept;

/// The process is about to end by a signal: nobody writes to the port but the signal's handler. RT: yes.
bool fatal_signal_came() noexcept;

}  // namespace psicarve::port
