// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/curve_nodes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace psicarve::plan {
namespace {

// Steps double away from a tight corner; so many reach from 1/8192 of half a span to its middle.
constexpr std::size_t kMostNodesToTheMiddle = 14;
// Where a tight corner is, this many steps make up each half of the turn.
constexpr double kStepsInATurn = 2.0;
// Where a turn takes all the room that it has, it is to bend evenly. Steps of a third of a span at most, one
// of which ends in its middle, make four of them.
constexpr std::size_t kPartsAtASharpCorner = 3;
// Where speeds change much within a span: cells so short that they are known everywhere.
constexpr std::size_t kPartsOfALongSpan = 8;
constexpr double kLongSpan_s = 0.03;
// Where points are as dense as that, the curve needs nodes in them alone.
constexpr double kShortSpan_s = 0.001;
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

/// Where a curve may be between the ends of one span after the other.
class SpanBounds {
public:
    SpanBounds(const MachineLimits& limits, std::span<const PathPoint> points,
               std::span<const PathSpan> spans)
        : points_(points),
          spans_(spans),
          soft_(limits.is_program ? &limits.tick.soft_limits : nullptr),
          rounds_corners_(rounds_corners(limits)) {
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            // A head never goes further in than the core, nor deeper than the chord where the tips are close.
            least_[k] = k < kHeads ? limits.least_radius_pulses[k] : -kNone;
            tolerance_[k] = tolerance_pulses(limits, k);
        }
    }

    void begin_span(std::size_t span) {
        way_ = &spans_[span];
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            const auto from = static_cast<double>(points_[span].pulses[k]);
            const auto to = static_cast<double>(points_[span + 1].pulses[k]);
            from_[k] = from;
            lowest_[k] = std::min(from, to) - tolerance_[k];
            highest_[k] = std::max(from, to) + tolerance_[k];
            if (!way_->is_link || k == index_of(Axis::psi)) continue;
            // Between layers a head, or Y, that dips past an end stands deeper than the layer it is in asks.
            lowest_[k] = std::max(lowest_[k], std::min(from, to) - kLeastBeyondPulses);
            if (k >= kHeads) highest_[k] = std::min(highest_[k], std::max(from, to) + kLeastBeyondPulses);
        }
        if (soft_ != nullptr) keep_soft_limits(points_[span].pulses, points_[span + 1].pulses);
    }
    void at_point(std::size_t point, bool is_end, Lanes& low, Lanes& high) const {
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            const auto at = static_cast<double>(points_[point].pulses[k]);
            const double band = is_end ? 0.0 : band_at(point, k);
            low[k] = std::max(at - band, std::min(at, least_[k]));
            high[k] = at + band;
            if (soft_ == nullptr) continue;
            low[k] = std::max(low[k], std::min(at, static_cast<double>(soft_->least_pulses[k])));
            high[k] = std::min(high[k], std::max(at, static_cast<double>(soft_->most_pulses[k])));
        }
        if (soft_ != nullptr) {
            const Pulses4& at = points_[point].pulses;
            keep_tips_apart(static_cast<double>(at[0]), static_cast<double>(at[1]), low);
        }
    }
    void on_the_way(double along, Lanes& low, Lanes& high) const {
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            const double chord = from_[k] + way_->slope[k] * along;
            low[k] = std::max({chord - way_->band[k], lowest_[k], std::min(chord, least_[k])});
            high[k] = std::min(chord + way_->band[k], highest_[k]);
        }
        if (soft_ != nullptr)
            keep_tips_apart(from_[0] + way_->slope[0] * along, from_[1] + way_->slope[1] * along, low);
    }

private:
    static constexpr double kNone = 1e300;

    double band_at(std::size_t point, std::size_t axis) const {
        const PathSpan &before = spans_[point - 1], &after = spans_[point];
        return std::min({before.end_band[axis], after.begin_band[axis], before.band[axis], after.band[axis]});
    }
    // With backlash there is no run-up against the way: every turn would have to cross the gap.
    double tolerance_pulses(const MachineLimits& limits, std::size_t axis) const {
        if (limits.tick.axes[axis].backlash_pulses > 0) return kLeastBeyondPulses;
        if (rounds_corners_) return kNone;
        if (axis == index_of(Axis::psi)) return kMostTurnPulses;
        return std::max(1.0, kBeyondShare * limits.path_tolerance_mm * limits.axes[axis].pulses_per_unit);
    }

    // Programs are checked in their points alone: beyond them the curve keeps to the travel.
    void keep_soft_limits(const Pulses4& from, const Pulses4& to) {
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            const auto low = static_cast<double>(std::min(from[k], to[k]));
            const auto high = static_cast<double>(std::max(from[k], to[k]));
            lowest_[k] = std::max(lowest_[k], std::min(low, static_cast<double>(soft_->least_pulses[k])));
            highest_[k] = std::min(highest_[k], std::max(high, static_cast<double>(soft_->most_pulses[k])));
        }
    }
    // Heads leave each other what room they have where they are.
    void keep_tips_apart(double first_pulses, double second_pulses, Lanes& low) const {
        const double sum_mm = soft_->mm_per_pulse[0] * first_pulses + soft_->mm_per_pulse[1] * second_pulses;
        const double room_mm = 0.5 * std::max(sum_mm - tips_need_mm(*soft_), 0.0);
        for (std::size_t k = 0; k < kHeads; ++k) {
            const double room_pulses = std::max(room_mm / soft_->mm_per_pulse[k], kLeastBeyondPulses);
            low[k] = std::max(low[k], (k == 0 ? first_pulses : second_pulses) - room_pulses);
        }
    }

    std::span<const PathPoint> points_;
    std::span<const PathSpan> spans_;
    const cycle::SoftLimits* soft_;  ///< null: a table's points are checked with what the curve may add
    bool rounds_corners_;
    Lanes least_{};
    Lanes tolerance_{};
    const PathSpan* way_ = nullptr;
    Lanes from_{}, lowest_{}, highest_{};
};

class NodeMaker {
public:
    NodeMaker(const MachineLimits& limits, std::span<const PathPoint> points, std::span<const PathSpan> spans,
              CurveNodes&& memory)
        : spans_(spans), bounds_(limits, points, spans), nodes_(std::move(memory)) {
        for (auto* lanes : {&nodes_.low, &nodes_.high}) lanes->clear();
        for (auto* places : {&nodes_.span_at, &nodes_.point_at}) places->clear();
        nodes_.step.clear();
    }

    void add_point(std::size_t point, bool is_end) {
        bounds_.at_point(point, is_end, nodes_.low.emplace_back(), nodes_.high.emplace_back());
        nodes_.step.push_back(0.0);
        nodes_.span_at.push_back(static_cast<std::uint32_t>(point));
        nodes_.point_at.push_back(static_cast<std::uint32_t>(point));
    }
    void begin_span(std::size_t span) {
        span_ = static_cast<std::uint32_t>(span);
        last_at_ = 0.0;
        bounds_.begin_span(span);
    }
    /// The nodes between a span's ends: graded towards both, nowhere further apart than `most`.
    void add_way(const Grading& from, const Grading& to, double most) {
        const double length = spans_[span_].length;
        const double half = 0.5 * length;
        for (std::size_t i = 0; i < from.count; ++i) add_up_to(from.at[i], most);
        add_up_to(half, most);
        for (std::size_t i = to.count; i-- > 0;) add_up_to(length - to.at[i], most);
        const double last = to.count > 0 ? length - to.at[0] : half;
        const auto rest = static_cast<std::size_t>(std::max(1.0, std::ceil((length - last) / most * 0.999)));
        for (std::size_t i = 1; i < rest; ++i) {
            add_between(last + (length - last) * (static_cast<double>(i) / static_cast<double>(rest)));
        }
    }
    void end_span() { nodes_.step.back() = spans_[span_].length - last_at_; }

    CurveNodes&& take() {
        lay_out_cells();
        return std::move(nodes_);
    }

private:
    void add_up_to(double at, double most) {
        const double begin = last_at_;
        const auto count = static_cast<std::size_t>(std::max(1.0, std::ceil((at - begin) / most * 0.999)));
        for (std::size_t i = 1; i <= count; ++i) {
            add_between(begin + (at - begin) * (static_cast<double>(i) / static_cast<double>(count)));
        }
    }
    void add_between(double at) {
        nodes_.step.back() = at - last_at_;
        last_at_ = at;
        bounds_.on_the_way(at, nodes_.low.emplace_back(), nodes_.high.emplace_back());
        nodes_.step.push_back(0.0);
        nodes_.span_at.push_back(span_);
        nodes_.point_at.push_back(CurveNodes::kNoPoint);
    }

    void lay_out_cells() {
        const std::size_t last = nodes_.step.size() - 1;
        nodes_.cell.resize(last + 1);
        nodes_.offset.resize(last + 1);
        nodes_.control_step.resize(last + 1);
        nodes_.weight.assign(last + 1, Lanes{1.0, 1.0, 1.0, 1.0});
        double before = 0.0;
        for (std::size_t j = 0; j <= last; ++j) {
            const double after = j < last ? 0.5 * nodes_.step[j] : 0.0;
            nodes_.cell[j] = before + after;
            nodes_.offset[j] = j > 0 && j < last ? 0.5 * (before - after) : 0.0;
            before = after;
        }
        for (std::size_t j = 0; j < last; ++j) {
            nodes_.control_step[j] = nodes_.step[j] + nodes_.offset[j] - nodes_.offset[j + 1];
        }
        nodes_.control_step[last] = 0.0;
    }

    std::span<const PathSpan> spans_;
    SpanBounds bounds_;
    CurveNodes nodes_;
    std::uint32_t span_ = 0;
    double last_at_ = 0.0;
};

}  // namespace

CurveNodes curve_nodes(const MachineLimits& limits, std::span<const PathPoint> points,
                       std::span<const PathSpan> spans, std::span<const PathCorner> corners,
                       std::size_t first, std::size_t last, CurveNodes memory) {
    NodeMaker maker(limits, points, spans, std::move(memory));
    maker.add_point(first, true);
    for (std::size_t span = first; span < last; ++span) {
        const double length = spans[span].length;
        const double half = 0.5 * length;
        const Grading from =
            span == first || !corners[span - 1].is_tight ? Grading{} : graded(corners[span - 1].radius, half);
        const Grading to =
            span + 1 == last || !corners[span].is_tight ? Grading{} : graded(corners[span].radius, half);
        const bool is_sharp =
            (span > first && corners[span - 1].is_sharp) || (span + 1 < last && corners[span].is_sharp);
        const bool is_long = length > kLongSpan_s || spans[span].is_link;
        const std::size_t parts = is_long ? kPartsOfALongSpan : is_sharp ? kPartsAtASharpCorner : 2;
        maker.begin_span(span);
        const bool is_plain = !spans[span].is_link && from.count + to.count == 0;
        if (length > kShortSpan_s || !is_plain) maker.add_way(from, to, length / static_cast<double>(parts));
        maker.end_span();
        maker.add_point(span + 1, span + 1 == last);
    }
    return maker.take();
}

void bind_again(const MachineLimits& limits, std::span<const PathPoint> points,
                std::span<const PathSpan> spans, std::size_t node, CurveNodes& nodes) {
    SpanBounds bounds(limits, points, spans);
    bounds.begin_span(nodes.span_at[node]);
    double along = 0.0;
    for (std::size_t j = node + 1; nodes.point_at[j] == CurveNodes::kNoPoint; ++j) {
        along += nodes.step[j - 1];
        bounds.on_the_way(along, nodes.low[j], nodes.high[j]);
    }
    if (!rounds_corners(limits)) return;
    std::size_t end = node + 1;
    while (nodes.point_at[end] == CurveNodes::kNoPoint) ++end;
    for (const std::size_t j : {node, end}) {
        const bool is_end = j == 0 || j + 1 == nodes.point_at.size();
        bounds.at_point(nodes.point_at[j], is_end, nodes.low[j], nodes.high[j]);
    }
}

}  // namespace psicarve::plan
