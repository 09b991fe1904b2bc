// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>

#include "rtcore/cycle/cycle_io.hpp"
#include "rtcore/plan/job_estimate.hpp"
#include "rtcore/plan/machine_limits.hpp"
#include "rtcore/plan/program.hpp"
#include "shared/job.hpp"
#include "shared/profile.hpp"

namespace psicarve::plan {

/// Turns the tick's plan requests into motion blocks, ahead of it. On the real clock poll() runs in a thread
/// of its own; on the virtual clock between ticks. What the tick does with the blocks does not depend on how
/// often poll() is called, as long as it is called whenever wants_poll() says so. Not for the tick:
/// allocates.
class Planner {
public:
    Planner(const Profile& profile, cycle::CycleIo& io);

    /// Any thread. The job for the next `start`; a program that runs keeps the one it began with. The pointer
    /// keeps the view's blob alive: std::shared_ptr<const JobView>(loaded, &loaded->view).
    void set_job(std::shared_ptr<const JobView> job);

    /// Planner's thread. Cheap: a request waits, or an unfinished program's queue is at most half full.
    bool wants_poll() const noexcept;
    /// Planner's thread. Takes the newest request and queues as many blocks as fit. That may be seconds of
    /// work: whoever has other duties is asked after each block whether there is time for more.
    void poll(const std::function<bool()>& has_time = {});

    /// Any thread. For the running job with so many points reached; negative: unknown. Without an estimate of
    /// the whole job from how far it is planned.
    double seconds_left(std::uint64_t points_done, const JobEstimate* estimate = nullptr) const noexcept;
    /// Any thread. T_ref of the job last planned to its end; negative: there is none.
    double reference_seconds() const noexcept { return reference_seconds_.load(std::memory_order_relaxed); }

private:
    void take_requests();
    std::unique_ptr<Program> program_for(const cycle::PlanRequest& request);

    MachineLimits limits_;
    cycle::CycleIo* io_;
    std::mutex job_mutex_;
    std::shared_ptr<const JobView> next_job_;  ///< guarded by job_mutex_
    std::shared_ptr<const JobView> job_;
    std::unique_ptr<Program> program_;
    cycle::MotionBlock pending_{};  ///< made, but the queue was full
    bool has_pending_ = false;
    std::uint32_t epoch_ = 0;
    std::atomic<std::uint64_t> points_total_{0};
    std::atomic<std::uint64_t> points_planned_{0};
    std::atomic<double> seconds_planned_{0.0};
    std::atomic<double> reference_seconds_{-1.0};
};

}  // namespace psicarve::plan
