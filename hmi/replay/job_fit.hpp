// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>

#include "hmi/replay/trace_cursor.hpp"
#include "hmi/surface/job_geometry.hpp"

namespace psicarve::replay {

/// Whether a trace belongs to a job: counts the places where the machine carved, and those at which both
/// heads stood where that job has them at this height and angle.
struct JobFit {
    static constexpr std::size_t kLeastPlaces = 8;

    std::size_t places = 0;
    std::size_t fitting = 0;

    /// A trace that carves next to nothing, a dry run for example, shows no job.
    bool is_known() const noexcept { return places >= kLeastPlaces; }
    /// Ways between layers belong to no layer: so nine of ten places fit at least. Of the same model carved
    /// zigzag half of them fit, of another one hardly any.
    bool is_its_job() const noexcept { return is_known() && 4 * fitting > 3 * places; }
};

/// Tests some hundred instants.
Result<JobFit> job_fit(std::shared_ptr<const TraceIndex> index, const verify::JobGeometry& geometry);

}  // namespace psicarve::replay
