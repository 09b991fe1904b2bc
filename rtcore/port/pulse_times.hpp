// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "shared/machine/signal.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::port {

/// Keeps a driver's times on the clock of the hardware. Ticks keep them by their count alone; but a tick
/// whose write was delayed is followed by one on time, and the time between two edges is the time between two
/// writes.
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

    /// Whether this change has edges that the driver times.
    static bool has_edges(SignalWord from, SignalWord to) noexcept {
        return ((from ^ to) & (kStepMask | kDirMask)) != 0;
    }
    /// The earliest time at which `to` may follow `from` on the pins. At once where nothing stays enabled:
    /// what makes a machine safe does not wait.
    std::int64_t earliest_ns(SignalWord from, SignalWord to) const noexcept;
    /// Notes that `to` stands on the pins, since `now_ns` at the latest.
    void note(SignalWord from, SignalWord to, std::int64_t now_ns) noexcept;

private:
    // So long ago that adding a time to it cannot overflow.
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
