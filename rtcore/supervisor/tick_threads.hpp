// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>

#include "rtcore/realtime/periodic.hpp"
#include "rtcore/realtime/priority_mutex.hpp"
#include "rtcore/supervisor/core_parts.hpp"
#include "rtcore/supervisor/replay.hpp"

namespace psicarve::supervisor {

/// What the threads that tick share with the supervisor's besides the rings, and with each other.
struct TickThreads {
    std::atomic<bool> must_end{false};
    std::atomic<bool> record_is_over{false};
    std::atomic<bool> record_may_begin{false};
    rtcore::PeriodicStats stats;                ///< of the tick; two-timer: of inputs and pulses
    rtcore::PeriodicStats interpolation_stats;  ///< two-timer
    rtcore::PriorityMutex cycle_mutex;          ///< two-timer: its holder is the cycle's one thread
};

/// Schedule single: the whole tick, and no lock. Two-timer: inputs and pulses. Returns when told to end, with
/// the outputs safe.
void run_ticks(CoreParts& parts, RecordDirector* record, TickThreads& threads) noexcept;

/// Two-timer: the interpolation, in a second thread. Returns when told to end.
void run_interpolation(CoreParts& parts, TickThreads& threads) noexcept;

}  // namespace psicarve::supervisor
