// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/flat/svg_frame.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace psicarve::flat {
namespace {

// The rounding of drawing programs; strokes whose ends are this near are one as well.
constexpr double kRounding_mm = 0.01;

/// Whether a place lies before the beginning or behind the end of a frame's side `along`; all in mm from the
/// frame's corner.
bool is_beyond(Point from_corner, Point along, Point across) {
    // From the edge that lies across: a parallelogram's area by its base.
    const double base = std::hypot(across.x, across.y);
    const double distance = (from_corner.x * across.y - from_corner.y * across.x) / base;
    const double whole = (along.x * across.y - along.y * across.x) / base;
    return std::min(whole, 0.0) - distance > kRounding_mm || distance - std::max(whole, 0.0) > kRounding_mm;
}

bool hides(const SvgFrame& frame, const Path& path) {
    const Point corner = frame.placement.apply({0.0, 0.0});
    const Point width = frame.placement.turn({frame.size.width, 0.0});
    const Point height = frame.placement.turn({0.0, frame.size.height});
    return std::any_of(path.points.begin(), path.points.end(), [&](Point p) {
        const Point from_corner{p.x - corner.x, p.y - corner.y};
        return is_beyond(from_corner, width, height) || is_beyond(from_corner, height, width);
    });
}

}  // namespace

const SvgFrame* hiding_frame(const SvgFrame* frame, const std::vector<Path>& paths, std::size_t first_path) {
    for (; frame != nullptr; frame = frame->outer) {
        for (std::size_t i = first_path; i < paths.size(); ++i) {
            if (paths[i].is_shown && hides(*frame, paths[i])) return frame;
        }
    }
    return nullptr;
}

}  // namespace psicarve::flat
