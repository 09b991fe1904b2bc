// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
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

/// Nodes [first, last], both on points.
struct NodeRange {
    std::size_t first;
    std::size_t last;
};

/// Looks at a part of a fitted curve everywhere, not only in its nodes, and narrows the bands of those spans
/// in which
///   - it leaves the chord in a head's plane by more than the tolerance grants once its cuts and the DDA are
///     rounded to whole pulses, or
///   - the table turns back by more than a rounding.
/// Appends those that were narrowed to `narrowed`, upwards: there the curve has to be fitted again. A band
/// that is as narrow as it may be stays as it is: spans outside of which none could be narrowed go to
/// `stuck`.
void narrow_where_outside(const MachineLimits& limits, std::span<const PathPoint> points,
                          const FittedCurve& curve, const NodeRange& range, std::span<PathSpan> spans,
                          std::vector<std::uint32_t>& narrowed, std::vector<std::uint32_t>& stuck);

}  // namespace psicarve::plan
