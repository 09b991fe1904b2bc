// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "rtcore/plan/machine_limits.hpp"
#include "rtcore/plan/table_program.hpp"
#include "shared/job/job.hpp"

namespace psicarve::plan {

/// The table, or these layers of it, by the planner that the profile names.
std::unique_ptr<Program> carving_of(const MachineLimits& limits, std::shared_ptr<const JobView> job,
                                    LayerSpan layers = {});

}  // namespace psicarve::plan
