// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

#include "rtcore/checkpoint/piece_memory.hpp"
#include "rtcore/job/job_loader.hpp"
#include "rtcore/job/layer_times.hpp"
#include "rtcore/job/loaded_job.hpp"
#include "rtcore/journal/journal.hpp"
#include "rtcore/realtime/promptness.hpp"
#include "rtcore/supervisor/command_server.hpp"
#include "rtcore/supervisor/core_parts.hpp"
#include "rtcore/supervisor/flight_log.hpp"
#include "rtcore/supervisor/pin_recording.hpp"
#include "rtcore/supervisor/program_access.hpp"
#include "rtcore/supervisor/status_mirror.hpp"
#include "rtcore/supervisor/stop_listener.hpp"
#include "shared/segment/segment.hpp"

namespace psicarve::supervisor {

/// What a round of the supervisor takes from the segment. Urgent words (stop, emergency stop, a reader that
/// is gone) are heard and the heart beats in each.
enum class Hearing : std::uint8_t { everything, urgent_words };

/// Serves the segment: jobs and commands in, status, increments and flight recorder out, all through the
/// lock-free rings to the tick. Besides its StopListener nothing in the core touches shared memory. One
/// thread's; not for the tick. Its members: parts, each for one thing that is served, and what of jobs, of
/// the segment and of the end is none of theirs.
class Supervisor {
public:
    Supervisor(CoreParts& parts, const SegmentOptions& segment_options, Segment segment,
               const CoreFacts& facts);
    ~Supervisor() { parts_->traces.set_recording_taker({}); }
    Supervisor(const Supervisor&) = delete;
    Supervisor& operator=(const Supervisor&) = delete;

    /// One round. True when something was handed to the tick. Commands, jobs and a jog's lease wait for a
    /// round that hears everything.
    bool poll(Hearing hearing = Hearing::everything);
    /// Sleeps until a command or job comes, or the limit passes. On the real clock a sender
    /// does not keep us from it: the next round's commands are taken before anything ordinary runs.
    void wait(std::chrono::nanoseconds limit) noexcept;
    /// The tick has been asked for something, and what came of it is not known yet.
    bool awaits_answer() const noexcept {
        return server_.awaits_answer() || loading_job_ != nullptr || loader_.is_busy();
    }

    /// On the real clock, once the tick runs: stops are heard between any two rounds, too, by a thread of
    /// their own.
    void listen_for_stops() { listener_.listen(); }

    /// Before a job may be published, on the virtual clock: the job that an earlier core has left is loaded
    /// while the machine settles, and no tick passes for it later.
    void load_left_job() { take_job(); }

    /// Before the first round. Without it there are no programs.
    void set_program_access(ProgramAccess access);
    /// Makes it ready for the planner, or says why it cannot be run.
    Result<void> open_program(std::uint64_t program);

    void set_lateness(const LatenessFacts& lateness) noexcept { mirror_.set_lateness(lateness); }
    void set_realtime(const RealtimeFacts& realtime) noexcept { mirror_.set_realtime(realtime); }
    /// Asks the tick for something on the supervisor's own account; answers to it go nowhere. False: too much
    /// else waits for the tick, ask again.
    [[nodiscard]] bool request(cycle::RequestKind kind, std::uint64_t value = 0, std::uint8_t axis = 0);
    /// `failure`: cycle::failure_bits(). Seen at the next tick, whatever else waits.
    void fail(std::uint64_t failure) noexcept { parts_->io->urgent.failures.fetch_or(failure); }
    /// On the real clock, every round: the tick watches over us as long as we tell it.
    void note_round() noexcept { parts_->io->urgent.rounds.fetch_add(1, std::memory_order_relaxed); }
    void request_stop() noexcept { parts_->io->urgent.stop_requests.fetch_add(1); }
    void request_emergency_stop() noexcept { parts_->io->urgent.estop_requests.fetch_add(1); }

    /// The simulated machine's counters stay as they are now, whatever it still does.
    void freeze_machine() noexcept {
        publish_status();
        is_machine_frozen_ = true;
    }
    /// From here on every command is refused with this reason, but for shutdown.
    void refuse_commands(const Message& why) noexcept { server_.refuse_all(why); }

    /// On the virtual clock: time stands still until the process that has the pins recorded has read more, or
    /// is gone.
    bool must_wait_for_reader() const noexcept {
        return is_virtual_clock_ && recording_.is_reader_behind(segment_->header());
    }

    bool shutdown_requested() const noexcept { return server_.shutdown_requested(); }
    const cycle::Sample& sample() const noexcept { return sample_; }
    Segment& segment() noexcept { return *segment_; }
    /// The last thing: status as it stands, and the segment is not served any more.
    void leave();

private:
    cycle::Sample read_sample() const;
    bool take_requests();
    void mirror_jog_lease();
    void take_job();
    void judge_job(JobLoader::Outcome outcome);
    void offer_job(std::shared_ptr<const LoadedJob> job);
    void hand_out(const std::shared_ptr<const LoadedJob>& job);
    void finish_job(const cycle::Report& report);
    void drain_reports();
    void drain_increments();
    void watch_recording();
    void note_checkpoint();
    PlannedTimes planned_times();
    void publish_status();
    void watch_guard();
    void watch_sleep();
    void check_segment();
    void take_new_segment();
    /// Into the segment: who drives what.
    void introduce();

    static constexpr std::uint64_t kOwnRequest = 0;  ///< sequence of requests without a waiting sender
    static constexpr std::uint64_t kJobRequest = ~std::uint64_t{0};

    CoreParts* parts_;
    SegmentOptions segment_options_;
    std::shared_ptr<Segment> segment_;  ///< shared with readers of a job in it
    StopListener listener_;             ///< at segment_
    CommandServer server_;
    StatusMirror mirror_;
    PinRecording recording_;
    PieceMemory piece_;
    Journal journal_;
    FlightLog flight_log_;
    ProgramAccess programs_;
    bool is_virtual_clock_;
    rtcore::Promptness promptness_;
    cycle::Sample sample_;
    std::uint32_t wake_seen_ = 0;
    std::chrono::steady_clock::time_point jog_renewed_{};
    std::uint64_t judged_generation_;               ///< the newest that was published and judged
    std::uint64_t seen_generation_ = 0;             ///< the word as it was looked at last
    std::shared_ptr<const LoadedJob> loading_job_;  ///< offered to the tick, not answered yet
    std::shared_ptr<const LoadedJob> job_;
    JobLoader loader_;
    bool is_look_stale_ = false;   ///< the loader looks into a segment that was replaced
    bool is_offer_stale_ = false;  ///< loading_job_ came from one
    LayerTimesFile layer_times_;
    std::uint64_t changes_ = 0;  ///< state changes and alarms mirrored so far
    std::uint64_t changes_told_ = 0;
    std::chrono::steady_clock::time_point next_segment_check_{};
    std::int64_t slept_ns_ = 0;
    bool is_segment_lost_ = false;
    bool is_guard_lost_told_ = false;
    bool must_end_recording_ = false;
    bool is_machine_frozen_ = false;
};

}  // namespace psicarve::supervisor
