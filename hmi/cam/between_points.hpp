// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hmi/cam/job_plan.hpp"
#include "hmi/model/mesh.hpp"
#include "hmi/slice/slicer.hpp"
#include "shared/base/result.hpp"
#include "shared/job/job.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::cam {

/// How far the profile's tool goes into the model between two neighbouring points of a layer, where it goes
/// straight in (psi, r) from the one to the other: the most over all layers and all gaps. The model's edges
/// are tested in every gap; any other contact of a tool with a size in the middle and at the worst edge of
/// the 36 gaps where edges go deepest. [mm]; 0: nowhere. Errors: those of tool::tip_radii.
Result<double> sunk_between_points_mm(const model::Mesh& mesh, const Profile& profile, const JobPlan& plan,
                                      const JobTable& table, const slice::SliceOptions& options);

}  // namespace psicarve::cam
