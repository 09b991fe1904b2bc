// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hmi/piece/piece_deviation.hpp"
#include "hmi/piece/placed_model.hpp"
#include "hmi/piece/stock_map.hpp"
#include "hmi/slice/slicer.hpp"
#include "shared/base/result.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::piece {

/// What a tool would leave of a model, by samples of it: before slicing, and much sooner.
struct DraftPiece {
    StockMap piece;
    PieceDeviation deviation;
    double allowance_mm = 0.0;  ///< by which the tips were kept further out for what samples do not tell
};

/// Samples the model's radii in square cells, 360 once round, moves the profile's tool over them (dilated()),
/// and cuts the profile's blank, or the least one, along its tips. Requires a tool that has a size. The
/// progress is asked on the caller's thread. ErrorCode::cancelled.
Result<DraftPiece> draft_piece(const PlacedModel& model, const Profile& profile,
                               const slice::SliceOptions& options);

}  // namespace psicarve::piece
