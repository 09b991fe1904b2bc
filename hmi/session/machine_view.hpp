// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "shared/machine/machine_state.hpp"
#include "shared/machine/program_status.hpp"
#include "shared/machine/status.hpp"
#include "shared/profile/profile.hpp"
#include "shared/record/saved_checkpoint.hpp"

namespace psicarve::session {

/// How current the knowledge about the core is.
enum class CoreLife : std::uint8_t {
    none,    ///< no core serves the segment
    silent,  ///< it holds its lock but its heartbeat stands still
    late,
    alive,
};
inline constexpr std::chrono::milliseconds kFreshLimit{250};
inline constexpr std::chrono::milliseconds kSilentLimit{500};

constexpr CoreLife core_life(bool has_core, std::chrono::milliseconds silence) noexcept {
    if (!has_core) return CoreLife::none;
    if (silence >= kSilentLimit) return CoreLife::silent;
    return silence >= kFreshLimit ? CoreLife::late : CoreLife::alive;
}

/// Where a run of the job begins, counted from 0.
struct StartPlace {
    std::uint32_t layer = 0;
    std::optional<std::uint32_t> point{};  ///< of the layer's table; nothing: the layer's begin

    friend bool operator==(const StartPlace&, const StartPlace&) = default;
};

/// The machine at one instant, for the operator's side.
struct MachineView {
    CoreLife life = CoreLife::none;
    std::uint32_t core_pid = 0;
    std::optional<CoreStatus> status;  ///< the last known, also of a core that has ended
    /// The machine's profile, which converts pulses to mm; nothing when it is not known.
    std::optional<Profile> profile;
    /// `profile` is that of the job that the core accepted, equal to the machine's in every key of motion.
    /// Pins, tick and the computer's keys may differ.
    bool is_profile_of_job = false;
    std::uint64_t core_profile_hash = 0;  ///< of the core's profile, known or not
    /// Name of the profile that the user has chosen and that is not the core's: it is not used. Empty: none,
    /// or it is.
    std::string unused_profile{};
    /// The count when the latched alarm was first seen: the computer goes on missing ticks, which do not
    /// belong to the alarm.
    std::uint64_t missed_ticks_at_alarm = 0;
    /// The most in any of the last five seconds, at rest, too; on the real clock.
    std::uint64_t missed_per_s = 0;
    /// By the computer's clock, when `status` was written; for a silent core the display shows that time.
    std::chrono::system_clock::time_point status_time{};
    /// The core's port, as --port names it: "sim", "ppdev:/dev/parport0"; empty: not known.
    std::string port_name{};
    /// By the computer's clock, when the window began to look.
    std::chrono::system_clock::time_point watched_since{};
    /// The core was there already at the window's first look.
    bool is_core_of_first_look = false;
    /// The layer behind the last finished one of the published job, counted from 0; nothing: none was
    /// finished, or all.
    std::optional<std::uint32_t> resumable_layer;
    /// The point of the layer behind the finished ones, be it the first, up to which that layer is carved,
    /// too, counted from 0 as the status does; nothing: it is not known.
    std::optional<std::uint32_t> resumable_point;
    /// The layer for the run before, which that one began anew and has not passed.
    std::optional<std::uint32_t> earlier_layer;
    std::uint32_t checkpoint_layer_count = 0;  ///< of that job, where one of the two is known
    std::uint64_t checkpoint_job_checksum = 0;
    std::vector<psicarve::Message> job_remarks{};  ///< of the core, on the published job
    /// It comes from a disk, and nothing was carved by it since: it may be of a piece of long ago.
    bool is_checkpoint_from_disk = false;
    bool is_disk_refusing = false;  ///< the core's disk has not taken the present progress
    /// A core's record on a disk of an unfinished piece, while no core has a job or its piece is known from
    /// there.
    std::optional<FoundCheckpoint> saved_piece{};
    /// The core's own last state; `status` may have its guard's instead. Nothing: none was heard.
    std::optional<MachineState> heard_state;
    /// The program in G-code that ran last, as read with `status`; also of a core that has ended.
    ProgramStatus program{};
    std::optional<psicarve::Message> program_refusal{};  ///< why it is held for good
    bool is_alarm_of_program = false;                    ///< the latched alarm came while it ran
    /// An emergency stop was asked for here and no core heard it; until the operator has read that.
    bool unheard_stop = false;
    std::string segment_problem;  ///< why a segment that is there cannot be used; else empty

    bool is_heard() const noexcept { return life == CoreLife::alive || life == CoreLife::late; }
    MachineState state() const noexcept { return status ? status->state : MachineState::off; }
    /// What runs, or ran when the core was heard last, is a program: the status tells of a job that ran
    /// before it.
    bool runs_program() const noexcept {
        return program.is_running != 0 && psicarve::runs_job(heard_state.value_or(state()));
    }
    bool runs_job() const noexcept { return psicarve::runs_job(state()) && !runs_program(); }
    bool is_homed(Axis axis) const noexcept {
        return status && (status->homed_mask >> index_of(axis) & 1U) != 0;
    }
    bool is_active(Signal signal) const noexcept { return status && (status->signals & bit_of(signal)) != 0; }
    bool is_simulator() const noexcept { return status && status->is_simulator != 0; }
};

/// The value of `missed_ticks_at_alarm` with the next status.
constexpr std::uint64_t missed_ticks_at_alarm(const MachineView& before, const CoreStatus& now) noexcept {
    const bool is_same =
        before.status && before.status->alarm_count == now.alarm_count && before.status->tick <= now.tick;
    return is_same ? before.missed_ticks_at_alarm : now.missed_ticks;
}

inline constexpr std::array<Signal, 3> kLimitSignals{Signal::r1_limit, Signal::r2_limit, Signal::y_limit};

/// What is open in the window.
enum class OpenJobState : std::uint8_t {
    empty,
    opening,  ///< a file is being read
    model,    ///< a mesh that is not sliced
    slicing,
    job,  ///< ready to be published
    publishing,
    published,  ///< it is the job that the core accepted
};

struct OpenJobView {
    OpenJobState state = OpenJobState::empty;
    bool can_be_sliced = false;          ///< a model or a table is open
    std::uint32_t layer_count = 0;       ///< of the job, when there is one
    std::uint32_t core_layer_count = 0;  ///< of the core's job, which may be another; 0: not known
    /// The job is that of the machine's checkpoint; only checked where no core is heard.
    bool is_of_checkpoint = false;
    /// The first key of motion in which the job's profile differs from the core's; empty: none, or not known.
    std::string profile_difference{};
    /// How the blank of the job, or of the core's job where none is open, differs from that of the core's
    /// profile.
    std::optional<BlankDifference> blank_difference{};
    /// The core had accepted it before; by now it may have another job.
    bool was_published = false;
    bool has_job() const noexcept {
        return state == OpenJobState::job || state == OpenJobState::publishing ||
               state == OpenJobState::published;
    }
    bool is_busy() const noexcept {
        return state == OpenJobState::opening || state == OpenJobState::slicing ||
               state == OpenJobState::publishing;
    }
};

}  // namespace psicarve::session
