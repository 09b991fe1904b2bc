// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "hmi/cam/job_plan.hpp"
#include "hmi/model/mesh.hpp"
#include "shared/job/job.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::cam {

/// The way between two neighbouring points of the layers, over all layers.
struct Gap {
    double sunk_mm = 0.0;        ///< the tip goes at least this far into the model there
    double direction_rad = 0.0;  ///< where it does, as its head faces it
};

/// How far tips go into the model's edges on their straight way (psi, r) from point to point of a table: for
/// every gap once round, from direction 0 on. Only edges stand out of a straight way: every edge is tested
/// where a layer crosses it, and for tools with a size also from the layers next to it.
std::vector<Gap> sunk_at_edges(const model::Mesh& mesh, const Profile& profile, const JobPlan& plan,
                               const JobTable& table);

/// The most over all these gaps [mm], 0: nowhere. Much quicker for a point in flat layers.
double most_sunk_at_edges_mm(const model::Mesh& mesh, const Profile& profile, const JobPlan& plan,
                             const JobTable& table);

}  // namespace psicarve::cam
