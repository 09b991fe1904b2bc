// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "shared/base/result.hpp"
#include "shared/machine/signal.hpp"

namespace psicarve {

/// What a way cannot be faster for: an axis that is at its top speed or acceleration, or the feed; unknown:
/// or something else, as the plunge's speed.
enum class WayBound : std::uint8_t { unknown, r1, r2, psi, y, feed };
inline constexpr std::size_t kWayBoundCount = 6;
constexpr WayBound way_bound_of(Axis axis) noexcept {
    return static_cast<WayBound>(index_of(axis) + 1);
}
static_assert(way_bound_of(Axis::r1) == WayBound::r1 && way_bound_of(Axis::y) == WayBound::y);

/// A job as the core plans it, point by point: both are [layer * point_count + point], of the way to that
/// point from the one that is carved before it.
struct PointPlan {
    std::vector<float> seconds;    ///< at 100 % feed; 0 at the job's first point
    std::vector<WayBound> bounds;  ///< what holds for most of that time

    friend bool operator==(const PointPlan&, const PointPlan&) = default;
};

/// For one process to give it to another: "PSCAPTS1", the count of points (64 bits), their seconds (32-bit
/// floats), a byte each for their bounds; little-endian.
std::vector<std::byte> point_plan_bytes(const PointPlan& plan);
/// Refuses what is not the plan of so many points: another count, size or bound, seconds that are negative or
/// no number (bad_input).
Result<PointPlan> point_plan_from(std::span<const std::byte> bytes, std::size_t point_count);

}  // namespace psicarve
