// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/curve_nodes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace psicarve::plan {
namespace {

// Steps double away from a tight corner; so many reach from 1/8192 of half a span to its middle.
constexpr std::size_t kMostNodesToTheMiddle = 14;
// Where a tight corner is, this many steps make up each half of the turn.
constexpr double kStepsInATurn = 2.0;
// Where speeds change much within a span: cells so short that they are known everywhere.
constexpr std::size_t kPartsOfALongSpan = 8;
constexpr double kLongSpan_s = 0.03;
constexpr std::size_t kHeads = 2;
// Past a span's end, as a share of the tolerance: between nodes it may be a little more.
constexpr double kBeyondShare = 0.75;
// Beyond both ends of a span by so little that no pulse comes of it.
constexpr double kLeastBeyondPulses = 0.25;

/// Distances from a span's end to its nodes before the middle.
struct Grading {
    std::array<double, kMostNodesToTheMiddle> at{};
    std::size_t count = 0;
};

Grading graded(double radius, double half) {
    Grading grading;
    double step = std::max(radius / kStepsInATurn, half / 8192.0);
    double at = step;
    for (bool is_first = true; at < 0.75 * half && grading.count < kMostNodesToTheMiddle; is_first = false) {
        grading.at[grading.count++] = at;
        if (!is_first) step *= 2.0;
        at += step;
    }
    return grading;
}

class NodeMaker {
public:
    NodeMaker(const MachineLimits& limits, std::span<const PathPoint> points, std::span<const PathSpan> spans)
        : limits_(limits), points_(points), spans_(spans) {}

    void add_point(std::size_t point, bool is_end) {
        Lanes low;
        Lanes high;
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            const auto at = static_cast<double>(points_[point].pulses[k]);
            const double band =
                is_end ? 0.0 : std::min(spans_[point - 1].end_band[k], spans_[point].end_band[k]);
            low[k] = std::max(at - band, least(k, at));
            high[k] = at + band;
        }
        add(low, high, point, static_cast<std::uint32_t>(point));
    }

    /// The nodes between a span's ends: graded towards both, nowhere further apart than `most`.
    void add_way(std::size_t span, const Grading& from, const Grading& to, double most) {
        const double length = spans_[span].length;
        const double half = 0.5 * length;
        for (std::size_t i = 0; i < from.count; ++i) add_up_to(span, from.at[i], most);
        add_up_to(span, half, most);
        for (std::size_t i = to.count; i-- > 0;) add_up_to(span, length - to.at[i], most);
        const double last = to.count > 0 ? length - to.at[0] : half;
        const auto rest = static_cast<std::size_t>(std::max(1.0, std::ceil((length - last) / most * 0.999)));
        for (std::size_t i = 1; i < rest; ++i) {
            add_between(span, last + (length - last) * (static_cast<double>(i) / static_cast<double>(rest)));
        }
    }
    void add_up_to(std::size_t span, double at, double most) {
        const double begin = last_at_;
        const auto count = static_cast<std::size_t>(std::max(1.0, std::ceil((at - begin) / most * 0.999)));
        for (std::size_t i = 1; i <= count; ++i) {
            add_between(span, begin + (at - begin) * (static_cast<double>(i) / static_cast<double>(count)));
        }
    }

    void add_between(std::size_t span, double at) {
        const PathSpan& way = spans_[span];
        Lanes low;
        Lanes high;
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            const auto from = static_cast<double>(points_[span].pulses[k]);
            const auto to = static_cast<double>(points_[span + 1].pulses[k]);
            const double chord = from + way.slope[k] * at;
            const double beyond = tolerance_pulses(k);
            low[k] = std::max({chord - way.band[k], std::min(from, to) - beyond, least(k, chord)});
            high[k] = std::min(chord + way.band[k], std::max(from, to) + beyond);
            if (!way.is_link || k == index_of(Axis::psi)) continue;
            // Between layers a head, or Y, that dips past an end stands deeper than the layer it is in asks.
            low[k] = std::max(low[k], std::min(from, to) - kLeastBeyondPulses);
            if (k >= kHeads) high[k] = std::min(high[k], std::max(from, to) + kLeastBeyondPulses);
        }
        add(low, high, span, CurveNodes::kNoPoint);
        nodes_.step[nodes_.step.size() - 2] = at - last_at_;
        last_at_ = at;
    }
    void end_span(double length) {
        nodes_.step[nodes_.step.size() - 2] = length - last_at_;
        last_at_ = 0.0;
    }
    CurveNodes&& take() {
        lay_out_cells();
        return std::move(nodes_);
    }

private:
    // A head never goes further in than the core, nor deeper than the chord where the tips are close.
    double least(std::size_t axis, double chord) const {
        if (axis >= kHeads) return chord - 1e9;
        return std::min(chord, limits_.least_radius_pulses[axis]);
    }
    // With backlash there is no run-up against the way: every turn would have to cross the gap.
    double tolerance_pulses(std::size_t axis) const {
        if (limits_.tick.axes[axis].backlash_pulses > 0) return kLeastBeyondPulses;
        if (axis == index_of(Axis::psi)) return kMostTurnPulses;
        return std::max(1.0, kBeyondShare * limits_.path_tolerance_mm * limits_.axes[axis].pulses_per_unit);
    }
    void add(const Lanes& low, const Lanes& high, std::size_t span, std::uint32_t point) {
        nodes_.low.push_back(low);
        nodes_.high.push_back(high);
        nodes_.step.push_back(0.0);
        nodes_.span_at.push_back(static_cast<std::uint32_t>(span));
        nodes_.point_at.push_back(point);
    }

    void lay_out_cells() {
        const std::size_t last = nodes_.step.size() - 1;
        double before = 0.0;
        for (std::size_t j = 0; j <= last; ++j) {
            const double after = j < last ? 0.5 * nodes_.step[j] : 0.0;
            nodes_.cell.push_back(before + after);
            nodes_.offset.push_back(j > 0 && j < last ? 0.5 * (before - after) : 0.0);
            before = after;
        }
        for (std::size_t j = 0; j < last; ++j) {
            nodes_.control_step.push_back(nodes_.step[j] + nodes_.offset[j] - nodes_.offset[j + 1]);
        }
        nodes_.control_step.push_back(0.0);
    }

    const MachineLimits& limits_;
    std::span<const PathPoint> points_;
    std::span<const PathSpan> spans_;
    CurveNodes nodes_;
    double last_at_ = 0.0;
};

}  // namespace

CurveNodes curve_nodes(const MachineLimits& limits, std::span<const PathPoint> points,
                       std::span<const PathSpan> spans, std::span<const PathCorner> corners,
                       std::size_t first, std::size_t last) {
    NodeMaker maker(limits, points, spans);
    maker.add_point(first, true);
    for (std::size_t span = first; span < last; ++span) {
        const double length = spans[span].length;
        const double half = 0.5 * length;
        const Grading from =
            span == first || !corners[span - 1].is_tight ? Grading{} : graded(corners[span - 1].radius, half);
        const Grading to =
            span + 1 == last || !corners[span].is_tight ? Grading{} : graded(corners[span].radius, half);
        const std::size_t parts = length > kLongSpan_s || spans[span].is_link ? kPartsOfALongSpan : 2;
        maker.add_way(span, from, to, length / static_cast<double>(parts));
        maker.add_point(span + 1, span + 1 == last);
        maker.end_span(length);
    }
    return maker.take();
}

}  // namespace psicarve::plan
