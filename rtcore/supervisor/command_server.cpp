// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/command_server.hpp"

#include <algorithm>

#include "rtcore/cycle/request_command.hpp"
#include "rtcore/supervisor/motion_request.hpp"
#include "rtcore/supervisor/refusal_message.hpp"
#include "shared/machine/jog_lease.hpp"
#include "shared/machine/message_argument.hpp"
#include "shared/record/saved_checkpoint.hpp"
#include "shared/segment/checkpoint.hpp"
#include "shared/segment/reached_point.hpp"
#include "shared/segment/shared_record.hpp"
#include "shared/wording/wording.hpp"

namespace psicarve::supervisor {
namespace {

/// In the ring to the tick, for what the supervisor asks on its own account.
constexpr std::size_t kPlacesLeft = 4;
constexpr std::chrono::milliseconds kLongestTrust{100};
constexpr int kMostOfARound = 16;
constexpr std::chrono::milliseconds kLookInterval{50};  ///< for slots of senders that died

bool is_of(const std::optional<Checkpoint>& known, const LoadedJob& job) noexcept {
    return known && known->job_checksum == job.checksum && known->layer_count == job.view.layer_count();
}

/// A start that is to resume names neither layer nor point: where the checkpoint says, if it is this job's.
Result<Command> with_layer(const Command& command, Segment& segment, const LoadedJob* job) {
    if (command.kind != CommandKind::start || (command.axis & kStartResumes) == 0) return command;
    if (job == nullptr) return error_from(ErrorCode::machine_refused, message_of(MessageId::no_job));
    const auto known = read_record(segment.header().checkpoint);
    const auto point = (command.axis & kStartResumesWithin) != 0 && is_of(known, *job)
                           ? point_to_resume(segment.header().reached_point.load(), *known)
                           : std::nullopt;
    // In the first layer no layer is finished, and a point may be reached all the same.
    const auto layer = point ? Result<std::uint32_t>{known->next_layer}
                             : layer_to_resume(known, job->checksum, job->view.layer_count());
    if (!layer) return layer.error();
    Command resuming = command;
    resuming.value = *layer;
    resuming.value2 = start_layers(command);
    if (point) set_start_point(resuming, *point);
    return resuming;
}

/// The machine is where a program's sender saw it.
bool stands_at(const cycle::Sample& sample, const Command& command) noexcept {
    for (std::size_t k = 0; k < kAxisCount; ++k)
        if (static_cast<double>(sample.position_pulses[k]) != command.target[k]) return false;
    return true;
}

}  // namespace

void CommandServer::take_commands(Segment& segment, cycle::RequestRing& requests, const cycle::Sample& sample,
                                  const LoadedJob* job) {
    has_more_ = false;
    const auto take_some = [&](SenderLook look) {
        for (int left = kMostOfARound; left > 0; --left) {
            if (requests.size() + kPlacesLeft >= cycle::RequestRing::capacity())
                return listener_->note_crowd();
            const auto received = take_command(segment, look);
            if (!received) return;
            if (left < kMostOfARound) listener_->note_crowd();
            take_one(segment, *received, requests, sample, job);
        }
        has_more_ = true;
    };
    // What came since the last round is from a sender that lived a moment ago. After a longer silence of ours
    // none is trusted: what a dead one wished for is not done.
    const auto now = std::chrono::steady_clock::now();
    if (now - last_round_ < kLongestTrust) take_some(SenderLook::trusts);
    last_round_ = now;
    if (now < next_look_) return;
    next_look_ = now + kLookInterval;
    take_some(SenderLook::asks);
}

void CommandServer::answer(Segment& segment, const ReceivedCommand& received, AnswerKind kind,
                           const Message& message) const {
    if (answer_taker_) answer_taker_(received, kind, message);
    answer_command(segment, received, kind, message);
}

void CommandServer::take_one(Segment& segment, const ReceivedCommand& received, cycle::RequestRing& requests,
                             const cycle::Sample& sample, const LoadedJob* job) {
    const Command& command = received.command;
    if (command.kind == CommandKind::shutdown) {
        const bool may_end = is_at_rest(sample.state) && sample.state != MachineState::held;
        shutdown_requested_ = shutdown_requested_ || may_end;
        if (may_end) return answer(segment, received, AnswerKind::done);
        return refuse(segment, received, message_of(MessageId::not_at_rest));
    }
    if (!refusal_for_all_.is_none()) return refuse(segment, received, refusal_for_all_);
    if (command.kind == CommandKind::forget_piece) {
        const Message refusal = try_to_forget(segment, command, sample);
        return answer(segment, received, refusal.is_none() ? AnswerKind::done : AnswerKind::refused, refusal);
    }
    const bool leaves_alarm =
        command.kind == CommandKind::reset_alarm || command.kind == CommandKind::back_off;
    if (leaves_alarm && is_guard_lost_)
        return refuse(segment, received, message_of(MessageId::guard_ended, argument_of(command.kind)));
    // Looked at once the command is ours: a sender that sent a job before it finds that job, or is refused.
    const std::uint64_t published = published_generation(segment);
    if (command.kind == CommandKind::start && published != 0 && published != seen_generation_)
        return refuse(segment, received, message_of(MessageId::job_looked_at));
    const auto kind = cycle::request_of(command.kind);
    if (!kind) return refuse(segment, received, message_of(MessageId::unknown_command));
    if (command.kind == CommandKind::back_off && command.axis >= kAxisCount)
        return refuse(segment, received, message_of(MessageId::no_such_sensor));
    if (command.kind == CommandKind::program) {
        if (!program_opener_) return refuse(segment, received, message_of(MessageId::unknown_command));
        // It was read for a machine that stands there; other motion is refused while it is asked for.
        if (!stands_at(sample, command))
            return refuse(segment, received, message_of(MessageId::program_start_moved));
        const auto opened = program_opener_(command.value2);
        if (!opened) return refuse(segment, received, opened.error().said);
    }
    const auto placed = with_layer(command, segment, job);
    auto request = placed ? motion_request(*placed, *kind, *profile_, is_virtual_clock_)
                          : Result<cycle::Request>{placed.error()};
    if (!request) return refuse(segment, received, request.error().said);
    request->sequence = ++last_sequence_;
    listener_->note_stops_seen(received, *request);
    requests.push(*request);
    const JobCounts of_job =
        job != nullptr ? JobCounts{job->view.layer_count(), job->view.point_count()} : JobCounts{};
    waiting_.push_back({request->sequence, received, of_job});
}

Message CommandServer::try_to_forget(Segment& segment, const Command& command, const cycle::Sample& sample) {
    if (!is_at_rest(sample.state) || runs_job(sample.state)) return message_of(MessageId::forget_not_at_rest);
    const RecordName record = record_to_forget(command, segment.name());
    if (record.job_checksum == 0) return {};  // of none: whether it may
    return piece_->forget(segment.header(), record);
}

void CommandServer::note_lease(const Command& command) noexcept {
    const bool is_jog = command.kind == CommandKind::jog || command.kind == CommandKind::jog_on ||
                        command.kind == CommandKind::test_pin;
    if (!is_jog && command.kind != CommandKind::move) return;
    const std::chrono::milliseconds asked{is_jog ? command.lease_ms : 0};
    jog_lease_ = std::min(asked, kLongestJogLease);
    jog_token_ = command.lease_token;
}

void CommandServer::deliver_answer(Segment& segment, const cycle::Report& report,
                                   const cycle::Sample& sample) {
    const auto found = std::ranges::find(waiting_, report.sequence, &Waiting::sequence);
    if (found == waiting_.end()) return;
    const bool is_done = report.refusal == cycle::Refusal::none;
    if (is_done) note_lease(found->received.command);
    const Command& command = found->received.command;
    if (command.kind == CommandKind::program && opened_taker_) opened_taker_(command.value2, is_done);
    answer(segment, found->received, is_done ? AnswerKind::done : AnswerKind::refused,
           is_done ? speed_remark(command, *profile_)
                   : refusal_message(report, command.kind, sample, *profile_, found->of_job));
    waiting_.erase(found);
}

}  // namespace psicarve::supervisor
