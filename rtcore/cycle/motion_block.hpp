// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "rtcore/cycle/motion_order.hpp"
#include "shared/base/spsc_ring.hpp"
#include "shared/machine/program_status.hpp"
#include "shared/machine/signal.hpp"

namespace psicarve::cycle {

enum class BlockKind : std::uint8_t {
    line,         ///< one DDA segment of a table; part of an acceleration group
    path,         ///< one DDA segment of a timed curve; part of a run, which is a group too
    move,         ///< a motion of its own: approach, link, retraction, homing
    define,       ///< the present position of `axis` is `position_pulses`; nothing moves
    outputs,      ///< drives, spindle and switched outputs as `enable_mask`, `spindle`, `switched_on` and
                  ///< `switched_off` say
    dwell,        ///< `ticks` ticks of rest
    halt,         ///< of a program: rest until the operator resumes; `halt` says why
    program_end,  ///< all blocks before it are done
};

/// What ends a move before its way is done.
enum class Until : std::uint8_t {
    none,            ///< the way's end; with a sensor condition below, the way's end means: not found
    sensor_tripped,  ///< the sensor of `axis` trips: slow down, stop
    sensor_clear,    ///< it does not trip any more: slow down, stop
    index_edge,      ///< it begins to trip (an edge): slow down, stop
};

/// What a sensor's edge means for the position.
enum class Latch : std::uint8_t {
    none,
    at_edge,  ///< where the sensor's edge was seen is `position_pulses`
};

enum class Spindle : std::uint8_t { keep, on, off };

/// How a path segment is timed. u is the curve's parameter, it grows along the curve; how fast is planned.
/// Its speed squared is linear in u within a segment; a segment starts as fast as the one before it ended.
/// Two profiles: [0] at 100 % feed, [1] at 200 %; [0] <= [1] everywhere, and both within every axis' limits.
struct PathTiming {
    double length;                             ///< of u, > 0
    std::array<double, 2> start_speed2;        ///< (du/dt)^2 at the begin [u^2/s^2]
    std::array<double, 2> end_speed2;          ///< at the end; not 0 at both
    std::array<float, kAxisCount> accel_free;  ///< a_k / max|dq_k/du| here [u/s^2]; 1e30 when k does not move
    std::array<float, kAxisCount> accel_bend;  ///< max|d2q_k/du2| / max|dq_k/du| here [1/u]; 0 then
    float start_stop_speed;                    ///< du/dt that may begin and end in a jump [u/s]
    float feed_from;  ///< WayKind::to_feed: from so far within the segment on; 0 where it is all of it [u]
    /// Groups that go on without a rest only: (du/dt)^2 at begin and end of a third profile, within all
    /// limits, that comes to rest where the group ends; at its begin no lower than [1] there.
    std::array<double, 2> rest_speed2;
};

/// Whose override is for a way.
enum class WayKind : std::uint8_t {
    feed,     ///< of a job, or a way in the material: the feed's
    rapid,    ///< of a program, in the air: the rapids'
    to_feed,  ///< the same, and from PathTiming::feed_from on a brake may end in a way in the material: there
              ///< the lower of both
};

/// How a group of path segments is joined to its neighbours, as bits in each of its blocks.
inline constexpr std::uint8_t kGoesOn = 1;     ///< without a rest the next group goes on where it ends
inline constexpr std::uint8_t kCarriesOn = 2;  ///< it is such a next one

/// What comes behind a block of a program, as bits: behind those that are wanted it rests.
inline constexpr std::uint8_t kEndsLine = 1;      ///< a line of the program ends with it
inline constexpr std::uint8_t kOptionalStop = 2;  ///< M1

/// One piece of motion. Written by the planner, read by the tick. Speeds are those of the long axis: DDA
/// iterations per second, each iteration at least one pulse. Long, as one entry of the queue has room for
/// every kind of block.
struct MotionBlock {
    BlockKind kind;
    Until until;
    Latch latch;
    Spindle spindle;
    std::uint8_t axis;            ///< Axis of until, latch, define
    std::uint8_t enable_mask;     ///< outputs: drives on, bit by axis; others off
    std::uint8_t is_homing;       ///< 1: sensors of `axis` raise no alarm during this block
    std::uint8_t reaches_points;  ///< of the job, at its end; the last of them is `layer`, `point`
    std::uint8_t up_axes;         ///< a run's first block, bit by axis: those with backlash that go up in it,
    std::uint8_t down_axes;  ///< or down, wherever in it they begin to move; their gaps are taken up first
    ProgramHold halt;        ///< halt: never none
    std::uint8_t joints;     ///< path: kGoesOn, kCarriesOn
    SwitchedOutputs switched_on;   ///< outputs: these go on; all others stay as they are
    SwitchedOutputs switched_off;  ///< outputs: these go off
    WayKind way;                   ///< path
    std::uint8_t marks;            ///< kEndsLine, kOptionalStop; of a halt: waits only if one is wanted
    std::uint32_t epoch;           ///< of the plan request it belongs to; others are dropped
    std::uint32_t group_blocks;    ///< of the whole acceleration group or run; 0: not its first block
    std::array<std::int64_t, kAxisCount> delta_pulses;
    double start_speed_per_s;  ///< lines: a group's first block only, as the next three
    double max_speed_per_s;
    double accel_per_s2;
    std::uint64_t group_iterations;
    std::uint32_t layer;
    std::uint32_t point;
    std::int64_t position_pulses;  ///< latch, define; a program's: set_program_sequence()
    std::int64_t ticks;            ///< dwell
    PathTiming path;               ///< path
    /// path: the straight line of whose pulses this segment has a part, and how many iterations of it come
    /// before; all 0: a line of its own.
    std::array<std::int32_t, kAxisCount> line_pulses;
    std::int64_t line_done;
};
static_assert(sizeof(MotionBlock) <= 232 && std::is_trivially_copyable_v<MotionBlock>);

/// Blocks of a program carry its line where those of a job carry the point that they reach. 0: none.
constexpr std::uint64_t program_line(const MotionBlock& block) noexcept {
    return std::uint64_t{block.layer} << 32U | block.point;
}
constexpr void set_program_line(MotionBlock& block, std::uint64_t line) noexcept {
    block.layer = static_cast<std::uint32_t>(line >> 32U);
    block.point = static_cast<std::uint32_t>(line);
}
/// And its record's sequence, which no other pass of the line has, in the place of a latch's position: blocks
/// of a program neither latch nor define.
constexpr std::uint64_t program_sequence(const MotionBlock& block) noexcept {
    return static_cast<std::uint64_t>(block.position_pulses);
}
constexpr void set_program_sequence(MotionBlock& block, std::uint64_t sequence) noexcept {
    block.position_pulses = static_cast<std::int64_t>(sequence);
}

inline constexpr std::size_t kBlockRingEntries = 16384;
/// A group starts when all of it, or this many blocks, are queued: then it cannot run dry.
inline constexpr std::size_t kGroupStartBlocks = kBlockRingEntries / 2;
/// Without a rest the next group is gone on with when all of it, or this many blocks, are queued. The planner
/// fills a queue that is less than half full: so it comes to that while as many of the group at hand are
/// left.
inline constexpr std::size_t kGroupGoesOnBlocks = kGroupStartBlocks / 2;
using BlockRing = SpscRing<MotionBlock, kBlockRingEntries>;

/// What the tick asks of the planner. The newest request replaces all before it.
enum class PlanKind : std::uint8_t {
    home,          ///< `axis`: those to home, bit by axis
    reset_height,  ///< Y to its sensor
    position,      ///< from anywhere to the run's first point, spindle up
    carve,         ///< from that point to the last layer's last
    finish,        ///< heads out, spindle off; also after a stop
    back_off,      ///< `axis` away from its tripped sensor
    move,          ///< a jog or a move: `order`, from rest to rest
    program,       ///< `program`, from where the machine stands
};
struct PlanRequest {
    std::uint32_t epoch;
    PlanKind kind;
    std::uint8_t axis;
    std::uint8_t homed_mask;    ///< only homed axes have a meaningful position
    std::uint8_t tripped_mask;  ///< sensors that are tripped now
    std::array<std::int64_t, kAxisCount> position_pulses;
    std::uint64_t job_generation;
    std::uint64_t first_layer;  ///< position, carve: the layer to begin with
    std::uint64_t first_step;   ///< and which of its points, in the order in which they are carved
    std::uint64_t end_layer;    ///< carve: one past the last
    std::uint8_t is_dry;        ///< position: heads stay outside, spindle off
    std::uint8_t is_single;     ///< program: a halt after each of its blocks
    std::uint8_t reserved[6];
    std::uint64_t program;  ///< program: its number
    MotionOrder order;      ///< move: targets of all axes
};
using PlanRequestRing = SpscRing<PlanRequest, 16>;

}  // namespace psicarve::cycle
