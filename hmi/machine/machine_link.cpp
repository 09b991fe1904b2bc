// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/machine/machine_link.hpp"

#include <algorithm>

#include "shared/base/message_text.hpp"
#include "shared/computer/event.hpp"
#include "shared/machine/message_argument.hpp"
#include "shared/segment/reached_point.hpp"
#include "shared/segment/shared_record.hpp"
#include "shared/wording/wording.hpp"

namespace psicarve::machine {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kPoll{10};

std::uint64_t heartbeat_of(const std::optional<CoreStatus>& status) {
    return status ? status->heartbeat : 0;
}

bool is_among(const std::vector<MachineState>& wanted, MachineState state) {
    return std::find(wanted.begin(), wanted.end(), state) != wanted.end();
}

/// At rest, and no command under way will change that.
bool is_dead_end(MachineState state) {
    return state == MachineState::off || state == MachineState::ready || state == MachineState::waiting;
}

}  // namespace

Error alarm_error(const CoreStatus& status) {
    const Argument cause = argument_of(status.alarm_cause);
    const Argument remedy = alarm_remedy_argument(status.alarm_cause, status.is_port_silent != 0);
    if (status.alarm_axis == kNoAxis || status.alarm_axis >= kAxisCount)
        return error_from(ErrorCode::machine_refused, message_of(MessageId::alarm, cause, remedy));
    const Argument axis = argument_of(static_cast<Axis>(status.alarm_axis));
    return error_from(ErrorCode::machine_refused, message_of(MessageId::alarm_of_axis, cause, axis, remedy));
}

Result<MachineLink> MachineLink::attach(const std::string& segment_name, const std::string& group) {
    auto segment = Segment::attach(segment_name, group);
    if (!segment) return segment.error();
    return MachineLink{std::move(segment).value()};
}

Result<MachineLink> MachineLink::attach_to_stop(const std::string& segment_name) {
    auto segment = Segment::attach_to_stop(segment_name);
    if (!segment) return segment.error();
    return MachineLink{std::move(segment).value()};
}

Result<MachineLink> MachineLink::create_or_attach(const SegmentOptions& options) {
    auto segment = Segment::create_or_attach(options);
    if (!segment) return segment.error();
    return MachineLink{std::move(segment).value()};
}

Result<void> MachineLink::require_core() const {
    if (core_pid()) return {};
    return error_from(ErrorCode::no_core, with_text(message_of(MessageId::no_core), segment_name()));
}

Error MachineLink::silent_core() const {
    const auto pid = core_pid();
    if (!pid) return require_core().error();
    return error_from(ErrorCode::no_core,
                      with_text(message_of(MessageId::core_silent, count_argument(*pid)), segment_name()));
}

std::optional<CoreStatus> MachineLink::last_status() const noexcept {
    auto status = read_record(segment_.header().status);
    if (!status || status->heartbeat == 0) return std::nullopt;
    return status;
}

std::optional<CoreStatus> MachineLink::status_of_ended_core() const noexcept {
    // A core that dies keeps its name in the segment; one that ends takes it away after its last status.
    if (segment_.glance_at_core() || segment_.header().core.pid.load() != 0) return std::nullopt;
    return last_status();
}

std::string MachineLink::port_name() const {
    const auto port = read_record(segment_.header().port);
    return port ? text_from_field(port->text) : std::string{};
}

std::optional<Checkpoint> MachineLink::checkpoint() const noexcept {
    const auto checkpoint = read_record(segment_.header().checkpoint);
    if (!checkpoint || !is_checkpoint(*checkpoint)) return std::nullopt;
    return checkpoint;
}

std::optional<std::uint32_t> MachineLink::point_to_resume(const Checkpoint& checkpoint) const noexcept {
    return psicarve::point_to_resume(segment_.header().reached_point.load(), checkpoint);
}

bool MachineLink::is_of_published_job(const Checkpoint& checkpoint) const noexcept {
    return published_checksum(segment_) == std::optional{checkpoint.job_checksum};
}

std::optional<CoreStatus> MachineLink::next_status(std::uint64_t seen_heartbeat) {
    EventWord& changed = segment_.header().status_changed;
    const std::uint32_t seen_count = event_count(changed);
    auto status = last_status();
    if (heartbeat_of(status) != seen_heartbeat) return status;
    event_wait_past(changed, seen_count, kPoll);
    return last_status();
}

Result<CoreStatus> MachineLink::status() {
    if (const auto core = require_core(); !core) return core.error();
    const std::uint64_t first = heartbeat_of(last_status());
    const auto give_up = Clock::now() + kSilenceLimit;
    while (true) {
        const auto now_there = next_status(first);
        if (now_there && now_there->heartbeat != first) return *now_there;
        if (!core_pid() || Clock::now() >= give_up) return silent_core();
    }
}

Result<void> MachineLink::send(CommandKind kind, std::optional<Axis> axis) {
    Command command{};
    command.kind = kind;
    if (axis) command.axis = static_cast<std::uint32_t>(index_of(*axis));
    return send(command);
}

Result<void> MachineLink::send(const Command& command) {
    if (const auto core = require_core(); !core) return core;
    command_remark_ = {};
    return send_command(segment_, command, kCommandLimit, &command_remark_);
}

Result<std::uint64_t> MachineLink::publish(std::span<const std::byte> job_blob) {
    const auto generation = publish_job(segment_, job_blob);
    if (!generation || !core_pid()) return generation;
    const auto accepted = wait_for_acceptance(segment_, *generation, kAcceptanceLimit);
    if (!accepted) return accepted.error();
    return generation;
}

Result<CoreStatus> MachineLink::status_after_answer() {
    auto next = status();
    if (next) return next;
    if (const auto last = status_of_ended_core()) return *last;
    return next;
}

Result<CoreStatus> MachineLink::wait_for_state(const std::vector<MachineState>& wanted,
                                               const StatusWatch& watch) {
    auto last_change = Clock::now();
    std::uint64_t heartbeat = 0;
    while (true) {
        const auto status = next_status(heartbeat);
        if (heartbeat_of(status) != heartbeat) last_change = Clock::now();
        heartbeat = heartbeat_of(status);
        if (!core_pid()) {
            const auto last = status_of_ended_core();
            if (last && is_among(wanted, last->state)) return *last;
            return silent_core();
        }
        if (Clock::now() - last_change > kSilenceLimit) return silent_core();
        if (!status) continue;
        if (watch) {
            if (const auto go_on = watch(*status); !go_on) return go_on.error();
        }
        if (is_among(wanted, status->state)) return *status;
        if (status->state == MachineState::alarm) return alarm_error(*status);
        if (is_dead_end(status->state)) {
            return error_from(ErrorCode::machine_refused,
                              message_of(MessageId::stopped_by_somebody, argument_of(status->state),
                                         states_argument(wanted)));
        }
    }
}

Result<CoreStatus> MachineLink::wait_after_stop(const std::vector<MachineState>& wanted,
                                                std::chrono::milliseconds rest_limit) {
    auto last_motion = Clock::now();
    while (true) {
        auto now_there = status();
        if (!now_there) {
            const auto last = status_of_ended_core();
            if (last && is_among(wanted, last->state)) return *last;
            return now_there;
        }
        const MachineState state = now_there->state;
        if (is_among(wanted, state)) return now_there;
        const auto now = Clock::now();
        if (!is_at_rest(state)) last_motion = now;
        if (now - last_motion > rest_limit) {
            return error_from(ErrorCode::timed_out, message_of(MessageId::still_in_state, argument_of(state),
                                                               states_argument(wanted)));
        }
    }
}

}  // namespace psicarve::machine
