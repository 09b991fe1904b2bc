// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/path_stretch.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "rtcore/plan/curve_check.hpp"
#include "shared/base/units.hpp"

namespace psicarve::plan {
namespace {

// Speeds are looked at in five places of a cell; between them they may be a little higher.
constexpr double kSpeedShare = 0.998;
// A curve that leaves its tube between the nodes is fitted again; once is enough as a rule.
constexpr int kMostFits = 12;
// So far to both sides the curve gives way to a narrower tube.
constexpr std::size_t kSpansAround = 12;
// A curve is fitted by so many spans, which the processor keeps at hand, and some more beyond them.
constexpr std::size_t kSpansAWindow = 96;
// Whole pulses in whole ticks shake a little.
constexpr double kAccelShare = 0.985;
// Less of the time at an axis' acceleration than that: no other curve would be faster by much.
constexpr double kLeastLimitedShare = 0.1;

}  // namespace

Lanes curve_accel(const MachineLimits& limits) {
    Lanes accel;
    for (std::size_t k = 0; k < kAxisCount; ++k) accel[k] = kAccelShare * limits.axes[k].accel_pps2;
    return accel;
}

StretchPlanner::StretchPlanner(const MachineLimits& limits)
    : limits_(limits), accel_(curve_accel(limits)), fit_(accel_), timing_(accel_) {
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

void StretchPlanner::begin_curve(const Path& path, std::size_t first, std::size_t last) {
    spans_.resize(path.spans.size());
    std::copy(path.spans.begin() + static_cast<std::ptrdiff_t>(first),
              path.spans.begin() + static_cast<std::ptrdiff_t>(last),
              spans_.begin() + static_cast<std::ptrdiff_t>(first));
    curve_.nodes =
        curve_nodes(limits_, path.points, spans_, path.corners, first, last, std::move(curve_.nodes));
    decided_.clear();
    first_node_ = 0;
}

double StretchPlanner::plan_curve(const Path& path, std::size_t first, std::size_t last,
                                  std::vector<PathPiece>& pieces) {
    begin_curve(path, first, last);
    curve_.times.is_within = fit(path.points);
    time(path.spans);
    if (!path.spans[first].is_link) bend_evenly(path.points, path.spans);
    add_pieces(path.points, pieces);
    return curve_.times.seconds[0];
}

// The fastest timing of the curve, at 100 % and at twice the feed.
void StretchPlanner::time(std::span<const PathSpan> spans) {
    const std::size_t first = curve_.nodes.span_at.front();
    const std::size_t last = curve_.nodes.span_at.back();
    note_outside();
    limit_speeds();
    const Lanes* before = first > 0 ? &spans[first - 1].slope : nullptr;
    const Lanes* after = last < spans.size() ? &spans[last].slope : nullptr;
    // At its ends the curve may be steeper than its chords.
    const double begin2 = std::min(stop_speed2(limits_, spans[first].slope, before),
                                   stop_speed2(limits_, curve_.cells.front().slope_begin, before));
    const double end2 = std::min(stop_speed2(limits_, spans[last - 1].slope, after),
                                 stop_speed2(limits_, curve_.cells.back().slope_end, after));
    for (std::size_t timing = 0; timing < kTimingCount; ++timing) {
        if (decided_.empty()) bound2_[timing].front() = std::min(bound2_[timing].front(), begin2);
        bound2_[timing].back() = std::min(bound2_[timing].back(), end2);
    }
    timing_.set_path(curve_.cells);
    const std::array<SpeedLimits, kTimingCount> limits{SpeedLimits{bound2_[0], inner2_[0]},
                                                       SpeedLimits{bound2_[1], inner2_[1]}};
    if (bound2_[1] == bound2_[0]) {
        timing_.solve(limits[0], curve_.speed2[0]);
        curve_.speed2[1] = curve_.speed2[0];
    } else {
        timing_.solve_both(limits, curve_.speed2);
        // Greedy passes may lose a little where an axis turns back.
        for (std::size_t i = 0; i < curve_.speed2[1].size(); ++i) {
            curve_.speed2[1][i] = std::max(curve_.speed2[1][i], curve_.speed2[0][i]);
        }
    }
    for (std::size_t timing = 0; timing < kTimingCount; ++timing) {
        const std::vector<double>& speed2 = curve_.speed2[timing];
        double& seconds = curve_.times.seconds[timing];
        seconds = 0.0;
        for (std::size_t i = 0; i < curve_.cells.size(); ++i)
            seconds += cell_seconds(curve_.cells[i].length, speed2[i], speed2[i + 1]);
    }
}

// The curve once more, with what its timing says of where bending costs time.
void StretchPlanner::bend_evenly(std::span<const PathPoint> points, std::span<const PathSpan> spans) {
    const double limited_share = weigh_bending(curve_.cells, curve_.speed2[0], accel_, curve_.nodes.weight);
    if (limited_share < kLeastLimitedShare) return;
    std::swap(curve_, least_bent_);
    curve_.nodes = least_bent_.nodes;
    curve_.times.is_within = fit(points);
    if (curve_.times.is_within) time(spans);
    if (!is_worthwhile(curve_.times, least_bent_.times)) std::swap(curve_, least_bent_);
}

// The tube is looked at in the nodes; where the curve leaves it in between, the tube is narrowed and the
// curve fitted again around there. False if it is still outside somewhere, a tube being narrowed only so far,
// or if no curve was found that comes close to what was asked for.
bool StretchPlanner::fit(std::span<const PathPoint> points) {
    const NodeRange whole{first_node_, curve_.nodes.step.size() - 1};
    curve_.control.resize(whole.last + 1);
    std::copy(decided_.begin(), decided_.end(), curve_.control.begin());
    ranges_.assign(1, whole);
    bool is_stuck = false;
    is_found_ = true;
    for (int fits = 1;; ++fits) {
        const auto is_fitted = [this](const NodeRange& range) { return fit_again(range); };
        const bool is_good =
            fits == 1 ? fit_in_windows() : std::all_of(ranges_.begin(), ranges_.end(), is_fitted);
        if (!is_good) {
            ranges_.assign(1, whole);
            is_found_ = fit_whole();
        }
        cells_of(curve_.nodes, curve_.control, curve_.cells, curve_.cell_at);
        if (fits == kMostFits) return false;
        narrowed_.clear();
        stuck_.clear();
        for (const NodeRange& range : ranges_) narrow(points, range);
        is_stuck = !bend_least_where_stuck() || is_stuck;
        if (narrowed_.empty()) return is_found_ && (!is_stuck || is_within(points));
        gather_narrowed_ranges();
        for (const std::uint32_t span : narrowed_)
            bind_again(limits_, points, spans_, node_of(span), curve_.nodes);
    }
}

void StretchPlanner::narrow(std::span<const PathPoint> points, const NodeRange& range) {
    narrow_where_outside(limits_, points, {curve_.nodes, curve_.cells, curve_.cell_at}, range, spans_,
                         narrowed_, stuck_);
}

bool StretchPlanner::is_within(std::span<const PathPoint> points) {
    narrowed_.clear();
    stuck_.clear();
    narrow(points, {first_node_, curve_.nodes.step.size() - 1});
    return narrowed_.empty() && stuck_.empty();
}

// Around spans that the curve leaves though their tube is as narrow as it may be, all cells weigh the same
// again. False if they do already.
bool StretchPlanner::bend_least_where_stuck() {
    constexpr Lanes kEven{1.0, 1.0, 1.0, 1.0};
    const std::size_t first = curve_.nodes.span_at[first_node_];
    const std::size_t last = curve_.nodes.span_at.back();
    bool is_eased = true;
    for (const std::uint32_t span : stuck_) {
        const std::size_t begin = node_of(std::max(first + kSpansAround, std::size_t{span}) - kSpansAround);
        const std::size_t end = node_of(std::min(last, span + 1 + kSpansAround));
        const auto weights = std::span(curve_.nodes.weight).subspan(begin, end + 1 - begin);
        if (std::all_of(weights.begin(), weights.end(), [&](const Lanes& w) { return w == kEven; })) {
            is_eased = false;
            continue;
        }
        std::fill(weights.begin(), weights.end(), kEven);
        narrowed_.push_back(span);
    }
    std::sort(narrowed_.begin(), narrowed_.end());
    return is_eased;
}

// Where a span begins, or the last one ends.
std::size_t StretchPlanner::node_of(std::size_t span) const {
    const auto at = std::lower_bound(curve_.nodes.span_at.begin(), curve_.nodes.span_at.end(), span);
    return static_cast<std::size_t>(at - curve_.nodes.span_at.begin());
}

void StretchPlanner::gather_narrowed_ranges() {
    const std::size_t first = curve_.nodes.span_at[first_node_];
    const std::size_t last = curve_.nodes.span_at.back();
    ranges_.clear();
    for (const std::uint32_t span : narrowed_) {
        const NodeRange around{node_of(std::max(first + kSpansAround, std::size_t{span}) - kSpansAround),
                               node_of(std::min(last, span + 1 + kSpansAround))};
        if (!ranges_.empty() && around.first <= ranges_.back().last) {
            ranges_.back().last = around.last;
        } else {
            ranges_.push_back(around);
        }
    }
}

bool StretchPlanner::fit_whole() {
    const std::size_t last = curve_.nodes.step.size() - 1;
    const std::span<const Lanes> control{curve_.control};
    fit_.solve(NodesView::of(curve_.nodes, first_node_, last),
               {control.subspan(first_node_, decided_.empty() ? 0 : 2), {}});
    std::copy(fit_.control().begin(), fit_.control().end(),
              curve_.control.begin() + static_cast<std::ptrdiff_t>(first_node_));
    return fit_.has_converged();
}

// From begin to end. How the curve goes on many spans later changes nothing where it is: what was fitted
// beyond a window is fitted again with the next one. False if one of them was not found.
bool StretchPlanner::fit_in_windows() {
    const std::size_t last_span = curve_.nodes.span_at.back();
    std::size_t span = curve_.nodes.span_at[first_node_];
    for (NodeRange range{first_node_, 0};; range.first = node_of(span)) {
        span += kSpansAWindow;
        const bool is_last = span + kSpansAround >= last_span;
        range.last = is_last ? curve_.nodes.step.size() - 1 : node_of(span + kSpansAround);
        if (!fit_part(range, 0)) return false;
        if (is_last) return true;
    }
}

// Outside the range the curve stays as it is. False, and nothing changed, if no curve within was found.
bool StretchPlanner::fit_again(const NodeRange& range) {
    return fit_part(range, range.last + 1 < curve_.nodes.step.size() ? 2 : 0);
}

bool StretchPlanner::fit_part(const NodeRange& range, std::size_t decided_last) {
    const std::span<const Lanes> decided{curve_.control};
    fit_.solve(NodesView::of(curve_.nodes, range.first, range.last),
               {decided.subspan(range.first, range.first > 0 ? 2 : 0),
                decided.subspan(range.last - 1, decided_last)});
    if (!fit_.has_converged()) return false;
    std::copy(fit_.control().begin(), fit_.control().end(),
              curve_.control.begin() + static_cast<std::ptrdiff_t>(range.first));
    return true;
}

PSICARVE_FOR_WIDE_REGISTERS
void cells_of(const CurveNodes& nodes, std::span<const Lanes> control, std::vector<PathCell>& cells,
              std::vector<Lanes>& cell_at) {
    const std::size_t last = nodes.step.size() - 1;
    cells.resize(last + 1);
    cell_at.resize(last + 1);
    Vec point, point_after, begin, end, at;
    load(control[0], point);
    load(control[1], point_after);
    at = point;
    begin = end = (point_after - point) / nodes.control_step[0];
    for (std::size_t j = 0; j <= last; ++j) {
        PathCell& cell = cells[j];
        cell.length = nodes.cell[j];
        store(begin, cell.slope_begin);
        store(end, cell.slope_end);
        store(Vec((end - begin) / cell.length), cell.bend);
        store(at, cell_at[j]);
        at += 0.5 * cell.length * (begin + end);
        begin = end;
        if (j + 1 >= last) continue;
        point = point_after;
        load(control[j + 2], point_after);
        end = (point_after - point) / nodes.control_step[j + 1];
    }
}

// A cell reaches half-way to its neighbours' nodes, so into two spans where it stands on a point.
void StretchPlanner::note_outside() {
    const std::size_t last = curve_.cells.size() - 1;
    is_fed_.resize(last + 1);
    for (std::size_t j = 0; j <= last; ++j) {
        for (std::size_t head = 0; head < 2; ++head) {
            const bool before = j == 0 || spans_[curve_.nodes.span_at[j - 1]].is_outside[head];
            const bool after = j == last || spans_[curve_.nodes.span_at[j]].is_outside[head];
            is_fed_[j][head] = !before || !after;
        }
    }
}

// All of a cell keeps to the slower of the two spans that it reaches into.
Timings StretchPlanner::least_pace2_of(std::size_t cell) const {
    Timings pace2{};
    const std::size_t last = curve_.cells.size() - 1;
    for (std::size_t timing = 0; timing < kTimingCount; ++timing) {
        if (cell > 0) pace2[timing] = spans_[curve_.nodes.span_at[cell - 1]].least_pace2[timing];
        if (cell == last) continue;
        pace2[timing] = std::max(pace2[timing], spans_[curve_.nodes.span_at[cell]].least_pace2[timing]);
    }
    return pace2;
}

// Motors' top speeds, and the feed of the tip over the surface: (r psi')^2 + R'^2 + Y'^2, the faster of the
// heads that are not outside. Four places of a cell side by side: its begin, a quarter, the half, three
// quarters. Where two cells meet, the feed holds if it does in one of them.
PSICARVE_FOR_WIDE_REGISTERS
void StretchPlanner::limit_speeds() {
    constexpr Vec kPlaces{0.0, 0.25, 0.5, 0.75};
    constexpr Vec kBeginAlone{1.0, 0.0, 0.0, 0.0};
    const std::size_t count = curve_.cells.size();
    for (std::size_t timing = 0; timing < kTimingCount; ++timing) {
        bound2_[timing].resize(count + 1);
        inner2_[timing].resize(count);
    }
    for (std::size_t i = 0; i <= count; ++i) {
        // The last cell's end as the begin of one more.
        const bool is_end = i == count;
        const PathCell& cell = curve_.cells[is_end ? i - 1 : i];
        const Lanes& begin = is_end ? cell.slope_end : cell.slope_begin;
        const Lanes& begin_at = is_end ? curve_.control.back() : curve_.cell_at[i];
        const Vec along = is_end ? Vec{} : kPlaces * cell.length;
        std::array<Four, kAxisCount> slope;
        Vec need{};
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            slope[k].axes = begin[k] + along * cell.bend[k];
            const Vec share = slope[k].axes * inverse_speed_[k];
            raise_to(need, Vec(share * share));
        }
        const Vec turn = slope[kPsi].axes * rad_per_pulse_;
        const Vec lift = slope[kY].axes * mm_per_pulse_[kY];
        Vec surface_speed2{};
        for (std::size_t head = 0; head < 2; ++head) {
            const bool is_fed = is_fed_[is_end ? i - 1 : i][head];
            if (!is_fed && (i == 0 || !is_fed_[i - 1][head])) continue;
            const Vec at = begin_at[head] + 0.5 * along * (begin[head] + slope[head].axes);
            const Vec around = (at * mm_per_pulse_[head] + limits_.tip_offset_mm[head]) * turn;
            const Vec out = slope[head].axes * mm_per_pulse_[head];
            Vec speed2 = around * around + out * out + lift * lift;
            if (!is_fed) speed2 *= kBeginAlone;
            raise_to(surface_speed2, speed2);
        }
        const Timings pace2 = least_pace2_of(is_end ? i - 1 : i);
        const Timings pace2_before = least_pace2_of(i > 0 ? i - 1 : 0);
        for (std::size_t timing = 0; timing < kTimingCount; ++timing) {
            Vec most = need;
            raise_to(most, Vec(surface_speed2 * inverse_feed2_[timing]));
            raise_to(most, Vec(Vec{} + pace2[timing]));
            raise_to(most, Vec(pace2_before[timing] * kBeginAlone));
            const Vec limit = most > 0.0 ? 1.0 / most : Vec{} + 1.0;
            bound2_[timing][i] = limit[0];
            if (!is_end) inner2_[timing][i] = {limit[1], limit[2], limit[3]};
        }
    }
}

void StretchPlanner::add_pieces(std::span<const PathPoint> points, std::vector<PathPiece>& pieces) {
    show_cells(curve_.cells, true);
    PieceMaker maker(limits_, points, curve_.nodes.point_at.front(), curve_.control.front(), pieces);
    for (std::size_t j = 0; j < curve_.cells.size(); ++j) {
        std::array<double, kTimingCount> begin2;
        std::array<double, kTimingCount> end2;
        for (std::size_t timing = 0; timing < kTimingCount; ++timing) {
            begin2[timing] = curve_.speed2[timing][j];
            end2[timing] = curve_.speed2[timing][j + 1];
        }
        maker.begin_cell(curve_.cells[j], curve_.cell_at[j], begin2, end2);
        const std::uint32_t point = curve_.nodes.point_at[j];
        const double before = j > 0 ? 0.5 * curve_.nodes.step[j - 1] : 0.0;
        if (point == CurveNodes::kNoPoint || j == 0) {
            maker.add(0.0, curve_.cells[j].length, PathPiece::kNoPoint);
        } else {
            maker.add(0.0, before, point);
            if (j + 1 < curve_.cells.size()) maker.add(before, curve_.cells[j].length, PathPiece::kNoPoint);
        }
    }
}

}  // namespace psicarve::plan
