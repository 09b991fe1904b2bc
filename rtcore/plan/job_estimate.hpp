// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "rtcore/plan/program.hpp"
#include "shared/job/point_plan.hpp"

namespace psicarve::plan {

/// What is left of a run.
struct TimeLeft {
    double seconds = -1.0;    ///< negative: not known
    bool is_planned = false;  ///< to the end; else from some place on it is a forecast
};

/// How long a whole table takes as planned, at 100 % feed, and how long the way to each of its points: known
/// at the places where a layer or a stretch ends. In between layers share the time as a forecast says, and
/// within one each point takes as long as the next. Grows as the table is planned; what is not planned yet
/// takes as long as the forecast says.
class JobEstimate {
public:
    /// By layer, about when it ends, in a table with so many points in each.
    void forecast(const std::vector<double>& layer_ends_s, std::uint32_t point_count);
    /// So much has been planned; neither count nor seconds ever less than before.
    void add(const PlannedSoFar& planned);

    std::uint64_t points() const noexcept { return marks_.back().points; }
    /// From the first point to the last one planned.
    double seconds() const noexcept { return marks_.back().seconds; }
    /// Of each point by itself; once all is planned, where that was asked for.
    void keep(PointPlan points) { point_plan_ = std::move(points); }
    const PointPlan& point_plan() const noexcept { return point_plan_; }
    /// They are the least that the limits allow: T_ref.
    bool is_reference() const noexcept { return marks_.back().is_reference; }
    /// From the first point to the one after which so many are done; past what is planned as forecast, if
    /// there is a forecast.
    double seconds_to(std::uint64_t points_done) const noexcept;
    /// From `points_done` on to the end at `points_total`; never less than what is planned of it.
    TimeLeft left(std::uint64_t points_done, std::uint64_t points_total) const noexcept;

private:
    using Marks = std::vector<PlannedSoFar>;
    static double seconds_at(const Marks& marks, std::uint64_t points_done) noexcept;
    double forecast_between(std::uint64_t begin, std::uint64_t end) const noexcept;

    Marks marks_{PlannedSoFar{.points = 1}};     ///< the first point is where it begins
    Marks forecast_{PlannedSoFar{.points = 1}};  ///< of the whole table
    PointPlan point_plan_;
};

}  // namespace psicarve::plan
