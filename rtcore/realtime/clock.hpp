// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

namespace psicarve::rtcore {

/// The machine's own clock: CLOCK_MONOTONIC, which no program can set. RT: yes; sleeping is the tick's one
/// system call.
class RealClock {
public:
    std::int64_t now_ns() const noexcept;
    /// Returns at once when the time has passed; a signal does not cut it short.
    void sleep_until_ns(std::int64_t deadline_ns) const noexcept;
};

/// How long the computer has slept since it was started: the difference between two of its clocks, exact to
/// the time of one look. Nothing when the look was interrupted.
std::optional<std::int64_t> slept_ns() noexcept;

}  // namespace psicarve::rtcore
