// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/surface_feed.hpp"

#include <algorithm>
#include <cmath>

#include "shared/base/units.hpp"

namespace psicarve::gcode {
namespace {

/// Less than a pulse of any machine.
constexpr double kSamePlaceOutMm = 1e-5;

bool is_out(const DrawingMachine& machine, std::size_t head, const Position& from,
            const Position& to) noexcept {
    const std::size_t letter = machine.head_letters[head];
    return std::min(from[letter], to[letter]) >= machine.out_mm[head] - kSamePlaceOutMm;
}

bool are_all_out(const DrawingMachine& machine, const Position& from, const Position& to) noexcept {
    return is_out(machine, 0, from, to) && is_out(machine, 1, from, to);
}

double turned_rad(const Position& from, const Position& to) noexcept {
    return rad_from_deg(to[kTurnLetter] - from[kTurnLetter]);
}

}  // namespace

double greatest_tip_radius_mm(const DrawingMachine& machine, const Position& from,
                              const Position& to) noexcept {
    double most_mm = 0.0;
    for (std::size_t head = 0; head < machine.head_letters.size(); ++head) {
        if (is_out(machine, head, from, to) && !are_all_out(machine, from, to)) continue;
        const std::size_t letter = machine.head_letters[head];
        most_mm = std::max(most_mm, machine.tip_radius_mm(head, std::max(from[letter], to[letter])));
    }
    return most_mm;
}

double line_over_surface_mm(const DrawingMachine& machine, const Position& from,
                            const Position& to) noexcept {
    const std::size_t y = machine.is_y_on_z ? 2 : 1;
    double most_mm = 0.0;
    for (std::size_t head = 0; head < machine.head_letters.size(); ++head) {
        if (is_out(machine, head, from, to) && !are_all_out(machine, from, to)) continue;
        const std::size_t letter = machine.head_letters[head];
        const double radius_mm = machine.tip_radius_mm(head, std::max(from[letter], to[letter]));
        most_mm = std::max(most_mm, std::hypot(to[letter] - from[letter], to[y] - from[y],
                                               radius_mm * turned_rad(from, to)));
    }
    return most_mm;
}

double arc_over_surface_mm(const DrawingMachine& machine, const CanonRecord& arc, double length_mm) noexcept {
    const Plane& plane = *arc.plane;
    const ArcExtents reach = arc_extents({arc.start[plane.first], arc.start[plane.second]},
                                         {arc.end[plane.first], arc.end[plane.second]},
                                         {arc.centre_first_mm, arc.centre_second_mm}, arc.turns);
    double radius_mm = 0.0;
    for (std::size_t head = 0; head < machine.head_letters.size(); ++head) {
        const std::size_t letter = machine.head_letters[head];
        const bool is_first = letter == plane.first;
        if (is_first || letter == plane.second) {
            const std::size_t which = is_first ? 0 : 1;
            radius_mm = std::max(radius_mm, machine.tip_radius_mm(head, reach.most_mm[which]));
        } else if (!is_out(machine, head, arc.start, arc.end)) {
            radius_mm = std::max(radius_mm,
                                 machine.tip_radius_mm(head, std::max(arc.start[letter], arc.end[letter])));
        }
    }
    return std::hypot(length_mm, radius_mm * turned_rad(arc.start, arc.end));
}

}  // namespace psicarve::gcode
