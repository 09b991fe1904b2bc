// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "rtcore/checkpoint/piece_memory.hpp"
#include "rtcore/cycle/cycle_io.hpp"
#include "rtcore/job/loaded_job.hpp"
#include "rtcore/supervisor/refusal_message.hpp"
#include "rtcore/supervisor/stop_listener.hpp"
#include "shared/base/result.hpp"
#include "shared/message/message.hpp"
#include "shared/profile/profile.hpp"
#include "shared/segment/segment.hpp"

namespace psicarve::supervisor {

/// Carries commands from the segment to the tick and answers back. Everything in a command is checked here:
/// the tick only sees requests that make sense. Its members: whom it asks, what waits for an answer, and why
/// it refuses.
class CommandServer {
public:
    /// Profile, listener and memory outlive the server.
    CommandServer(const Profile& profile, StopListener& listener, PieceMemory& piece,
                  bool is_virtual_clock) noexcept
        : profile_(&profile), listener_(&listener), piece_(&piece), is_virtual_clock_(is_virtual_clock) {}

    /// Hands on what is pending, but no more than a handful: senders may be faster than we are, and whoever
    /// wants a stop is heard between two rounds. A full request ring leaves the rest for the next one, too.
    /// `job`: the one that a start would find; null: none.
    void take_commands(Segment& segment, cycle::RequestRing& requests, const cycle::Sample& sample,
                       const LoadedJob* job);
    /// For a report of kind answer.
    void deliver_answer(Segment& segment, const cycle::Report& report, const cycle::Sample& sample);
    /// The segment was replaced: answers to its commands have nowhere to go.
    void forget_all() noexcept { waiting_.clear(); }

    /// Of the jog that the tick took last; 0: what it took last was none.
    std::chrono::milliseconds jog_lease() const noexcept { return jog_lease_; }
    /// Whose it is.
    std::uint32_t jog_token() const noexcept { return jog_token_; }

    /// Without its guard the machine would be in alarm again at once: the alarm is not left, neither by a
    /// reset, nor by an axis that backs off.
    void keep_in_alarm(bool is_guard_lost) noexcept { is_guard_lost_ = is_guard_lost; }
    /// Of the published job that was accepted or refused last. While it is not the published one, a start is
    /// refused: which job it would carve is about to change.
    void note_seen(std::uint64_t generation) noexcept { seen_generation_ = generation; }
    void refuse_all(const Message& why) noexcept { refusal_for_all_ = why; }

    /// Makes a program ready for the tick to ask for, or says why it cannot be run.
    using ProgramOpener = std::function<Result<void>(std::uint64_t program)>;
    void set_program_opener(ProgramOpener opener) { program_opener_ = std::move(opener); }

    /// Is told what became of a program that was opened, just before its sender is; of no other command.
    using OpenedTaker = std::function<void(std::uint64_t program, bool is_done)>;
    void set_opened_taker(OpenedTaker taker) { opened_taker_ = std::move(taker); }

    /// Is told of every answer just before its sender is.
    using AnswerTaker = std::function<void(const ReceivedCommand&, AnswerKind, const Message&)>;
    void set_answer_taker(AnswerTaker taker) { answer_taker_ = std::move(taker); }

    /// Something is with the tick and not answered yet.
    bool awaits_answer() const noexcept { return !waiting_.empty(); }
    /// Some were left for the next round.
    bool has_more() const noexcept { return has_more_; }
    bool shutdown_requested() const noexcept { return shutdown_requested_; }

private:
    void take_one(Segment& segment, const ReceivedCommand& received, cycle::RequestRing& requests,
                  const cycle::Sample& sample, const LoadedJob* job);
    /// None: it is done.
    Message try_to_forget(Segment& segment, const Command& command, const cycle::Sample& sample);
    void answer(Segment& segment, const ReceivedCommand& received, AnswerKind kind,
                const Message& message = {}) const;
    void refuse(Segment& segment, const ReceivedCommand& received, const Message& why) const {
        answer(segment, received, AnswerKind::refused, why);
    }
    void note_lease(const Command& command) noexcept;

    const Profile* profile_;
    StopListener* listener_;
    PieceMemory* piece_;
    std::chrono::steady_clock::time_point last_round_{};
    std::chrono::steady_clock::time_point next_look_{};
    std::chrono::milliseconds jog_lease_{0};
    std::uint32_t jog_token_ = 0;
    bool is_virtual_clock_;
    struct Waiting {
        std::uint64_t sequence;  ///< ours: what a sender wrote is not trusted to be unique
        ReceivedCommand received;
        JobCounts of_job;  ///< that a start would find
    };
    std::vector<Waiting> waiting_;  ///< handed to the tick, not answered yet
    std::uint64_t last_sequence_ = 0;
    AnswerTaker answer_taker_;
    OpenedTaker opened_taker_;
    ProgramOpener program_opener_;
    Message refusal_for_all_{};
    bool is_guard_lost_ = false;
    std::uint64_t seen_generation_ = 0;
    bool shutdown_requested_ = false;
    bool has_more_ = false;
};

}  // namespace psicarve::supervisor
