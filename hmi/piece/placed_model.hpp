// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "hmi/model/mesh.hpp"
#include "hmi/piece/stock_map.hpp"
#include "hmi/slice/placement.hpp"
#include "hmi/slice/slicer.hpp"
#include "shared/base/result.hpp"
#include "shared/job/job.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::piece {

/// The model that a job was sliced from, as it stands on the table.
struct PlacedModel {
    std::shared_ptr<const model::Mesh> mesh;
    slice::Placement placement;
    double scale = 1.0;    ///< mm per file unit
    double base_mm = 0.0;  ///< the model's lowest point above the table
    double core_mm = 0.0;  ///< no head goes further in
};

/// Places the model where the job's report says. Refuses a model that is not the one that was sliced.
Result<PlacedModel> place_as_sliced(std::shared_ptr<const model::Mesh> mesh, const JobView& job,
                                    const Profile& profile);

/// The model's radii at a stock map's heights and directions [mm], row by row: those of its outermost
/// surface, at least the core radius.
Result<std::vector<float>> wanted_radii(const PlacedModel& model, const StockMap& stock,
                                        const slice::SliceOptions& options);

}  // namespace psicarve::piece
