// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>

#include "rtcore/plan/cycle_config_from_profile.hpp"
#include "rtcore/supervisor/outlets.hpp"
#include "rtcore/supervisor/run_loops.hpp"

namespace psicarve::supervisor {
namespace {

constexpr std::uint64_t kTicksPerSlice = 4096;  ///< so few that the trace ring cannot overflow in one
constexpr std::uint64_t kLongestSlice = trace::kTraceRingEntries / 2;
constexpr std::uint64_t kSettleTicks = 16;  ///< after coming to rest: pins fall, filters settle
constexpr std::chrono::milliseconds kIdleWait{20};
constexpr std::chrono::milliseconds kReaderWait{1};
constexpr std::chrono::milliseconds kLongestSilence{20};  ///< of the core while it plans

/// Decides which ticks virtual time has. At rest a tick passes only to take a request, so that the moment a
/// command comes in from another process does not show in the trace.
class VirtualTime {
public:
    VirtualTime(CoreParts& parts, RecordDirector* record, Supervisor& supervisor)
        : parts_(&parts),
          record_(record),
          supervisor_(&supervisor),
          settle_ticks_(settle_ticks_of(parts.profile)),
          settle_left_(settle_ticks_) {}

    /// Runs one slice, less when the machine comes to rest. False when no tick was due.
    bool run_slice(bool has_urgent_words) {
        bool has_run = false;
        if (has_urgent_words && !has_work()) {
            tick();
            has_run = true;
        }
        for (std::uint64_t n = 0; (n < kTicksPerSlice || (is_settling() && n < kLongestSlice)) && has_work();
             ++n) {
            tick();
            has_run = true;
        }
        return has_run;
    }

    /// While a reader is behind: what was asked for takes effect, and nothing else happens.
    void run_one_tick() {
        constexpr std::size_t kMostEntries = 64;  // of one tick
        if (parts_->trace_ring->size() + kMostEntries < trace::TraceRing::capacity()) tick();
    }

private:
    bool is_settling() const { return settle_left_ > 0 && is_at_rest(parts_->cycle->state()); }
    bool has_work() const {
        if (settle_left_ > 0 || parts_->io->requests.size() > 0) return true;
        if (parts_->io->replayed_requests.size() > 0 || parts_->io->urgent.failures.load() != 0) return true;
        return record_ != nullptr && record_->has_begun() && !record_->is_over(parts_->cycle->next_tick());
    }
    void tick() {
        if (record_ != nullptr) record_->before_tick(parts_->cycle->next_tick(), *parts_);
        if (parts_->planner->wants_poll()) plan();
        parts_->cycle->tick();
        if (!is_at_rest(parts_->cycle->state())) {
            settle_left_ = settle_ticks_;
        } else if (settle_left_ > 0) {
            --settle_left_;
        }
    }

    /// The planner has no thread of its own here: others are heard and answered while it works, and what they
    /// ask of the tick does not wait for the whole plan.
    void plan() {
        auto last_heard = std::chrono::steady_clock::now();
        parts_->planner->poll([&] {
            if (std::chrono::steady_clock::now() - last_heard < kLongestSilence) return true;
            const bool has_news = supervisor_->poll();
            last_heard = std::chrono::steady_clock::now();
            return !has_news;
        });
    }

    CoreParts* parts_;
    RecordDirector* record_;
    Supervisor* supervisor_;
    /// So long after its last pulse an axis may still be turning: it must come to rest before time stands
    /// still.
    static std::uint64_t settle_ticks_of(const Profile& profile) {
        std::int64_t longest_ticks = 0;
        for (const auto& axis : plan::cycle_config_from_profile(profile).axes) {
            longest_ticks = std::max(longest_ticks, axis.coast_ticks);
        }
        return kSettleTicks + static_cast<std::uint64_t>(longest_ticks);
    }

    std::uint64_t settle_ticks_;
    std::uint64_t settle_left_;
};

}  // namespace

int run_on_virtual_clock(CoreParts& parts, Supervisor& supervisor, const Directors& directors,
                         EndRequest& end) {
    VirtualTime time{parts, directors.record, supervisor};
    int exit_code = kExitDone;
    time.run_slice(false);
    for (;;) {
        move_traces(parts);
        const bool has_news = supervisor.poll();
        if (directors.job != nullptr) {
            const auto progress = directors.job->poll(supervisor);
            if (progress == JobDirector::Progress::alarm) exit_code = kExitAlarm;
            if (progress != JobDirector::Progress::going_on) break;
        }
        if (directors.record != nullptr) {
            const std::uint64_t next_tick = parts.cycle->next_tick();
            if (!directors.record->has_begun() && supervisor.sample().job_generation != 0) {
                directors.record->begin(next_tick);
            } else if (directors.record->is_over(next_tick)) {
                if (supervisor.sample().state == MachineState::alarm) exit_code = kExitAlarm;
                break;
            }
        }
        const auto ending = end.poll(supervisor);
        if (ending == EndRequest::Progress::may_end || supervisor.shutdown_requested()) break;
        const bool must_be_heard = has_news || ending == EndRequest::Progress::told_tick;
        if (supervisor.must_wait_for_reader() || parts.trace_ring->size() > 0) {
            if (must_be_heard) time.run_one_tick();
            supervisor.wait(kReaderWait);
            continue;
        }
        if (!time.run_slice(must_be_heard)) {
            parts.traces.flush();
            supervisor.wait(kIdleWait);
        }
    }
    // A recorded run may end in full motion: what the machine makes of drives that go off then is not part of
    // it.
    supervisor.freeze_machine();
    parts.cycle->shut_down();
    finish_whole_traces(parts);
    return exit_code;
}

}  // namespace psicarve::supervisor
