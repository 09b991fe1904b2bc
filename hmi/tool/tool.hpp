// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "shared/profile/profile.hpp"

namespace psicarve::tool {

using Shape = ToolShape;

/// The cutting end of a tool whose axis lies on its head's radius. Lengths in the unit of the mesh.
struct Tool {
    Shape shape = Shape::ball;  ///< not point: the slicer and the grooves handle a point themselves
    double radius = 1.5;
    double angle_deg = 60.0;  ///< of a vee: between its flanks

    friend bool operator==(const Tool&, const Tool&) = default;
};

/// "ball 3 mm", "vee 6 mm 60 deg", "point".
std::string name_of(const ToolProfile& profile);
/// A profile's tool, its lengths times `per_mm`.
Tool tool_of(const ToolProfile& profile, double per_mm) noexcept;

/// How far behind the tip the tool's surface stands at the distance s from its axis, 0 <= s <= radius:
/// ball R - sqrt(R^2 - s^2), flat 0, vee s / tan(angle / 2).
double rise(const Tool& tool, double s) noexcept;
/// Half the tool's width at a distance behind its tip: its own radius from where it is widest on. 0 for a
/// point.
double half_width(const Tool& tool, double behind_tip) noexcept;
/// For a vee's flank: 1 / tan(angle / 2); else 0.
double flank_slope(const Tool& tool) noexcept;

}  // namespace psicarve::tool
