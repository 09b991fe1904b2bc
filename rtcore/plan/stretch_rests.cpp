// SPDX-License-Identifier: GPL-3.0-or-later
// Where no curve keeps the tolerance: rests at both ends of the ways concerned, which are then straight.
#include <numeric>

#include "rtcore/plan/kept_tolerance.hpp"
#include "rtcore/plan/path_stretch.hpp"

namespace psicarve::plan {
namespace {

// So often a stretch is divided where its pulses leave the tolerance; after that each of its ways is
// straight.
constexpr int kMostDivisions = 3;

}  // namespace

double StretchPlanner::plan(std::span<const PathPoint> points, std::span<const PathSpan> spans,
                            std::span<const PathCorner> corners, std::size_t first, std::size_t last,
                            std::vector<PathPiece>& pieces) {
    return plan_within({points, spans, corners}, first, last, kMostDivisions, pieces);
}

double StretchPlanner::plan_within(const Path& path, std::size_t first, std::size_t last, int divisions,
                                   std::vector<PathPiece>& pieces) {
    const std::size_t begin = pieces.size();
    const std::size_t seen_begin = seen_ != nullptr ? seen_->size() : 0;
    const double seconds = plan_curve(path, first, last, pieces);
    if (!curve_.times.is_within) {
        std::vector<std::uint32_t> left =
            spans_left(limits_, path.points, path.spans, first, std::span(pieces).subspan(begin));
        if (!left.empty()) {
            pieces.resize(begin);
            if (seen_ != nullptr) seen_->resize(seen_begin);
            if (divisions == 0) {
                left.resize(last - first);
                std::iota(left.begin(), left.end(), static_cast<std::uint32_t>(first));
            }
            return plan_with_rests(path, first, last, left, divisions - 1, pieces);
        }
    }
    pieces.back().rests = true;
    return seconds;
}

// `straight`: spans, upwards.
double StretchPlanner::plan_with_rests(const Path& path, std::size_t first, std::size_t last,
                                       std::span<const std::uint32_t> straight, int divisions,
                                       std::vector<PathPiece>& pieces) {
    double seconds = 0.0;
    for (const std::uint32_t span : straight) {
        if (span > first) seconds += plan_within(path, first, span, divisions, pieces);
        seconds += plan_straight(path, span, pieces);
        first = span + 1;
    }
    if (first < last) seconds += plan_within(path, first, last, divisions, pieces);
    return seconds;
}

// All control points stand on the chord, and so does the curve.
double StretchPlanner::plan_straight(const Path& path, std::size_t span, std::vector<PathPiece>& pieces) {
    begin_curve(path, span, span + 1);
    const CurveNodes& nodes = curve_.nodes;
    curve_.control.resize(nodes.step.size());
    double along = 0.0;
    for (std::size_t j = 0; j < nodes.step.size(); ++j) {
        for (std::size_t k = 0; k < kAxisCount; ++k)
            curve_.control[j][k] = static_cast<double>(path.points[span].pulses[k]) +
                                   path.spans[span].slope[k] * (along - nodes.offset[j]);
        along += nodes.step[j];
    }
    for (std::size_t k = 0; k < kAxisCount; ++k)
        curve_.control.back()[k] = static_cast<double>(path.points[span + 1].pulses[k]);
    cells_of(nodes, curve_.control, curve_.cells, curve_.cell_at);
    time(path.spans);
    add_pieces(path.points, pieces);
    pieces.back().rests = true;
    return curve_.times.seconds[0];
}

}  // namespace psicarve::plan
