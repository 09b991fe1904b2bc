// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hmi/flat/drawing.hpp"
#include "hmi/flat/svg_tree.hpp"

namespace psicarve::flat {

/// The lengths that percentages refer to [user units].
struct SvgViewport {
    double width = 0.0;
    double height = 0.0;
};

/// Draws a path or basic shape; other elements draw nothing. False where its data is wrong: the part before
/// the fault is drawn.
bool draw_svg_shape(const SvgElement& element, const SvgViewport& viewport, PathMaker& maker);

}  // namespace psicarve::flat
