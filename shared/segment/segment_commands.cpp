// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/segment/segment_commands.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <string>
#include <utility>

#include "shared/base/message_text.hpp"
#include "shared/computer/event.hpp"
#include "shared/computer/process_identity.hpp"
#include "shared/machine/jog_lease.hpp"
#include "shared/segment/segment.hpp"
#include "shared/segment/shared_record.hpp"
#include "shared/wording/wording.hpp"

namespace psicarve {
namespace {

using Clock = std::chrono::steady_clock;

/// How often a waiting sender checks whether the core still lives.
constexpr std::chrono::milliseconds kVerdictCheckInterval{100};

constexpr std::uint64_t pack(SlotState state, std::uint32_t sender_pid) noexcept {
    return (std::uint64_t{sender_pid} << 32) | static_cast<std::uint32_t>(state);
}
constexpr std::uint64_t pack(StopsSeen seen) noexcept {
    return (std::uint64_t{seen.emergency_stops} << 32) | seen.stops;
}
constexpr StopsSeen unpack_stops(std::uint64_t word) noexcept {
    return {.stops = static_cast<std::uint32_t>(word),
            .emergency_stops = static_cast<std::uint32_t>(word >> 32)};
}
StopsSeen stops_in(const SegmentHeader& header) noexcept {
    return {.stops = header.stop_requests.load(), .emergency_stops = header.estop_requests.load()};
}
constexpr std::uint64_t kFreeSlot = pack(SlotState::free, 0);
SlotState state_of(std::uint64_t word) noexcept {
    return static_cast<SlotState>(static_cast<std::uint32_t>(word));
}
std::uint32_t sender_of(std::uint64_t word) noexcept {
    return static_cast<std::uint32_t>(word >> 32);
}

bool move_slot(CommandSlot& slot, std::uint64_t from, std::uint64_t to) noexcept {
    return slot.state_and_sender.compare_exchange_strong(from, to, std::memory_order_acq_rel);
}

/// Only the slot's present owner calls this. The start time goes first: a slot never shows a new sender's pid
/// beside an earlier sender's start time.
bool free_slot(CommandSlot& slot, std::uint64_t from) noexcept {
    slot.sender_start_time.store(0, std::memory_order_relaxed);
    return move_slot(slot, from, kFreeSlot);
}

Answer make_answer(AnswerKind kind, const Message& message) noexcept {
    return {.kind = kind, .reserved = 0, .message = message};
}

// --- sender ------------------------------------------------------------------------------------------------

CommandSlot* claim_slot(SegmentHeader& header, std::uint32_t pid) noexcept {
    for (CommandSlot& slot : header.commands) {
        if (move_slot(slot, kFreeSlot, pack(SlotState::writing, pid))) return &slot;
    }
    return nullptr;
}

void post(SegmentHeader& header, CommandSlot& slot, const Command& command, std::uint32_t pid) noexcept {
    store_words<Command>(slot.command, command);
    slot.sequence.store(header.next_sequence.fetch_add(1) + 1, std::memory_order_relaxed);
    slot.stops_seen.store(pack(stops_in(header)), std::memory_order_relaxed);
    slot.state_and_sender.store(pack(SlotState::pending, pid), std::memory_order_release);
    event_signal(header.command_raised);
    // Not before: the look takes as long as the core's answer. The slot stays ours; until then its start time
    // is 0, and the pid alone counts.
    slot.sender_start_time.store(process_start_time(pid), std::memory_order_relaxed);
}

Result<Message> read_answer(CommandSlot& slot, std::uint32_t pid) {
    const Answer answer = load_words<Answer>(slot.answer);
    free_slot(slot, pack(SlotState::answered, pid));
    if (answer.kind == AnswerKind::done) return answer.message;
    return error_from(ErrorCode::machine_refused,
                      answer.message.is_none() ? message_of(MessageId::no_reason) : answer.message);
}

/// Leaves a slot whose answer is no longer wanted. False: it was answered meanwhile.
bool give_up(CommandSlot& slot, std::uint32_t pid) noexcept {
    return free_slot(slot, pack(SlotState::pending, pid)) ||
           move_slot(slot, pack(SlotState::taken, pid), pack(SlotState::abandoned, pid)) ||
           slot.state_and_sender.load() != pack(SlotState::answered, pid);
}

Result<Message> wait_for_answer(Segment& segment, CommandSlot& slot, std::uint32_t pid,
                                std::chrono::milliseconds limit) {
    SegmentHeader& header = segment.header();
    const Clock::time_point deadline = Clock::now() + limit;
    for (;;) {
        const std::uint32_t seen = event_count(header.status_changed);
        if (slot.state_and_sender.load(std::memory_order_acquire) == pack(SlotState::answered, pid)) {
            return read_answer(slot, pid);
        }
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
        const bool has_core = segment.core_pid().has_value();
        if (!has_core || left.count() <= 0) {
            if (!give_up(slot, pid)) return read_answer(slot, pid);
            if (!has_core) return error_from(ErrorCode::no_core, message_of(MessageId::core_ended));
            const auto limit_ms = static_cast<std::uint64_t>(std::max<std::int64_t>(limit.count(), 0));
            return error_from(ErrorCode::timed_out,
                              message_of(MessageId::no_answer_in_time, ms_argument(limit_ms)));
        }
        event_wait_past(header.status_changed, seen, std::min(left, kVerdictCheckInterval));
    }
}

// --- core --------------------------------------------------------------------------------------------------

/// True when a dead process used the slot, which is free afterwards.
bool free_if_sender_died(CommandSlot& slot, std::uint64_t word) noexcept {
    if (is_process_alive(sender_of(word), slot.sender_start_time.load(std::memory_order_relaxed)))
        return false;
    return free_slot(slot, word);
}

CommandSlot* oldest_pending(SegmentHeader& header, SenderLook look) noexcept {
    CommandSlot* oldest = nullptr;
    for (CommandSlot& slot : header.commands) {
        const std::uint64_t word = slot.state_and_sender.load(std::memory_order_acquire);
        if (state_of(word) == SlotState::free) continue;
        if (look == SenderLook::asks && free_if_sender_died(slot, word)) continue;
        if (state_of(word) != SlotState::pending) continue;
        if (oldest == nullptr || slot.sequence.load() < oldest->sequence.load()) oldest = &slot;
    }
    return oldest;
}

/// Answers if the sender still waits, else frees the slot.
void finish(CommandSlot& slot, std::uint32_t sender_pid, const Answer& answer) noexcept {
    store_words<Answer>(slot.answer, answer);
    if (move_slot(slot, pack(SlotState::taken, sender_pid), pack(SlotState::answered, sender_pid))) return;
    free_slot(slot, pack(SlotState::abandoned, sender_pid));
}

}  // namespace

Result<void> send_command(Segment& segment, const Command& command, std::chrono::milliseconds limit,
                          Message* remark) {
    const std::uint32_t pid = own_pid();
    CommandSlot* const slot = claim_slot(segment.header(), pid);
    if (slot == nullptr) {
        return error_from(ErrorCode::timed_out,
                          message_of(MessageId::slots_in_use, count_argument(kCommandSlots)));
    }
    post(segment.header(), *slot, command, pid);
    // Not before: the look takes longer than the core's answer.
    if (!segment.core_pid() && free_slot(*slot, pack(SlotState::pending, pid))) {
        return error_from(ErrorCode::no_core,
                          with_text(message_of(MessageId::no_core_for_command), segment.name()));
    }
    auto answer = wait_for_answer(segment, *slot, pid, limit);
    if (!answer) return answer.error();
    if (remark != nullptr) *remark = *answer;
    return {};
}

StopsSeen stops_seen(const Segment& segment) noexcept {
    return stops_in(segment.header());
}

void request_stop(Segment& segment) noexcept {
    segment.header().stop_requests.fetch_add(1);
    event_signal(segment.header().command_raised);
}

void request_emergency_stop(Segment& segment) noexcept {
    segment.header().estop_requests.fetch_add(1);
    event_signal(segment.header().command_raised);
}

void write_jog_lease(Segment& segment, std::uint32_t token, std::uint32_t beat) noexcept {
    segment.header().jog_lease.store(jog_lease_word(token, beat));
    event_signal(segment.header().command_raised);
}

std::optional<ReceivedCommand> take_command(Segment& segment, SenderLook look) {
    SegmentHeader& header = segment.header();
    CommandSlot* const slot = oldest_pending(header, look);
    if (slot == nullptr) return std::nullopt;
    const std::uint64_t word = slot->state_and_sender.load(std::memory_order_acquire);
    const std::uint32_t sender = sender_of(word);
    // Its words stand still only once it is taken: before, the sender may give up and write another.
    if (state_of(word) != SlotState::pending || !move_slot(*slot, word, pack(SlotState::taken, sender))) {
        return std::nullopt;
    }
    return ReceivedCommand{.slot = static_cast<std::uint32_t>(slot - header.commands),
                           .sequence = slot->sequence.load(std::memory_order_relaxed),
                           .sender_pid = sender,
                           .stops_seen = unpack_stops(slot->stops_seen.load(std::memory_order_relaxed)),
                           .command = load_words<Command>(slot->command)};
}

void answer_command(Segment& segment, const ReceivedCommand& command, AnswerKind kind,
                    const Message& message) {
    if (command.slot >= kCommandSlots) return;
    CommandSlot& slot = segment.header().commands[command.slot];
    finish(slot, command.sender_pid, make_answer(kind, message));
    event_signal(segment.header().status_changed);
}

void clear_commands_of_dead_core(SegmentHeader& header) noexcept {
    const Answer answer = make_answer(AnswerKind::refused, message_of(MessageId::core_replaced));
    for (CommandSlot& slot : header.commands) {
        const std::uint64_t word = slot.state_and_sender.load(std::memory_order_acquire);
        const std::uint32_t sender = sender_of(word);
        switch (state_of(word)) {
            case SlotState::free:
                break;
            case SlotState::writing:
            case SlotState::answered:
                free_if_sender_died(slot, word);
                break;
            case SlotState::pending:
                if (free_if_sender_died(slot, word)) break;
                if (move_slot(slot, word, pack(SlotState::taken, sender))) finish(slot, sender, answer);
                break;
            case SlotState::taken:
                finish(slot, sender, answer);
                free_if_sender_died(slot, pack(SlotState::answered, sender));
                break;
            default:  // abandoned, or overwritten
                free_slot(slot, word);
                break;
        }
    }
    event_signal(header.status_changed);
}

}  // namespace psicarve
