// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include "shared/machine/signal.hpp"

namespace psicarve::cycle {

enum class OrderShape : std::uint8_t {
    straight,   ///< fine interpolation: all axes arrive together
    stepped,    ///< a line by point-by-point comparison, two axes
    arc,        ///< the same, counter-clockwise from the first axis' positive direction to the second's
    clockwise,  ///< an arc the other way
};

/// Where a jog or a move is to go: from the supervisor to the tick, which makes it absolute and judges it,
/// and on to the planner.
struct MotionOrder {
    /// Of `axes`: a position; in a request for a jog the distance, for a continuous jog the direction (+-1).
    std::array<std::int64_t, kAxisCount> target_pulses;
    double speed_pps;          ///< a jog's; 0: the axes' own
    std::uint8_t axes;         ///< bit by axis
    std::uint8_t drops_turns;  ///< 1: psi goes the short way, whole turns are dropped from its count
    OrderShape shape;
    std::uint8_t reserved[5];
    std::array<std::int64_t, 2> centre_pulses;  ///< of an arc: its two axes in their order
};
static_assert(std::is_trivially_copyable_v<MotionOrder>);

/// Nothing is further: far beyond every travel, and psi may turn for days.
inline constexpr std::int64_t kFurthestPulses = std::int64_t{1} << 36;

}  // namespace psicarve::cycle
