// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/polyline_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "rtcore/plan/path_pieces.hpp"
#include "rtcore/plan/program_tube.hpp"

namespace psicarve::plan {
namespace {

// Narrowed a little further than needed, so that one more fit is enough as a rule.
constexpr double kPolylineMargin = 0.96;
// A curve that lags is nearest to a chord before its own, or to one after it if it leads.
constexpr std::size_t kChordsBeside = 8;

using SpaceVector = std::array<double, kSpaceAxisCount>;

/// What one span's way has shown so far.
class PolylineWatch {
public:
    PolylineWatch(const MachineLimits& limits, std::span<const PathPoint> points, std::size_t span_at,
                  PathSpan& span)
        : points_(points), span_at_(span_at), span_(span) {
        follows_table_ = cuts_follow_table(limits, span.radius_mm);
        for (std::size_t head = 0; head < kHeads; ++head) {
            pulses_mm_[head] = space_pulses_mm(limits, span, head);
            allowed_mm_[head] = limits.path_tolerance_mm + rounding_mm(head);
        }
    }

    /// A part of a cell: where it may be cut.
    void watch(const PathCell& cell, const Lanes& cell_at, double from, double to) {
        const std::size_t count = bits_in(cell, to - from);
        const double step = (to - from) / static_cast<double>(count);
        for (std::size_t i = 1; i <= count; ++i) {
            along_span_ += step;
            const double along = from + static_cast<double>(i) * step;
            Lanes at;
            for (std::size_t k = 0; k < kAxisCount; ++k)
                at[k] = cell_at[k] + along * (cell.slope_begin[k] + 0.5 * along * cell.bend[k]);
            see(at);
        }
    }

    bool is_outside() const { return excess_[0] > 1.0 || excess_[1] > 1.0; }
    bool narrow() {
        bool narrowed = false;
        for (std::size_t head = 0; head < kHeads; ++head) {
            if (excess_[head] <= 1.0) continue;
            for (const std::size_t axis : space_axes(head)) {
                if (span_.band[axis] <= kLeastBandPulses) continue;
                span_.band[axis] =
                    std::max(kLeastBandPulses, span_.band[axis] * kPolylineMargin / excess_[head]);
                narrowed = true;
            }
        }
        return narrowed;
    }

private:
    // Square to the chord a pulse of the coarsest axis, of which half a pulse of each axis is the DDA's.
    double rounding_mm(std::size_t head) const {
        const auto axes = space_axes(head);
        SpaceVector way{};
        double length2 = 0.0;
        for (std::size_t i = 0; i < kSpaceAxisCount; ++i) {
            way[i] = span_.slope[axes[i]] * pulses_mm_[head][i];
            length2 += way[i] * way[i];
        }
        double half2 = 0.0;
        double most2 = 0.0;
        for (std::size_t i = 0; i < kSpaceAxisCount; ++i) {
            if (!moves_beside(axes[i])) continue;
            const double along2 = length2 > 0.0 ? way[i] * way[i] / length2 : 0.0;
            const double across2 = pulses_mm_[head][i] * pulses_mm_[head][i] * (1.0 - along2);
            half2 += 0.25 * across2;
            most2 = std::max(most2, across2);
        }
        return std::sqrt(most2) - std::sqrt(half2);
    }
    bool moves_beside(std::size_t axis) const {
        const std::size_t first = span_at_ > 0 ? span_at_ - 1 : 0;
        const std::size_t last = std::min(span_at_ + 2, points_.size() - 1);
        for (std::size_t i = first; i < last; ++i)
            if (points_[i].pulses[axis] != points_[i + 1].pulses[axis]) return true;
        return false;
    }

    void see(Lanes& at) {
        if (!follows_table_)
            at[kPsi] = static_cast<double>(points_[span_at_].pulses[kPsi]) + span_.slope[kPsi] * along_span_;
        for (double& place : at) place = std::nearbyint(place);
        for (std::size_t head = 0; head < kHeads; ++head) {
            excess_[head] = std::max(excess_[head], share_of_allowed(at, head));
        }
    }

    double share_of_allowed(const Lanes& at, std::size_t head) const {
        const double allowed2 = allowed_mm_[head] * allowed_mm_[head];
        double least2 = off2_mm2(at, head, span_at_);
        for (std::size_t i = 1; i <= kChordsBeside && least2 > allowed2; ++i) {
            if (span_at_ >= i) least2 = std::min(least2, off2_mm2(at, head, span_at_ - i));
            if (span_at_ + i + 1 < points_.size())
                least2 = std::min(least2, off2_mm2(at, head, span_at_ + i));
        }
        return std::sqrt(least2) / allowed_mm_[head];
    }

    /// From the nearest place of one chord.
    double off2_mm2(const Lanes& at, std::size_t head, std::size_t chord) const {
        const auto axes = space_axes(head);
        SpaceVector way, off;
        double along = 0.0;
        double length2 = 0.0;
        for (std::size_t i = 0; i < kSpaceAxisCount; ++i) {
            const auto from = static_cast<double>(points_[chord].pulses[axes[i]]);
            const auto to = static_cast<double>(points_[chord + 1].pulses[axes[i]]);
            way[i] = (to - from) * pulses_mm_[head][i];
            off[i] = (at[axes[i]] - from) * pulses_mm_[head][i];
            along += off[i] * way[i];
            length2 += way[i] * way[i];
        }
        const double share = length2 > 0.0 ? std::clamp(along / length2, 0.0, 1.0) : 0.0;
        double off2 = 0.0;
        for (std::size_t i = 0; i < kSpaceAxisCount; ++i) {
            const double part = off[i] - share * way[i];
            off2 += part * part;
        }
        return off2;
    }

    std::span<const PathPoint> points_;
    std::size_t span_at_;
    PathSpan& span_;
    bool follows_table_ = false;
    std::array<SpaceVector, kHeads> pulses_mm_{};
    std::array<double, kHeads> allowed_mm_{};
    std::array<double, kHeads> excess_{};
    double along_span_ = 0.0;
};

}  // namespace

void narrow_where_off_polyline(const MachineLimits& limits, std::span<const PathPoint> points,
                               const FittedCurve& curve, const NodeRange& range, std::span<PathSpan> spans,
                               std::vector<std::uint32_t>& narrowed, std::vector<std::uint32_t>& stuck) {
    const CurveNodes& nodes = curve.nodes;
    std::optional<PolylineWatch> watch;
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
            const std::uint32_t span = nodes.span_at[j];
            watch.emplace(limits, points, span, spans[span]);
        }
        watch->watch(cell, curve.cell_at[j], begin, cell.length);
    }
}

}  // namespace psicarve::plan
