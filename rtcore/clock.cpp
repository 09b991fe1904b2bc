// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/clock.hpp"

#include <cerrno>
#include <ctime>

#include "shared/units.hpp"

namespace psicarve::rtcore {

std::int64_t RealClock::now_ns() const noexcept {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return std::int64_t{now.tv_sec} * kNsPerS + now.tv_nsec;
}

void RealClock::sleep_until_ns(std::int64_t deadline_ns) const noexcept {
    timespec deadline{};
    deadline.tv_sec = deadline_ns / kNsPerS;
    deadline.tv_nsec = deadline_ns % kNsPerS;
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &deadline, nullptr) == EINTR) {
    }
}

}  // namespace psicarve::rtcore
