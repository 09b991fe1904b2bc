// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "hmi/flat/drawing.hpp"
#include "hmi/flat/svg_shapes.hpp"
#include "hmi/flat/svg_tree.hpp"

namespace psicarve::flat {

/// The edge of a viewport: what lies beyond it, who shows the drawing hides. It begins at (0, 0).
struct SvgFrame {
    const SvgElement* element = nullptr;
    Affine placement;  ///< of what is in it to mm
    SvgViewport size;
    const SvgFrame* outer = nullptr;  ///< that it stands in
};

/// The frame, or one outside of it, that hides a part of a path that is seen, of those from `first_path` on;
/// nothing where none does.
const SvgFrame* hiding_frame(const SvgFrame* frame, const std::vector<Path>& paths, std::size_t first_path);

}  // namespace psicarve::flat
