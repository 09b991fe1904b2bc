// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "shared/machine/status.hpp"
#include "shared/profile/profile.hpp"
#include "shared/record/saved_checkpoint.hpp"

namespace psicarve::session {

/// How fresh what we know about the core is.
enum class CoreLife : std::uint8_t {
    none,    ///< no core serves the segment
    silent,  ///< it keeps its lock but its heartbeat stands still
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

/// The machine as the operator's side sees it at one instant.
struct MachineSight {
    CoreLife life = CoreLife::none;
    std::uint32_t core_pid = 0;
    std::optional<CoreStatus> status;  ///< the last that is known, also of a core that is no more
    /// The machine's, by which pulses become mm; nothing when it is not known.
    std::optional<Profile> profile;
    /// `profile` is that of the job that the core accepted, in every key of motion the machine's. Pins, tick
    /// and the computer's keys may be others.
    bool is_profile_of_job = false;
    std::uint64_t core_profile_hash = 0;  ///< of the one that the core counts by, known or not
    /// Name of the profile that the user has chosen and that is not the core's: nothing counts by it. Empty:
    /// none, or it is.
    std::string unused_profile{};
    /// When the alarm that is latched was first seen: the computer's troubles go on, the alarm's do not.
    std::uint64_t missed_ticks_at_alarm = 0;
    /// The most in any of the last five seconds, at rest, too; on the real clock.
    std::uint64_t missed_per_s = 0;
    /// By the computer's clock, when `status` was written; what is shown of a core that is silent is of then.
    std::chrono::system_clock::time_point status_time{};
    /// What the core drives, as its --port says it: "sim", "ppdev:/dev/parport0"; empty: not known.
    std::string port_name{};
    /// By the computer's clock, when somebody began to look.
    std::chrono::system_clock::time_point watched_since{};
    /// It was there already when somebody looked for the first time.
    bool is_core_of_first_look = false;
    /// Behind the last layer that was finished of the published job, counted from 0; nothing: none, or all
    /// were.
    std::optional<std::uint32_t> resumable_layer;
    /// The same of the run before, which that one began anew and has not passed.
    std::optional<std::uint32_t> earlier_layer;
    std::uint32_t checkpoint_layer_count = 0;  ///< of that job, where one of the two is known
    std::uint64_t checkpoint_job_checksum = 0;
    std::vector<psicarve::Message> job_remarks{};  ///< of the core, on the published job
    /// It comes from a disk, and nothing was carved by it since: it may be of a piece of long ago.
    bool is_checkpoint_from_disk = false;
    bool is_disk_refusing = false;  ///< the core's disk has not taken how far the piece has come
    /// What a core has kept on a disk of a piece that is not finished, while no core has a job or its piece
    /// is known from there.
    std::optional<FoundCheckpoint> saved_piece{};
    /// What the core itself said last; `status` may have its guard's word instead. Nothing: none was heard.
    std::optional<MachineState> heard_state;
    /// An emergency stop was asked for here and no core was there to hear it; until somebody has read that.
    bool unheard_stop = false;
    std::string segment_problem;  ///< why a segment that is there cannot be used; else empty

    bool is_heard() const noexcept { return life == CoreLife::alive || life == CoreLife::late; }
    MachineState state() const noexcept { return status ? status->state : MachineState::off; }
    bool is_homed(Axis axis) const noexcept {
        return status && (status->homed_mask >> index_of(axis) & 1U) != 0;
    }
    bool is_active(Signal signal) const noexcept { return status && (status->signals & bit_of(signal)) != 0; }
    bool is_simulator() const noexcept { return status && status->is_simulator != 0; }
};

/// What `missed_ticks_at_alarm` becomes with the next status.
constexpr std::uint64_t missed_ticks_at_alarm(const MachineSight& before, const CoreStatus& now) noexcept {
    const bool is_same =
        before.status && before.status->alarm_count == now.alarm_count && before.status->tick <= now.tick;
    return is_same ? before.missed_ticks_at_alarm : now.missed_ticks;
}

inline constexpr std::array<Signal, 3> kLimitSignals{Signal::r1_limit, Signal::r2_limit, Signal::y_limit};

/// What is open in the window.
enum class DeskState : std::uint8_t {
    empty,
    opening,  ///< a file is being read
    model,    ///< a mesh that is not sliced
    slicing,
    job,  ///< ready to be published
    publishing,
    published,  ///< it is the job that the core accepted
};

struct JobSight {
    DeskState state = DeskState::empty;
    bool can_be_sliced = false;          ///< a model or a table is open
    std::uint32_t layer_count = 0;       ///< of the job, when there is one
    std::uint32_t core_layer_count = 0;  ///< of the core's job, which may be another; 0: not known
    /// The job is that of the machine's checkpoint; only looked for where no core is heard.
    bool is_of_checkpoint = false;
    /// The first key of motion in which the job's profile is not the core's; empty: none, or not known.
    std::string profile_difference{};
    /// In what the blank of the job, or of the core's where none is open, is not that of the core's profile.
    std::optional<BlankDifference> blank_difference{};
    /// The core had accepted it before; by now it may have another one.
    bool was_published = false;
    bool has_job() const noexcept {
        return state == DeskState::job || state == DeskState::publishing || state == DeskState::published;
    }
    bool is_busy() const noexcept {
        return state == DeskState::opening || state == DeskState::slicing || state == DeskState::publishing;
    }
};

}  // namespace psicarve::session
