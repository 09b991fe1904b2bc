// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace psicarve {

/// What the machine is doing. The numbers are part of the segment's layout.
enum class MachineState : std::uint8_t {
    off = 0,          ///< drives disabled, position unknown
    homing = 1,       ///< R1, R2 out first, then Y, then psi to its index
    ready = 2,        ///< homed, drives on, at rest
    moving = 3,       ///< a jog or a move to a point
    positioning = 4,  ///< to the job's first point, spindle up
    waiting = 5,      ///< at the first point
    carving = 6,
    holding = 7,       ///< slowing down on the path
    held = 8,          ///< at rest on the path, spindle on
    finishing = 9,     ///< retracting, spindle off, after the last point
    stopping = 10,     ///< slowing down on the path, then retracting, spindle off: the job ends
    alarm = 11,        ///< outputs safe
    backing_off = 12,  ///< in alarm, the one motion allowed: one axis away from its tripped sensor
    testing = 13,      ///< drives off except for the axis under test: one output by hand
};
inline constexpr std::uint8_t kMachineStateCount = 14;

/// Events that change the state.
enum class MachineEvent : std::uint8_t {
    home,
    home_done,
    start,
    positioned,
    start_interpolation,
    last_point_done,
    finished,
    hold,
    at_rest,  ///< at_rest: holding or stopping came to rest on the path
    resume,
    stop,
    stopped,  ///< stopped: retracted, spindle off
    move,
    move_done,
    fail,  ///< any alarm
    reset_alarm_unhomed,
    reset_alarm_homed,
    back_off,
    back_off_done,
    reset_height,       ///< Y alone to its sensor: a kind of homing
    home_done_unhomed,  ///< homing ended as asked, but not every axis is homed (reset height from off)
    stopped_unhomed,    ///< stopped, and an axis does not know its position (stop while homing)
    begin_test,
    end_test,
    drives_off,    ///< by command, at rest
    run_program,   ///< a program of motion records: it is carved as a job is, without an approach
    program_done,  ///< it has come to its end: rest, spindle off, heads where it left them
};
inline constexpr std::uint8_t kMachineEventCount = 27;
std::string_view name_of(MachineEvent event) noexcept;  ///< "start interpolation", "last point done"

/// The one table of transitions; nothing means the event is refused in that state. A stop is never refused:
/// where nothing is there to stop, or all is ending already, it leaves the state as it is. RT: yes.
std::optional<MachineState> next_state(MachineState from, MachineEvent event) noexcept;

/// Words as users see them: "off", "homing", "backing off"...
std::string_view name_of(MachineState state) noexcept;
/// No axis moves and none will before a command comes: off, ready, waiting, held, alarm.
bool is_at_rest(MachineState state) noexcept;
/// A job was started and has not ended: all states from positioning to stopping.
bool runs_job(MachineState state) noexcept;

/// Why the machine is in alarm. The numbers are part of the segment's layout.
enum class AlarmCause : std::uint8_t {
    none = 0,
    limit = 1,           ///< a limit sensor tripped while its axis was not being homed
    emergency_stop = 2,  ///< the switch, or the command
    steps_lost = 3,      ///< the psi index came at another count than expected
    tick_gap = 4,        ///< a gap in ticks longer than 1/j_k while an axis moved
    missed_ticks = 5,    ///< more missed ticks a second than the profile allows
    home_failed = 6,     ///< a home sensor was not found, or did not clear
    segment_lost = 7,
    port_error = 8,
    plan_starved = 9,  ///< the planner did not keep ahead of the tick
    guard_lost = 10,
    core_lost = 11,           ///< the guard says it: the core died, drives and spindle are off
    supervisor_stalled = 12,  ///< the tick finds it: for a second the supervisor has read no command
};
inline constexpr std::uint8_t kAlarmCauseCount = 13;
std::string_view name_of(AlarmCause cause) noexcept;  ///< "limit", "emergency stop", ...
/// For a port that has not taken the safe state; shown in place of the alarm's own remedy, which comes after
/// it.
inline constexpr std::string_view kSilentPortRemedy =
    "The port does not answer: drives and spindle may be ON. Switch the machine off by its own switch, then "
    "see to the port's card, cable and driver.";
std::string_view remedy_of(AlarmCause cause) noexcept;  ///< one sentence for the operator

}  // namespace psicarve
