// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "shared/base/result.hpp"
#include "shared/job/job.hpp"
#include "shared/job/point_plan.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::machine {

/// The core's plan of a job.
struct PlannedTime {
    double carve_seconds = 0.0;
    std::vector<double> layer_seconds;  ///< of each layer with the way to it; their sum is carve_seconds
    std::optional<double> reference_seconds;       ///< T_ref; none with planner angle
    std::shared_ptr<const PointPlan> points = {};  ///< null: not asked for
};

/// Lets a core of our own plan the whole job, without carving. `goes_on` is asked now and then; when it
/// returns false the answer is `cancelled`. `keeps_points`: each point's time, too.
Result<PlannedTime> planned_time(std::span<const std::byte> blob, const JobView& job, const Profile& profile,
                                 const std::function<bool()>& goes_on = {}, bool keeps_points = false);

}  // namespace psicarve::machine
