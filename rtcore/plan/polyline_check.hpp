// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rtcore/plan/curve_check.hpp"
#include "rtcore/plan/path.hpp"

namespace psicarve::plan {

/// As narrow_where_outside(), of a program whose corners are rounded: wherever the curve may be cut, each
/// head must be within the tolerance and what the roundings to pulses add to it of the polyline, in the space
/// (R, r * psi, Y).
void narrow_where_off_polyline(const MachineLimits& limits, std::span<const PathPoint> points,
                               const FittedCurve& curve, const NodeRange& range, std::span<PathSpan> spans,
                               std::vector<std::uint32_t>& narrowed, std::vector<std::uint32_t>& stuck);

}  // namespace psicarve::plan
