// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "rtcore/cycle/motion_block.hpp"
#include "rtcore/plan/machine_limits.hpp"
#include "shared/job/job.hpp"
#include "shared/job/point_plan.hpp"

namespace psicarve::plan {

/// Adds up a job's motion blocks to the time of the way to each of its points, and what bounds it. Motion
/// alone counts, and dwells: not how long backlash takes to be crossed. The feed is told of curves alone:
/// what bounds a straight line by planner angle where no axis is at its limit is another line of its group,
/// or the feed.
class PointTimes {
public:
    /// `limits` of the job, as those of its planner.
    PointTimes(const MachineLimits& limits, const JobView& job);

    /// All blocks of a carving from the job's first point on, in their order.
    void add(const cycle::MotionBlock& block);
    PointPlan take() noexcept { return std::move(plan_); }

private:
    /// What a block takes, and by what it is bounded.
    struct Cost {
        double seconds = 0.0;
        WayBound bound = WayBound::unknown;
    };
    using Shares = std::array<double, kAxisCount>;  ///< by axis: of its top speed or acceleration, 1 is all

    Cost cost_of(const cycle::MotionBlock& block);
    Cost cost_of_path(const cycle::MotionBlock& block) const;
    Cost cost_of_line(const cycle::MotionBlock& block);
    /// `if_none` of the axes is at its limit.
    static WayBound bound_by(const Shares& shares, WayBound if_none) noexcept;
    void end_way(const cycle::MotionBlock& block);

    MachineLimits limits_;
    std::uint32_t point_count_;
    PointPlan plan_;
    GroupLimits group_{};  ///< of the lines at hand
    double group_iterations_ = 0.0;
    double done_iterations_ = 0.0;                  ///< of those
    double way_s_ = 0.0;                            ///< to the next point, so far
    std::array<double, kWayBoundCount> bound_s_{};  ///< of it
};

}  // namespace psicarve::plan
