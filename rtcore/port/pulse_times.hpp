// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "shared/machine/signal.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::port {

/// A driver's times on the clock that it lives by. Ticks keep them by their count alone: one whose write was
/// delayed, however, is followed by one that comes on time, and what lies between two edges is what lies
/// between two writes.
///
///     tick      |----------|----------|
///     step      ___________(late)/~~~~\___      too short: the second write waits until
///     step      ___________(late)/~~~~~~~~~\_   rose_ns + step_high_ns
///
/// RT: yes.
class PulseTimes {
public:
    explicit PulseTimes(const PortProfile& port) noexcept
        : high_ns_(port.step_high_ns),
          low_ns_(port.step_low_ns),
          setup_ns_(port.dir_setup_ns),
          hold_ns_(port.dir_hold_ns) {}

    /// Whether such a write has edges that count.
    static bool has_edges(SignalWord from, SignalWord to) noexcept {
        return ((from ^ to) & (kStepMask | kDirMask)) != 0;
    }
    /// Not before this may `to` follow `from` on the pins. At any time where nothing is enabled any more:
    /// what makes a machine safe does not wait.
    std::int64_t earliest_ns(SignalWord from, SignalWord to) const noexcept;
    /// `to` stands on the pins, since `now_ns` at the latest.
    void note(SignalWord from, SignalWord to, std::int64_t now_ns) noexcept;

private:
    // So long ago that adding a time overflows nothing.
    static constexpr std::int64_t kLongAgo_ns = std::numeric_limits<std::int64_t>::min() / 2;
    struct Edges {
        std::int64_t rose_ns = kLongAgo_ns;
        std::int64_t fell_ns = kLongAgo_ns;
        std::int64_t turned_ns = kLongAgo_ns;
    };

    std::int64_t high_ns_;
    std::int64_t low_ns_;
    std::int64_t setup_ns_;
    std::int64_t hold_ns_;
    std::array<Edges, kAxisCount> edges_{};
};

}  // namespace psicarve::port
