// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/job_estimator.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <utility>

#include "rtcore/plan/carving.hpp"

namespace psicarve::plan {
namespace {

constexpr std::chrono::milliseconds kBeforeIt{100};
constexpr int kLowPriority = 10;  ///< nice

void lower_own_priority() noexcept {
    // Refused or not: it only asks for less. On Linux each thread has a niceness of its own.
    static_cast<void>(setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kLowPriority));
}

// The first point is reached before the carving begins.
PlannedSoFar with_first_point(PlannedSoFar planned) noexcept {
    ++planned.points;
    return planned;
}

}  // namespace

JobEstimator::JobEstimator(const Profile& profile)
    : limits_(machine_limits(profile)), thread_([this] { run(); }) {}

JobEstimator::~JobEstimator() {
    {
        const std::lock_guard lock(mutex_);
        must_end_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void JobEstimator::begin(std::shared_ptr<const JobView> job) {
    {
        const std::lock_guard lock(mutex_);
        job_ = std::move(job);
        estimate_.reset();
        ++edition_;
    }
    changed_.notify_all();
}

void JobEstimator::set_paused(bool is_paused) {
    {
        const std::lock_guard lock(mutex_);
        if (is_paused_ == is_paused) return;
        is_paused_ = is_paused;
    }
    changed_.notify_all();
}

std::shared_ptr<const JobEstimate> JobEstimator::estimate() const {
    const std::lock_guard lock(mutex_);
    return estimate_;
}

bool JobEstimator::wait(std::chrono::milliseconds limit) const {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, limit, [this] { return estimate_ != nullptr; });
}

void JobEstimator::run() {
    lower_own_priority();
    std::uint64_t edition = 0;
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [&] { return must_end_ || edition_ != edition; });
        if (must_end_) return;
        edition = edition_;
        const auto job = job_;
        const bool is_overtaken =
            changed_.wait_for(lock, kBeforeIt, [&] { return must_end_ || edition_ != edition; });
        if (is_overtaken || job == nullptr) continue;
        lock.unlock();
        plan(job, edition);
        lock.lock();
    }
}

bool JobEstimator::is_overtaken(std::uint64_t edition, std::unique_lock<std::mutex>& lock) {
    changed_.wait(lock, [&] { return !is_paused_ || must_end_ || edition_ != edition; });
    return must_end_ || edition_ != edition;
}

void JobEstimator::plan(const std::shared_ptr<const JobView>& job, std::uint64_t edition) {
    const auto program = carving_of(limits_, job);
    auto estimate = std::make_shared<JobEstimate>();
    cycle::MotionBlock block{};
    std::uint64_t points = 0;
    while (program->next(block)) {
        const PlannedSoFar planned = program->planned();
        if (planned.points == points) continue;
        points = planned.points;
        std::unique_lock lock(mutex_);
        if (is_overtaken(edition, lock)) return;
        estimate->add(with_first_point(planned));
    }
    estimate->add(with_first_point(program->planned()));
    {
        const std::lock_guard lock(mutex_);
        if (edition_ == edition) estimate_ = std::move(estimate);
    }
    changed_.notify_all();
}

}  // namespace psicarve::plan
