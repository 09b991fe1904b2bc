// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "hmi/flat/drawing.hpp"
#include "shared/base/result.hpp"

namespace psicarve::flat {

// Stroke ends no farther apart than this count as joined; so do an outline's end and its beginning.
inline constexpr double kJoinGap_mm = 0.01;

/// Joins strokes that end where others begin; rings become closed.
std::vector<Path> joined(std::vector<Path> strokes);

/// The outermost outlines of a drawing: overlapping outlines become one, and outlines inside another are
/// ignored.
struct Outline {
    std::vector<std::vector<Point>> outers;  ///< counter-clockwise, no crossings [mm]
    Point centroid;                          ///< of their area
    double area_mm2 = 0.0;
    std::vector<std::string> warnings;
};

/// Whether no stroke, joined to those it touches, is closed or filled. False for a drawing without strokes.
bool has_only_open_lines(const Drawing& drawing);

/// Refuses a drawing without a closed outline; says where an open one has its gap.
Result<Outline> outline_of(const Drawing& drawing, const std::string& file);

}  // namespace psicarve::flat
