// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "rtcore/plan/machine_limits.hpp"
#include "rtcore/plan/path.hpp"

namespace psicarve::plan {

/// Appends the points on the way from the end of one layer to the begin of the next, both left out: psi at
/// rest, heads that have to move out do so before Y is half-way up, where the lower layer's cut ends, heads
/// that move in do so after it. Y does not wait for them: it sets out so that it comes by there when the
/// last head is out, and heads go in while it rises on.
///
/// Where each is after t follows from its own speed and acceleration (and the feed):
///
///     t_middle = max(t_out, t_Y / 2)     Y moves from t_middle - t_Y / 2 on
///     t_end    = t_middle + max(t_in, t_Y / 2)
///
/// Of each half in which a head moves, so many parts: 1 is a corner at its end alone.
void add_link_way(const MachineLimits& limits, const PathPoint& from, const PathPoint& to, int parts,
                  std::vector<PathPoint>& points);

}  // namespace psicarve::plan
