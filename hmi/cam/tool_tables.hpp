// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "hmi/cam/job_plan.hpp"
#include "hmi/cam/radius_tables.hpp"
#include "hmi/model/mesh.hpp"
#include "hmi/slice/slicer.hpp"
#include "shared/base/result.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::cam {

/// Heights of a turn's places, for tool::TipPlaces: a layer's height is the same all round. A spiral's row
/// begins at its bottom with the point before and reaches its top with point n: one list of heights a column.
std::vector<double> row_heights(const JobPlan& plan, double height_error);

/// Fills both tables with the depth that the profile's tool can reach, R2's with its angle and height error.
Result<void> fill_with_tool(const model::Mesh& mesh, const Profile& profile, const JobPlan& plan,
                            const slice::SliceOptions& options, RadiusTables& tables);

}  // namespace psicarve::cam
