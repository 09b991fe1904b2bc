// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/realtime/clock.hpp"

#include <cerrno>
#include <ctime>

#include "shared/base/units.hpp"

namespace psicarve::rtcore {

namespace {

std::int64_t now_on(clockid_t clock) noexcept {
    timespec now{};
    clock_gettime(clock, &now);
    return std::int64_t{now.tv_sec} * kNsPerS + now.tv_nsec;
}

}  // namespace

std::int64_t RealClock::now_ns() const noexcept {
    return now_on(CLOCK_MONOTONIC);
}

void RealClock::sleep_until_ns(std::int64_t deadline_ns) const noexcept {
    timespec deadline{};
    deadline.tv_sec = deadline_ns / kNsPerS;
    deadline.tv_nsec = deadline_ns % kNsPerS;
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &deadline, nullptr) == EINTR) {
    }
}

// CLOCK_BOOTTIME goes on while the computer sleeps, CLOCK_MONOTONIC stands still.
std::optional<std::int64_t> slept_ns() noexcept {
    constexpr std::int64_t kLongestLook_ns = 10'000'000;
    const std::int64_t before_ns = now_on(CLOCK_MONOTONIC);
    const std::int64_t with_sleep_ns = now_on(CLOCK_BOOTTIME);
    const std::int64_t after_ns = now_on(CLOCK_MONOTONIC);
    if (after_ns - before_ns > kLongestLook_ns) return std::nullopt;
    return with_sleep_ns - before_ns;
}

}  // namespace psicarve::rtcore
