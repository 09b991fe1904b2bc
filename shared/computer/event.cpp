// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/computer/event.hpp"

#include <linux/futex.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <ctime>

namespace psicarve {
namespace {

/// Longest single sleep; the loop around it goes on until the caller's own limit.
constexpr std::chrono::milliseconds kLongestSleep{1000};

long futex_wait(const std::atomic<std::uint32_t>& word, std::uint32_t expected,
                std::chrono::nanoseconds limit) noexcept {
    const timespec timeout{.tv_sec = static_cast<time_t>(limit.count() / 1'000'000'000),
                           .tv_nsec = static_cast<long>(limit.count() % 1'000'000'000)};
    // FUTEX_WAIT counts its relative time on CLOCK_MONOTONIC.
    return ::syscall(SYS_futex, &word, FUTEX_WAIT, expected, &timeout, nullptr, 0);
}

}  // namespace

std::uint32_t event_count(const EventWord& event) noexcept {
    return event.counter.load();
}

void event_signal(EventWord& event) noexcept {
    event.counter.fetch_add(1);
    ::syscall(SYS_futex, &event.counter, FUTEX_WAKE, INT_MAX, nullptr, nullptr, 0);
}

bool event_wait_past(EventWord& event, std::uint32_t seen, std::chrono::nanoseconds limit) noexcept {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    for (;;) {
        if (event.counter.load() != seen) return true;
        const auto passed = Clock::now() - start;
        if (passed >= limit) return false;
        const auto left = std::chrono::duration_cast<std::chrono::nanoseconds>(limit - passed);
        // Woken early, interrupted, or timed out: the loop looks again in every case.
        futex_wait(event.counter, seen, std::min<std::chrono::nanoseconds>(left, kLongestSleep));
    }
}

}  // namespace psicarve
