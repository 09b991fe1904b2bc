// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

#include "rtcore/cycle/motion_block.hpp"
#include "rtcore/cycle/sample_record.hpp"
#include "rtcore/trace/trace_entry.hpp"
#include "shared/base/spsc_ring.hpp"
#include "shared/machine/machine_state.hpp"
#include "shared/machine/program_status.hpp"
#include "shared/machine/status.hpp"

namespace psicarve::cycle {

// Everything that passes between the tick and the threads beside it. The tick touches only this, the motion
// blocks and the port; it never sees the segment.

/// supervisor -> tick. One request is answered by one report of kind `answer`.
enum class RequestKind : std::uint8_t {
    home,   ///< value: the axes, bit by axis; 0: all
    start,  ///< value: a LayerRange, packed
    start_interpolation,
    hold,
    resume,
    reset_alarm,
    back_off,
    reset_height,
    job_loaded,  ///< value: generation; points_total: the job's points. Only sent when no job runs
    override,    ///< value: per cent of the planned feed
    fail,        ///< value: AlarmCause that was found outside the tick; by UrgentWords, not by the ring
    jog,         ///< order, lease; one axis by a distance
    jog_on,      ///< order, lease; one axis until it is let go or its travel ends
    move,        ///< order; all its axes to their targets together
    end_jog,     ///< value: MoveEnd. A replay lets go of a jog where the recorded run did
    spindle,     ///< value: 1 on, 0 off
    record,      ///< value: RecordingForm; lease_token: its owner, 0 at the end: any
    test_pin,    ///< value: a PinOrder, packed; lease
    drives_off,
    run_program,     ///< value: its number; axis: not 0: a halt after each of its blocks
    single,          ///< value: 1: a running program rests at the end of each line, 0: it does not
    optional_stop,   ///< value: 1: a running program rests at each M1, 0: it does not
    rapid_override,  ///< value: per cent of the speed of a program's rapid ways
};
struct Request {
    std::uint64_t sequence;  ///< echoed in the answer
    RequestKind kind;
    std::uint8_t axis;        ///< Axis, for back_off; fail: axes whose place is not known, bit by axis
    std::uint8_t has_sender;  ///< 0: the core's own account; no stop comes between
    std::uint8_t runs_back;   ///< job_loaded: 1: odd layers are carved from their last point to their first
    std::uint8_t reserved[4];
    std::uint64_t value;
    std::uint64_t points_total;
    std::uint64_t points_per_layer;  ///< job_loaded
    MotionOrder order;               ///< jog, jog_on, move
    std::uint32_t lease_token;       ///< jog, jog_on: see Lease; record; 0: not held
    std::uint32_t lease_ticks;
    std::uint32_t stops_seen;  ///< of UrgentWords::stop_word, by the sender when it asked
    std::uint32_t emergency_stops_seen;
};

/// Why a request was refused; the supervisor finds the words.
enum class Refusal : std::uint8_t {
    none,
    not_in_this_state,
    no_job,
    not_homed,
    still_tripped,       ///< a limit or the emergency stop is still active
    sensor_not_tripped,  ///< back off: nothing to back off from
    no_sensor,           ///< the axis has no sensor
    outside_travel,      ///< these four name their axis in the answer's record
    inside_core_radius,
    heads_too_close,
    at_the_end,          ///< no way is left in this direction
    bad_override,        ///< beyond 10 to 200 per cent
    bad_rapid_override,  ///< beyond 10 to 100 per cent
    no_program,          ///< none runs
    no_such_layer,
    no_such_point,     ///< beyond the layer's, or its last
    not_an_arc,        ///< begin and end are not as far from the centre, or it is too small
    recording,         ///< another process has the pins recorded, or none can
    heads_not_homed,   ///< psi and y are homed after the heads, or with them
    port_failed,       ///< the port still answers with an error
    port_reset_first,  ///< the port failed: the alarm must be reset before anything moves
    overtaken,         ///< a stop was asked for after it, and came first
};

/// tick -> supervisor, in the order in which things happened. Each carries the flight-recorder entry of it.
struct Report {
    enum class Kind : std::uint8_t { event, answer };
    FlightRecord record;
    std::uint64_t sequence;        ///< answer: the request's
    std::int64_t expected_pulses;  ///< alarm steps_lost: the count expected; record.value is the one seen
    Kind kind;
    Refusal refusal;            ///< answer: none means done
    std::uint16_t layer_count;  ///< alarm steps_lost: of the layers that it affects, as in AlarmRecord
    std::uint32_t first_layer;
};

/// The tick's view of itself, copied out as a whole (sequence lock in our own memory). Mirrors CoreStatus,
/// which is why it is long.
struct Sample {
    std::uint64_t tick;
    MachineState state;
    AlarmCause alarm_cause;
    std::uint8_t alarm_axis;
    std::uint8_t homed_mask;
    SignalWord signals;
    MoveEnd move_end;
    std::uint8_t is_dry;           ///< the job at hand, or the last: nothing is carved
    std::uint16_t is_port_silent;  ///< it has not taken the safe state; `signals` may stand on its pins
    std::array<std::int64_t, kAxisCount> position_pulses;
    std::array<std::uint64_t, kAxisCount> emitted_pulses;
    std::uint32_t layer;
    std::uint32_t point;
    std::uint64_t points_done;
    std::uint64_t points_total;
    std::uint64_t first_layer;  ///< with which the job at hand, or the last, began
    std::uint64_t first_step;   ///< and with which of that layer's points, in the order of carving
    std::uint64_t job_generation;
    std::uint64_t job_start_tick;
    std::uint64_t carve_first_tick;
    std::uint64_t carve_last_tick;
    std::uint64_t job_end_tick;
    std::uint64_t missed_ticks;
    std::uint64_t waited_ticks;
    std::uint64_t override_percent;
    std::uint64_t rapid_override_percent;
    std::uint64_t trace_lost;
    std::uint64_t reports_lost;
    std::uint64_t increments_lost;
    ProgramStatus program;
};

using RequestRing = SpscRing<Request, 64>;
using ReportRing = SpscRing<Report, 4096>;
using IncrementQueue = SpscRing<IncrementEntry, 16384>;

/// Words that are seen at the next tick and never wait behind anything. The tick acts on any change.
struct UrgentWords {
    std::atomic<std::uint32_t> stop_requests{0};  ///< of the core's own account
    std::atomic<std::uint32_t> estop_requests{0};
    /// The segment's words: in the low half as they were looked at last, less what they were when the core
    /// came to them; in the high half their writer keeps which segment it is (urgent_ear.hpp).
    std::atomic<std::uint64_t> stop_word{0};
    std::atomic<std::uint64_t> estop_word{0};
    std::atomic<std::uint64_t> jog_lease{0};  ///< as in the segment
    std::atomic<std::uint64_t> failures{0};   ///< a set of failure_bits(), which the tick empties
    /// Of the thread that hands requests on: the tick sees whether it still comes round. 0: not told.
    std::atomic<std::uint64_t> rounds{0};
};

inline constexpr unsigned kLostAxesShift = 32;
static_assert(kAlarmCauseCount <= kLostAxesShift);
/// A cause that was found outside the tick. `lost_axes`: those whose place is not known, bit by axis.
constexpr std::uint64_t failure_bits(AlarmCause cause, std::uint8_t lost_axes = 0) noexcept {
    return std::uint64_t{1} << static_cast<unsigned>(cause) | std::uint64_t{lost_axes} << kLostAxesShift;
}

/// All of it together, made once before the tick starts; it is large, so not for a stack. The trace ring is
/// apart: without one nothing is traced or recorded.
struct CycleIo {
    RequestRing requests;
    RequestRing replayed_requests;  ///< of a recorded run: written and read by the thread that ticks
    ReportRing reports;
    IncrementQueue increments;
    UrgentWords urgent;
    PlanRequestRing plan_requests;
    BlockRing blocks;
    SampleRecord<Sample> sample;
    trace::TraceRing* trace = nullptr;
    bool traces_always = true;  ///< false: only while a process has the pins recorded
};

}  // namespace psicarve::cycle
