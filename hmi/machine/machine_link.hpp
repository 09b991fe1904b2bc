// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "shared/base/result.hpp"
#include "shared/machine/command.hpp"
#include "shared/machine/status.hpp"
#include "shared/segment/segment.hpp"

namespace psicarve::machine {

/// A core that holds its lock but writes no status for this long is stopped or hangs.
inline constexpr std::chrono::milliseconds kSilenceLimit{3000};
inline constexpr std::chrono::milliseconds kCommandLimit{5000};
/// Copying and checking the largest job takes a while on a small machine; a dead core is noticed at once.
inline constexpr std::chrono::milliseconds kAcceptanceLimit{60'000};

/// Called with every new status during a wait (at least every 100 ms); an error ends the wait.
using StatusWatch = std::function<Result<void>(const CoreStatus&)>;

/// "alarm: limit of r1 (tick 123): what to do". Requires an alarm in the status.
Error alarm_error(const CoreStatus& status);

/// The segment seen from the operator's side. One thread.
class MachineLink {
public:
    /// no_core when there is no such segment.
    static Result<MachineLink> attach(const std::string& segment_name, const std::string& group = {});
    /// Segment::attach_to_stop().
    static Result<MachineLink> attach_to_stop(const std::string& segment_name);
    static Result<MachineLink> create_or_attach(const SegmentOptions& options);

    Segment& segment() noexcept { return segment_; }
    const Segment& segment() const noexcept { return segment_; }
    const std::string& segment_name() const noexcept { return segment_.name(); }
    std::optional<std::uint32_t> core_pid() const noexcept { return segment_.core_pid(); }
    /// Success when a living core serves the segment.
    Result<void> require_core() const;

    /// The last status that the core, or a dead one, wrote; nothing when none ever did.
    std::optional<CoreStatus> last_status() const noexcept;
    /// The port of the core, or of a dead one, as --port names it; empty: not known.
    std::string port_name() const;
    /// How far the last carving has come, checked; nothing when there was none.
    std::optional<Checkpoint> checkpoint() const noexcept;
    /// The point of the checkpoint's next layer with which it goes on; see reached_point.hpp.
    std::optional<std::uint32_t> point_to_resume(const Checkpoint& checkpoint) const noexcept;
    /// Whether it belongs to the job that is published now.
    bool is_of_published_job(const Checkpoint& checkpoint) const noexcept;
    /// A status that the living core wrote after this call began. no_core when none serves or it is silent.
    Result<CoreStatus> status();
    /// The last status of the core that has ended in order. Nothing where one serves, or died.
    std::optional<CoreStatus> status_of_ended_core() const noexcept;

    /// Sends one command and waits for the answer: done, or the core's reason (machine_refused).
    Result<void> send(CommandKind kind, std::optional<Axis> axis = {});
    Result<void> send(const Command& command);
    /// What the core wants to be known of the last command that it did; mostly none.
    const Message& command_remark() const noexcept { return command_remark_; }
    void stop() noexcept { request_stop(segment_); }
    void emergency_stop() noexcept { request_emergency_stop(segment_); }

    /// Publishes a job and, when a core serves, waits until it has judged it. Returns the generation.
    Result<std::uint64_t> publish(std::span<const std::byte> job_blob);
    /// What the core wants to be known of the job that it has accepted; mostly nothing.
    std::vector<Message> job_remarks() const { return psicarve::job_remarks(segment_); }

    /// After a command's answer: the next status, or the last one of a core that has done the command and has
    /// ended in order since, as one does that serves a single run.
    Result<CoreStatus> status_after_answer();
    /// After a command's answer: waits for one of `wanted`, as long as it takes. Ends early with an error
    /// when the core is gone or silent (no_core), in alarm or at rest in another state (machine_refused), or
    /// when `watch` returns one. A core that ends in order in one of `wanted` has reached it.
    Result<CoreStatus> wait_for_state(const std::vector<MachineState>& wanted, const StatusWatch& watch = {});
    /// After stop or emergency stop, which have no answer: waits for one of `wanted`, no longer than
    /// `rest_limit` (timed_out) while the machine rests in another state. A core that ends in order in one of
    /// `wanted` has reached it.
    Result<CoreStatus> wait_after_stop(const std::vector<MachineState>& wanted,
                                       std::chrono::milliseconds rest_limit);

private:
    explicit MachineLink(Segment segment) noexcept : segment_(std::move(segment)) {}
    /// Sleeps until there is a status newer than `seen_heartbeat`, or a while has passed.
    std::optional<CoreStatus> next_status(std::uint64_t seen_heartbeat);
    Error silent_core() const;

    Segment segment_;
    Message command_remark_{};
};

}  // namespace psicarve::machine
