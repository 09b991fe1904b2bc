// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "hmi/gcode/active_modes.hpp"
#include "hmi/gcode/kept_offsets.hpp"
#include "hmi/gcode/position.hpp"

namespace psicarve::gcode {

enum class CanonKind : std::uint8_t {
    rapid,
    feed,
    arc,
    dwell,         ///< value: seconds
    speed,         ///< value: revolutions a minute
    spindle,       ///< code: 3, 4 or 5, as M has it
    coolant,       ///< code: 7, 8 or 9
    tool_select,   ///< value: number
    tool_change,   ///< value: number of the selected one
    path,          ///< code: 610, 611 or 640; value: tolerance in mm, 0: none is given
    override_set,  ///< code: 48 to 53; value: P, 1 where none is given
    output,        ///< code: 62 to 65; value: number
    input,         ///< code: 66; value: number
    stop,          ///< code: 0, 1 or 60
    end,           ///< code: 2 or 30, 0: by %
};

/// The next action of a machine, in machine coordinates.
struct CanonRecord {
    CanonKind kind = CanonKind::end;
    std::uint64_t line = 0;
    std::uint32_t column = 0;
    int code = 0;
    double value = 0.0;
    Position start{};
    Position end{};
    AxisMask placed = 0;           ///< axes whose place the program has set by now
    AxisMask start_placed = 0;     ///< the same before
    double feed_per_min = 0.0;     ///< mm, or degrees where only rotary axes move; 0: rapid
    double length = 0.0;           ///< that the feed counts along, mm or degrees alike; 0: rapid
    const Plane* plane = nullptr;  ///< of an arc
    double centre_first_mm = 0.0;
    double centre_second_mm = 0.0;
    int turns = 0;  ///< begun, > 0 counterclockwise
    /// Drawn in the cross-section or on the unrolled cylinder, and so given out as one or more ways that are
    /// straight for the axes.
    bool is_drawn = false;
    bool begins_within = false;  ///< a drawn way, and not where that begins
    bool ends_within = false;    ///< a drawn way, not at its end: the end is passed in every mode of the path
};

/// A line that is executed.
struct ReachedLine {
    std::uint64_t number = 0;
    std::uint64_t called_line = 0;  ///< where the subroutine begins that it stands in; 0: the main program

    /// Whether a program that begins with this line has come to it. A subroutine that begins behind the line
    /// may be called before it.
    bool is_at_or_behind(std::uint64_t line) const noexcept { return number >= line && called_line <= line; }
};

/// Takes records in the order of their execution.
class CanonSink {
public:
    virtual ~CanonSink() = default;
    virtual void take(const CanonRecord& record) = 0;
    /// Before its records.
    virtual void begin_line(const ReachedLine&) {}
    /// What follows is of another block, though perhaps of the same line.
    virtual void end_block() {}
    /// A block, all of which was given, has set what outlives the program.
    virtual void set_offsets(const KeptOffsets&) {}
    /// What holds for the records that follow, where it is another than before. Only for who wants it.
    virtual void set_modes(const ActiveModes&) {}
    virtual bool wants_modes() const noexcept { return false; }
    /// Whom a block that may come to very many records is given to before it is given to this, so that it is
    /// judged before any of it is carried out. Null: that is not wanted.
    virtual CanonSink* rehearsal() { return nullptr; }
    /// False: it has failed, and there is no use in reading on.
    virtual bool wants_more() const noexcept { return true; }
};

}  // namespace psicarve::gcode
