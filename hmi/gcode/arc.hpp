// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "hmi/gcode/problem.hpp"

namespace psicarve::gcode {

/// A point by the plane's two axes [mm].
struct PlanePoint {
    double first_mm = 0.0;
    double second_mm = 0.0;
};

struct ArcFault {
    ProblemCode code;
    Phrase what;
};

/// An arc whose ends are this close is a whole circle.
inline constexpr double kSamePlaceMm = 1e-6;
/// And so is one whose ends lie in the same direction from the centre, whichever way that was rounded.
inline constexpr double kSameDirectionRad = 1e-12;

/// The fault of a centre, if any: none of the radii may be zero, nor may they differ by more than 0.5 mm, or
/// by more than both 0.005 mm and a thousandth. Source: grbl 1.1, gcode.c.
std::optional<ArcFault> centre_fault(const PlanePoint& start, const PlanePoint& end,
                                     const PlanePoint& centre);

/// Centre of an arc from its radius; a negative radius means more than half a turn. Nothing: `fault` says
/// why.
std::optional<PlanePoint> centre_of_radius(const PlanePoint& start, const PlanePoint& end, double radius_mm,
                                           bool is_clockwise, std::optional<ArcFault>& fault);

/// Angle of an arc, > 0 counterclockwise, over `turns` begun turns (their sign is the direction).
double sweep_rad(const PlanePoint& start, const PlanePoint& end, const PlanePoint& centre,
                 int turns) noexcept;

/// Least and greatest of both axes of an arc.
struct ArcExtents {
    double least_mm[2];
    double most_mm[2];
};
ArcExtents arc_extents(const PlanePoint& from, const PlanePoint& to, const PlanePoint& centre,
                       int turns) noexcept;

}  // namespace psicarve::gcode
