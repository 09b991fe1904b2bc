// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "rtcore/cycle/cycle_io.hpp"
#include "shared/profile.hpp"
#include "shared/segment.hpp"

namespace psicarve::supervisor {

/// Carries commands from the segment to the tick and answers back. Everything in a command is checked here:
/// the tick only sees requests that make sense.
class CommandDesk {
public:
    /// The profile outlives the desk.
    CommandDesk(const Profile& profile, bool is_virtual_clock) noexcept
        : profile_(&profile), is_virtual_clock_(is_virtual_clock) {}

    /// Hands on what is pending. A full request ring leaves the rest for the next round.
    void take_commands(Segment& segment, cycle::RequestRing& requests, const cycle::Sample& sample);
    /// For a report of kind answer.
    void deliver_answer(Segment& segment, const cycle::Report& report, const cycle::Sample& sample);
    /// The segment was replaced: answers to its commands have nowhere to go.
    void forget_all() noexcept { waiting_.clear(); }

    /// Of the jog that the tick took last; 0: what it took last was none.
    std::chrono::milliseconds jog_lease() const noexcept { return jog_lease_; }

    void refuse_all(const std::string& reason) { refusal_for_all_ = reason; }

    bool shutdown_requested() const noexcept { return shutdown_requested_; }

private:
    void take_one(Segment& segment, const ReceivedCommand& received, cycle::RequestRing& requests,
                  const cycle::Sample& sample);

    void note_lease(const Command& command) noexcept;

    const Profile* profile_;
    std::chrono::milliseconds jog_lease_{0};
    bool is_virtual_clock_;
    struct Waiting {
        std::uint64_t sequence;  ///< ours: what a sender wrote is not trusted to be unique
        ReceivedCommand received;
    };
    std::vector<Waiting> waiting_;  ///< handed to the tick, not answered yet
    std::uint64_t last_sequence_ = 0;
    std::string refusal_for_all_;
    bool shutdown_requested_ = false;
};

}  // namespace psicarve::supervisor
