// SPDX-License-Identifier: GPL-3.0-or-later
// What G12.1 draws in the cross-section.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "hmi/gcode/interpreter.hpp"
#include "shared/base/units.hpp"

namespace psicarve::gcode {
namespace {

constexpr int kMostHalvings = 60;

}  // namespace

/// Where both X and C are said, the place is known again.
void Interpreter::locate_in_polar(const PlanePoint& to, Position& end) noexcept {
    drawing_.place = to;
    doubts_.axes |= kDrawnLetters;
    place_.placed = static_cast<AxisMask>(place_.placed & ~kDrawnLetters);
    const double radius_mm = std::hypot(to.first_mm, to.second_mm);
    const bool is_said = (words_.axes() & kDrawnLetters) == kDrawnLetters && !modes_.is_incremental;
    drawing_.is_doubtful = !is_said || doubts_.are_of_places() || (unknown_zeros() & kDrawnLetters) != 0 ||
                           !(radius_mm >= kLeastPolarMm);
    if (drawing_.is_doubtful) return;
    end[kDepthLetter] = radius_mm - options_.drawing.tip_mm[0];
    end[kTurnLetter] = deg_from_rad(std::atan2(to.second_mm, to.first_mm));
    place_.placed |= kDrawnLetters;
    doubts_.axes = static_cast<AxisMask>(doubts_.axes & ~kDrawnLetters);
}

Interpreter::Fault Interpreter::draw_in_polar() {
    const auto drawn_mm = [&](std::size_t letter, double from_mm) {
        if ((words_.axes() & mask_of(letter)) == 0) return from_mm;
        const double said_mm = words_.axis_value(letter) * modes_.mm_per_unit;
        return modes_.is_incremental ? from_mm + said_mm : said_mm;
    };
    const PlanePoint from = drawing_.place;
    const PlanePoint to{drawn_mm(kDepthLetter, from.first_mm), drawn_mm(kTurnLetter, from.second_mm)};
    const bool is_arc = outcome_.motion == 20 || outcome_.motion == 30;
    if (doubts_.are_of_places() || drawing_.is_doubtful) doubts_.axes |= kDrawnLetters;
    drawing_.is_doubtful = drawing_.is_doubtful || doubts_.are_of_places();
    PlanePoint centre = from;
    int turns = 1;
    if (is_arc)
        if (auto wrong = arc_in_plane(from, to, centre, turns)) return wrong;
    Position end = target();
    end[kDepthLetter] = place_.program[kDepthLetter];
    end[kTurnLetter] = place_.program[kTurnLetter];
    const AxisMask before = place_.placed;
    note_places(static_cast<AxisMask>(words_.axes() & ~kDrawnLetters), false);
    if (drawing_.is_doubtful) {
        locate_in_polar(to, end);
        emit_drawn(end, 1.0, feed_of_line(place_.program, end), true, true);
        return std::nullopt;
    }
    const PolarWay way = is_arc ? PolarWay::arc(from, to, centre, sweep_rad(from, to, centre, turns))
                                : PolarWay::line(from, to);
    if (way.length_mm() < kLeastWayMm) {
        emit_drawn(end, 1.0, feed_of_line(place_.program, end), true, true);
        return std::nullopt;
    }
    if (auto wrong = judge_core(way)) return wrong;
    drawing_.place = to;
    return carry_out_polar(way, end, before);
}

/// The way is that of the tip, but for a tool's length, which the program alone knows.
Interpreter::Fault Interpreter::judge_core(const PolarWay& way) const {
    const DrawingMachine& machine = options_.drawing;
    const double tool_mm = place_.machine[kDepthLetter] - place_.program[kDepthLetter];
    const double least_mm = way.least_radius_mm(0.0, 1.0);
    const auto comes_into_core = [&](std::size_t head) {
        return least_mm + tool_mm < machine.core_mm - machine.half_pulse_mm[head];
    };
    const bool has_direction = least_mm >= kLeastPolarMm;
    const bool is_of_second = machine.follows && !comes_into_core(0) && comes_into_core(1);
    if (has_direction && !is_of_second && !comes_into_core(0)) return std::nullopt;
    const PlanePoint there = way.at(way.nearest_share());
    const std::string x = mm_text(there.first_mm);
    const std::string c = mm_text(there.second_mm);
    if (!has_direction)
        return fault(words_.axis_column(), ProblemCode::core_radius,
                     phrase("at X %1 C %2 mm the way passes the axis", x, c));
    return fault(
        words_.axis_column(), ProblemCode::core_radius,
        phrase("at X %1 C %2 mm the tip of %3 comes to %4 mm, and the core that it must not reach "
               "ends at %5 mm",
               x, c, is_of_second ? "r2" : "r1", mm_text(least_mm + tool_mm), mm_text(machine.core_mm)));
}

/// Pieces of the way are halved until they are even enough. What gets its place by the block, and had none
/// `before`, has it at the end alone.
Interpreter::Fault Interpreter::carry_out_polar(const PolarWay& way, const Position& end, AxisMask before) {
    constexpr double kLeastChordMm = 1e-7;
    const Position start = place_.program;
    const auto beside = static_cast<AxisMask>(options_.drawing.linear_letters() & ~kDrawnLetters);
    const double length_mm = std::hypot(way.length_mm(), moved_mm(end, beside));
    const FeedAlong along{feed_of_length(length_mm), length_mm};
    const double most_mm = std::max(chord_mm(), kLeastChordMm);
    const double begin_rad = rad_from_deg(start[kTurnLetter]);
    std::array<double, kMostHalvings> ends{1.0};
    std::size_t open = 1;
    double from = 0.0;
    const AxisMask behind = place_.placed;
    place_.placed = static_cast<AxisMask>(behind & before);
    for (std::uint64_t count = 1; open > 0 && sink_->wants_more() && !outcome_.is_too_far;) {
        const double to = ends[open - 1];
        if (open < ends.size() && way.deviation_mm(from, to) > most_mm) {
            ends[open++] = from + (to - from) / 2.0;
            continue;
        }
        if (count++ > kMostDrawnChords)
            return fault(words_.axis_column(), ProblemCode::out_of_range,
                         phrase("a way of more than 100000 chords"));
        Position at;
        for (std::size_t letter = 0; letter < kLetterCount; ++letter)
            at[letter] = to < 1.0 ? start[letter] + to * (end[letter] - start[letter]) : end[letter];
        const PlanePoint there = way.at(to);
        at[kDepthLetter] = std::hypot(there.first_mm, there.second_mm) - options_.drawing.tip_mm[0];
        // The direction itself, with the turns that it has come to: nothing is summed up.
        const double direction_rad = std::atan2(there.second_mm, there.first_mm);
        const double turns = std::round((begin_rad + way.turned_rad(to) - direction_rad) / (2.0 * kPi));
        at[kTurnLetter] = deg_from_rad(direction_rad) + turns * kDegPerRev;
        if (--open == 0) place_.placed = behind;
        emit_drawn(at, to - from, along, from == 0.0, open == 0);
        from = to;
    }
    return std::nullopt;
}

}  // namespace psicarve::gcode
