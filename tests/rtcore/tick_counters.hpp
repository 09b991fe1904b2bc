// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace psicarve::tick_counters {

// What a tick must not do, counted: memory and locks by functions that stand before the C library's own,
// system calls by the kernel itself (tests/system_calls), page faults and sleeps as the kernel keeps account
// of them.

/// A parallel port that answers to everything: its accesses end here.
inline constexpr int kPortDescriptor = 12345;

struct Counts {
    std::uint64_t allocations = 0;
    std::uint64_t locks = 0;  ///< taken or tried
    std::uint64_t waits = 0;  ///< of these, those that wait until they have it
    std::uint64_t port_accesses = 0;
    std::uint64_t sleeps = 0;  ///< asked for
    std::uint64_t other_system_calls = 0;
    long last_other_call = -1;  ///< its number
    std::uint64_t page_faults = 0;
    std::uint64_t switches = 0;  ///< of its own accord, as the kernel counted
};

/// Must precede counting, once in each thread that counts. False: this kernel does not allow it.
bool watch_this_thread() noexcept;
void begin_counting() noexcept;
/// Adds what this thread did since then.
void end_counting(Counts& counts) noexcept;

template <typename Work>
void count_into(Counts& counts, Work&& work) {
    begin_counting();
    work();
    end_counting(counts);
}

}  // namespace psicarve::tick_counters
