// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "hmi/flat/drawing.hpp"
#include "hmi/flat/load_model.hpp"
#include "hmi/tool/tool.hpp"
#include "shared/base/result.hpp"

namespace psicarve::flat {

/// A stroke on the unrolled cylinder: x along its surface from direction 0 on [mm], y above its lower end.
struct GrooveStroke {
    std::vector<Point> points;  ///< a closed one does not repeat its first point
    bool is_closed = false;
    double half_floor_mm = 0.0;  ///< half the width over which the groove has its full depth
};

/// Line art wrapped round a cylinder, and the grooves that a tool leaves along it. Lengths in mm.
struct Grooves {
    std::vector<GrooveStroke> strokes;
    double radius_mm = 0.0;  ///< of the cylinder
    double height_mm = 0.0;
    double depth_mm = 0.0;
    tool::Tool tool;
    std::vector<std::string> warnings;

    double round_mm() const noexcept;  ///< once round the cylinder
    /// How far a groove reaches beside its floor.
    double wall_mm() const noexcept { return tool::half_width(tool, depth_mm); }
    double widest_floor_mm() const noexcept;
    /// A groove's cross-section: its depth at a distance beside its floor.
    double depth_beside_mm(double beside_mm) const noexcept;
    /// How deep the tool's tip can go there without touching the walls of the grooves.
    double tip_depth_mm(double beside_mm) const noexcept;
};

/// The drawing's visible lines, placed as the options' engraving says: at its own size or all round, from its
/// start on, in the middle of the height. Refuses a drawing wider than the cylinder's circumference, or
/// higher than the cylinder.
Result<Grooves> grooves_of(const Drawing& drawing, const FlatOptions& options, const std::string& file);

}  // namespace psicarve::flat
