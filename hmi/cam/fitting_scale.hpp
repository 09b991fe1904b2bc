// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hmi/cam/job_plan.hpp"
#include "hmi/cam/slice_report.hpp"
#include "hmi/model/mesh.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::cam {

/// The largest scale at which the model, about the plan's axis, fits the machine's travel and, if the profile
/// has one, the blank; the report's notes name the one that limits it. Not above 0: it fits nowhere.
double fitting_scale(const model::Mesh& mesh, const Profile& profile, const JobPlan& plan,
                     SliceReport& report);

}  // namespace psicarve::cam
