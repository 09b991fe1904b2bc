// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/job_estimator.hpp"

#include <optional>
#include <utility>
#include <vector>

#include "rtcore/plan/approach.hpp"
#include "rtcore/plan/carving.hpp"
#include "rtcore/plan/point_times.hpp"
#include "rtcore/plan/time_forecast.hpp"
#include "rtcore/process/handler_stack.hpp"
#include "rtcore/process/side_thread.hpp"

namespace psicarve::plan {
namespace {

constexpr std::chrono::milliseconds kBeforeIt{100};

// The first point is reached before the carving begins.
PlannedSoFar with_first_point(PlannedSoFar planned) noexcept {
    ++planned.points;
    return planned;
}

}  // namespace

JobEstimator::JobEstimator(const Profile& profile, bool keeps_points)
    : limits_(machine_limits(profile)), keeps_points_(keeps_points), thread_([this] { run(); }) {}

JobEstimator::~JobEstimator() {
    {
        const std::lock_guard lock(mutex_);
        must_end_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void JobEstimator::begin(std::shared_ptr<const JobView> job) {
    next_job_ = std::move(job);
    has_next_job_ = true;
    whole_ = nullptr;
    last_left_ = {};
    static_cast<void>(look());
}

// Its thread is of low priority: interrupted while it holds the mutex, it keeps it until no other thread is
// busy.
std::unique_lock<std::mutex> JobEstimator::look() {
    std::unique_lock lock(mutex_, std::try_to_lock);
    if (lock) exchange_with_thread();
    return lock;
}

void JobEstimator::exchange_with_thread() {
    if (!has_next_job_) {
        if (is_whole_) whole_ = estimate_;
        return;
    }
    has_next_job_ = false;
    job_ = std::move(next_job_);
    estimate_ = std::make_shared<JobEstimate>();
    is_whole_ = false;
    ++edition_;
    changed_.notify_all();
}

std::shared_ptr<const JobEstimate> JobEstimator::estimate() {
    if (whole_ == nullptr) static_cast<void>(look());
    return whole_;
}

TimeLeft JobEstimator::left(std::uint64_t points_done, std::uint64_t points_total) {
    if (points_total == 0) return {};
    if (whole_ != nullptr) return whole_->left(points_done, points_total);
    if (const auto lock = look()) {
        last_left_ = estimate_ != nullptr ? estimate_->left(points_done, points_total) : TimeLeft{};
    }
    return last_left_;
}

bool JobEstimator::wait(std::chrono::milliseconds limit) {
    std::unique_lock lock(mutex_);
    exchange_with_thread();
    if (!changed_.wait_for(lock, limit, [this] { return is_whole_; })) return false;
    exchange_with_thread();
    return true;
}

void JobEstimator::run() {
    const rtcore::HandlerStack handler_stack;
    rtcore::lower_own_priority();
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

bool JobEstimator::change(std::uint64_t edition, const std::function<void(JobEstimate&)>& change) {
    const std::lock_guard lock(mutex_);
    if (must_end_ || edition_ != edition) return false;
    change(*estimate_);
    return true;
}

void JobEstimator::plan(const std::shared_ptr<const JobView>& job, std::uint64_t edition) {
    const MachineLimits limits = limits_for(limits_, *job);
    TimeForecast forecast(limits, job);
    while (forecast.next()) {
        if (!change(edition, [](JobEstimate& /*estimate*/) {})) return;
    }
    const std::vector<double> ends_s = forecast.layer_ends_seconds();
    if (!change(edition, [&](JobEstimate& estimate) { estimate.forecast(ends_s, job->point_count()); }))
        return;
    const auto program = carving_of(limits, job);
    cycle::MotionBlock block{};
    std::uint64_t points = 0;
    std::optional<PointTimes> times;
    if (keeps_points_) times.emplace(limits, *job);
    while (program->next(block)) {
        if (times) times->add(block);
        const PlannedSoFar planned = program->planned();
        if (planned.points == points) continue;
        points = planned.points;
        if (!change(edition, [&](JobEstimate& estimate) { estimate.add(with_first_point(planned)); })) return;
    }
    const bool is_done = change(edition, [&](JobEstimate& estimate) {
        estimate.add(with_first_point(program->planned()));
        if (times) estimate.keep(times->take());
        is_whole_ = true;
    });
    if (is_done) changed_.notify_all();
}

}  // namespace psicarve::plan
