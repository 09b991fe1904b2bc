// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/kept_tolerance.hpp"

#include <array>

#include "rtcore/cycle/dual_head_dda.hpp"
#include "rtcore/plan/chord_plane.hpp"
#include "rtcore/plan/polyline_space.hpp"

namespace psicarve::plan {
namespace {

/// Whether each place that the pulses of one piece pass is one that `is_kept` accepts. A part of a line that
/// leads from point to point is never more than half a pulse off.
template <typename IsKept>
bool all_kept(const PathPiece& piece, Pulses4 at, const IsKept& is_kept) {
    if (piece.line_pulses != Pulses4{}) return true;
    const Pulses4& way = piece.delta_pulses;
    cycle::DualHeadDda dda;
    dda.start(way);
    while (dda.iterations_left() > 0) {
        const std::uint32_t axes = dda.iterate();
        for (std::size_t k = 0; k < kAxisCount; ++k)
            if ((axes >> k & 1U) != 0) at[k] += way[k] < 0 ? -1 : 1;
        if (!is_kept(at)) return false;
    }
    return true;
}

class TolerancedSpan {
public:
    TolerancedSpan(const MachineLimits& limits, std::span<const PathPoint> points, std::size_t span_at,
                   const PathSpan& span)
        : begin_(points[span_at].pulses),
          is_rounded_(rounds_corners(limits)),
          planes_{{{limits, span, 0, JudgedPlaces::pulses}, {limits, span, 1, JudgedPlaces::pulses}}},
          space_(limits, points, span_at, span, JudgedPlaces::pulses) {}

    bool keeps(const Pulses4& at) const {
        Lanes place;
        for (std::size_t k = 0; k < kAxisCount; ++k)
            place[k] = static_cast<double>(is_rounded_ ? at[k] : at[k] - begin_[k]);
        Vec passed;
        load(place, passed);
        for (std::size_t head = 0; head < kHeads; ++head) {
            const double share =
                is_rounded_ ? space_.share_of_allowed(place, head) : planes_[head].share_of_allowed(passed);
            if (share > 1.0) return false;
        }
        return true;
    }

private:
    Pulses4 begin_;
    bool is_rounded_;
    std::array<ChordPlane, kHeads> planes_;
    PolylineSpace space_;
};

}  // namespace

std::vector<std::uint32_t> spans_left(const MachineLimits& limits, std::span<const PathPoint> points,
                                      std::span<const PathSpan> spans, std::size_t first,
                                      std::span<const PathPiece> pieces) {
    std::vector<std::uint32_t> left;
    Pulses4 at = points[first].pulses;
    auto piece = pieces.begin();
    for (std::size_t i = first; piece != pieces.end(); ++i) {
        const TolerancedSpan span(limits, points, i, spans[i]);
        bool is_kept = true;
        for (bool is_last = false; !is_last; ++piece) {
            is_last = piece->point != PathPiece::kNoPoint;
            is_kept = is_kept && (spans[i].is_link || all_kept(*piece, at, [&span](const Pulses4& place) {
                                      return span.keeps(place);
                                  }));
            for (std::size_t k = 0; k < kAxisCount; ++k) at[k] += piece->delta_pulses[k];
        }
        if (!is_kept) left.push_back(static_cast<std::uint32_t>(i));
    }
    return left;
}

}  // namespace psicarve::plan
