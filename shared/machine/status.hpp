// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <type_traits>

#include "shared/machine/machine_state.hpp"
#include "shared/machine/signal.hpp"

namespace psicarve {

inline constexpr std::size_t kLatenessBins =
    32;  ///< bin n counts ticks 2^n .. 2^(n+1) ns late; bin 0 also earlier ones
inline constexpr std::size_t kAlarmHistory = 8;

/// One alarm as it happened.
struct AlarmRecord {
    std::uint64_t tick;
    AlarmCause cause;
    std::uint8_t axis;          ///< Axis, or kNoAxis
    std::uint16_t layer_count;  ///< cause steps_lost while a job was carved: of so many layers, from the one
                                ///< in which the axis was last right to the one in which it was not; else 0
    std::uint32_t first_layer;  ///< of these, counted from 0
    std::int64_t expected;      ///< cause steps_lost: the count expected at the index; else 0
    std::int64_t seen;          ///< cause steps_lost: the count seen; else 0
};
inline constexpr std::uint8_t kNoAxis = 255;
static_assert(sizeof(AlarmRecord) == 32, "bump kLayoutVersion");

/// How the last jog or move ended.
enum class MoveEnd : std::uint32_t {
    none = 0,        ///< none yet, or it is under way, or stop or an alarm cut it short
    reached = 1,     ///< where it was sent
    released = 2,    ///< a jog: its sender let go
    lease_gone = 3,  ///< a jog: its sender stopped renewing its lease
};

/// The core's state as it shows it to all processes: the supervisor writes it as a whole, readers read it as
/// a whole. Fixed-width only.
struct CoreStatus {
    std::uint64_t tick;       ///< ticks since the core started (missed ones counted)
    std::uint64_t heartbeat;  ///< grows with every write, whatever the clock
    std::int64_t period_ns;
    MachineState state;
    AlarmCause alarm_cause;   ///< none unless state is alarm or backing_off
    std::uint8_t alarm_axis;  ///< Axis or kNoAxis
    std::uint8_t homed_mask;  ///< bit by axis
    std::uint8_t is_simulator;
    std::uint8_t is_virtual_clock;
    std::uint8_t has_realtime_rights;
    std::uint8_t missing_sensors_mask;         ///< bit by axis: home = none
    std::int64_t position_pulses[kAxisCount];  ///< as counted; meaningless while not homed
    std::uint64_t emitted_pulses[kAxisCount];  ///< since the job was started
    std::uint32_t layer;                       ///< of the point last reached
    std::uint32_t point;
    std::uint64_t points_done;  ///< of layer_count * point_count
    std::uint64_t points_total;
    std::uint64_t job_generation;  ///< accepted job, 0: none
    SignalWord signals;            ///< outputs and inputs, logical levels
    MoveEnd move_end;              ///< of the last jog or move
    double seconds_left;       ///< of the running job as planned; when none runs: carving all of the accepted
                               ///< one; negative: unknown, or not planned yet
    double reference_seconds;  ///< T_ref of the accepted job, whole; negative: unknown, or planner angle
    std::uint64_t job_start_tick;    ///< tick at which start was accepted
    std::uint64_t carve_first_tick;  ///< tick at which the first point was left; 0: not yet
    std::uint64_t carve_last_tick;   ///< tick at which the last point was reached; 0: not yet
    std::uint64_t job_end_tick;      ///< tick at which finishing was done; 0: not yet
    std::uint64_t missed_ticks;
    std::int64_t max_lateness_ns;
    std::uint64_t lateness_histogram[kLatenessBins];
    std::uint64_t alarm_count;          ///< alarms since the core started
    AlarmRecord alarms[kAlarmHistory];  ///< alarm n stands at n % kAlarmHistory
    std::uint64_t waited_ticks;         ///< ticks in which the pins kept a due iteration waiting, since start
    std::uint16_t override_percent;     ///< of the planned feed
    std::uint16_t
        rapid_override_percent;     ///< of a program's rapid ways; 0, in snapshots before layout 16: 100
    std::uint8_t is_dry;            ///< 1: the job at hand, or the last, was a dry run
    std::uint8_t is_left_forecast;  ///< 1: part of seconds_left is a forecast: not all is planned yet
    std::uint16_t is_port_silent;   ///< 1: the port has not taken the safe state; `signals` may stand on it
    std::uint64_t trace_lost;       ///< pin changes that no trace could take (real clock only)
    // How the tick's thread is set up (real clock only), and what interrupted it: counted outside of the
    // tick.
    std::uint32_t realtime_asked;     ///< bit by RealtimeStep: tried
    std::uint32_t realtime_done;      ///< bit by RealtimeStep: in force
    std::int32_t tick_cpu;            ///< the processor that the tick is bound to; -1: any
    std::uint32_t tick_priority;      ///< of SCHED_FIFO; 0: not scheduled so
    std::uint64_t tick_minor_faults;  ///< page faults since its first tick, without the disk
    std::uint64_t tick_major_faults;  ///< page faults that waited for the disk
    std::uint64_t tick_sleeps;        ///< context switches of its own: at most one a tick is its sleep
    std::uint64_t tick_preemptions;   ///< context switches that others forced on it
    // What a simulated machine knows about itself; zero on a real port.
    std::int64_t sim_true_position_pulses[kAxisCount];
    std::uint64_t sim_ignored_pulses[kAxisCount];  ///< drive disabled
    std::uint64_t sim_timing_lost[kAxisCount];     ///< driver timing violated
    std::uint64_t sim_stalls[kAxisCount];          ///< motor asked for more than its torque gives
};
static_assert(std::is_trivially_copyable_v<CoreStatus> && sizeof(CoreStatus) % 8 == 0, "bump kLayoutVersion");

/// Also of a snapshot that is older than the override.
constexpr std::uint32_t rapid_override_percent(const CoreStatus& status) noexcept {
    return status.rapid_override_percent == 0 ? 100 : status.rapid_override_percent;
}

inline std::string_view remedy_of(const CoreStatus& status) noexcept {
    return status.is_port_silent != 0 ? kSilentPortRemedy : remedy_of(status.alarm_cause);
}

/// One entry of the increment ring: where the axes were at a tick.
struct IncrementEntry {
    std::uint64_t tick;
    std::int32_t r1_pulses;
    std::int32_t r2_pulses;
    std::int64_t psi_pulses;
    std::int64_t y_pulses;
};
static_assert(sizeof(IncrementEntry) == 32 && std::is_trivially_copyable_v<IncrementEntry>,
              "bump kLayoutVersion");

enum class RecordKind : std::uint16_t {
    none = 0,
    command = 1,
    stop = 2,
    emergency_stop = 3,
    input_edge = 4,
    state_change = 5,
    alarm = 6,
    job = 7,
    home_latch = 8,
    gap = 9,       ///< value: ticks missed from here on, before whatever follows; code: in so many gaps;
                   ///< answer: the longest of them that would be harmless here [ticks]
    failure = 10,  ///< code: the AlarmCause that the core itself found
    order = 11,    ///< code: OrderPart of the command that follows in the same tick; axis, value
    jog_end = 12,  ///< a jog was let go, or its lease ran out: slowing down from here
    program = 13,  ///< of a program of motion records (recorded_program.hpp)
};

/// What a jog or a move asks for besides its kind: a FlightRecord each.
enum class OrderPart : std::uint16_t {
    target = 0,  ///< axis; value: position, jog: distance, jog_on: direction [pulses]
    speed = 1,   ///< value: bits of a double [pulses/s]
    shape = 2,   ///< value: MoveShape
    centre = 3,  ///< of an arc; axis: 0 or 1, its first or second axis; value [pulses]
};

/// FlightRecord::answer of a gap that was too long for the rotors that turned: this record counts that gap
/// alone.
inline constexpr std::uint32_t kAlarmingGap = 0;
/// No rotor turned.
inline constexpr std::uint32_t kAnyGap = 0xFFFF'FFFF;

/// One entry of the flight recorder.
struct FlightRecord {
    std::uint64_t tick;
    RecordKind kind;
    std::uint16_t code;    ///< CommandKind, MachineState entered, AlarmCause, by kind
    std::uint32_t axis;    ///< Axis or kNoAxis
    SignalWord signals;    ///< all levels after it happened
    std::uint32_t answer;  ///< command: AnswerKind; gap, program: as said there
    std::int64_t value;    ///< command: its value; alarm: count seen; job: generation; latch: correction
                           ///< [pulses]; ready entered: of the screws' gaps (recorded_gaps.hpp)
    std::int64_t position_pulses[kAxisCount];
};
static_assert(sizeof(FlightRecord) == 64 && std::is_trivially_copyable_v<FlightRecord>,
              "bump kLayoutVersion");

}  // namespace psicarve
