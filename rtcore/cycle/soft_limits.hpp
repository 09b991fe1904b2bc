// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "shared/machine/signal.hpp"

namespace psicarve::cycle {

/// Where the tips may be sent, in counted positions.
struct SoftLimits {
    std::array<std::int64_t, kAxisCount> least_pulses{};  ///< travel; psi: as far as numbers go
    std::array<std::int64_t, kAxisCount> most_pulses{};
    std::array<std::int64_t, 2> core_pulses{};  ///< by head: nothing is nearer to the axis
    std::array<double, 2> mm_per_pulse{1.0, 1.0};
    double least_sum_mm = 0.0;  ///< of both heads' counted positions: the tips' clearance
};

enum class SoftLimit : std::uint8_t { none, travel, core_radius, head_clearance };
struct SoftBreach {
    SoftLimit limit = SoftLimit::none;
    std::uint8_t axis = 0;
};

/// The first limit that a straight way from `from` to `to` would break. A place outside may be left
/// towards the inside, so that a machine that stands there is not caught. As all limits are straight, a way
/// between two good ends is good all along. RT: yes.
SoftBreach first_breach(const SoftLimits& limits, const std::array<std::int64_t, kAxisCount>& from,
                        const std::array<std::int64_t, kAxisCount>& to) noexcept;

/// The furthest good position of an axis that moves alone from `from`, up or down; `from`'s own when there is
/// no way. RT: yes.
std::int64_t furthest_pulses(const SoftLimits& limits, const std::array<std::int64_t, kAxisCount>& from,
                             std::size_t axis, bool up) noexcept;

/// The same of both heads that go equally far, both outwards or both inwards. RT: yes.
std::array<std::int64_t, kAxisCount> furthest_of_heads(const SoftLimits& limits,
                                                       const std::array<std::int64_t, kAxisCount>& from,
                                                       bool out) noexcept;

}  // namespace psicarve::cycle
