// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>

namespace psicarve {

/// A cross-process wake-up: `counter` grows with each signal; waiters sleep on it (futex without the PRIVATE
/// flag).
struct EventWord {
    std::atomic<std::uint32_t> counter;
    std::uint32_t reserved;
};

/// A cross-process wake-up on a counter in shared memory: a futex without the PRIVATE flag. It has no owner,
/// so no process that dies can hang it; every wait has a time limit. A signal always asks the kernel to wake:
/// a count of waiters would be one more word that a killed waiter leaves wrong. Not for the tick.
///
/// Use: remember `count()`, look at the data, then `wait_past(seen)`: a signal in between is not lost.
std::uint32_t event_count(const EventWord& event) noexcept;
void event_signal(EventWord& event) noexcept;
/// True when the counter has moved on from `seen`; false when the limit passed first.
bool event_wait_past(EventWord& event, std::uint32_t seen, std::chrono::nanoseconds limit) noexcept;

}  // namespace psicarve
