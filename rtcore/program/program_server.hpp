// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>

#include "rtcore/plan/program_step.hpp"
#include "shared/base/result.hpp"
#include "shared/machine/program_status.hpp"
#include "shared/profile/profile.hpp"
#include "shared/segment/segment_program.hpp"

namespace psicarve::program {

/// What a core that begins then numbers its programs from: no number comes twice while the computer runs, so
/// no process that outlives a core takes a later core's program for its own. A whole number also in JSON.
constexpr std::uint64_t first_program_number(std::chrono::steady_clock::time_point began) noexcept {
    constexpr std::uint64_t kMostPerMillisecond = 1000;
    const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(began.time_since_epoch()).count();
    return static_cast<std::uint64_t>(ms) * kMostPerMillisecond;
}

/// Gives numbers to those who want a program run, makes a program ready for the planner when a command names
/// it, and tells in the segment how it goes. One program at a time:
///
///     idle ──a writer asks──▶ given ──command──▶ asked ──done──▶ running ──tick: it runs no more──▶ idle
///       ▲                       │  ▲───refused─────┘
///       └──its writer is gone───┘
///
/// The supervisor's thread. A segment that is replaced ends the program in it; the old one stays mapped as
/// long as the planner reads it.
class ProgramServer {
public:
    /// `last_program`: the first number that it gives is one more.
    explicit ProgramServer(const Profile& profile, std::uint64_t last_program = 0)
        : profile_(profile), last_program_(last_program) {}

    /// Each round, with the tick's latest word on its program.
    void serve(const std::shared_ptr<Segment>& segment, const ProgramStatus& status);
    /// A command asks for it: the steps of the program, or why it cannot be run.
    Result<std::shared_ptr<plan::StepSource>> open(std::uint64_t program);
    /// What became of the command for which open() gave steps; at the latest by now serve() is told of a
    /// program that runs.
    void note_answer(std::uint64_t program, bool is_done) noexcept;

private:
    class Source;
    enum class Phase : std::uint8_t { idle, given, asked, running };

    void turn_to(const std::shared_ptr<Segment>& segment);
    void give_number();
    void end_program();
    void tell(const ProgramStatus& status);

    Profile profile_;
    std::shared_ptr<Segment> segment_;
    std::optional<ProgramDesk> desk_;  ///< of segment_
    std::optional<ProgramFeed> feed_;  ///< unless idle
    std::shared_ptr<Source> source_;   ///< of the program that was asked for, with the planner
    Phase phase_ = Phase::idle;
    std::uint64_t last_program_;
    ProgramStatus told_{};
};

}  // namespace psicarve::program
