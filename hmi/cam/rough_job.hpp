// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hmi/cam/job_builder.hpp"
#include "hmi/model/mesh.hpp"
#include "shared/base/result.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::cam {

/// Puts the roughing passes that the profile asks for, if any, before the finishing pass that the job is, and
/// tells of them in its report. `level`: the same layers not rising, where the job is a spiral; else its own
/// table.
Result<void> rough(BuiltJob& built, const JobTable& level, const Profile& profile);

/// How to slice the same layers of the same model so that they do not rise.
JobOptions level_options(const BuiltJob& spiral, const JobOptions& options);

}  // namespace psicarve::cam
