// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace psicarve::rtcore {

/// The machine's own clock: CLOCK_MONOTONIC, which nobody can set. RT: yes; sleeping is the tick's one
/// system call.
class RealClock {
public:
    std::int64_t now_ns() const noexcept;
    /// Returns at once when the time has passed; a signal does not cut it short.
    void sleep_until_ns(std::int64_t deadline_ns) const noexcept;
};

}  // namespace psicarve::rtcore
