// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/curve_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "rtcore/plan/chord_plane.hpp"
#include "rtcore/plan/curve_walk.hpp"
#include "rtcore/plan/path_pieces.hpp"
#include "rtcore/plan/polyline_check.hpp"
#include "rtcore/plan/wide.hpp"

namespace psicarve::plan {
namespace {

// Narrowed a little further than needed, so that one more fit is enough as a rule.
constexpr double kMargin = 0.96;
constexpr double kTurnShare = 0.25;
// Numbers this large have no fractions: adding it and taking it off again rounds.
constexpr double kRounder = 6755399441055744.0;

/// What one span's way has shown so far.
class SpanWatch {
public:
    SpanWatch(const MachineLimits& limits, const PathPoint& from, const PathPoint& to, PathSpan& span)
        : span_(span),
          planes_{{{limits, span, 0, JudgedPlaces::cuts}, {limits, span, 1, JudgedPlaces::cuts}}} {
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
    const auto begin_span = [&](std::optional<SpanWatch> & watch, std::uint32_t span)
        __attribute__((always_inline)) {
        watch.emplace(limits, points[span], points[span + 1], spans[span]);
    };
    narrow_watched<SpanWatch>(curve, range, begin_span, narrowed, stuck);
}

}  // namespace psicarve::plan
