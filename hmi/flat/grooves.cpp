// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/flat/grooves.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "hmi/flat/dashes.hpp"
#include "shared/base/decimals.hpp"
#include "shared/base/units.hpp"

namespace psicarve::flat {
namespace {

constexpr double kEdge_mm = 1.0;     // above and below the grooves, if no height is given
constexpr double kLargest_mm = 1e4;  // far beyond every machine, and safe to calculate with
constexpr double kRounding = 1e-9;   // of a drawing that is as wide as the cylinder is round

std::vector<Path> shown_paths(const Drawing& drawing) {
    std::vector<Path> paths;
    std::copy_if(drawing.paths.begin(), drawing.paths.end(), std::back_inserter(paths),
                 [](const Path& path) { return path.is_shown; });
    return paths;
}

Result<void> check_depth(const Grooves& grooves, const std::string& file) {
    if (grooves.depth_mm > 0.0 && grooves.depth_mm < grooves.radius_mm) return {};
    return bad_input(file + ": grooves " + mm_text(grooves.depth_mm) +
                     " deep; they must be deeper than 0, and less deep than the cylinder's radius of " +
                     mm_text(grooves.radius_mm));
}

Result<void> check_size(const Grooves& grooves, Point size, double scale, const std::string& file) {
    if (size.x > grooves.round_mm() * (1.0 + kRounding)) {
        constexpr double kDigits = 1e4;
        const double most = std::floor(scale * grooves.round_mm() / size.x * kDigits) / kDigits;
        return bad_input(file + ": the drawing is " + mm_text(size.x) +
                         " wide, and once round the cylinder are only " + mm_text(grooves.round_mm()) +
                         ": at most --scale " + decimals(most, 4) + ", a larger --diameter, or --full-turn");
    }
    if (size.y > grooves.height_mm * (1.0 + kRounding)) {
        return bad_input(file + ": the drawing is " + mm_text(size.y) + " high, and the cylinder only " +
                         mm_text(grooves.height_mm) + ": --height or --scale");
    }
    return {};
}

/// A groove at least as wide as the tool at the surface.
double half_floor_mm(const Grooves& grooves, double width_mm) {
    return std::max(0.0, 0.5 * width_mm - grooves.wall_mm());
}

void add_strokes(Grooves& grooves, std::vector<Path>& paths, Point least, double scale, double start_mm,
                 double bottom_mm, bool follows_strokes) {
    std::size_t narrow = 0;
    for (Path& path : paths) {
        GrooveStroke stroke{std::move(path.points), path.is_closed, 0.0};
        for (Point& p : stroke.points)
            p = {start_mm + (p.x - least.x) * scale, bottom_mm + (p.y - least.y) * scale};
        if (follows_strokes) {
            const double width_mm = std::min(path.width_mm * scale, kLargest_mm);
            stroke.half_floor_mm = half_floor_mm(grooves, width_mm);
            narrow += 0.5 * width_mm < grooves.wall_mm() * (1.0 - kRounding) ? 1U : 0U;
        }
        grooves.strokes.push_back(std::move(stroke));
    }
    if (narrow > 0) {
        grooves.warnings.push_back(std::to_string(narrow) + " of " + std::to_string(grooves.strokes.size()) +
                                   " strokes are narrower than the tool cuts, " +
                                   mm_text(2.0 * grooves.wall_mm()) + ": they become as wide as that");
    }
}

}  // namespace

double Grooves::round_mm() const noexcept {
    return 2.0 * kPi * radius_mm;
}

double Grooves::widest_floor_mm() const noexcept {
    double widest_mm = 0.0;
    for (const GrooveStroke& stroke : strokes) widest_mm = std::max(widest_mm, stroke.half_floor_mm);
    return widest_mm;
}

double Grooves::depth_beside_mm(double beside_mm) const noexcept {
    if (beside_mm <= 0.0) return depth_mm;
    return beside_mm <= wall_mm() ? std::max(0.0, depth_mm - tool::rise(tool, beside_mm)) : 0.0;
}

// The material that is left meets the tool first at the groove's rim.
double Grooves::tip_depth_mm(double beside_mm) const noexcept {
    if (beside_mm <= 0.0) return depth_mm;
    const double to_rim_mm = wall_mm() - beside_mm;
    return to_rim_mm > 0.0 ? std::min(depth_mm, tool::rise(tool, to_rim_mm)) : 0.0;
}

Result<Grooves> grooves_of(const Drawing& drawing, const FlatOptions& options, const std::string& file) {
    const Engraving& engraving = *options.engraving;
    Grooves grooves;
    grooves.radius_mm = 0.5 * options.diameter_mm.value_or(kUsualDiameter_mm);
    grooves.depth_mm = engraving.depth_mm;
    grooves.tool = tool::tool_of(engraving.tool, 1.0);
    grooves.warnings = drawing.warnings;
    if (auto good = check_depth(grooves, file); !good) return good.error();
    std::vector<Path> paths = shown_paths(drawing);
    Point least;
    Point most;
    if (!box_of(paths, least, most))
        return bad_input(file + ": no lines to engrave" + why_without_lines(drawing));
    double scale = 1.0;
    if (options.is_full_turn) {
        if (!(most.x > least.x)) return bad_input(file + ": a drawing without a width goes not all round");
        scale = grooves.round_mm() / (most.x - least.x);
    }
    const Point size{(most.x - least.x) * scale, (most.y - least.y) * scale};
    double widest_mm = 0.0;
    for (const Path& path : paths)
        widest_mm = std::max(widest_mm, std::min(path.width_mm * scale, kLargest_mm));
    const double groove_mm =
        2.0 * (grooves.wall_mm() + (engraving.follows_strokes ? half_floor_mm(grooves, widest_mm) : 0.0));
    grooves.height_mm = options.height_mm.value_or(size.y + groove_mm + 2.0 * kEdge_mm);
    if (!(std::max(size.x, std::max(size.y, grooves.height_mm)) <= kLargest_mm))
        return bad_input(file + ": the drawing would be more than ten metres wide or high");
    if (!(grooves.height_mm > 0.0)) return bad_input(file + ": --height must be more than 0 mm");
    if (auto good = check_size(grooves, size, options.scale, file); !good) return good.error();
    auto seen = seen_strokes(std::move(paths), file);
    if (!seen) return seen.error();
    const double turn_deg = engraving.start_deg - kDegPerRev * std::floor(engraving.start_deg / kDegPerRev);
    add_strokes(grooves, *seen, least, scale, turn_deg / kDegPerRev * grooves.round_mm(),
                0.5 * (grooves.height_mm - size.y), engraving.follows_strokes);
    return grooves;
}

}  // namespace psicarve::flat
