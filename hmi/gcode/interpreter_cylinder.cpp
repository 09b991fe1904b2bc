// SPDX-License-Identifier: GPL-3.0-or-later
// What G7.1 draws on the unrolled cylinder.
#include <algorithm>
#include <cmath>

#include "hmi/gcode/arc_chords.hpp"
#include "hmi/gcode/interpreter.hpp"
#include "hmi/gcode/surface_feed.hpp"
#include "shared/base/units.hpp"

namespace psicarve::gcode {
namespace {

constexpr AxisMask kUvw = 0x1C0;

}  // namespace

/// Where no machine says whether Y or Z is y: the words of an arc do.
const Plane* Interpreter::plane_by_words() const noexcept {
    const bool has_z = (words_.axes() & mask_of(2)) != 0 && (words_.axes() & mask_of(1)) == 0;
    return words_.has('K') || (words_.has('R') && has_z) ? &kCylinderZc : &kCylinderCy;
}

Interpreter::Fault Interpreter::draw_on_cylinder() {
    const double mm_per_deg = drawing_.radius_mm * rad_from_deg(1.0);
    if (!options_.drawing.is_known) modes_.plane = plane_by_words();
    const Plane& plane = *modes_.plane;
    const Position end = target();
    CanonRecord arc;  // where it is drawn
    arc.start = place_.program;
    arc.end = end;
    arc.start[kTurnLetter] *= mm_per_deg;
    arc.end[kTurnLetter] *= mm_per_deg;
    const double turned_mm = arc.end[kTurnLetter] - arc.start[kTurnLetter];
    if (outcome_.motion == 0 || outcome_.motion == 10) {
        double moved = moved_mm(end, options_.drawing.linear_letters());
        if (moved < kLeastWayMm) moved = moved_mm(end, kUvw);
        const double length_mm = std::hypot(moved, turned_mm);
        note_places(words_.axes(), false);
        const FeedAlong along = length_mm < kLeastWayMm ? feed_of_line(place_.program, end)
                                                        : FeedAlong{feed_of_length(length_mm), length_mm};
        emit_drawn(end, 1.0, along, true, true);
        return std::nullopt;
    }
    const PlanePoint from{arc.start[plane.first], arc.start[plane.second]};
    const PlanePoint to{arc.end[plane.first], arc.end[plane.second]};
    PlanePoint centre = from;
    arc.turns = 1;
    if (auto wrong = arc_in_plane(from, to, centre, arc.turns)) return wrong;
    arc.plane = &plane;
    arc.centre_first_mm = centre.first_mm;
    arc.centre_second_mm = centre.second_mm;
    const double round_mm = std::hypot(from.first_mm - centre.first_mm, from.second_mm - centre.second_mm) *
                            sweep_rad(from, to, centre, arc.turns);
    const auto across = static_cast<AxisMask>(options_.drawing.linear_letters() &
                                              ~(mask_of(plane.first) | mask_of(plane.second)));
    return carry_out_on_cylinder(arc, end, std::hypot(round_mm, moved_mm(end, across)));
}

Interpreter::Fault Interpreter::carry_out_on_cylinder(const CanonRecord& arc, const Position& end,
                                                      double length_mm) {
    // A tip outside the cylinder is as much further off as it is further out.
    const double tip_mm = greatest_tip_radius_mm(options_.drawing, place_.machine, offsets_.to_machine(end));
    const ArcChords chords{arc, chord_mm() / std::max(1.0, tip_mm / drawing_.radius_mm)};
    if (chords.count() > kMostDrawnChords)
        return fault(words_.axis_column(), ProblemCode::out_of_range,
                     phrase("an arc of more than 100000 chords"));
    const double mm_per_deg = drawing_.radius_mm * rad_from_deg(1.0);
    const AxisMask axes = static_cast<AxisMask>(mask_of(arc.plane->first) | mask_of(arc.plane->second));
    const AxisMask before = place_.placed;
    note_places(words_.axes(), false);
    const AxisMask behind = place_.placed;
    // What gets its place by it has that at its end alone, and so has all of an arc from anywhere.
    place_.placed = static_cast<AxisMask>(behind & before);
    if ((before & axes) != axes) place_.placed = static_cast<AxisMask>(place_.placed & ~axes);
    const FeedAlong along{feed_of_length(length_mm), length_mm};
    const double share = 1.0 / static_cast<double>(chords.count());
    for (std::uint64_t chord = 1; chord < chords.count() && sink_->wants_more(); ++chord) {
        Position at = chords.end_of(chord);
        at[kTurnLetter] /= mm_per_deg;
        emit_drawn(at, share, along, chord == 1, false);
    }
    place_.placed = behind;
    emit_drawn(end, share, along, chords.count() == 1, true);
    return std::nullopt;
}

}  // namespace psicarve::gcode
