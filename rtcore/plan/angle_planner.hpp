// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rtcore/plan/machine_limits.hpp"

namespace psicarve::plan {

/// One line of a table: to the point that is carved as a layer's `step`-th.
struct TableLine {
    Pulses4 delta_pulses;
    std::array<double, 2> radius_mm;  ///< by head: of the tip, the larger of the line's two ends
    std::uint32_t layer;              ///< of the point at its end
    std::uint32_t step;
    std::array<bool, 2> is_outside{};  ///< by head: all along it clear of the blank, so without a feed
};

/// Lines [first, first + count) under one speed profile.
struct LineGroup {
    std::size_t first;
    std::size_t count;
    GroupLimits limits;
    std::uint64_t iterations;
};

/// The original's planner: lines whose directions differ by less than corner_deg join one acceleration
/// segment, which starts and ends at start speed. Directions are compared for each head in mm, x = r * dpsi,
/// y = dR; a corner counts only if it stays one when each point may move by half a pulse of R. Speeds: the
/// least over lines and axes of limit_k * S / |d_k|, the feed over the surface of the faster head, and the
/// jump of each axis at an inner joint at most its start-stop speed. A segment also ends where an axis that
/// has backlash turns round. A head that is outside has no feed; a segment in which heads go outside, or come
/// back, is cut there if that is sooner. O(lines).
std::vector<LineGroup> plan_by_angle(const MachineLimits& limits, std::span<const TableLine> lines);

/// Whether the joint of two lines is a corner for a head (0: R1, 1: R2).
bool is_corner(const MachineLimits& limits, const TableLine& before, const TableLine& after,
               std::size_t head);

}  // namespace psicarve::plan
