// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "rtcore/guard/guard_page.hpp"

namespace psicarve::guard {

/// The core's side of what ties it to its guard. That the core is gone the guard learns from the pipe that
/// closes with it, whatever it dies of. Move-only.
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

    /// Supervisor. Asks, does not wait.
    bool is_guard_gone() const noexcept;
    /// Supervisor. True once for each time that the guard has made the port safe under us.
    bool guard_has_acted() noexcept;

private:
    int from_guard_;
    int to_guard_;
    GuardPage page_;
    std::uint32_t acts_seen_ = 0;
};

}  // namespace psicarve::guard
