// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/program/path_sketch.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hmi/gcode/arc_chords.hpp"

namespace psicarve::program {
namespace {

using gcode::CanonKind;
using gcode::CanonRecord;

constexpr double kMmPerDeg = 0.5;  // at the radius of a hand's breadth
constexpr double kChord_mm = 0.05;
constexpr std::uint64_t kMostChords = 4096;  // of one arc, however many turns it has
constexpr double kFirstTolerance_mm = 0.001;
constexpr double kSamePlace_mm = 1e-6;
constexpr int kMostDoublings = 100;

double distance_mm(const SketchPoint& a, const SketchPoint& b) noexcept {
    double most = 0.0;
    for (const Axis axis : kAllAxes) {
        const double along = std::abs(a.place[index_of(axis)] - b.place[index_of(axis)]);
        most = std::max(most, axis == Axis::psi ? kMmPerDeg * along : along);
    }
    return most;
}

}  // namespace

std::array<double, kAxisCount> PathSketch::place_of(const gcode::Position& position) const noexcept {
    std::array<double, kAxisCount> place{};
    for (const Axis axis : kAllAxes) place[index_of(axis)] = position[letters_.letter_of(axis)];
    return place;
}

std::uint8_t PathSketch::placed_of(gcode::AxisMask placed) const noexcept {
    unsigned bits = 0;
    for (const Axis axis : kAllAxes) {
        if ((placed & letters_.mask_of_axis(axis)) != 0) bits |= 1U << index_of(axis);
    }
    return static_cast<std::uint8_t>(bits);
}

void PathSketch::take(const CanonRecord& record) {
    const bool is_arc = record.kind == CanonKind::arc;
    if (record.kind != CanonKind::rapid && record.kind != CanonKind::feed && !is_arc) return;
    const std::uint8_t placed = placed_of(record.placed & record.start_placed);
    SketchPoint point{{}, record.line, record.line, placed, record.kind == CanonKind::rapid};
    begin_at(place_of(record.start), record.line);
    if (is_arc) {
        const gcode::ArcChords chords{record, kChord_mm};
        const std::uint64_t step = chords.count() / kMostChords + 1;
        for (std::uint64_t chord = step; chord < chords.count(); chord += step) {
            point.place = place_of(chords.end_of(chord));
            add(point);
        }
    }
    point.place = place_of(record.end);
    add(point);
}

/// What a wrong block was to do is not known: behind it the path begins anew.
void PathSketch::begin_at(const std::array<double, kAxisCount>& place, std::uint64_t line) {
    const SketchPoint begin{place, line, line, 0, true};
    if (points_.empty()) return points_.push_back(begin);
    if (distance_mm(points_.back(), begin) > kSamePlace_mm) add(begin);
}

void PathSketch::add(const SketchPoint& point) {
    put(point);
    if (points_.size() > kMostPoints) thin();
}

/// The last point is where the program has come; those before it stand.
void PathSketch::put(const SketchPoint& point) {
    if (points_.size() > 1) {
        SketchPoint& last = points_.back();
        if (distance_mm(points_[points_.size() - 2], last) <= tolerance_mm_) {
            // Too near to stand for itself: it becomes part of the way to the next one.
            SketchPoint both = point;
            both.first_line = std::min(last.first_line, point.first_line);
            both.last_line = std::max(last.last_line, point.last_line);
            both.placed &= last.placed;
            if (distance_mm(last, point) <= tolerance_mm_) both.is_rapid = last.is_rapid && point.is_rapid;
            last = both;
            return;
        }
    }
    points_.push_back(point);
}

void PathSketch::thin() {
    for (int i = 0; i < kMostDoublings && points_.size() > kMostPoints / 2; ++i) {
        tolerance_mm_ = std::max(2.0 * tolerance_mm_, kFirstTolerance_mm);
        const std::vector<SketchPoint> before = std::exchange(points_, {});
        for (const SketchPoint& point : before) put(point);
    }
}

std::size_t piece_of_line(const std::vector<SketchPoint>& points, std::uint64_t line) noexcept {
    std::size_t found = 0;
    for (std::size_t i = 1; line != 0 && i < points.size(); ++i) {
        if (points[i].first_line > line || line > points[i].last_line) continue;
        if (found != 0) return 0;
        found = i;
    }
    return found;
}

}  // namespace psicarve::program
