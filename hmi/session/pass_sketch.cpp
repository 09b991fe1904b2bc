// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/pass_sketch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "hmi/phrase/error_phrase.hpp"
#include "hmi/rough/roughing.hpp"
#include "hmi/session/display_text.hpp"
#include "hmi/tool/tool.hpp"

namespace psicarve::session {
namespace {

constexpr std::size_t kRows = 240;       // of the stock: finer than the picture's pixels
constexpr std::size_t kToolPoints = 25;  // round its tip
constexpr std::size_t kMostSteps = 500;  // more are one slope to the eye
constexpr double kPointWidth = 0.02;     // of the drawing: a point has none, and must be seen
constexpr double kRoom = 1.3;            // of the tool's diameter, where it is drawn alone
constexpr double kLength = 1.25;         // of what cuts
constexpr double kTipAt = 0.15;          // of the drawing
constexpr double kAir = 0.25;            // of the blank's radius, where the tool comes from

double deepest_tip_mm(const Profile& profile) {
    const BlankProfile& blank = profile.blank;
    const double limit_mm = blank.depth_limit_mm > 0.0 ? blank.radius_mm - blank.depth_limit_mm : 0.0;
    return std::min(blank.reach_mm(), std::max(profile.core_radius_mm, limit_mm));
}

std::vector<double> sketch_depths_of(const Profile& profile, const PassSketch& sketch) {
    std::vector<double> depths_mm;
    const auto wanted = rough::wanted_roughing(profile);
    if (!wanted || !(wanted->stepdown_mm > 0.0)) return depths_mm;
    const double last_mm = sketch.finished_mm + std::max(0.0, wanted->allowance_mm);
    for (double depth_mm = sketch.blank_mm; depth_mm > last_mm + 1e-9 && depths_mm.size() < kMostSteps;) {
        depth_mm = std::max(last_mm, depth_mm - wanted->stepdown_mm);
        depths_mm.push_back(depth_mm);
    }
    return depths_mm;
}

/// As many bands as passes and one more, of the blank as it was, from the top down. Without roughing the
/// finishing pass cuts its way alone.
class Bands {
public:
    explicit Bands(const PassSketch& sketch)
        : sketch_(sketch),
          depths_mm_(sketch.depths_mm.empty() ? std::vector{sketch.finished_mm} : sketch.depths_mm),
          band_mm_(sketch.height_mm / static_cast<double>(depths_mm_.size() + 1)),
          step_mm_(sketch.stepover_mm > 0.0 ? std::max(sketch.stepover_mm, sketch.height_mm / kRows)
                                            : sketch.height_mm / kRows) {}

    /// Height of the last layer that is carved at all, in the middle of the lowest band.
    double first_layer_mm() const { return 0.5 * band_mm_; }
    double step_mm() const { return step_mm_; }
    /// How far in the last pass with a layer at this height goes.
    double depth_mm(double height_mm) const {
        const auto from_below = static_cast<std::size_t>(std::max(0.0, height_mm / band_mm_));
        const std::size_t passes = depths_mm_.size();
        return from_below >= passes ? sketch_.blank_mm : depths_mm_[passes - 1 - from_below];
    }

private:
    const PassSketch& sketch_;
    std::vector<double> depths_mm_;
    double band_mm_;
    double step_mm_;
};

/// The lower envelope of the tool in all layers.
std::vector<SketchPoint> stock_of(const PassSketch& sketch, const tool::Tool& cutter) {
    const Bands bands(sketch);
    const bool is_point = cutter.shape == ToolShape::point;
    // A tool as thin as a point would pass between two rows.
    const double reach_mm =
        std::max(is_point ? 0.5 * bands.step_mm() : cutter.radius, 0.5 * sketch.height_mm / kRows);
    const auto first = bands.first_layer_mm();
    std::vector<SketchPoint> stock;
    for (std::size_t row = 0; row <= kRows; ++row) {
        const double height_mm = sketch.height_mm * static_cast<double>(row) / kRows;
        double radius_mm = sketch.blank_mm;
        const auto from = std::llround(std::ceil((height_mm - reach_mm - first) / bands.step_mm() - 1e-9));
        const auto to = std::llround(std::floor((height_mm + reach_mm - first) / bands.step_mm() + 1e-9));
        for (auto layer = from; layer <= to; ++layer) {
            const double layer_mm = first + static_cast<double>(layer) * bands.step_mm();
            const double away_mm = std::min(cutter.radius, std::abs(height_mm - layer_mm));
            const double rise_mm = is_point ? 0.0 : tool::rise(cutter, away_mm);
            if (layer_mm > sketch.height_mm) continue;
            radius_mm = std::min(radius_mm, bands.depth_mm(layer_mm) + rise_mm);
        }
        stock.push_back({radius_mm, height_mm});
    }
    return stock;
}

void draw_tool(const Profile& profile, const tool::Tool& cutter, PassSketch& sketch) {
    const double tip_mm = sketch.depths_mm.empty() ? sketch.finished_mm : sketch.depths_mm.back();
    const double middle_mm = sketch.blank_mm > 0.0 ? Bands(sketch).first_layer_mm() : sketch.height_mm / 2.0;
    const bool is_point = cutter.shape == ToolShape::point;
    const double half_mm = is_point ? 0.5 * kPointWidth * sketch.width_mm : cutter.radius;
    const double flute_mm = profile.tool.flute_mm;
    const bool has_shank = flute_mm > 0.0 && tip_mm + flute_mm < sketch.width_mm;
    const double end_mm = has_shank ? tip_mm + flute_mm : sketch.width_mm;
    sketch.tool.push_back({end_mm, middle_mm - half_mm});
    for (std::size_t i = 0; i < kToolPoints; ++i) {
        const double across = 2.0 * static_cast<double>(i) / (kToolPoints - 1) - 1.0;
        const double rise_mm = is_point ? std::abs(across) * 4.0 * half_mm
                                        : tool::rise(cutter, std::abs(across) * cutter.radius);
        sketch.tool.push_back({std::min(end_mm, tip_mm + rise_mm), middle_mm + across * half_mm});
    }
    sketch.tool.push_back({end_mm, middle_mm + half_mm});
    if (!has_shank) return;
    for (const double at_mm : {end_mm, sketch.width_mm})
        for (const double side : at_mm == end_mm ? std::array{-1.0, 1.0} : std::array{1.0, -1.0})
            sketch.shank.push_back({at_mm, middle_mm + side * half_mm});
}

/// The tool alone, in a frame that holds it, its cutting end from the tip to beyond its flutes.
PassSketch tool_sketch(const Profile& profile, double height_ratio) {
    PassSketch sketch;
    if (profile.tool.shape == ToolShape::point) return sketch;
    const tool::Tool cutter = tool::tool_of(profile.tool, 1.0);
    const double length_mm = std::max({profile.tool.diameter_mm, kLength * tool::rise(cutter, cutter.radius),
                                       kLength * profile.tool.flute_mm});
    sketch.width_mm = std::max(kRoom * profile.tool.diameter_mm / height_ratio, length_mm / (1.0 - kTipAt));
    sketch.height_mm = sketch.width_mm * height_ratio;
    sketch.finished_mm = kTipAt * sketch.width_mm;
    draw_tool(profile, cutter, sketch);
    return sketch;
}

}  // namespace

PassSketch pass_sketch(const Profile& profile, double height_ratio) {
    const double blank_mm = profile.blank.reach_mm();
    if (!(blank_mm > 0.0)) return tool_sketch(profile, height_ratio);
    PassSketch sketch;
    sketch.blank_mm = blank_mm;
    sketch.width_mm = blank_mm * (1.0 + kAir);
    sketch.height_mm = sketch.width_mm * height_ratio;
    sketch.finished_mm = deepest_tip_mm(profile);
    sketch.depths_mm = sketch_depths_of(profile, sketch);
    const tool::Tool cutter = tool::tool_of(profile.tool, 1.0);
    if (!sketch.depths_mm.empty()) {
        if (const auto wanted = rough::wanted_roughing(profile))
            sketch.stepover_mm = rough::used_stepover_mm(*wanted, profile.tool);
    }
    sketch.stock = stock_of(sketch, cutter);
    draw_tool(profile, cutter, sketch);
    return sketch;
}

Phrase passes_phrase(const PassSketch& sketch) {
    if (!(sketch.blank_mm > 0.0)) return phrase("The tool alone: no blank is chosen");
    if (sketch.depths_mm.empty()) return phrase("The finishing pass alone");
    if (sketch.depths_mm.size() >= kMostSteps) return phrase("Hundreds of roughing passes");
    const std::string count = std::to_string(sketch.depths_mm.size());
    if (!(sketch.stepover_mm > 0.0)) return phrase("Up to %1 roughing passes of all layers", count);
    return phrase("Up to %1 roughing passes, layers %2 mm apart", count, number_text(sketch.stepover_mm, 2));
}

Phrase roughing_problem(const Profile& profile) {
    const auto wanted = rough::wanted_roughing(profile);
    if (!wanted) return {};
    const auto checked = rough::check_options(*wanted, profile);
    return checked ? Phrase{} : error_phrase(checked.error());
}

}  // namespace psicarve::session
