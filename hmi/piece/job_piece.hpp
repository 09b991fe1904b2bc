// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "hmi/piece/piece_deviation.hpp"
#include "hmi/piece/placed_model.hpp"
#include "hmi/piece/stock_map.hpp"
#include "hmi/slice/slicer.hpp"
#include "shared/base/result.hpp"
#include "shared/job/job.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::piece {

/// The piece that a job's tables and its tool will leave, after the last of its passes, and how far it will
/// be from its model.
struct JobPiece {
    StockMap piece;
    std::vector<std::size_t> rows;            ///< of the piece, that are carved
    std::optional<PieceDeviation> deviation;  ///< on these rows; nothing without a model
};

/// The rows of the piece that are seen: those that are carved, and what is left of the blank below and above
/// them. Between carved ones those that no layer reaches are not.
std::vector<std::size_t> shown_rows(const JobPiece& piece);

/// `columns` cells once round, see blank_of(). `model`: null where nobody knows it. ErrorCode::cancelled.
Result<JobPiece> job_piece(const JobView& job, const Profile& profile, const PlacedModel* model,
                           std::size_t columns, const slice::SliceOptions& options);

}  // namespace psicarve::piece
