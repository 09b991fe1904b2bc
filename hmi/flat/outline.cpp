// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/flat/outline.hpp"

#include <algorithm>
#include <array>
#include <clipper.hpp>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "hmi/flat/drawing.hpp"
#include "shared/base/result.hpp"

namespace psicarve::flat {
namespace {

// The library works in whole numbers: nanometres, coarser only where a drawing is larger than a metre.
constexpr double kUnitsPerMm = 1e6;
constexpr double kLargestUnit = 1e9;
constexpr double kLeastArea_mm2 = 1e-6;

/// Between millimetres and the clipping library's whole numbers.
class Lattice {
public:
    Lattice(Point least, Point most)
        : centre_{0.5 * (least.x + most.x), 0.5 * (least.y + most.y)},
          per_mm_(
              std::min(kUnitsPerMm, kLargestUnit / std::max({most.x - least.x, most.y - least.y, 1e-9}))) {}

    ClipperLib::IntPoint to(Point p) const {
        return {static_cast<ClipperLib::cInt>(std::llround((p.x - centre_.x) * per_mm_)),
                static_cast<ClipperLib::cInt>(std::llround((p.y - centre_.y) * per_mm_))};
    }
    Point from(const ClipperLib::IntPoint& p) const {
        return {static_cast<double>(p.X) / per_mm_ + centre_.x,
                static_cast<double>(p.Y) / per_mm_ + centre_.y};
    }

private:
    Point centre_;
    double per_mm_;
};

std::string at_text(Point p) {
    std::array<char, 96> text{};
    std::snprintf(text.data(), text.size(), "(%.3f, %.3f)", p.x, p.y);
    return text.data();
}

std::string short_mm_text(double value_mm) {
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), "%.3g mm", value_mm);
    return text.data();
}

/// Area and first moments of a ring, about its first point: far from the origin nothing is lost.
void add_moments(const std::vector<Point>& ring, double& area, double& x_moment, double& y_moment) {
    const Point base = ring.front();
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point a{ring[i].x - base.x, ring[i].y - base.y};
        const Point& next = ring[(i + 1) % ring.size()];
        const Point b{next.x - base.x, next.y - base.y};
        const double twice = a.x * b.y - a.y * b.x;
        area += 0.5 * twice;
        x_moment += 0.5 * twice * (base.x + (a.x + b.x) / 3.0);
        y_moment += 0.5 * twice * (base.y + (a.y + b.y) / 3.0);
    }
}

Error no_outline(const Drawing& drawing, const std::vector<Path>& paths, const std::string& file) {
    if (paths.empty()) {
        return bad_input(file + ": holds no line that can be carved (" + drawing.format + ")" +
                         why_without_lines(drawing));
    }
    const auto longest = std::max_element(paths.begin(), paths.end(), [](const Path& a, const Path& b) {
        return a.points.size() < b.points.size();
    });
    const Point a = longest->points.front();
    const Point b = longest->points.back();
    return bad_input(file + ": has no closed outline; the longest stroke goes from " + at_text(a) + " to " +
                     at_text(b) + " mm, " + short_mm_text(std::hypot(a.x - b.x, a.y - b.y)) +
                     " apart; close it in the drawing program");
}

/// The outlines in whole numbers, all turned the same way: where two overlap they do not cancel each other.
ClipperLib::Paths turned_alike(const std::vector<Path>& paths, const Lattice& lattice) {
    ClipperLib::Paths rings;
    for (const Path& path : paths) {
        if (!path.is_closed && !path.is_filled) continue;
        ClipperLib::Path ring;
        ring.reserve(path.points.size());
        for (const Point& p : path.points) ring.push_back(lattice.to(p));
        if (!ClipperLib::Orientation(ring)) ClipperLib::ReversePath(ring);
        if (ring.size() > 2) rings.push_back(std::move(ring));
    }
    return rings;
}

std::string count_text(std::size_t count, const char* one, const char* many) {
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

bool is_open(const Path& path) {
    return !path.is_closed && !path.is_filled;
}

}  // namespace

bool has_only_open_lines(const Drawing& drawing) {
    const std::vector<Path> paths = joined(drawing.paths);
    return !paths.empty() && std::all_of(paths.begin(), paths.end(), is_open);
}

Result<Outline> outline_of(const Drawing& drawing, const std::string& file) {
    const std::vector<Path> paths = joined(drawing.paths);
    Point least;
    Point most;
    if (!box_of(paths, least, most)) return no_outline(drawing, paths, file);
    const Lattice lattice(least, most);
    const ClipperLib::Paths rings = turned_alike(paths, lattice);
    if (std::all_of(paths.begin(), paths.end(), is_open)) return no_outline(drawing, paths, file);
    ClipperLib::PolyTree tree;
    try {
        ClipperLib::Clipper clipper;
        clipper.StrictlySimple(true);
        clipper.AddPaths(rings, ClipperLib::ptSubject, true);
        clipper.Execute(ClipperLib::ctUnion, tree, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
    } catch (const ClipperLib::clipperException& wrong) {
        return bad_input(file + ": its outlines cannot be joined: " + wrong.what());
    }
    Outline outline;
    double x_moment = 0.0;
    double y_moment = 0.0;
    for (const ClipperLib::PolyNode* node : tree.Childs) {
        std::vector<Point> ring;
        for (const auto& p : node->Contour) ring.push_back(lattice.from(p));
        double area = 0.0;
        double x = 0.0;
        double y = 0.0;
        if (ring.size() > 2) add_moments(ring, area, x, y);
        if (!(area > kLeastArea_mm2)) continue;
        outline.area_mm2 += area;
        x_moment += x;
        y_moment += y;
        outline.outers.push_back(std::move(ring));
    }
    if (outline.outers.empty())
        return bad_input(file + ": its outlines enclose no area; there is nothing to carve");
    outline.centroid = {x_moment / outline.area_mm2, y_moment / outline.area_mm2};
    outline.warnings = drawing.warnings;
    if (const auto open = static_cast<std::size_t>(std::count_if(paths.begin(), paths.end(), is_open));
        open > 0) {
        const auto first = std::find_if(paths.begin(), paths.end(), is_open);
        outline.warnings.push_back(
            count_text(open, "stroke is", "strokes are") + " not closed and left out, the first from " +
            at_text(first->points.front()) + " to " + at_text(first->points.back()) + " mm");
    }
    return outline;
}

}  // namespace psicarve::flat
