// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>

#include "rtcore/guard/guard_page.hpp"

namespace psicarve::guard {

/// Whether a counter that should grow has stood still for too long.
class Silence {
public:
    using Time = std::chrono::steady_clock::time_point;
    bool is_too_long(std::uint64_t count, Time now) noexcept;

private:
    std::uint64_t seen_ = 0;
    Time asked_at_{};
    std::chrono::nanoseconds length_{};
};

/// The core's link to its guard. However the core dies, the guard learns of it from the pipe that closes
/// then. Move-only.
class GuardLink {
public:
    /// Takes both descriptors: `from_guard` closes when the guard ends, `to_guard` with us.
    GuardLink(int from_guard, int to_guard, GuardPage page) noexcept;
    GuardLink(GuardLink&& other) noexcept;
    GuardLink& operator=(GuardLink&&) = delete;
    ~GuardLink();

    /// RT: yes.
    void note_tick() noexcept { page_.note_tick(); }
    void set_ticking(bool is_ticking) noexcept { page_.set_ticking(is_ticking); }

    /// For the tick: true once for each time that the guard has made the port safe behind the core's back.
    /// RT: yes.
    bool guard_has_acted() noexcept;
    /// For the supervisor, repeatedly; does not wait. True: the guard is dead, or has not looked at the core
    /// for a long time, as when it is stopped.
    bool is_guard_lost(Silence::Time now) noexcept;

private:
    int from_guard_;
    int to_guard_;
    GuardPage page_;
    std::uint32_t acts_seen_ = 0;
    Silence silence_;
};

}  // namespace psicarve::guard
