// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>
#include <type_traits>

#include "shared/machine/signal.hpp"
#include "shared/message/message.hpp"

namespace psicarve {

/// What a process may ask of the core through the command slots. Stop and emergency stop are not here: they
/// are words of their own (layout.hpp) that never wait behind anything. The numbers are part of the segment's
/// layout.
enum class CommandKind : std::uint32_t {
    none = 0,
    home = 1,   ///< axis: those to home, bit by axis; 0: all
    start = 2,  ///< drives on, spindle on, heads to the first point, wait there. value: the first
                ///< layer; value2: so many layers, 0: all that follow, and the point (set_start_point);
                ///< axis: kStart... bits
    start_interpolation = 3,  ///< carve the published tables
    hold = 4,
    resume = 5,
    reset_alarm = 6,
    back_off = 7,      ///< axis
    reset_height = 8,  ///< Y to its limit sensor, which defines its position
    shutdown = 9,      ///< a private core ends its work; refused unless at rest or in alarm
    jog = 10,          ///< axis, value: a distance [mm; psi: deg], speed, lease
    jog_on = 11,       ///< axis, value: +1 or -1, speed, lease: until released or the travel's end
    move = 12,         ///< axes, target: all of them together, in a straight line
    spindle = 13,      ///< value: 1 on, 0 off
    override = 14,     ///< value: so many per cent of the planned feed, whole, 10 to 200
    record = 15,       ///< value: RecordingForm; lease_token: of the reader (recording.hpp)
    test_pin = 16,    ///< drives off: axis: an output's Signal, active alone while value is 1, lease; value2:
                      ///< so many pulses instead, speed: in a second; value 0: the test ends
    drives_off = 17,  ///< at rest: positions are lost
    forget_piece = 18,  ///< at rest: the one record that it names (saved_checkpoint.hpp), in the segment and
                        ///< on the disk
    program = 19,  ///< run the program of that number (value2), whose records a writer puts into the ring;
                   ///< axis: kProgram... bits; target: where the machine stood when it was read [pulses]
    rapid_override = 20,  ///< value: so many per cent of the speed of a program's rapid ways, whole, 10 to
                          ///< 100
    single = 21,          ///< value: 1 the program that runs rests at the end of each line, 0 it does not
    optional_stop = 22,   ///< value: 1 the program that runs waits at each M1 from here on, 0 it does not
};
inline constexpr std::uint32_t kCommandKindCount = 23;
std::string_view name_of(CommandKind kind) noexcept;  ///< as on the command line: "start-interpolation"

inline constexpr std::uint32_t kLeastOverride_percent = 10;
inline constexpr std::uint32_t kMostOverride_percent = 200;

/// Of a start: with the layer that the checkpoint names (checkpoint.hpp), not `value`.
inline constexpr std::uint32_t kStartResumes = 1;
/// Of a start: heads outside and still, spindle off; table and Y go as they would. No checkpoint.
inline constexpr std::uint32_t kStartsDry = 2;
/// With kStartResumes: and with the point of that layer that was reached last, where it is known.
inline constexpr std::uint32_t kStartResumesWithin = 4;

/// Of a program: it waits for a resume after each of its blocks.
inline constexpr std::uint32_t kProgramIsSingle = 1;
/// Of a program: it waits at each M1.
inline constexpr std::uint32_t kProgramStopsAtOptional = 2;

/// How a move gets to its target.
enum class MoveShape : std::uint32_t {
    straight = 0,   ///< all axes together
    stepped = 1,    ///< two of r1, r2, y: a line by point-by-point comparison, one axis at a time
    arc = 2,        ///< a head and y, likewise: round `centre`, from +head towards +y
    clockwise = 3,  ///< an arc the other way round
};

/// Fixed-size, trivially copyable. Written by a sender, read once by the core.
struct Command {
    CommandKind kind;
    std::uint32_t axis;  ///< Axis, where the command has one; move: its axes, bit by axis
    double value;        ///< meaning by kind; 0 where it has none
    std::uint64_t value2;
    double speed = 0.0;              ///< jog, jog_on: [mm/s; deg/s]; 0: the axis' home speed
    std::uint32_t lease_token = 0;   ///< jog, jog_on: see jog_lease.hpp; record; 0: not held
    std::uint32_t lease_ms = 0;      ///< jog, jog_on: how long it lives without being renewed
    double target[kAxisCount] = {};  ///< move: position by axis [mm; psi: deg]; program: [pulses]
    double centre[kAxisCount] = {};  ///< move, arcs: likewise
    MoveShape shape = MoveShape::straight;
    std::uint32_t reserved = 0;
};
static_assert(sizeof(Command) == 112 && std::is_trivially_copyable_v<Command>, "bump kLayoutVersion");

/// Of a start, in the high half of value2: 0: from the first layer's begin; else one more than the point of
/// that layer's table, as the status counts points.
constexpr std::uint32_t start_point_number(const Command& command) noexcept {
    return static_cast<std::uint32_t>(command.value2 >> 32U);
}
constexpr std::uint32_t start_layers(const Command& command) noexcept {
    return static_cast<std::uint32_t>(command.value2);
}
/// Requires a point of the layer's table, and value2 to be no more than a number of layers.
constexpr void set_start_point(Command& command, std::uint32_t point) noexcept {
    command.value2 |= (std::uint64_t{point} + 1) << 32U;
}

enum class AnswerKind : std::uint32_t { none = 0, done = 1, refused = 2 };

struct Answer {
    AnswerKind kind;
    std::uint32_t reserved;
    Message message;  ///< why refused, or what to know of what is done; mostly none
};
static_assert(sizeof(Answer) == 400 && std::is_trivially_copyable_v<Answer>, "bump kLayoutVersion");

}  // namespace psicarve
