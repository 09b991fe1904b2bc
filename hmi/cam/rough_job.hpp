// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hmi/cam/job_builder.hpp"
#include "hmi/model/mesh.hpp"
#include "shared/base/result.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::cam {

/// Puts the roughing passes that the profile asks for, if any, before the job's finishing pass, and adds them
/// to its report. `level`: the same layers without rising, where the job is a spiral; else its own table.
Result<void> rough(BuiltJob& built, const JobTable& level, const Profile& profile);

/// Options that slice the same layers of the same model without rising.
JobOptions level_options(const BuiltJob& spiral, const JobOptions& options);

}  // namespace psicarve::cam
