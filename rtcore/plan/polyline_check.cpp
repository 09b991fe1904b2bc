// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/polyline_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "rtcore/plan/curve_walk.hpp"
#include "rtcore/plan/path_pieces.hpp"
#include "rtcore/plan/polyline_space.hpp"
#include "rtcore/plan/program_tube.hpp"

namespace psicarve::plan {
namespace {

// Narrowed a little further than needed, so that one more fit is enough as a rule.
constexpr double kPolylineMargin = 0.96;
/// What one span's way has shown so far.
class PolylineWatch {
public:
    PolylineWatch(const MachineLimits& limits, std::span<const PathPoint> points, std::size_t span_at,
                  PathSpan& span)
        : points_(points),
          span_at_(span_at),
          span_(span),
          space_(limits, points, span_at, span, JudgedPlaces::cuts) {
        follows_table_ = cuts_follow_table(limits, span.radius_mm);
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
    void see(Lanes& at) {
        if (!follows_table_)
            at[kPsi] = static_cast<double>(points_[span_at_].pulses[kPsi]) + span_.slope[kPsi] * along_span_;
        for (double& place : at) place = std::nearbyint(place);
        for (std::size_t head = 0; head < kHeads; ++head) {
            excess_[head] = std::max(excess_[head], space_.share_of_allowed(at, head));
        }
    }

    std::span<const PathPoint> points_;
    std::size_t span_at_;
    PathSpan& span_;
    PolylineSpace space_;
    bool follows_table_ = false;
    std::array<double, kHeads> excess_{};
    double along_span_ = 0.0;
};

}  // namespace

void narrow_where_off_polyline(const MachineLimits& limits, std::span<const PathPoint> points,
                               const FittedCurve& curve, const NodeRange& range, std::span<PathSpan> spans,
                               std::vector<std::uint32_t>& narrowed, std::vector<std::uint32_t>& stuck) {
    const auto begin_span = [&](std::optional<PolylineWatch>& watch, std::uint32_t span) {
        watch.emplace(limits, points, span, spans[span]);
    };
    narrow_watched<PolylineWatch>(curve, range, begin_span, narrowed, stuck);
}

}  // namespace psicarve::plan
