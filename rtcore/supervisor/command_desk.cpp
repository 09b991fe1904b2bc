// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/command_desk.hpp"

#include <algorithm>
#include <string>

#include "rtcore/cycle/request_command.hpp"
#include "rtcore/supervisor/refusal_text.hpp"

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
    cycle::Request request{};
    request.sequence = ++last_sequence_;
    request.kind = *kind;
    request.axis = static_cast<std::uint8_t>(command.axis);
    requests.push(request);
    waiting_.push_back({request.sequence, received});
}

void CommandDesk::deliver_answer(Segment& segment, const cycle::Report& report, const cycle::Sample& sample) {
    const auto found = std::ranges::find(waiting_, report.sequence, &Waiting::sequence);
    if (found == waiting_.end()) return;
    const bool is_done = report.refusal == cycle::Refusal::none;
    answer_command(segment, found->received, is_done ? AnswerKind::done : AnswerKind::refused,
                   refusal_text(report.refusal, found->received.command.kind, sample));
    waiting_.erase(found);
}

}  // namespace psicarve::supervisor
