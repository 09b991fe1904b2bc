// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "hmi/flat/drawing.hpp"
#include "hmi/flat/svg_shapes.hpp"
#include "hmi/flat/svg_tree.hpp"

namespace psicarve::flat {

/// The edge of a viewport: viewers hide what lies beyond it. It begins at (0, 0).
struct SvgFrame {
    const SvgElement* element = nullptr;
    Affine placement;  ///< from the frame's content to mm
    SvgViewport size;
    const SvgFrame* outer = nullptr;  ///< the frame that holds this one
};

/// The frame, or one that holds it, that hides a part of a visible path, of those from `first_path` on; null
/// where none does.
const SvgFrame* hiding_frame(const SvgFrame* frame, const std::vector<Path>& paths, std::size_t first_path);

}  // namespace psicarve::flat
