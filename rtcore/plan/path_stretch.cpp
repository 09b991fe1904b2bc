// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/path_stretch.hpp"

#include <algorithm>

#include "rtcore/plan/curve_check.hpp"
#include "shared/units.hpp"

namespace psicarve::plan {
namespace {

// Speeds are looked at in five places of a cell; between them they may be a little higher.
constexpr double kSpeedShare = 0.998;
// A curve that leaves its tube between the nodes is fitted again; once is enough as a rule.
constexpr int kMostFits = 5;
// Whole pulses in whole ticks shake a little.
constexpr double kAccelShare = 0.985;

Lanes accel_of(const MachineLimits& limits) {
    Lanes accel;
    for (std::size_t k = 0; k < kAxisCount; ++k) accel[k] = kAccelShare * limits.axes[k].accel_pps2;
    return accel;
}

}  // namespace

StretchPlanner::StretchPlanner(const MachineLimits& limits)
    : limits_(limits), fit_(accel_of(limits)), timing_(accel_of(limits)) {
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        mm_per_pulse_[k] = 1.0 / limits.axes[k].pulses_per_unit;
        inverse_speed_[k] = 1.0 / (kSpeedShare * limits.axes[k].speed_pps);
    }
    for (std::size_t timing = 0; timing < kTimingCount; ++timing) {
        const double feed_mm_s = limits.feed_mm_s * kFeedFactor[timing];
        inverse_feed2_[timing] = 1.0 / (feed_mm_s * feed_mm_s);
    }
    rad_per_pulse_ = rad_from_pulses(1, limits.pulses_per_rev);
}

double StretchPlanner::plan(std::span<const PathPoint> points, std::span<const PathSpan> spans,
                            std::span<const PathCorner> corners, std::size_t first, std::size_t last,
                            std::vector<PathPiece>& pieces) {
    const CurveNodes nodes = fit(points, spans, corners, first, last);
    limit_speeds();
    const Lanes* before = first > 0 ? &spans[first - 1].slope : nullptr;
    const Lanes* after = last < spans.size() ? &spans[last].slope : nullptr;
    // At its ends the curve may be steeper than its chords.
    const double begin2 = std::min(stop_speed2(limits_, spans[first].slope, before),
                                   stop_speed2(limits_, cells_.front().slope_begin, before));
    const double end2 = std::min(stop_speed2(limits_, spans[last - 1].slope, after),
                                 stop_speed2(limits_, cells_.back().slope_end, after));
    for (std::size_t timing = 0; timing < kTimingCount; ++timing) {
        bound2_[timing].front() = std::min(bound2_[timing].front(), begin2);
        bound2_[timing].back() = std::min(bound2_[timing].back(), end2);
    }
    timing_.set_path(cells_);
    timing_.solve(bound2_[0], inner2_[0], speed2_[0]);
    if (bound2_[1] == bound2_[0]) {
        speed2_[1] = speed2_[0];
    } else {
        timing_.solve(bound2_[1], inner2_[1], speed2_[1]);
        // Greedy passes may lose a little where an axis turns back.
        for (std::size_t i = 0; i < speed2_[1].size(); ++i) {
            speed2_[1][i] = std::max(speed2_[1][i], speed2_[0][i]);
        }
    }
    double seconds = 0.0;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        seconds += cell_seconds(cells_[i].length, speed2_[0][i], speed2_[0][i + 1]);
    }
    add_pieces(points, nodes, pieces);
    return seconds;
}

// The tube is looked at in the nodes; where the curve leaves it in between, the tube is narrowed and the
// curve fitted again.
CurveNodes StretchPlanner::fit(std::span<const PathPoint> points, std::span<const PathSpan> spans,
                               std::span<const PathCorner> corners, std::size_t first, std::size_t last) {
    narrowed_.resize(spans.size());
    for (std::size_t span = first; span < last; ++span) narrowed_[span] = spans[span];
    CurveNodes nodes = curve_nodes(limits_, points, narrowed_, corners, first, last);
    for (int fits = 1;; ++fits) {
        fit_.solve(nodes);
        cells_of(nodes, fit_.control(), cells_, cell_at_);
        if (fits == kMostFits || !narrow_where_outside(limits_, points, {nodes, cells_, cell_at_}, narrowed_))
            return nodes;
        nodes = curve_nodes(limits_, points, narrowed_, corners, first, last);
    }
}

void cells_of(const CurveNodes& nodes, std::span<const Lanes> control, std::vector<PathCell>& cells,
              std::vector<Lanes>& cell_at) {
    const std::size_t last = nodes.step.size() - 1;
    cells.clear();
    cell_at.clear();
    Lanes slope{};
    Lanes at = control.front();
    for (std::size_t j = 0; j <= last; ++j) {
        PathCell cell{};
        cell.length = nodes.cell[j];
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            const double next =
                j < last ? (control[j + 1][k] - control[j][k]) / nodes.control_step[j] : slope[k];
            cell.slope_begin[k] = j > 0 ? slope[k] : next;
            cell.slope_end[k] = next;
            cell.bend[k] = (cell.slope_end[k] - cell.slope_begin[k]) / cell.length;
        }
        cells.push_back(cell);
        cell_at.push_back(at);
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            at[k] += 0.5 * cell.length * (cell.slope_begin[k] + cell.slope_end[k]);
        }
        slope = cell.slope_end;
    }
}

// Motors' top speeds, and the feed of the tip over the surface: (r psi')^2 + R'^2 + Y'^2, the faster head.
double StretchPlanner::greatest_speed2(const Lanes& slope, const Lanes& at, std::size_t timing) const {
    double need = 0.0;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        const double share = slope[k] * inverse_speed_[k];
        need = std::max(need, share * share);
    }
    constexpr std::size_t kPsi = index_of(Axis::psi);
    constexpr std::size_t kY = index_of(Axis::y);
    const double turn = slope[kPsi] * rad_per_pulse_;
    const double lift = slope[kY] * mm_per_pulse_[kY];
    for (std::size_t head = 0; head < 2; ++head) {
        const double radius_mm = at[head] * mm_per_pulse_[head] + limits_.tip_offset_mm[head];
        const double around = radius_mm * turn;
        const double out = slope[head] * mm_per_pulse_[head];
        need = std::max(need, (around * around + out * out + lift * lift) * inverse_feed2_[timing]);
    }
    return need > 0.0 ? 1.0 / need : 1.0;
}

void StretchPlanner::limit_speeds() {
    for (std::size_t timing = 0; timing < kTimingCount; ++timing) {
        std::vector<double>& bound2 = bound2_[timing];
        std::vector<InnerSpeeds2>& inner2 = inner2_[timing];
        bound2.clear();
        inner2.clear();
        for (std::size_t i = 0; i < cells_.size(); ++i) {
            const PathCell& cell = cells_[i];
            bound2.push_back(greatest_speed2(cell.slope_begin, cell_at_[i], timing));
            InnerSpeeds2 inner;
            for (std::size_t part = 0; part < inner.size(); ++part) {
                const double along = 0.25 * static_cast<double>(part + 1) * cell.length;
                Lanes slope;
                Lanes at;
                for (std::size_t k = 0; k < kAxisCount; ++k) {
                    slope[k] = cell.slope_begin[k] + along * cell.bend[k];
                    at[k] = cell_at_[i][k] + 0.5 * along * (cell.slope_begin[k] + slope[k]);
                }
                inner[part] = greatest_speed2(slope, at, timing);
            }
            inner2.push_back(inner);
        }
        bound2.push_back(greatest_speed2(cells_.back().slope_end, fit_.control().back(), timing));
    }
}

void StretchPlanner::add_pieces(std::span<const PathPoint> points, const CurveNodes& nodes,
                                std::vector<PathPiece>& pieces) {
    PieceMaker maker(limits_, points, nodes.point_at.front(), fit_.control().front(), pieces);
    for (std::size_t j = 0; j < cells_.size(); ++j) {
        std::array<double, kTimingCount> begin2;
        std::array<double, kTimingCount> end2;
        for (std::size_t timing = 0; timing < kTimingCount; ++timing) {
            begin2[timing] = speed2_[timing][j];
            end2[timing] = speed2_[timing][j + 1];
        }
        maker.begin_cell(cells_[j], cell_at_[j], begin2, end2);
        const std::uint32_t point = nodes.point_at[j];
        const double before = j > 0 ? 0.5 * nodes.step[j - 1] : 0.0;
        if (point == CurveNodes::kNoPoint || j == 0) {
            maker.add(0.0, cells_[j].length, PathPiece::kNoPoint);
        } else {
            maker.add(0.0, before, point);
            if (j + 1 < cells_.size()) maker.add(before, cells_[j].length, PathPiece::kNoPoint);
        }
    }
}

}  // namespace psicarve::plan
