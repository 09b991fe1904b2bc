// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include "shared/machine/signal.hpp"

namespace psicarve {

/// What a program asks the machine to do next. The numbers are part of the segment's layout.
enum class MotionKind : std::uint8_t {
    way = 1,      ///< straight, all axes together, to `target`
    dwell = 2,    ///< rest for `seconds`
    spindle = 3,  ///< on where `code` is 1, off where it is 0, at rest
    stop = 4,     ///< rest and wait for the operator; `code`: why, a StopReason
    end = 5,      ///< the program is done: rest, spindle and outputs off
    arc = 6,      ///< step by step, of one head and y, about `centre_mm` to `target`; `code`: an ArcSense
    output = 7,   ///< those of `outputs` on where `code` is 1, off where it is 0, at rest
};

/// Why a program waits for the operator. The numbers are part of the segment's layout.
enum class StopReason : std::uint8_t {
    program = 1,           ///< M0, M60
    optional = 2,          ///< M1, whatever the switch says: of writers before layout 18
    tool_change = 3,       ///< M6
    optional_at_rest = 4,  ///< M1: rests, and waits if the switch for it is on by then
    optional_on_way = 5,   ///< M1: neither, unless the switch is on when the machine comes there
};

/// Which way an arc runs, seen with its head's axis to the right and y upwards. The numbers are part of the
/// segment's layout.
enum class ArcSense : std::uint8_t { clockwise = 1, counterclockwise = 2 };

/// Flags of a record, one bit each.
inline constexpr std::uint8_t kIsRapid = 1;    ///< a way in the air: the feed's override is not for it
inline constexpr std::uint8_t kEndsBlock = 2;  ///< the last record of its block in the program
inline constexpr std::uint8_t kIsStepped = 4;  ///< a way by point-by-point comparison, from rest to rest
inline constexpr std::uint8_t kKnownFlags = kIsRapid | kEndsBlock | kIsStepped;

/// Nothing takes longer, be it a dwell or a way: a day.
inline constexpr double kMostRecordSeconds = 86'400.0;

/// One step of a program, as it stands in the ring between the program's reader and the core. Fixed-size,
/// without pointers. The core copies a record before it looks at it, and trusts none of its numbers.
struct MotionRecord {
    std::uint64_t program;   ///< the number that the core gave the program when it was opened
    std::uint64_t sequence;  ///< from 1, without a gap
    std::uint64_t line;      ///< of the program, from 1
    MotionKind kind;
    std::uint8_t axes;  ///< way, arc: those whose target counts, bit by Axis; the others stay where they are
    std::uint8_t flags;
    std::uint8_t code;
    SwitchedOutputs outputs;   ///< output: which, at least one; elsewhere 0
    std::uint8_t reserved[3];  ///< 0
    std::array<double, kAxisCount>
        target;           ///< machine positions by Axis: r1, r2, y in mm, psi in degrees with its turns
    double seconds;       ///< way: the least that it may take, 0: as fast as the machine can; dwell: how long
    double tolerance_mm;  ///< way: how near its end must be passed (G64 P); 0: it is reached to the pulse, at
                          ///< rest
    std::array<double, 2>
        centre_mm;        ///< arc: of the circle, by machine position: its head's, y's; elsewhere 0
    std::uint64_t check;  ///< record_check() of all that stands before it
};
static_assert(sizeof(MotionRecord) == 104 && std::is_trivially_copyable_v<MotionRecord>,
              "bump kLayoutVersion");

/// A number that any changed bit before `check` changes.
std::uint64_t record_check(const MotionRecord& record) noexcept;

}  // namespace psicarve
