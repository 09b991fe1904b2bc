// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "hmi/gcode/active_modes.hpp"
#include "hmi/gcode/block.hpp"
#include "hmi/gcode/modal_state.hpp"
#include "hmi/gcode/work_offsets.hpp"

namespace psicarve::gcode {

/// M98 or M99, which a block asks for.
struct WantedJump {
    int code = 0;  ///< 98 or 99; 0: none
    std::uint64_t number = 0;
    std::uint64_t times = 1;
    std::uint32_t column = 0;
};

/// Where the machine stands, and on which of its axes the program knows that.
struct MachinePlace {
    Position program{};  ///< in program coordinates
    Position machine{};
    AxisMask placed = 0;        ///< machine axes whose place the program has set, by this block, too
    AxisMask start_placed = 0;  ///< the same where the machine stands
};

/// Where G28 or G30 goes, machine coordinates.
struct ReferencePoint {
    Position at{};
    bool is_set = false;  ///< by G28.1 or G30.1, in this program or one before
};

/// What a wrong block, which is passed over, was perhaps meant to change. What depends on it is not judged: a
/// mistake is reported once, not in each block behind it.
struct Doubts {
    AxisMask axes = 0;  ///< it was perhaps meant to move them
    bool units = false;
    bool distance = false;
    bool values = false;  ///< of this block's words
    bool feed = false;
    bool motion = false;
    bool end = false;  ///< it may have been the program's

    /// Whether words of a block may mean other lengths, or other values.
    bool are_of_words() const noexcept { return units || values; }
    bool are_of_places() const noexcept { return are_of_words() || distance; }
};

/// What the block that is executed has come to.
struct BlockOutcome {
    int motion = kNoCode;                  ///< that it is to make
    bool is_too_far = false;               ///< a move of it was left out
    std::optional<KeptOffsets> offsets{};  ///< that it sets, to be told
    WantedJump jump{};
};

/// How far the program is.
struct ProgramCourse {
    std::uint64_t line = 0;          ///< that is being read
    std::uint64_t drawn_chords = 0;  ///< ways that drawn ones have become
    std::uint64_t motions = 0;
    std::uint64_t actions = 0;    ///< moves that lead somewhere, dwells and stops
    bool has_ended = false;       ///< the lines that follow are not part of it
    bool is_path_q_told = false;  ///< the warning of a Q of G64 is given once
};

/// When the sink is told the modes: before what is given under them, and only where they differ.
struct ModeReport {
    bool is_wanted = false;
    bool is_changing = false;  ///< this block may change them
    bool is_owed = false;      ///< what follows may be under others than were told
    ActiveModes told{};
};

}  // namespace psicarve::gcode
