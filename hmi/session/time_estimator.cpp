// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/time_estimator.hpp"

#include <utility>

#include "hmi/phrase/error_phrase.hpp"

namespace psicarve::session {
namespace {

Result<machine::PlannedTime> plan_by_core(const cam::PreparedJob& job, const std::function<bool()>& goes_on) {
    return machine::planned_time(job.blob, job.view, job.profile, goes_on, true);
}

}  // namespace

TimeEstimator::TimeEstimator(MessageLog& log, Plan plan)
    : log_(log), plan_(plan ? std::move(plan) : plan_by_core) {}

void TimeEstimator::give_up() {
    if (goes_on_) goes_on_->store(false);
    goes_on_.reset();
    queue_.drop_waiting();
}

void TimeEstimator::poll(const Job& wanted, Clock::time_point now) {
    queue_.deliver();
    if (wanted != wanted_) {
        give_up();
        wanted_ = wanted;
        since_ = now;
    }
    const bool is_open = wanted_ && wanted_ != planned_job_ && !goes_on_;
    if (is_open && now - since_ >= kPatience) begin();
}

void TimeEstimator::begin() {
    goes_on_ = std::make_shared<std::atomic<bool>>(true);
    queue_.post([this, job = wanted_, goes_on = goes_on_]() -> BackgroundQueue::Finish {
        const auto planned = plan_(*job, [goes_on] { return goes_on->load(); });
        return [this, job, goes_on, planned] {
            if (!goes_on->load()) return;
            goes_on_.reset();
            planned_job_ = job;
            planned_.reset();
            if (planned) {
                planned_ = *planned;
            } else {
                log_.add(Severity::info, joined(phrase("Planned time"), error_phrase(planned.error())));
            }
        };
    });
}

}  // namespace psicarve::session
