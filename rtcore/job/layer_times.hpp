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

/// That into a file, whose content goes, or into a descriptor's (/proc/self/fd/N).
Result<void> write_layer_times(const std::string& path, const plan::JobEstimate& estimate,
                               const JobView& job);

/// Has them written beside the supervisor's thread, which waits for no disk.
class LayerTimesFile {
public:
    /// `path` empty: nobody asks. `files`, which writes, outlives this.
    LayerTimesFile(std::string path, rtcore::SideThread& files) : path_(std::move(path)), files_(&files) {}

    /// Again and again, with what is known of the job at hand; null: nothing yet. True once the times are
    /// written, were refused, or wait for a disk that hangs: then whoever asks may be told that they are
    /// known.
    bool tell(const std::shared_ptr<const plan::JobEstimate>& estimate,
              const std::shared_ptr<const LoadedJob>& job);

private:
    std::string path_;
    rtcore::SideThread* files_;
    std::shared_ptr<const plan::JobEstimate> told_;
    std::shared_ptr<std::atomic<bool>> is_written_;
    std::chrono::steady_clock::time_point begun_{};
};

}  // namespace psicarve::supervisor
