// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>

#include "rtcore/cycle/cycle_io.hpp"
#include "rtcore/plan/machine_limits.hpp"
#include "rtcore/plan/program.hpp"
#include "rtcore/plan/program_step.hpp"
#include "shared/job/job.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::plan {

/// Turns the tick's plan requests into motion blocks, ahead of it. On the real clock poll() runs in a thread
/// of its own; on the virtual clock between ticks. What the tick does with the blocks does not depend on how
/// often poll() is called, as long as it is called whenever wants_poll() says so. Not for the tick:
/// allocates.
class Planner {
public:
    Planner(const Profile& profile, cycle::CycleIo& io);

    /// Any thread. A job that the tick may be asked to start, by its generation; the one before it stays
    /// known, should the tick refuse this one. A program that runs keeps the one it began with. The pointer
    /// keeps the view's blob alive: std::shared_ptr<const JobView>(loaded, &loaded->view).
    void set_job(std::shared_ptr<const JobView> job, std::uint64_t generation);

    /// Any thread. A program that the tick may be asked to run, by its number; it is run once, and the one
    /// before it is forgotten unless it runs.
    void set_source(std::shared_ptr<StepSource> source, std::uint64_t program);

    /// Planner's thread. Cheap: a request waits, or an unfinished program's queue is at most half full.
    bool wants_poll() const noexcept;
    /// Planner's thread. Takes the newest request and queues as many blocks as fit. That may be seconds of
    /// work: a caller with other duties is asked after each block whether there is time for more.
    void poll(const std::function<bool()>& has_time = {});

    /// Planner's thread. All that was queued may be done before more of the program comes: its next steps are
    /// awaited.
    bool is_waiting() const noexcept { return program_ != nullptr && program_->is_waiting(); }

    /// Any thread. After how many points of its job the carving that was asked for last ends; 0: none was.
    std::uint64_t points_total() const noexcept { return points_total_.load(std::memory_order_relaxed); }
    /// Any thread. T_ref of the job last planned to its end; negative: there is none.
    double reference_seconds() const noexcept { return reference_seconds_.load(std::memory_order_relaxed); }

private:
    void take_requests();
    std::unique_ptr<Program> program_of_records(const cycle::PlanRequest& request);
    std::unique_ptr<Program> program_for(const cycle::PlanRequest& request);

    MachineLimits limits_;  ///< with the blank of job_
    cycle::CycleIo* io_;
    std::mutex job_mutex_;
    struct KnownJob {
        std::shared_ptr<const JobView> job;
        std::uint64_t generation = 0;
        double blank_radius_mm = 0.0;  ///< that it was made for
    };
    KnownJob known(std::uint64_t generation);
    std::array<KnownJob, 2> known_;  ///< the newest first; guarded by job_mutex_
    struct KnownSource {
        std::shared_ptr<StepSource> source;
        std::uint64_t program = 0;
    };
    KnownSource known_source_;  ///< guarded by job_mutex_
    std::shared_ptr<const JobView> job_;
    std::unique_ptr<Program> program_;
    cycle::MotionBlock pending_{};  ///< made, but the queue was full
    bool has_pending_ = false;
    std::uint32_t epoch_ = 0;
    std::atomic<std::uint64_t> points_total_{0};
    std::atomic<double> reference_seconds_{-1.0};
};

}  // namespace psicarve::plan
