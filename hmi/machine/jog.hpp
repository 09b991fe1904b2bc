// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>

#include "hmi/machine/machine_link.hpp"
#include "shared/machine/jog_lease.hpp"

namespace psicarve::machine {

/// What a jog moves: one axis, or both heads, outwards or inwards.
class JogAxis {
public:
    // NOLINTNEXTLINE(google-explicit-constructor): every axis is one
    constexpr JogAxis(Axis axis) noexcept : number_(static_cast<std::uint32_t>(index_of(axis))) {}
    static constexpr JogAxis heads() noexcept {
        JogAxis both{Axis::r1};
        both.number_ = kBothHeads;
        return both;
    }
    constexpr std::uint32_t number() const noexcept { return number_; }
    constexpr bool is_turned() const noexcept { return number_ == index_of(Axis::psi); }

private:
    std::uint32_t number_;
};

/// A jog by a distance ends by itself: its lease may be long enough for a busy computer.
inline constexpr std::chrono::milliseconds kDistanceJogLease{1000};

/// A jog that this process began and holds: it goes on only while renew() is called repeatedly, at least
/// every kJogRenewal. Ends in order when it is released or destroyed; by itself when this process dies or
/// hangs. The link outlives it. One thread.
class HeldJog {
public:
    /// By a distance [mm; psi: deg]; `speed` [mm/s; deg/s], 0: the axis' home speed.
    static Result<HeldJog> by(MachineLink& link, JogAxis axis, double distance, double speed,
                              std::chrono::milliseconds lease = kDistanceJogLease);
    /// Upwards (or down) until it is released or the travel ends.
    static Result<HeldJog> on(MachineLink& link, JogAxis axis, bool up, double speed,
                              std::chrono::milliseconds lease = kJogLease);

    /// An output test, held the same way: with the drives off one output alone is active, or sends `pulses`
    /// pulses.
    static Result<HeldJog> test(MachineLink& link, Signal output, std::uint32_t pulses = 0,
                                double rate_hz = 0.0, std::chrono::milliseconds lease = kJogLease);

    HeldJog(HeldJog&& other) noexcept;
    HeldJog& operator=(HeldJog&&) = delete;
    ~HeldJog() { release(); }

    /// Cheap; writes to the segment only as often as needed.
    void renew() noexcept;
    void release() noexcept;

private:
    HeldJog(MachineLink& link, std::uint32_t token) noexcept : link_(&link), token_(token) {}
    static Result<HeldJog> begin(MachineLink& link, Command command, std::chrono::milliseconds lease);

    MachineLink* link_;
    std::uint32_t token_;
    std::uint32_t beat_ = 1;
    bool is_released_ = false;
    std::chrono::steady_clock::time_point renewed_{};
};

}  // namespace psicarve::machine
