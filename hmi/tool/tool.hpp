// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "shared/profile/profile.hpp"

namespace psicarve::tool {

using Shape = ToolShape;

/// The cutting end of a tool whose axis lies on its head's radius. Lengths in whatever unit the mesh has.
struct Tool {
    Shape shape = Shape::ball;  ///< of a point the slicer and grooves know themselves
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
/// How far from its axis the tool is as wide as this, so far behind its tip: its own radius from where it is
/// widest on. Of a point 0.
double half_width(const Tool& tool, double behind_tip) noexcept;
/// Of a vee's flank: 1 / tan(angle / 2); of others 0.
double flank_slope(const Tool& tool) noexcept;

}  // namespace psicarve::tool
