// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/polyline_space.hpp"

#include <algorithm>
#include <cmath>

namespace psicarve::plan {
namespace {

// A curve that lags is nearest to a chord before its own, or to one after it if it leads.
constexpr std::size_t kChordsBeside = 8;

}  // namespace

PolylineSpace::PolylineSpace(const MachineLimits& limits, std::span<const PathPoint> points,
                             std::size_t span_at, const PathSpan& span, JudgedPlaces places)
    : points_(points), span_at_(span_at) {
    for (std::size_t head = 0; head < kHeads; ++head) {
        pulses_mm_[head] = space_pulses_mm(limits, span, head);
        allowed_mm_[head] = limits.path_tolerance_mm + rounding_mm(span, head, places);
    }
}

// Pulses may be one of the coarsest axis off, cuts only square to the chord, and half a pulse of each axis
// less, which is the DDA's.
double PolylineSpace::rounding_mm(const PathSpan& span, std::size_t head, JudgedPlaces places) const {
    const auto axes = space_axes(head);
    SpaceVector way{};
    double length2 = 0.0;
    for (std::size_t i = 0; i < kSpaceAxisCount; ++i) {
        way[i] = span.slope[axes[i]] * pulses_mm_[head][i];
        length2 += way[i] * way[i];
    }
    double half2 = 0.0;
    double most2 = 0.0;
    double pulse_mm = 0.0;
    for (std::size_t i = 0; i < kSpaceAxisCount; ++i) {
        if (!moves_beside(axes[i])) continue;
        const double along2 = length2 > 0.0 ? way[i] * way[i] / length2 : 0.0;
        const double across2 = pulses_mm_[head][i] * pulses_mm_[head][i] * (1.0 - along2);
        half2 += 0.25 * across2;
        most2 = std::max(most2, across2);
        pulse_mm = std::max(pulse_mm, pulses_mm_[head][i]);
    }
    return places == JudgedPlaces::cuts ? std::sqrt(most2) - std::sqrt(half2) : pulse_mm;
}

bool PolylineSpace::moves_beside(std::size_t axis) const {
    const std::size_t first = span_at_ > 0 ? span_at_ - 1 : 0;
    const std::size_t last = std::min(span_at_ + 2, points_.size() - 1);
    for (std::size_t i = first; i < last; ++i)
        if (points_[i].pulses[axis] != points_[i + 1].pulses[axis]) return true;
    return false;
}

double PolylineSpace::share_of_allowed(const Lanes& at, std::size_t head) const {
    const double allowed2 = allowed_mm_[head] * allowed_mm_[head];
    double least2 = off2_mm2(at, head, span_at_);
    for (std::size_t i = 1; i <= kChordsBeside && least2 > allowed2; ++i) {
        if (span_at_ >= i) least2 = std::min(least2, off2_mm2(at, head, span_at_ - i));
        if (span_at_ + i + 1 < points_.size()) least2 = std::min(least2, off2_mm2(at, head, span_at_ + i));
    }
    return std::sqrt(least2) / allowed_mm_[head];
}

/// From the nearest place of one chord.
double PolylineSpace::off2_mm2(const Lanes& at, std::size_t head, std::size_t chord) const {
    const auto axes = space_axes(head);
    SpaceVector way, off;
    double along = 0.0;
    double length2 = 0.0;
    for (std::size_t i = 0; i < kSpaceAxisCount; ++i) {
        const auto from = static_cast<double>(points_[chord].pulses[axes[i]]);
        const auto to = static_cast<double>(points_[chord + 1].pulses[axes[i]]);
        way[i] = (to - from) * pulses_mm_[head][i];
        off[i] = (at[axes[i]] - from) * pulses_mm_[head][i];
        along += off[i] * way[i];
        length2 += way[i] * way[i];
    }
    const double share = length2 > 0.0 ? std::clamp(along / length2, 0.0, 1.0) : 0.0;
    double off2 = 0.0;
    for (std::size_t i = 0; i < kSpaceAxisCount; ++i) {
        const double part = off[i] - share * way[i];
        off2 += part * part;
    }
    return off2;
}

}  // namespace psicarve::plan
