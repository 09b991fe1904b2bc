// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/piece/draft_piece.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "hmi/piece/tool_cut.hpp"
#include "hmi/tool/map_dilation.hpp"
#include "shared/base/units.hpp"

namespace psicarve::piece {
namespace {

constexpr std::size_t kDraftColumns = 360;
constexpr double kDraftMostRows = 600.0;
// Of the whole's time.
constexpr double kSampleShare = 0.1;
constexpr double kDilationShare = 0.4;
constexpr double kCutShare = 0.3;
constexpr double kCompareShare = 0.2;
// Steep flanks need so much that nothing of the rest would be visible.
constexpr double kAllowanceShare = 0.5;

/// The greatest distance of a corner of the box from the axis [mm].
double box_radius_mm(const PlacedModel& model) {
    const auto least = slice::placed(model.placement.up, model.mesh->facts.min);
    const auto most = slice::placed(model.placement.up, model.mesh->facts.max);
    const double x =
        std::max(std::abs(least[0] - model.placement.axis_x), std::abs(most[0] - model.placement.axis_x));
    const double y =
        std::max(std::abs(least[1] - model.placement.axis_y), std::abs(most[1] - model.placement.axis_y));
    return std::max(std::hypot(x, y) * model.scale, model.core_mm);
}

StockMap draft_blank(const PlacedModel& model, const BlankProfile& blank) {
    const auto least = slice::placed(model.placement.up, model.mesh->facts.min);
    const auto most = slice::placed(model.placement.up, model.mesh->facts.max);
    const double height_mm = (most[2] - least[2]) * model.scale;
    const double model_mm = box_radius_mm(model);
    const double radius_mm = blank.radius_mm > 0.0 ? blank.radius_mm : model_mm;
    const double cell_mm = 2.0 * kPi * model_mm / static_cast<double>(kDraftColumns);
    const double rows = std::clamp(std::ceil(height_mm / std::max(cell_mm, 1e-9)), 1.0, kDraftMostRows);
    StockMap stock(radius_mm, model.base_mm, height_mm / rows, static_cast<std::size_t>(rows), kDraftColumns);
    if (blank.reach_mm() > blank.radius_mm) stock.stand_off(blank);
    return stock;
}

Result<void> cut_along(const std::vector<float>& tips_mm, const tool::Tool& tool,
                       const slice::Progress& progress, StockMap& stock) {
    ToolCut cut(tool, stock);
    for (std::size_t row = 0; row < stock.row_count(); ++row) {
        const double part = static_cast<double>(row) / static_cast<double>(stock.row_count());
        if (progress && !progress(part)) return Error{ErrorCode::cancelled, "the draft was cancelled"};
        for (std::size_t column = 0; column < stock.column_count(); ++column) {
            cut.at(stock.direction_rad(column), stock.height_mm(row),
                   double{tips_mm[row * stock.column_count() + column]});
        }
    }
    return {};
}

}  // namespace

Result<DraftPiece> draft_piece(const PlacedModel& model, const Profile& profile,
                               const slice::SliceOptions& options) {
    DraftPiece draft{draft_blank(model, profile.blank), {}, 0.0};
    StockMap& stock = draft.piece;
    const auto wanted_mm = wanted_radii(model, stock, options.part(0.0, kSampleShare));
    if (!wanted_mm) return wanted_mm.error();
    const tool::Tool tool = tool::tool_of(profile.tool, 1.0);
    const tool::SampledRadii surface{stock.row_count(), stock.column_count(), stock.row_mm(), *wanted_mm};
    draft.allowance_mm = tool::sample_allowance(surface, tool, kAllowanceShare);
    const auto tips_mm =
        tool::dilated(surface, tool, draft.allowance_mm, options.part(kSampleShare, kDilationShare));
    if (!tips_mm) return tips_mm.error();
    const double begun = kSampleShare + kDilationShare;
    const auto cutting = options.part(begun, kCutShare).progress;
    if (const auto done = cut_along(*tips_mm, tool, cutting, stock); !done) return done.error();
    std::vector<std::size_t> rows(stock.row_count());
    std::iota(rows.begin(), rows.end(), std::size_t{0});
    auto deviation =
        deviation_of(stock, *wanted_mm, rows, options.part(begun + kCutShare, kCompareShare).progress);
    if (!deviation) return deviation.error();
    draft.deviation = std::move(*deviation);
    return draft;
}

}  // namespace psicarve::piece
