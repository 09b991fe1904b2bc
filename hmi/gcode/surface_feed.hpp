// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hmi/gcode/arc.hpp"
#include "hmi/gcode/canon.hpp"
#include "hmi/gcode/drawing_machine.hpp"

namespace psicarve::gcode {

/// How far from the axis a tip comes on a straight way of the axes from one place of the machine to the
/// other; one that stays at the end of its travel cuts nothing.
double greatest_tip_radius_mm(const DrawingMachine& machine, const Position& from,
                              const Position& to) noexcept;

/// How far a tool goes over the piece on a straight way of the axes from one place of the machine to the
/// other, at the greatest radius that it has on it: so no part of it is faster than the feed. Of both heads'
/// the longer one; a head that stays at the end of its travel cuts nothing.
double line_over_surface_mm(const DrawingMachine& machine, const Position& from, const Position& to) noexcept;

/// The same of an arc that is `length_mm` long in its plane and across. Requires start, end, plane, centre
/// and turns.
double arc_over_surface_mm(const DrawingMachine& machine, const CanonRecord& arc, double length_mm) noexcept;

}  // namespace psicarve::gcode
