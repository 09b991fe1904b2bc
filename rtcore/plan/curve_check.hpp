// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "rtcore/plan/curve_nodes.hpp"
#include "rtcore/plan/path.hpp"
#include "rtcore/plan/speed_profile.hpp"

namespace psicarve::plan {

/// A fitted curve: one cell a node, and where each begins [pulses].
struct FittedCurve {
    const CurveNodes& nodes;
    std::span<const PathCell> cells;
    std::span<const Lanes> cell_at;
};

/// Looks at a fitted curve everywhere, not only in its nodes, and narrows the bands of those spans in which
///   - it leaves the chord in a head's plane by more than the tolerance grants once its cuts and the DDA are
///     rounded to whole pulses, or
///   - the table turns back by more than a rounding.
/// Whether any was narrowed: then the curve has to be fitted again. A band that is as narrow as it may be
/// stays as it is.
bool narrow_where_outside(const MachineLimits& limits, std::span<const PathPoint> points,
                          const FittedCurve& curve, std::span<PathSpan> spans);

}  // namespace psicarve::plan
