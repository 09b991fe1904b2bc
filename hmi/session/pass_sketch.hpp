// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "hmi/phrase/phrase.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::session {

/// Of a drawing in a plane through the rotation axis: how far out, and how high.
struct SketchPoint {
    double radius_mm = 0.0;
    double height_mm = 0.0;
};

/// What the passes would do to a blank of which nothing is to be left but its core: each goes as far down as
/// the one before and not as far up, so that all can be seen at once as steps.
struct PassSketch {
    double width_mm = 0.0;           ///< from the rotation axis outwards
    double height_mm = 0.0;          ///< of the drawing
    double blank_mm = 0.0;           ///< 0: the tool is drawn alone
    double finished_mm = 0.0;        ///< the deepest that any tip may go
    std::vector<double> depths_mm;   ///< to which roughing passes go in, the first one first
    double stepover_mm = 0.0;        ///< between their layers; 0: every layer of the finishing pass
    std::vector<SketchPoint> stock;  ///< what stands when they are done, upwards
    std::vector<SketchPoint> tool;   ///< in the last pass' last layer, from one end round its tip
    std::vector<SketchPoint> shank;  ///< four corners behind its flutes; empty: it cuts all along
};

/// Of the tool, the blank and the roughing of a profile, in a frame of `height_ratio` heights a width.
/// Without a blank there is the tool alone, without one that has a size nothing: width_mm is 0. What
/// check_options refuses is drawn as far as it can be.
PassSketch pass_sketch(const Profile& profile, double height_ratio);

/// "12 roughing passes at most, layers 1.5 mm apart"; "The finishing pass alone".
Phrase passes_phrase(const PassSketch& sketch);
/// What is wrong with what the profile asks for, as slicing it would be refused; empty: nothing.
Phrase roughing_problem(const Profile& profile);

}  // namespace psicarve::session
