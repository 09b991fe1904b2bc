// SPDX-License-Identifier: GPL-3.0-or-later
// How a curve is decided part by part, without its end being known.
#include "rtcore/plan/curve_part.hpp"

#include <algorithm>
#include <cstdint>

#include "rtcore/plan/path_stretch.hpp"

namespace psicarve::plan {
namespace {

// Of a curve that goes on two control points are decided, and one is where it ends.
constexpr std::size_t kLeastNodes = 4;

Lanes slope_at(const PathCell& cell, double along) {
    Lanes slope;
    for (std::size_t k = 0; k < kAxisCount; ++k) slope[k] = cell.slope_begin[k] + along * cell.bend[k];
    return slope;
}

Lanes place_at(const PathCell& cell, const Lanes& cell_at, double along) {
    Lanes at;
    for (std::size_t k = 0; k < kAxisCount; ++k)
        at[k] = cell_at[k] + along * (cell.slope_begin[k] + 0.5 * along * cell.bend[k]);
    return at;
}

PathCell part_of(const PathCell& cell, double from, double to) {
    return {to - from, slope_at(cell, from), slope_at(cell, to), cell.bend};
}

template <typename T>
void drop_front(std::vector<T>& values, std::size_t count) {
    values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count));
}

}  // namespace

void StretchPlanner::show_cells(std::span<const PathCell> cells, bool is_from_rest) const {
    if (seen_ == nullptr) return;
    for (const PathCell& cell : cells) seen_->push_back({cell, is_from_rest && &cell == cells.data()});
}

bool StretchPlanner::decide(std::span<const PathPoint> points, std::span<const PathSpan> spans,
                            std::span<const PathCorner> corners, const DecidedPoints& at, CurvePart& part) {
    // The last span but one before `from` has its nodes as the part before had them.
    const std::size_t first = decided_.empty() ? at.from : at.from - 2;
    spans_.assign(spans.begin(), spans.end());
    curve_.nodes = curve_nodes(limits_, points, spans_, corners, first, at.last, std::move(curve_.nodes));
    first_node_ = 0;
    is_found_ = decided_.empty() || go_on_from(static_cast<std::uint32_t>(at.from));
    is_found_ = is_found_ && curve_.nodes.step.size() >= first_node_ + kLeastNodes;
    if (is_found_) curve_.times.is_within = fit(points);
    if (is_found_) {
        time(spans);
        bend_evenly(points, spans);
        // Cut on its chords, a way keeps the tolerance wherever the curve is.
        is_found_ = curve_.times.is_within || !rounds_corners(limits_);
    }
    if (!is_found_) {
        decided_.clear();
        return false;
    }
    // Limits may be those of the curve that was not taken.
    note_outside();
    limit_speeds();
    take_part(points, spans, at, part);
    return true;
}

// All nodes before the one before that on the point are dropped, and of its cell the half that is not needed.
// False: its nodes are others now, and decided control points would make another curve than the one before.
bool StretchPlanner::go_on_from(std::uint32_t point) {
    CurveNodes& nodes = curve_.nodes;
    const auto on_point = std::find(nodes.point_at.begin(), nodes.point_at.end(), point);
    const auto count = static_cast<std::size_t>(on_point - nodes.point_at.begin()) - 1;
    for (auto* lengths : {&nodes.step, &nodes.cell, &nodes.control_step, &nodes.offset})
        drop_front(*lengths, count);
    for (auto* lanes : {&nodes.low, &nodes.high, &nodes.weight}) drop_front(*lanes, count);
    for (auto* places : {&nodes.point_at, &nodes.span_at}) drop_front(*places, count);
    nodes.cell.front() *= 0.5;
    first_node_ = 1;
    return nodes.step.size() >= first_node_ + kLeastNodes && lengths_around(first_node_) == decided_lengths_;
}

std::array<double, 4> StretchPlanner::lengths_around(std::size_t node) const {
    const CurveNodes& nodes = curve_.nodes;
    return {nodes.step[node - 1], nodes.cell[node], nodes.control_step[node - 1], nodes.control_step[node]};
}

double StretchPlanner::rest_speed2(std::span<const PathSpan> spans, std::size_t point,
                                   const Lanes& slope) const {
    const Lanes* before = point > 0 ? &spans[point - 1].slope : nullptr;
    const Lanes* after = point < spans.size() ? &spans[point].slope : nullptr;
    double speed2 = 1.0;
    for (const Lanes* way : {before, after, &slope}) {
        if (way == nullptr) continue;
        speed2 = std::min({speed2, stop_speed2(limits_, *way, before), stop_speed2(limits_, *way, after)});
    }
    return speed2;
}

void StretchPlanner::take_part(std::span<const PathPoint> points, std::span<const PathSpan> spans,
                               const DecidedPoints& at, CurvePart& part) {
    const CurveNodes& nodes = curve_.nodes;
    const bool rests = at.to == at.last;
    const auto end_node = static_cast<std::size_t>(
        std::find(nodes.point_at.begin(), nodes.point_at.end(), static_cast<std::uint32_t>(at.to)) -
        nodes.point_at.begin());
    const auto middle_of = [&](std::size_t j) { return j > 0 ? 0.5 * nodes.step[j - 1] : 0.0; };
    part.points.assign(points.begin() + static_cast<std::ptrdiff_t>(at.from),
                       points.begin() + static_cast<std::ptrdiff_t>(at.to) + 1);
    const auto add = [&](std::size_t j, double from, double to) {
        const PathCell& cell = curve_.cells[j];
        const bool is_whole = from == 0.0 && to == cell.length;
        part.cells.push_back(is_whole ? cell : part_of(cell, from, to));
        part.cell_at.push_back(place_at(cell, curve_.cell_at[j], from));
        const bool has_point = nodes.point_at[j] != CurveNodes::kNoPoint && j != first_node_;
        part.point_at.push_back(has_point ? nodes.point_at[j] - static_cast<std::uint32_t>(at.from)
                                          : PathPiece::kNoPoint);
        part.point_along.push_back(has_point ? middle_of(j) - from : 0.0);
        for (std::size_t timing = 0; timing < kTimingCount; ++timing) {
            const double begin2 = bound2_[timing][j];
            const double end2 = bound2_[timing][j + 1];
            const InnerSpeeds2& inner2 = inner2_[timing][j];
            // Of a half all places keep to the lowest limit in the cell.
            const double least2 = std::min({begin2, end2, inner2[0], inner2[1], inner2[2]});
            part.bound2[timing].push_back(from == 0.0 ? begin2 : least2);
            part.inner2[timing].push_back(is_whole ? inner2 : InnerSpeeds2{least2, least2, least2});
            if (j == end_node) part.bound2[timing].push_back(is_whole ? end2 : least2);
        }
    };
    for (std::size_t j = first_node_; j <= end_node; ++j) {
        const double from = j == first_node_ ? middle_of(j) : 0.0;
        add(j, from, j == end_node ? middle_of(j) : curve_.cells[j].length);
    }
    show_cells(part.cells, first_node_ == 0);
    part.begin_at = part.cell_at.front();
    part.rest_begin2 = rest_speed2(spans, at.from, part.cells.front().slope_begin);
    part.rest_end2 = rest_speed2(spans, at.to, part.cells.back().slope_end);
    decided_.clear();
    if (rests) return;
    const auto decided = curve_.control.begin() + static_cast<std::ptrdiff_t>(end_node) - 1;
    decided_.assign(decided, decided + 3);
    decided_lengths_ = lengths_around(end_node);
}

}  // namespace psicarve::plan
