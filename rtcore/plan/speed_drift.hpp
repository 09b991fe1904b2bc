// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "rtcore/plan/angle_planner.hpp"
#include "rtcore/plan/machine_limits.hpp"

namespace psicarve::plan {

/// The fastest iterations at which a run of lines asks no axis for more than its motor can follow, though
/// every joint by itself is harmless. Steps of at most the start-stop speed that all go one way are an
/// acceleration:
///
///     speed of axis k        __|        change from line n to line m:  V * |s_m - s_n|,  s = d_k / S
///                         __|           time between them:             L / V,            L = iterations of
///                         the
///                      __|                                             lines n+1 .. m-1
///                    n      m           allowed:  j_k + share * a_k * L / V
///
/// `share` leaves the rest of a_k to the ramps of the speed profile. Lines are compared at distances of 1 to
/// 256, each about a third more than the one before. Requires lines of one acceleration segment. O(lines).
double drift_limit_per_s(const MachineLimits& limits, std::span<const TableLine> lines);

}  // namespace psicarve::plan
