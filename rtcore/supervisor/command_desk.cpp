// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/command_desk.hpp"

#include <algorithm>
#include <string>

#include "rtcore/cycle/request_command.hpp"
#include "rtcore/supervisor/motion_request.hpp"
#include "rtcore/supervisor/refusal_text.hpp"
#include "shared/jog_lease.hpp"

namespace psicarve::supervisor {
void CommandDesk::take_commands(Segment& segment, cycle::RequestRing& requests, const cycle::Sample& sample) {
    while (requests.size() < cycle::RequestRing::capacity()) {
        const auto received = take_command(segment);
        if (!received) return;
        take_one(segment, *received, requests, sample);
    }
}

void CommandDesk::take_one(Segment& segment, const ReceivedCommand& received, cycle::RequestRing& requests,
                           const cycle::Sample& sample) {
    const Command& command = received.command;
    if (command.kind == CommandKind::shutdown) {
        const bool may_end = is_at_rest(sample.state) && sample.state != MachineState::held;
        shutdown_requested_ = shutdown_requested_ || may_end;
        answer_command(segment, received, may_end ? AnswerKind::done : AnswerKind::refused,
                       may_end ? "" : "the machine is not at rest; stop first");
        return;
    }
    if (!refusal_for_all_.empty()) {
        answer_command(segment, received, AnswerKind::refused, refusal_for_all_);
        return;
    }
    const auto kind = cycle::request_of(command.kind);
    if (!kind) {
        answer_command(segment, received, AnswerKind::refused,
                       "unknown command; is the sender another version?");
        return;
    }
    if (command.kind == CommandKind::back_off && command.axis >= kAxisCount) {
        answer_command(segment, received, AnswerKind::refused, "back-off: no such axis; r1, r2 or y");
        return;
    }
    auto request = motion_request(command, *kind, *profile_, is_virtual_clock_);
    if (!request) {
        answer_command(segment, received, AnswerKind::refused, request.error().message);
        return;
    }
    request->sequence = ++last_sequence_;
    requests.push(*request);
    waiting_.push_back({request->sequence, received});
}

void CommandDesk::note_lease(const Command& command) noexcept {
    const bool is_jog = command.kind == CommandKind::jog || command.kind == CommandKind::jog_on ||
                        command.kind == CommandKind::test_pin;
    if (!is_jog && command.kind != CommandKind::move) return;
    const std::chrono::milliseconds asked{is_jog ? command.lease_ms : 0};
    jog_lease_ = std::min(asked, kLongestJogLease);
}

void CommandDesk::deliver_answer(Segment& segment, const cycle::Report& report, const cycle::Sample& sample) {
    const auto found = std::ranges::find(waiting_, report.sequence, &Waiting::sequence);
    if (found == waiting_.end()) return;
    const bool is_done = report.refusal == cycle::Refusal::none;
    if (is_done) note_lease(found->received.command);
    answer_command(segment, found->received, is_done ? AnswerKind::done : AnswerKind::refused,
                   refusal_text(report, found->received.command.kind, sample, *profile_));
    waiting_.erase(found);
}

}  // namespace psicarve::supervisor
