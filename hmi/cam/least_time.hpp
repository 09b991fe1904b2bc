// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shared/job.hpp"
#include "shared/profile.hpp"

namespace psicarve::cam {

/// The least that carving the job can take [s]: straight from point to point at the job's feed over the
/// surface or at the axes' top speeds, whichever is slower. Acceleration, links between layers, approach and
/// return come on top; the planner alone knows them. Some 10 ns a point.
double least_carving_seconds(const JobView& job, const Profile& profile);

}  // namespace psicarve::cam
