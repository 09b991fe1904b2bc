// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/piece/job_piece.hpp"

#include <numeric>
#include <string>
#include <utility>

#include "hmi/piece/expected_piece.hpp"
#include "hmi/piece/piece_carver.hpp"
#include "hmi/piece/ridges.hpp"
#include "hmi/surface/job_geometry.hpp"
#include "hmi/tool/tool.hpp"

namespace psicarve::piece {
namespace {

// Of the whole's time.
constexpr double kCarveShare = 0.7;
constexpr double kModelShare = 0.1;
constexpr double kDistanceShare = 0.2;

}  // namespace

std::vector<std::size_t> shown_rows(const JobPiece& piece) {
    const std::size_t count = piece.piece.row_count();
    const std::size_t first = piece.rows.empty() ? count : piece.rows.front();
    std::vector<std::size_t> shown(first);
    std::iota(shown.begin(), shown.end(), std::size_t{0});
    shown.insert(shown.end(), piece.rows.begin(), piece.rows.end());
    if (piece.rows.empty()) return shown;
    for (std::size_t row = piece.rows.back() + 1; row < count; ++row) shown.push_back(row);
    return shown;
}

Result<JobPiece> job_piece(const JobView& job, const Profile& profile, const PlacedModel* model,
                           std::size_t columns, const slice::SliceOptions& options) {
    const auto geometry = verify::JobGeometry::make(job, profile);
    if (!geometry) return bad_input(std::string{job.source_name()} + ": " + geometry.error().message);
    StockMap blank = blank_of(*geometry, profile, columns);
    const bool is_point = profile.tool.shape == ToolShape::point;
    std::vector<std::size_t> rows = carved_rows(*geometry, blank, is_point);
    if (model == nullptr) {
        auto piece = expected_piece(*geometry, profile, std::move(blank), nullptr, options.progress);
        if (!piece) return piece.error();
        return JobPiece{std::move(*piece), std::move(rows), {}};
    }
    const auto wanted_mm = wanted_radii(*model, blank, options.part(0.0, kModelShare));
    if (!wanted_mm) return wanted_mm.error();
    Ridges ridges(*model, tool::tool_of(profile.tool, 1.0), blank, *wanted_mm, rows, *geometry);
    auto piece = expected_piece(*geometry, profile, std::move(blank), &ridges,
                                options.part(kModelShare, kCarveShare).progress);
    if (!piece) return piece.error();
    JobPiece made{std::move(*piece), std::move(rows), {}};
    auto deviation = deviation_of(made.piece, *wanted_mm, made.rows, &ridges,
                                  options.part(kCarveShare + kModelShare, kDistanceShare).progress);
    if (!deviation) return deviation.error();
    made.deviation = std::move(*deviation);
    return made;
}

}  // namespace psicarve::piece
