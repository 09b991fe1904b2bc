// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "rtcore/supervisor/supervisor.hpp"

namespace psicarve::supervisor {

inline constexpr int kExitDone = 0;
inline constexpr int kExitBadInput = 3;
inline constexpr int kExitAlarm = 4;
inline constexpr int kExitNoSegment = 5;

/// When the core has to end: on SIGINT, SIGTERM or SIGHUP in order (stop, come to rest, drives off), on the
/// second of them by an emergency stop. One that is sent to every process of a group or a service comes here
/// twice, from its sender and from the guard, and is one. Installed once in a process; the handlers only
/// count.
class EndRequest {
public:
    enum class Progress : std::uint8_t {
        none,
        told_tick,  ///< the tick was just asked to stop
        may_end,    ///< asked to end, and nothing moves or turns any more
    };
    EndRequest();
    Progress poll(Supervisor& supervisor);
    /// So many orders to end have come.
    static int orders() noexcept;

private:
    int orders_seen_ = 0;
};

}  // namespace psicarve::supervisor
