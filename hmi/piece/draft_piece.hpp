// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hmi/piece/piece_deviation.hpp"
#include "hmi/piece/placed_model.hpp"
#include "hmi/piece/stock_map.hpp"
#include "hmi/slice/slicer.hpp"
#include "shared/base/result.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::piece {

/// The piece that a tool would leave of a model, from samples of it: before slicing, and much sooner.
struct DraftPiece {
    StockMap piece;
    PieceDeviation deviation;
    double allowance_mm = 0.0;  ///< the tips were kept this much further out, since samples do not show all
                                ///< of the surface
};

/// Samples the model's radii in square cells, 360 once round, moves the profile's tool over them (dilated()),
/// and cuts the profile's blank, or the least one, along its tips. Requires a tool that has a size. Calls the
/// progress on the caller's thread. ErrorCode::cancelled.
Result<DraftPiece> draft_piece(const PlacedModel& model, const Profile& profile,
                               const slice::SliceOptions& options);

}  // namespace psicarve::piece
