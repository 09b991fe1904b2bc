// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>

#include "hmi/cam/prepared_job.hpp"
#include "hmi/machine/planned_time.hpp"
#include "hmi/session/background_queue.hpp"
#include "hmi/session/message_log.hpp"

namespace psicarve::session {

/// Lets a private core plan how long the open job takes, as `psicarve estimate` does, on a thread of its own.
/// All calls come from one thread, the owner's.
class TimeEstimator {
public:
    using Clock = std::chrono::steady_clock;
    using Job = std::shared_ptr<const cam::PreparedJob>;
    using Plan = std::function<Result<machine::PlannedTime>(const cam::PreparedJob&,
                                                            const std::function<bool()>& goes_on)>;
    /// A job that is published within this time is planned by the machine's own core.
    static constexpr std::chrono::milliseconds kPatience{1000};

    explicit TimeEstimator(MessageLog& log, Plan plan = {});
    /// Ends the task under way and waits for it.
    ~TimeEstimator() { give_up(); }

    /// Call it at screen rate. `wanted`: the job whose time is not known; null: there is none, or the
    /// computer is needed for something else. Another job ends the task under way.
    void poll(const Job& wanted, Clock::time_point now);
    bool is_planning() const noexcept { return goes_on_ != nullptr; }
    /// Nothing until it is known.
    std::optional<machine::PlannedTime> planned(const Job& job) const {
        return job && job == planned_job_ ? planned_ : std::nullopt;
    }

    /// It was tried, and said why in the log.
    bool has_failed(const Job& job) const noexcept { return job && job == planned_job_ && !planned_; }

private:
    void begin();
    void give_up();

    MessageLog& log_;
    Plan plan_;
    Job wanted_;
    Clock::time_point since_{};
    Job planned_job_;  ///< also one that could not be planned
    std::optional<machine::PlannedTime> planned_;
    std::shared_ptr<std::atomic<bool>> goes_on_;  ///< shared with the task under way
    BackgroundQueue queue_{BackgroundQueue::Haste::background};
};

}  // namespace psicarve::session
