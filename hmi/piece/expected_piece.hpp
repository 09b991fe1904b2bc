// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "hmi/piece/ridges.hpp"
#include "hmi/piece/stock_map.hpp"
#include "hmi/slice/slicer.hpp"
#include "hmi/surface/job_geometry.hpp"
#include "shared/base/result.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::piece {

/// The piece that a job's tables describe, without carving: the tips go straight from point to point, cutting
/// at every pulse of psi or, for a tool that has a size, twice in every column. Links between layers are left
/// out: they cut nothing that both layers would not.
StockMap expected_piece(const verify::JobGeometry& geometry, const Profile& profile, std::size_t columns);
/// Calls the progress at every layer. ErrorCode::cancelled.
Result<StockMap> expected_piece(const verify::JobGeometry& geometry, const Profile& profile,
                                std::size_t columns, const slice::Progress& progress);
/// From this blank; also cuts the model's ridges, if there are any.
Result<StockMap> expected_piece(const verify::JobGeometry& geometry, const Profile& profile, StockMap blank,
                                Ridges* ridges, const slice::Progress& progress);

}  // namespace psicarve::piece
