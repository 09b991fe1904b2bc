// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/approach.hpp"

#include <string>

#include "hmi/gcode/switched_outputs.hpp"

namespace psicarve::gcode {

Error ends_before(std::uint64_t line) {
    return bad_input("the program ends before line " + std::to_string(line) + "; begin at an earlier line");
}

void ApproachFinder::begin_line(const ReachedLine& line) {
    found_.is_reached = found_.is_reached || line.is_at_or_behind(from_line_);
}

void ApproachFinder::take(const CanonRecord& record) {
    if (found_.is_reached) return;
    if (record.kind == CanonKind::spindle) found_.is_spindle_on = record.code == 3;
    found_.outputs_on = outputs_behind(record, found_.outputs_on, wired_outputs_);
    const bool moves =
        record.kind == CanonKind::rapid || record.kind == CanonKind::feed || record.kind == CanonKind::arc;
    if (!moves) return;
    for (const Axis axis : kAllAxes) {
        const std::size_t letter = letters_.letter_of(axis);
        found_.place[index_of(axis)] = record.end[letter];
        if ((record.placed & mask_of(letter)) != 0)
            found_.placed = static_cast<std::uint8_t>(found_.placed | 1U << index_of(axis));
    }
}

}  // namespace psicarve::gcode
