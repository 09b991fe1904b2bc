// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <optional>

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
constexpr std::uint64_t kBlocksPerLook = 1024;            ///< planned between two looks at ordinary requests
/// A reader that stands still for longer keeps no request waiting.
constexpr std::chrono::milliseconds kReaderPatience{250};

/// Decides which ticks virtual time has, and which of them may take a request. At rest a tick passes only for
/// one, after the machine has settled; in motion they are taken at fixed places of ticks and of the plan. So
/// the moment a command comes in from another process does not show in the trace.
class VirtualTime {
public:
    VirtualTime(CoreParts& parts, RecordDirector* record, Supervisor& supervisor)
        : parts_(&parts),
          record_(record),
          supervisor_(&supervisor),
          settle_ticks_(settle_ticks_of(parts.profile)),
          settle_left_(settle_ticks_) {}

    /// Has come to rest, but pins or rotors have not: what comes in now waits, lest the trace tell when it
    /// came.
    bool is_settling() const { return settle_left_ > 0 && is_at_rest(parts_->cycle->state()); }

    /// Runs on to the next place where requests are taken, less when the machine comes to rest. False when no
    /// tick was due.
    bool run_slice(bool has_urgent_words) {
        bool has_run = false;
        if (has_urgent_words && (!has_work() || awaits_steps())) {
            tick();
            has_run = true;
        }
        bool is_at_end = false;
        for (std::uint64_t n = 0; n < kLongestSlice && has_work() && !(is_at_end && !is_settling()); ++n) {
            if (awaits_steps()) break;
            tick();
            has_run = true;
            if (parts_->cycle->next_tick() % kTicksPerSlice == 0) is_at_end = true;
        }
        return has_run;
    }

    /// The program that runs has not been written on, and all that was is done, or nothing is queued
    /// behind the part at hand: time stands still until it is, or something is asked for. So how quickly
    /// a program is written does not show in the trace.
    bool awaits_steps() {
        if (!parts_->cycle->awaits_blocks() || parts_->io->requests.size() > 0) return false;
        if (parts_->io->urgent.failures.load() != 0) return false;
        if (parts_->planner->wants_poll() || parts_->planner->is_waiting()) plan();
        return parts_->planner->is_waiting() && parts_->cycle->awaits_blocks();
    }

    /// While a reader is behind: what was asked for takes effect, and nothing else happens.
    void run_one_tick() {
        constexpr std::size_t kMostEntries = 64;  // of one tick
        if (parts_->trace_ring->size() + kMostEntries < trace::TraceRing::capacity()) tick();
    }

private:
    bool has_work() const {
        if (settle_left_ > 0 || parts_->io->requests.size() > 0) return true;
        if (parts_->io->replayed_requests.size() > 0 || parts_->io->urgent.failures.load() != 0) return true;
        return record_ != nullptr && record_->has_begun() && !record_->is_over(parts_->cycle->next_tick());
    }
    void tick() {
        if (record_ != nullptr) record_->before_tick(parts_->cycle->next_tick(), *parts_);
        // How much of a plan is queued when it is dropped follows from the moment at which it is stopped:
        // the next one finds an empty queue. Not earlier, or the planner would go on filling it.
        if (parts_->io->plan_requests.size() > 0) parts_->cycle->drop_overtaken_blocks();
        if (parts_->planner->wants_poll()) plan();
        parts_->cycle->tick();
        if (!is_at_rest(parts_->cycle->state())) {
            settle_left_ = settle_ticks_;
        } else if (settle_left_ > 0) {
            --settle_left_;
        }
        // A program may go on from its hold and end within a tick: what it switched comes to the pins yet.
        if (parts_->cycle->is_switching()) settle_left_ = std::max<std::uint64_t>(settle_left_, 1);
    }

    /// The planner has no thread of its own here: while it works stop and emergency stop are heard and the
    /// heart beats, whatever the clock on the wall says, and at fixed places everything else.
    void plan() {
        const bool rests = is_at_rest(parts_->cycle->state());
        auto last_heard = std::chrono::steady_clock::now();
        parts_->planner->poll([&] {
            const bool is_look = ++blocks_planned_ % kBlocksPerLook == 0 && !rests;
            if (!is_look && std::chrono::steady_clock::now() - last_heard < kLongestSilence) return true;
            const bool has_news = supervisor_->poll(is_look ? Hearing::everything : Hearing::urgent_words);
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
    std::uint64_t blocks_planned_ = 0;  ///< since the core began
};

/// Whether time stands still for a reader, and for how long it has.
class ReaderWatch {
public:
    void note(bool is_held_up) {
        if (is_held_up && !since_) since_ = std::chrono::steady_clock::now();
        if (!is_held_up) since_.reset();
    }
    bool is_held_up() const { return since_.has_value(); }
    bool is_stuck() const { return since_ && std::chrono::steady_clock::now() - *since_ > kReaderPatience; }

private:
    std::optional<std::chrono::steady_clock::time_point> since_;
};

}  // namespace

int run_on_virtual_clock(CoreParts& parts, Supervisor& supervisor, const Directors& directors,
                         EndRequest& end) {
    VirtualTime time{parts, directors.record, supervisor};
    ReaderWatch reader;
    int exit_code = kExitDone;
    time.run_slice(false);
    for (;;) {
        move_traces(parts);
        reader.note(supervisor.must_wait_for_reader() || parts.trace_ring->size() > 0);
        const bool hears_requests = !time.is_settling() || reader.is_stuck();
        const bool has_news = supervisor.poll(hears_requests ? Hearing::everything : Hearing::urgent_words);
        if (directors.job != nullptr) {
            const auto progress = directors.job->poll(supervisor);
            if (progress == JobDirector::Progress::alarm) exit_code = kExitAlarm;
            if (progress != JobDirector::Progress::going_on) break;
        }
        if (directors.record != nullptr) {
            const std::uint64_t next_tick = parts.cycle->next_tick();
            const auto may_begin = [&] {
                return directors.open_program ? directors.open_program()
                                              : supervisor.sample().job_generation != 0;
            };
            if (!directors.record->has_begun()) {
                if (may_begin()) directors.record->begin(next_tick);
            } else if (directors.record->is_over(next_tick)) {
                if (supervisor.sample().state == MachineState::alarm) exit_code = kExitAlarm;
                break;
            }
        }
        const auto ending = end.poll(supervisor);
        const bool may_end = ending == EndRequest::Progress::may_end && hears_requests;
        if (may_end || supervisor.shutdown_requested()) break;
        const bool must_be_heard = has_news || ending == EndRequest::Progress::told_tick;
        if (reader.is_held_up()) {
            if (must_be_heard) time.run_one_tick();
            supervisor.wait(kReaderWait);
            continue;
        }
        if (!time.run_slice(must_be_heard)) {
            parts.traces.flush();
            supervisor.wait(time.awaits_steps() ? kReaderWait : kIdleWait);
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
