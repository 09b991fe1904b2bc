// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/path.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "shared/units.hpp"

namespace psicarve::plan {
namespace {

// Over so many pulses the rounding of a span's ends hardly bends it.
constexpr double kRoughPulses = 8.0;
// Not quite half a pulse: the curve is to be rounded to the point, not beside it.
constexpr double kEndBandPulses = 0.45;
// The share of the tolerance that the table's own deviation may use up.
constexpr double kPsiShare = 0.25;
// The tube is looked at in the nodes; between them the curve may go a little further.
constexpr double kTubeShare = 0.93;
constexpr double kFlankShare = 0.75;

constexpr std::size_t kPsi = index_of(Axis::psi);
constexpr std::size_t kY = index_of(Axis::y);

// The tube is measured square to the chord in the plane x = r * dpsi, R. On a steep flank, moving along R
// hardly leaves the chord: the band of R is wider there, but never so wide that the curve could pass an end
// by more than the tolerance.
void set_bands(const MachineLimits& limits, const Pulses4& delta_pulses, PathSpan& span) {
    const double tolerance_mm = limits.path_tolerance_mm;
    const double rad_per_pulse = rad_from_pulses(1, limits.pulses_per_rev);
    const double largest_mm = std::max({span.radius_mm[0], span.radius_mm[1], tolerance_mm});
    const double turn_pulses = static_cast<double>(std::abs(delta_pulses[kPsi]));
    const double roughness = turn_pulses > kRoughPulses ? kRoughPulses / turn_pulses : 1.0;
    const double psi_band_mm =
        std::max(kPsiShare * tolerance_mm, kLeastBandPulses * roughness * rad_per_pulse * largest_mm);
    span.end_band.fill(kEndBandPulses);
    span.end_band[kPsi] = std::min(kEndBandPulses, psi_band_mm / (rad_per_pulse * largest_mm));
    span.band[kPsi] = psi_band_mm / (rad_per_pulse * largest_mm);
    span.band[kY] = std::max(kLeastBandPulses, tolerance_mm * limits.axes[kY].pulses_per_unit);
    for (std::size_t head = 0; head < 2; ++head) {
        const double scale = limits.axes[head].pulses_per_unit;
        const double along_mm =
            static_cast<double>(std::abs(delta_pulses[kPsi])) * rad_per_pulse * span.radius_mm[head];
        const double rise_mm = static_cast<double>(std::abs(delta_pulses[head])) / scale;
        const double chord_mm = std::sqrt(along_mm * along_mm + rise_mm * rise_mm);
        // What psi takes of it, and the rounding of both where the way is cut.
        const double psi_used_mm = psi_band_mm + 0.5 * rad_per_pulse * largest_mm;
        const double used_mm =
            chord_mm > 0.0 ? (psi_used_mm * rise_mm + 0.5 * along_mm / scale) / chord_mm : 0.0;
        const double share = rise_mm > along_mm ? kFlankShare : kTubeShare;
        const double left_mm = std::max(share * tolerance_mm - used_mm, kPsiShare * tolerance_mm);
        const double widened_mm = along_mm > 0.0 ? left_mm * chord_mm / along_mm : left_mm + rise_mm;
        const double band_mm = std::min(widened_mm, left_mm + 0.25 * rise_mm);
        span.band[head] = std::max(kLeastBandPulses, band_mm * scale);
    }
    // An axis with backlash must not turn back between two points, not even to take a run-up: it gets no room
    // for that.
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        if (limits.tick.axes[k].backlash_pulses > 0) span.band[k] = std::min(span.band[k], kLeastBandPulses);
    }
}

PathSpan span_between(const MachineLimits& limits, const Pulses4& from, const Pulses4& to) {
    PathSpan span{};
    Pulses4 delta_pulses;
    double length2 = 0.0;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        delta_pulses[k] = to[k] - from[k];
        const double seconds = static_cast<double>(delta_pulses[k]) / limits.axes[k].speed_pps;
        length2 += seconds * seconds;
    }
    span.length = std::sqrt(length2);
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        span.slope[k] = static_cast<double>(delta_pulses[k]) / span.length;
    }
    span.radius_mm = greatest_radii_mm(limits, from, to);
    set_bands(limits, delta_pulses, span);
    return span;
}

// A turn by K within a tube of half width w takes a length of 8w/K at most, since the parabola that touches
// both chords leaves them by K * length / 8.
PathCorner corner_between(const MachineLimits& limits, const PathSpan& before, const PathSpan& after) {
    const double room = 0.5 * (before.length + after.length);
    PathCorner corner{false, false, room};
    double turn_speed2 = 1.0;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        const double turn = std::abs(after.slope[k] - before.slope[k]);
        const double band = std::min(before.band[k], after.band[k]);
        if (turn * room <= kLeastBandPulses) continue;
        corner.radius = std::min(corner.radius, 4.0 * band / turn);
        const double length = std::min(room, 8.0 * band / turn);
        turn_speed2 = std::min(turn_speed2, limits.axes[k].accel_pps2 * length / turn);
    }
    const double stop2 = std::min(stop_speed2(limits, before.slope, &after.slope),
                                  stop_speed2(limits, after.slope, &before.slope));
    corner.is_stop = turn_speed2 <= stop2;
    corner.is_tight = corner.radius < room;
    return corner;
}

// Along a spiral Y keeps to the straight lines between its points.
void keep_y_on_its_way(std::span<PathSpan> spans) {
    const auto rises = [](const PathSpan& span) { return !span.is_link && span.slope[kY] != 0.0; };
    if (std::none_of(spans.begin(), spans.end(), rises)) return;
    for (PathSpan& span : spans) {
        if (!span.is_link) span.band[kY] = kLeastBandPulses;
    }
}

/// Which way each axis that has backlash went last; 0: not known.
using Ways = std::array<int, kAxisCount>;

// Whether an axis that has backlash turns round with this span: the gap is crossed at rest.
bool crosses_gap(const MachineLimits& limits, const PathSpan& span, Ways& ways) {
    bool crosses = false;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        if (limits.tick.axes[k].backlash_pulses == 0 || span.slope[k] == 0.0) continue;
        const int way = span.slope[k] > 0.0 ? 1 : -1;
        crosses = crosses || ways[k] != way;
        ways[k] = way;
    }
    return crosses;
}

}  // namespace

std::array<double, 2> greatest_radii_mm(const MachineLimits& limits, const Pulses4& from, const Pulses4& to) {
    std::array<double, 2> radii_mm{};
    for (std::size_t head = 0; head < 2; ++head) {
        radii_mm[head] = mm_from_pulses(std::max(from[head], to[head]), limits.axes[head].pulses_per_unit) +
                         limits.tip_offset_mm[head];
    }
    return radii_mm;
}

bool heads_are_coarse(const MachineLimits& limits) {
    const double pulses_per_mm = std::min(limits.axes[0].pulses_per_unit, limits.axes[1].pulses_per_unit);
    return limits.path_tolerance_mm * pulses_per_mm < 1.0;
}

bool cuts_follow_table(const MachineLimits& limits, const std::array<double, 2>& radius_mm) {
    return std::max(radius_mm[0], radius_mm[1]) * rad_from_pulses(1, limits.pulses_per_rev) <
           limits.path_tolerance_mm;
}

double stop_speed2(const MachineLimits& limits, const Lanes& slope, const Lanes* across) {
    double speed2 = 1.0;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        if (slope[k] == 0.0) continue;
        const bool turns_back = across != nullptr && slope[k] * (*across)[k] < 0.0;
        const double jump_pps = limits.axes[k].start_stop_pps * (turns_back ? 0.5 : 1.0);
        const double speed = jump_pps / std::abs(slope[k]);
        speed2 = std::min(speed2, speed * speed);
    }
    return speed2;
}

std::vector<PathSpan> path_spans(const MachineLimits& limits, std::span<const PathPoint> points) {
    std::vector<PathSpan> spans;
    spans.reserve(points.size());
    for (std::size_t i = 1; i < points.size(); ++i) {
        spans.push_back(span_between(limits, points[i - 1].pulses, points[i].pulses));
        spans.back().is_link = is_between_layers(points[i - 1], points[i]);
    }
    keep_y_on_its_way(spans);
    return spans;
}

std::vector<PathCorner> path_corners(const MachineLimits& limits, std::span<const PathSpan> spans) {
    std::vector<PathCorner> corners;
    corners.reserve(spans.size());
    Ways ways{};
    if (!spans.empty()) crosses_gap(limits, spans[0], ways);
    for (std::size_t i = 1; i < spans.size(); ++i) {
        corners.push_back(corner_between(limits, spans[i - 1], spans[i]));
        if (crosses_gap(limits, spans[i], ways)) corners.back().is_stop = true;
    }
    return corners;
}

}  // namespace psicarve::plan
