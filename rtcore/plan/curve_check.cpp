// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/curve_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "rtcore/plan/path_pieces.hpp"
#include "rtcore/plan/polyline_check.hpp"
#include "rtcore/plan/wide.hpp"
#include "shared/base/units.hpp"

namespace psicarve::plan {
namespace {

// Narrowed a little further than needed, so that one more fit is enough as a rule.
constexpr double kMargin = 0.96;
constexpr double kTurnShare = 0.25;
// Numbers this large have no fractions: adding it and taking it off again rounds.
constexpr double kRounder = 6755399441055744.0;

/// One head's plane around a chord: along and across it [mm], from pulses past the chord's begin.
class ChordPlane {
public:
    ChordPlane(const MachineLimits& limits, const PathSpan& span, std::size_t head) : head_(head) {
        const double psi_mm = std::max(span.radius_mm[head], 0.0) * rad_from_pulses(1, limits.pulses_per_rev);
        const double radius_mm = 1.0 / limits.axes[head].pulses_per_unit;
        const double x_mm = span.slope[kPsi] * span.length * psi_mm;
        const double y_mm = span.slope[head] * span.length * radius_mm;
        length_mm_ = std::sqrt(x_mm * x_mm + y_mm * y_mm);
        const double ux = length_mm_ > 0.0 ? x_mm / length_mm_ : 1.0;
        const double uy = length_mm_ > 0.0 ? y_mm / length_mm_ : 0.0;
        across_psi_ = -uy * psi_mm;
        across_radius_ = ux * radius_mm;
        along_psi_ = ux * psi_mm;
        along_radius_ = uy * radius_mm;
        pulse_along_mm_ = std::max(std::abs(along_psi_), std::abs(along_radius_));
        // Rule 1 grants the greater of the two axes' pulses; half of both is the DDA's.
        const double psi_share_mm = std::abs(across_psi_);
        const double radius_share_mm = std::abs(across_radius_);
        const double allowed_mm = limits.path_tolerance_mm + std::max(psi_share_mm, radius_share_mm) -
                                  0.5 * (psi_share_mm + radius_share_mm);
        inverse_allowed_ = 1.0 / allowed_mm;
    }

    /// How far from the chord, its ends included, as a share of what is allowed.
    PSICARVE_INLINE double share_of_allowed(const Vec& passed) const {
        const double across = across_psi_ * passed[kPsi] + across_radius_ * passed[head_];
        const double along = along_psi_ * passed[kPsi] + along_radius_ * passed[head_];
        const double outside = std::max(-along, along - length_mm_);
        const double distance_mm =
            outside <= pulse_along_mm_ ? std::abs(across) : std::sqrt(across * across + outside * outside);
        return distance_mm * inverse_allowed_;
    }

private:
    std::size_t head_;
    double length_mm_;
    double across_psi_;
    double across_radius_;
    double along_psi_;
    double along_radius_;
    double pulse_along_mm_;
    double inverse_allowed_;
};

/// What one span's way has shown so far.
class SpanWatch {
public:
    SpanWatch(const MachineLimits& limits, const PathPoint& from, const PathPoint& to, PathSpan& span)
        : span_(span), planes_{{{limits, span, 0}, {limits, span, 1}}} {
        follows_table_ = cuts_follow_table(limits, span.radius_mm);
        way_ = to.pulses[kPsi] < from.pulses[kPsi] ? -1.0 : 1.0;
        for (std::size_t k = 0; k < kAxisCount; ++k) begin_[k] = static_cast<double>(from.pulses[k]);
        turn_pulses_ = std::abs(static_cast<double>(to.pulses[kPsi] - from.pulses[kPsi]));
    }

    /// A part of a cell: where it may be cut.
    PSICARVE_INLINE void watch(const PathCell& cell, const Lanes& cell_at, double from, double to) {
        const std::size_t count = bits_in(cell, to - from);
        const double step = (to - from) / static_cast<double>(count);
        Vec at, slope, bend;
        load(cell_at, at);
        load(cell.slope_begin, slope);
        load(cell.bend, bend);
        at -= begin_;
        for (std::size_t i = 1; i <= count; ++i) {
            along_span_ += step;
            const double along = from + static_cast<double>(i) * step;
            see(Vec(at + along * (slope + 0.5 * along * bend)));
        }
    }

    bool is_outside() const { return excess_[0] > 1.0 || excess_[1] > 1.0 || turn_back_ > kMostTurnPulses; }
    bool narrow() {
        bool narrowed = false;
        for (std::size_t head = 0; head < kHeads; ++head) {
            if (excess_[head] <= 1.0) continue;
            narrowed = narrow_band(head, kMargin / excess_[head]) || narrowed;
        }
        if (turn_back_ > kMostTurnPulses) narrowed = narrow_band(kPsi, kTurnShare) || narrowed;
        return narrowed;
    }

private:
    PSICARVE_INLINE void see(const Vec& at) {
        Vec passed = at;
        if (follows_table_) {
            const double psi = way_ * passed[kPsi];
            turn_back_ = std::max({turn_back_, furthest_ - psi, psi - turn_pulses_});
            furthest_ = std::max(furthest_, psi);
        } else {
            passed[kPsi] = span_.slope[kPsi] * along_span_;
        }
        // To whole pulses.
        passed = (passed + kRounder) - kRounder;
        for (std::size_t head = 0; head < kHeads; ++head) {
            excess_[head] = std::max(excess_[head], planes_[head].share_of_allowed(passed));
        }
    }
    bool narrow_band(std::size_t axis, double share) {
        if (span_.band[axis] <= kLeastBandPulses) return false;
        span_.band[axis] = std::max(kLeastBandPulses, share * span_.band[axis]);
        return true;
    }

    PathSpan& span_;
    Vec begin_{};
    std::array<ChordPlane, kHeads> planes_;
    std::array<double, kHeads> excess_{};
    bool follows_table_ = false;
    double along_span_ = 0.0;
    double way_ = 1.0;
    double turn_pulses_ = 0.0;
    double furthest_ = 0.0;
    double turn_back_ = 0.0;
};

}  // namespace

PSICARVE_FOR_WIDE_REGISTERS
void narrow_where_outside(const MachineLimits& limits, std::span<const PathPoint> points,
                          const FittedCurve& curve, const NodeRange& range, std::span<PathSpan> spans,
                          std::vector<std::uint32_t>& narrowed, std::vector<std::uint32_t>& stuck) {
    if (rounds_corners(limits)) {
        narrow_where_off_polyline(limits, points, curve, range, spans, narrowed, stuck);
        return;
    }
    const CurveNodes& nodes = curve.nodes;
    std::optional<SpanWatch> watch;
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
            watch.emplace(limits, points[span], points[span + 1], spans[span]);
        }
        watch->watch(cell, curve.cell_at[j], begin, cell.length);
    }
}

}  // namespace psicarve::plan
