// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <string>

#include "rtcore/job/loaded_job.hpp"
#include "rtcore/plan/job_estimate.hpp"
#include "rtcore/process/side_thread.hpp"
#include "shared/base/result.hpp"
#include "shared/job/job.hpp"

namespace psicarve::supervisor {

/// "layer,seconds": when each of a job's layers is over as planned, counted from the job's first point.
std::string layer_times_csv(const plan::JobEstimate& estimate, const JobView& job);

/// Where they go, and where each point's (PointPlan): a file, whose content is replaced, or `fd:N`, an open
/// descriptor's. Empty: nowhere.
struct PlannedFiles {
    std::string layers;
    std::string points;
    bool are_wanted() const noexcept { return !layers.empty() || !points.empty(); }
};
Result<void> write_planned(const PlannedFiles& files, const plan::JobEstimate& estimate, const JobView& job);

/// Writes them in another thread than the supervisor's, which waits for no disk.
class LayerTimesFile {
public:
    /// `files`, the thread that writes, outlives this.
    LayerTimesFile(PlannedFiles wanted, rtcore::SideThread& files)
        : wanted_(std::move(wanted)), files_(&files) {}

    /// Call it repeatedly, with the estimate of the job at hand; null: none yet. True once the times are
    /// written, were refused, or wait for a disk that hangs: then the supervisor may report that they are
    /// known.
    bool tell(const std::shared_ptr<const plan::JobEstimate>& estimate,
              const std::shared_ptr<const LoadedJob>& job);

private:
    PlannedFiles wanted_;
    rtcore::SideThread* files_;
    std::shared_ptr<const plan::JobEstimate> told_;
    std::shared_ptr<std::atomic<bool>> is_written_;
    std::chrono::steady_clock::time_point begun_{};
};

}  // namespace psicarve::supervisor
