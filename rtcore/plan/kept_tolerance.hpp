// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rtcore/plan/path.hpp"
#include "rtcore/plan/path_pieces.hpp"

namespace psicarve::plan {

/// Spans of a path, upwards, on which its pulses are further off than the tolerance and a pulse: of the chord
/// in a job, of the polyline where a program's corners are rounded. Looks at every iteration of `pieces`,
/// which begin in the point `first`. Ways between two layers have no tolerance.
std::vector<std::uint32_t> spans_left(const MachineLimits& limits, std::span<const PathPoint> points,
                                      std::span<const PathSpan> spans, std::size_t first,
                                      std::span<const PathPiece> pieces);

}  // namespace psicarve::plan
