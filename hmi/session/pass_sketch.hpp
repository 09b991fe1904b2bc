// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "hmi/phrase/phrase.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::session {

/// A point of a drawing in a plane through the rotation axis: how far out, and how high.
struct SketchPoint {
    double radius_mm = 0.0;
    double height_mm = 0.0;
};

/// A sketch of the passes in a blank of which only the core is left: each goes as far down as the one before
/// and not as far up, so that all are visible at once as steps.
struct PassSketch {
    double width_mm = 0.0;           ///< from the rotation axis outwards
    double height_mm = 0.0;          ///< of the drawing
    double blank_mm = 0.0;           ///< 0: the tool is drawn alone
    double finished_mm = 0.0;        ///< the deepest that any tip goes
    std::vector<double> depths_mm;   ///< of the roughing passes, the first one first
    double stepover_mm = 0.0;        ///< between their layers; 0: every layer of the finishing pass
    std::vector<SketchPoint> stock;  ///< what they leave, upwards
    std::vector<SketchPoint> tool;   ///< in the last pass' last layer, from one end round its tip
    std::vector<SketchPoint> shank;  ///< four corners behind its flutes; empty: it cuts over its whole length
};

/// Made of the tool, the blank and the roughing of a profile, in a frame of `height_ratio` heights a width.
/// Without a blank it draws the tool alone, for a point nothing: width_mm is 0. Values that check_options
/// refuses are drawn as well as possible.
PassSketch pass_sketch(const Profile& profile, double height_ratio);

/// "12 roughing passes at most, layers 1.5 mm apart"; "The finishing pass alone".
Phrase passes_phrase(const PassSketch& sketch);
/// Why slicing would refuse the profile's roughing; empty: it would not.
Phrase roughing_problem(const Profile& profile);

}  // namespace psicarve::session
