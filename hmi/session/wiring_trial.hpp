// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <optional>

#include "hmi/phrase/phrase.hpp"
#include "hmi/session/machine_view.hpp"

namespace psicarve::session {

/// Why outputs cannot be tested one by one; nothing when the drives are off and nothing moves.
std::optional<Phrase> wiring_lock(const MachineView& machine);

/// Whether outputs may be tested: armed on purpose, and over after a while without a test.
class WiringTrial {
public:
    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::seconds kIdleLimit{30};

    void arm(Clock::time_point now) noexcept {
        is_armed_ = true;
        used_ = now;
    }
    void disarm() noexcept { is_armed_ = false; }
    bool is_armed() const noexcept { return is_armed_; }
    /// An output is tested now.
    void use(Clock::time_point now) noexcept { used_ = now; }
    /// Time until it is over, rounded up; 0: it is over, or not armed.
    std::chrono::seconds left(Clock::time_point now) const noexcept;

private:
    bool is_armed_ = false;
    Clock::time_point used_{};
};

}  // namespace psicarve::session
