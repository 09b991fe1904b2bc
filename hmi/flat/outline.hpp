// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "hmi/flat/drawing.hpp"
#include "shared/base/result.hpp"

namespace psicarve::flat {

// Strokes whose ends are no farther apart belong together; so does an outline's end to its beginning.
inline constexpr double kJoinGap_mm = 0.01;

/// Strokes that end where others begin, made into one; rings become closed.
std::vector<Path> joined(std::vector<Path> strokes);

/// The outermost outlines of a drawing: where outlines overlap they are one, and what lies inside another is
/// not looked at.
struct Outline {
    std::vector<std::vector<Point>> outers;  ///< counter-clockwise, no crossings [mm]
    Point centroid;                          ///< of their area
    double area_mm2 = 0.0;
    std::vector<std::string> warnings;
};

/// Not one stroke, joined to those it touches, is closed or filled. A drawing without strokes has no lines.
bool has_only_open_lines(const Drawing& drawing);

/// Refuses a drawing without a closed outline; says where an open one has its gap.
Result<Outline> outline_of(const Drawing& drawing, const std::string& file);

}  // namespace psicarve::flat
