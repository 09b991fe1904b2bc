// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "rtcore/plan/path.hpp"

namespace psicarve::plan {

/// The axes of one head's space (R, r * psi, Y), in which a program's tolerance is measured.
inline constexpr std::size_t kSpaceAxisCount = 3;
constexpr std::array<std::size_t, kSpaceAxisCount> space_axes(std::size_t head) noexcept {
    return {head, index_of(Axis::psi), index_of(Axis::y)};
}

/// One pulse of each of them [mm]: psi's at the span's larger radius.
std::array<double, kSpaceAxisCount> space_pulses_mm(const MachineLimits& limits, const PathSpan& span,
                                                    std::size_t head);

/// The tubes of a program whose corners are rounded: in every head's space the curve is within the tolerance
/// of the chord along it, and passes the points between the path's ends within the tolerance. Where the
/// table's pulses are coarse, and of axes that have backlash, points are passed as in a job. Requires
/// rounds_corners(limits).
void set_program_tubes(const MachineLimits& limits, std::span<PathSpan> spans);

}  // namespace psicarve::plan
