// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rtcore/plan/machine_limits.hpp"

namespace psicarve::plan {

/// One number for each axis.
using Lanes = std::array<double, kAxisCount>;

/// Rounding to whole pulses moves a point by this much; less of a tube would force the steps of the rounding
/// upon the motors.
inline constexpr double kLeastBandPulses = 0.5;

/// The table turning back by less is lost in the rounding of the cuts.
inline constexpr double kMostTurnPulses = 0.5;

/// A position that the machine passes: exactly in a job, in a program within its tolerance. The ends of a
/// path are always met exactly.
struct PathPoint {
    Pulses4 pulses;
    std::uint32_t layer;  ///< of the job; one for all rows of a spiral
    std::uint32_t point;
    bool is_on_the_way;  ///< between two layers: not a point of the table
};

constexpr bool is_between_layers(const PathPoint& from, const PathPoint& to) noexcept {
    return from.layer != to.layer || from.is_on_the_way || to.is_on_the_way;
}

/// The straight way between two neighbouring points, and the tube around it.
///
///     path parameter u of the span:  length = sqrt(sum (d_k / v_k)^2)  [s]
///
/// so that du/dt = 1 is about as fast as the motors turn.
struct PathSpan {
    double length;                    ///< > 0 [s]
    Lanes slope;                      ///< of the chord [pulses / s of u]
    Lanes band;                       ///< how far the curve may leave the chord [pulses]
    Lanes begin_band;                 ///< and how far its begin [pulses]
    Lanes end_band;                   ///< and its end
    std::array<double, 2> radius_mm;  ///< by head: of the tip, at the larger end
    bool is_link;                     ///< between two layers: heads never further in than its ends
    std::array<bool, 2> is_outside;   ///< by head: all along it clear of the blank, so without a feed
    /// (dt/du)^2 is nowhere less: a program's feed, at 100 % and at twice that. 0: as fast as the axes can
    std::array<double, 2> least_pace2{};
};

/// A turn of the polyline at a point.
struct PathCorner {
    bool is_stop;   ///< the tube is so tight that coming to rest is faster
    bool is_tight;  ///< the tube lets the curve turn over a part of the spans only
    bool is_sharp;  ///< or over twice that at most
    double radius;  ///< half the length over which the tube lets the curve turn, at most so, in u [s]
};

/// By head: where its tip is at the larger of two radii.
std::array<double, 2> greatest_radii_mm(const MachineLimits& limits, const Pulses4& from, const Pulses4& to);
/// Whether a head's pulse is coarser than the tolerance: then spans are cut on their chords, as rounding the
/// curve could leave them by more than the tolerance and a pulse.
bool heads_are_coarse(const MachineLimits& limits);
/// Whether points between rests are passed within the tolerance: in programs, if the heads' pulses are finer.
bool rounds_corners(const MachineLimits& limits);
/// The sum of both heads' positions that every cut of a program keeps, where its points do: so that between
/// two cuts, too, the tips have their clearance [mm].
double tips_need_mm(const cycle::SoftLimits& soft);
/// How far Y may leave its straight way over psi along a spiral [pulses].
double height_tolerance_pulses(const MachineLimits& limits);
/// Whether a span is cut where the curve has the table: where the table's pulses are coarser than the
/// tolerance, rounding the curve could leave the chord by more than the tolerance and a pulse; rounding the
/// chord does not.
bool cuts_follow_table(const MachineLimits& limits, const std::array<double, 2>& radius_mm);

/// How fast one may leave or reach a stop, as the square of du/dt along a way of this slope: every axis
/// within its start-stop speed, or half of that where it turns back against `across`.
double stop_speed2(const MachineLimits& limits, const Lanes& slope, const Lanes* across);

/// Tube and parameter of every way between neighbouring points (points.size() - 1 of them). Requires
/// neighbours that differ.
std::vector<PathSpan> path_spans(const MachineLimits& limits, std::span<const PathPoint> points);
/// Which way each axis that has backlash went last; 0: not known.
using GapWays = std::array<int, kAxisCount>;
/// What they are after a straight way between these points.
void note_gap_ways(const MachineLimits& limits, const Pulses4& from, const Pulses4& to, GapWays& ways);
/// One for each inner point: corners[i] lies between spans[i] and spans[i + 1]. `ways`: before the first
/// span.
std::vector<PathCorner> path_corners(const MachineLimits& limits, std::span<const PathSpan> spans,
                                     GapWays ways = {});

}  // namespace psicarve::plan
