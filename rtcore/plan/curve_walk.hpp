// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "rtcore/plan/curve_check.hpp"
#include "rtcore/plan/wide.hpp"

namespace psicarve::plan {

/// Watches a curve span by span, cell by cell, and narrows the spans outside which it is. A `Watch` is made
/// for each span in place of `watch` by `begin_span(watch, span)`.
template <typename Watch, typename BeginSpan>
PSICARVE_INLINE void narrow_watched(const FittedCurve& curve, const NodeRange& range,
                                    const BeginSpan& begin_span, std::vector<std::uint32_t>& narrowed,
                                    std::vector<std::uint32_t>& stuck) {
    const CurveNodes& nodes = curve.nodes;
    std::optional<Watch> watch;
    for (std::size_t j = range.first; j <= range.last; ++j) {
        const PathCell& cell = curve.cells[j];
        double begin = 0.0;
        if (nodes.point_at[j] != CurveNodes::kNoPoint) {
            begin = j > 0 ? 0.5 * nodes.step[j - 1] : 0.0;
            if (j > range.first) {
                watch->watch(cell, curve.cell_at[j], 0.0, begin);
                if (watch->is_outside()) (watch->narrow() ? narrowed : stuck).push_back(nodes.span_at[j - 1]);
            }
            if (j == range.last) break;
            begin_span(watch, nodes.span_at[j]);
        }
        watch->watch(cell, curve.cell_at[j], begin, cell.length);
    }
}

}  // namespace psicarve::plan
