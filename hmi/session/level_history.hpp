// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <deque>
#include <utility>

#include "shared/machine/signal.hpp"
#include "shared/machine/status.hpp"

namespace psicarve::session {

/// The pins in the last seconds, sampled at screen rate. Between two samples only the number of steps is
/// known.
class LevelHistory {
public:
    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::seconds kLength{20};

    struct Look {
        Clock::time_point time;
        SignalWord levels;
        std::array<std::uint64_t, kAxisCount> pulses;  ///< by axis, since the sample before
    };

    void note(const CoreStatus& status, Clock::time_point now);
    void forget() noexcept;
    /// For a recording: replaces the samples, oldest first.
    void show(std::deque<Look> looks) noexcept { looks_ = std::move(looks); }
    /// Oldest first.
    const std::deque<Look>& looks() const noexcept { return looks_; }

private:
    std::deque<Look> looks_;
    std::array<std::uint64_t, kAxisCount> emitted_{};
};

}  // namespace psicarve::session
