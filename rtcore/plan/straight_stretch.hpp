// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "rtcore/plan/machine_limits.hpp"
#include "rtcore/plan/path.hpp"
#include "rtcore/plan/path_pieces.hpp"

namespace psicarve::plan {

/// One straight way from rest to rest, exactly on its chord: no curve is to be found, and the fastest timing
/// is known. With (du/dt)^2 = x and the acceleration A that every axis has along it
///
///     x(u) = min(x_top, x_stop + 2 A u, x_stop + 2 A (length - u))       x_top: axes' speeds, and its feed
///
///      x |      ________________
///        |    /                  \        one DDA line in three pieces; five where the ramps at twice the
///        |  /                      \      feed are longer
///        +--------------------------- u
///
/// Appends to `pieces`; the last of them reaches `point`. Requires that it has a pulse to go, and
/// of no axis more than 2^30.
void add_straight_stretch(const MachineLimits& limits, const PathSpan& span, const Pulses4& way_pulses,
                          std::uint32_t point, std::vector<PathPiece>& pieces);

/// What every axis can accelerate along a way of this slope, of u [1/s].
double accel_along_way(const MachineLimits& limits, const Lanes& slope);

}  // namespace psicarve::plan
