// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "hmi/model/mesh.hpp"
#include "hmi/slice/placement.hpp"
#include "hmi/slice/slicer.hpp"
#include "shared/base/result.hpp"

namespace psicarve::slice {

/// The loss at an axis position, each a share of the whole: 0 nothing, 1 all.
struct AxisLoss {
    double undercut_share = 0.0;  ///< surface that lies behind another in the same direction
    double outside_share = 0.0;   ///< layers whose section does not contain the axis
    double radius_max = 0.0;      ///< file units

    double total() const noexcept { return undercut_share + outside_share; }
};

struct AxisSearch {
    std::array<double, 2> best{};  ///< in the turned model, file units
    AxisLoss best_loss;
    AxisLoss centre_loss;  ///< at the centre of the bounding box
    AxisLoss used_loss;    ///< at the position that the caller asks about
};

/// Finds the axis position that loses the least: a grid over the bounding box seen from above, then ever
/// smaller steps around the best. Losses are estimated on a few sections and directions, so they differ a
/// little from those of the full job. Positions that would need a radius over `radius_limit` (file units) are
/// taken only when there are no others. Deterministic; of equal positions the one nearest the centre wins.
Result<AxisSearch> search_axis(const model::Mesh& mesh, Up up, const std::array<double, 2>& used,
                               double radius_limit, const Progress& progress);

/// How far the model reaches from its axis, file units.
double largest_radius(const model::Mesh& mesh, const Placement& placement);

}  // namespace psicarve::slice
