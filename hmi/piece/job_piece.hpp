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

/// The piece that a job's tables and its tool will leave, after the last of its passes, and its deviation
/// from the model.
struct JobPiece {
    StockMap piece;
    std::vector<std::size_t> rows;            ///< the carved rows of the piece
    std::optional<PieceDeviation> deviation;  ///< on these rows; nothing without a model
};

/// The visible rows of the piece: the carved ones, and the rest of the blank below and above them. Rows
/// between carved ones that no layer reaches are left out.
std::vector<std::size_t> shown_rows(const JobPiece& piece);

/// `columns` cells once round, see blank_of(). `model`: null when it is not known. ErrorCode::cancelled.
Result<JobPiece> job_piece(const JobView& job, const Profile& profile, const PlacedModel* model,
                           std::size_t columns, const slice::SliceOptions& options);

}  // namespace psicarve::piece
