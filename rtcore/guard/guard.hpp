// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <variant>

#include "rtcore/guard/guard_link.hpp"
#include "rtcore/port/port_access.hpp"
#include "shared/base/result.hpp"

namespace psicarve::guard {

/// What a guard needs of the core that it watches.
struct GuardDuty {
    port::SafeState safe_state;  ///< of the port that was opened before the two processes part
    std::string segment_name;    ///< where the guard says what became of the core
    std::string group;
};

/// Parts this process, which has one thread, from its core:
///
///     the process that was started = guard ── forwards SIGTERM, SIGINT, SIGHUP ... ──> core = its child
///           writes the safe state when the core is gone or has not ticked for half a second
///           <───────────── a pipe each way, that closes when its writer is gone ─────────────>
///
/// The core leads a process group of its own: a terminal and a shell reach it by the guard alone. Returns in
/// the core with the link to its guard. Returns in the guard when all is over, with the exit code: the core's
/// own, or 128 + the signal that killed it. The guard needs no real-time rights: it sleeps until something
/// happens. An error: there is no guard, and no second process.
Result<std::variant<GuardLink, int>> fork_guard(const GuardDuty& duty);

}  // namespace psicarve::guard
