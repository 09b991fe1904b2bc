// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "rtcore/plan/job_estimate.hpp"
#include "rtcore/plan/machine_limits.hpp"
#include "shared/job/job.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::plan {

/// Plans a job from end to end only to know how long it takes, in a low-priority thread of its own: so the
/// time is known before anything moves, and the time left while it runs does not depend on how far the
/// planner has come. Nothing waits for it, and no motion depends on it. Not for the tick.
class JobEstimator {
public:
    /// `keeps_points`: each point by itself, too, 5 bytes a point.
    explicit JobEstimator(const Profile& profile, bool keeps_points = false);
    ~JobEstimator();
    JobEstimator(const JobEstimator&) = delete;
    JobEstimator& operator=(const JobEstimator&) = delete;

    /// Begins with this job, after a moment: one that is started at once has the computer to itself first.
    /// What was known is of another job and forgotten. The pointer keeps the view's blob alive. All methods
    /// are those of one thread, which never waits for the other but in wait(): an answer may be the last one.
    void begin(std::shared_ptr<const JobView> job);
    /// Of the job, when all of it is planned; else null.
    std::shared_ptr<const JobEstimate> estimate();
    /// Of a run of the job that ends at `points_total`; not known until there is a forecast, a moment after
    /// the job has begun to be planned.
    TimeLeft left(std::uint64_t points_done, std::uint64_t points_total);
    /// Waits until there is one.
    bool wait(std::chrono::milliseconds limit);

private:
    /// With the mutex, unless the thread has it.
    std::unique_lock<std::mutex> look();
    void exchange_with_thread();
    void run();
    void plan(const std::shared_ptr<const JobView>& job, std::uint64_t edition);
    /// Does something to the estimate; false, and nothing is done: another job has come.
    bool change(std::uint64_t edition, const std::function<void(JobEstimate&)>& change);

    MachineLimits limits_;
    bool keeps_points_;
    std::shared_ptr<const JobView> next_job_;  ///< not handed over yet
    bool has_next_job_ = false;
    std::shared_ptr<const JobEstimate> whole_;
    TimeLeft last_left_;
    std::mutex mutex_;  // guards all that follow
    std::condition_variable changed_;
    std::shared_ptr<const JobView> job_;
    std::shared_ptr<JobEstimate> estimate_;  ///< grows until it is whole; replaced with each job
    bool is_whole_ = false;
    std::uint64_t edition_ = 0;  ///< grows with each job
    bool must_end_ = false;
    std::thread thread_;  // last: it uses the others
};

}  // namespace psicarve::plan
