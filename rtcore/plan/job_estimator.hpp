// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <thread>

#include "rtcore/plan/job_estimate.hpp"
#include "rtcore/plan/machine_limits.hpp"
#include "shared/job.hpp"
#include "shared/profile.hpp"

namespace psicarve::plan {

/// Plans a job from end to end only to know how long it takes, in a low-priority thread of its own: so the
/// time is known before anything moves, and the time left while it runs does not depend on how far the
/// planner has come. Nothing waits for it, and no motion depends on it. Not for the tick.
class JobEstimator {
public:
    explicit JobEstimator(const Profile& profile);
    ~JobEstimator();
    JobEstimator(const JobEstimator&) = delete;
    JobEstimator& operator=(const JobEstimator&) = delete;

    /// Any thread, as all of these. Begins with this job, after a moment: one that is started at once has the
    /// computer to itself first. What was known is of another job and forgotten. The pointer keeps the view's
    /// blob alive.
    void begin(std::shared_ptr<const JobView> job);
    /// Goes on when it is false again.
    void set_paused(bool is_paused);
    /// Of the job, when all of it is planned; else null.
    std::shared_ptr<const JobEstimate> estimate() const;
    /// Waits until there is one.
    bool wait(std::chrono::milliseconds limit) const;

private:
    void run();
    bool is_overtaken(std::uint64_t edition, std::unique_lock<std::mutex>& lock);
    void plan(const std::shared_ptr<const JobView>& job, std::uint64_t edition);

    MachineLimits limits_;
    mutable std::mutex mutex_;  // guards all that follow
    mutable std::condition_variable changed_;
    std::shared_ptr<const JobView> job_;
    std::shared_ptr<const JobEstimate> estimate_;
    std::uint64_t edition_ = 0;  ///< grows with each job
    bool is_paused_ = false;
    bool must_end_ = false;
    std::thread thread_;  // last: it uses the others
};

}  // namespace psicarve::plan
