// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/path.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "rtcore/plan/program_tube.hpp"
#include "shared/base/units.hpp"

namespace psicarve::plan {
namespace {

// Over so many pulses the rounding of a span's ends hardly bends it.
constexpr double kRoughPulses = 8.0;
// Not quite half a pulse: the curve is to be rounded to the point, not beside it.
constexpr double kEndBandPulses = 0.45;
// The share of the tolerance that the table's own deviation may use up.
constexpr double kPsiShare = 0.25;
// Nor may it use up more of its own way: it is not to turn back.
constexpr double kTurnShare = 0.125;
// The tube is looked at in the nodes; between them the curve may go a little further.
constexpr double kTubeShare = 0.93;
constexpr double kBoundaryShare = 0.75;
// A turn that goes over more than so much of its room is an easy one.
constexpr double kSharpRoom = 2.0;
// A fitted turn is slower than the widest parabola that the tube has room for: (du/dt)^2 as a share of that
// one's.
constexpr double kFittedShare = 0.6;
// Of the turn's (du/dt)^2, a stop from which motors jump off with less costs more than its own surroundings.
constexpr double kLeastStopShare = 0.12;

// The tube is measured square to the chord in the plane x = r * dpsi, R. On a steep flank, moving along R
// hardly leaves the chord: the band of R is wider there, but never so wide that the curve could pass an end
// by more than the tolerance.
void set_bands(const MachineLimits& limits, const Pulses4& delta_pulses, PathSpan& span) {
    const double tolerance_mm = limits.path_tolerance_mm;
    const double rad_per_pulse = rad_from_pulses(1, limits.pulses_per_rev);
    const double largest_mm = std::max({span.radius_mm[0], span.radius_mm[1], tolerance_mm});
    const double turn_pulses = static_cast<double>(std::abs(delta_pulses[kPsi]));
    const double roughness = turn_pulses > kRoughPulses ? kRoughPulses / turn_pulses : 1.0;
    const double psi_pulse_mm = rad_per_pulse * largest_mm;
    const double psi_room_mm = std::min(kPsiShare * tolerance_mm, kTurnShare * turn_pulses * psi_pulse_mm);
    const double psi_band_mm = std::max(psi_room_mm, kLeastBandPulses * roughness * psi_pulse_mm);
    span.end_band.fill(kEndBandPulses);
    span.end_band[kPsi] = std::min(kEndBandPulses, psi_band_mm / psi_pulse_mm);
    span.begin_band = span.end_band;
    span.band[kPsi] = psi_band_mm / psi_pulse_mm;
    // Cut on the chord, all axes stand at one place of it, wherever the curve has each.
    const bool is_on_chord = heads_are_coarse(limits);
    const double y_band_pulses = tolerance_mm * limits.axes[kY].pulses_per_unit;
    span.band[kY] =
        limits.is_program && is_on_chord ? kLeastBandPulses : std::max(kLeastBandPulses, y_band_pulses);
    for (std::size_t head = 0; head < 2; ++head) {
        const double scale = limits.axes[head].pulses_per_unit;
        const double along_mm = std::abs(turn_pulses * rad_per_pulse * span.radius_mm[head]);
        const double rise_mm = static_cast<double>(std::abs(delta_pulses[head])) / scale;
        const double chord_mm = std::sqrt(along_mm * along_mm + rise_mm * rise_mm);
        // What psi takes of it, and the rounding of both where the way is cut.
        const double psi_used_mm = psi_band_mm + 0.5 * psi_pulse_mm;
        const double used_mm =
            chord_mm > 0.0 ? (psi_used_mm * rise_mm + 0.5 * along_mm / scale) / chord_mm : 0.0;
        const double share = rise_mm > along_mm ? kBoundaryShare : kTubeShare;
        const double left_mm = std::max(share * tolerance_mm - used_mm, kPsiShare * tolerance_mm);
        const double widened_mm = along_mm > 0.0 ? left_mm * chord_mm / along_mm : left_mm + rise_mm;
        const double band_mm = std::min(widened_mm, left_mm + 0.25 * rise_mm);
        span.band[head] = is_on_chord ? kLeastBandPulses : std::max(kLeastBandPulses, band_mm * scale);
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

/// Of u: what every axis has for both spans [1/s].
double accel_along(const MachineLimits& limits, const PathSpan& before, const PathSpan& after) {
    double accel = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        const double slope = std::max(std::abs(before.slope[k]), std::abs(after.slope[k]));
        if (slope > 0.0) accel = std::min(accel, limits.axes[k].accel_pps2 / slope);
    }
    return accel;
}

// A turn uses up the acceleration over all of its length and is passed at an even speed; a stop leaves it to
// the way on both sides: half the length takes length / 2v there, here (sqrt(v0^2 + a * length) - v0) / a.
bool stop_is_sooner(double accel, double length, double turn_speed2, double stop2) {
    const double gain = accel * length;
    return std::sqrt(stop2 + gain) - std::sqrt(stop2) <= 0.5 * gain / std::sqrt(kFittedShare * turn_speed2);
}

// A turn by K within a tube of half width w takes a length of 8w/K at most, since the parabola that touches
// both chords leaves them by K * length / 8. A turn that goes away when each of the three points moves within
// its own tube is but rounding: no need to stop for that.
PathCorner corner_between(const MachineLimits& limits, const PathSpan& before, const PathSpan& after) {
    const double room = 0.5 * (before.length + after.length);
    const double offset_per_turn = 0.5 * before.length * after.length / room;
    PathCorner corner{false, false, false, kSharpRoom * room};
    const bool rounds = rounds_corners(limits);
    double turn_speed2 = 1.0;
    double turn_length = room;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        const double turn = std::abs(after.slope[k] - before.slope[k]);
        const double band = std::min(before.band[k], after.band[k]);
        if (turn * room <= kLeastBandPulses) continue;
        const double end_band = std::min(before.end_band[k], after.begin_band[k]);
        const double width = rounds ? band + end_band : band;
        corner.radius = std::min(corner.radius, 4.0 * width / turn);
        const double rounding = 2.0 * end_band / offset_per_turn;
        if (turn <= rounding) continue;
        const double true_turn = turn - rounding;
        const double length = std::min(room, 8.0 * width / true_turn);
        const double speed2 = limits.axes[k].accel_pps2 * length / true_turn;
        if (speed2 >= turn_speed2) continue;
        turn_speed2 = speed2;
        turn_length = length;
    }
    const double stop2 = std::min(stop_speed2(limits, before.slope, &after.slope),
                                  stop_speed2(limits, after.slope, &before.slope));
    corner.is_sharp = corner.radius < kSharpRoom * room;
    corner.is_tight = corner.radius < room;
    corner.is_stop = turn_speed2 <= stop2 ||
                     (kLeastStopShare * turn_speed2 <= stop2 &&
                      stop_is_sooner(accel_along(limits, before, after), turn_length, turn_speed2, stop2));
    return corner;
}

// Along a spiral Y keeps to the straight lines between its points, over psi: what psi leaves its own by takes
// Y off its line by no more than the tolerance, either.
void keep_y_on_its_way(const MachineLimits& limits, std::span<PathSpan> spans) {
    const auto rises = [](const PathSpan& span) { return !span.is_link && span.slope[kY] != 0.0; };
    if (std::none_of(spans.begin(), spans.end(), rises)) return;
    const double tolerance_pulses = height_tolerance_pulses(limits);
    for (PathSpan& span : spans) {
        if (span.is_link) continue;
        span.band[kY] = kLeastBandPulses;
        const double rise = std::abs(span.slope[kY]);
        const double turn = std::abs(span.slope[kPsi]);
        if (rise * span.band[kPsi] > turn * tolerance_pulses)
            span.band[kPsi] = std::max(kLeastBandPulses, turn * tolerance_pulses / rise);
    }
}

// Whether an axis that has backlash turns round with this span, or begins to move and it is not known how it
// stands in its gap: that is crossed at rest.
bool crosses_gap(const MachineLimits& limits, const PathSpan& span, GapWays& ways) {
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

bool rounds_corners(const MachineLimits& limits) {
    return limits.is_program && !heads_are_coarse(limits);
}

// A millionth of a millimetre, for sums of decimal numbers are not exact.
double tips_need_mm(const cycle::SoftLimits& soft) {
    return soft.least_sum_mm + 0.5 * (soft.mm_per_pulse[0] + soft.mm_per_pulse[1]) - 1e-6;
}

double height_tolerance_pulses(const MachineLimits& limits) {
    return limits.path_tolerance_mm * limits.axes[kY].pulses_per_unit;
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
        PathSpan& span = spans.back();
        span.is_link = is_between_layers(points[i - 1], points[i]);
        for (std::size_t head = 0; head < 2; ++head) {
            span.is_outside[head] = !span.is_link && limits.outside.holds(head, points[i - 1].pulses[head],
                                                                          points[i].pulses[head]);
        }
    }
    if (!limits.is_program) keep_y_on_its_way(limits, spans);
    if (rounds_corners(limits)) set_program_tubes(limits, spans);
    return spans;
}

void note_gap_ways(const MachineLimits& limits, const Pulses4& from, const Pulses4& to, GapWays& ways) {
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        if (limits.tick.axes[k].backlash_pulses > 0 && from[k] != to[k]) ways[k] = from[k] < to[k] ? 1 : -1;
    }
}

std::vector<PathCorner> path_corners(const MachineLimits& limits, std::span<const PathSpan> spans,
                                     GapWays ways) {
    std::vector<PathCorner> corners;
    corners.reserve(spans.size());
    if (!spans.empty()) crosses_gap(limits, spans[0], ways);
    for (std::size_t i = 1; i < spans.size(); ++i) {
        corners.push_back(corner_between(limits, spans[i - 1], spans[i]));
        if (crosses_gap(limits, spans[i], ways)) corners.back().is_stop = true;
    }
    return corners;
}

}  // namespace psicarve::plan
