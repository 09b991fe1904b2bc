// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <string>

#include "hmi/gcode/interpreter.hpp"
#include "hmi/gcode/surface_feed.hpp"

namespace psicarve::gcode {
namespace {

constexpr double kMostTurns = 1e6;
/// What is left where offsets were added and taken off again is no move [mm].
constexpr double kLeastLength = 1e-7;
/// In mm or degrees; pulses of it can be counted.
constexpr double kFurthest = 1e9;

double length_of(const Position& from, const Position& to, std::size_t begin) noexcept {
    const double a = to[begin] - from[begin];
    const double b = to[begin + 1] - from[begin + 1];
    const double c = to[begin + 2] - from[begin + 2];
    return std::sqrt(a * a + b * b + c * c);
}

/// False for NaN, too.
bool is_in_reach(const Position& position) noexcept {
    return std::all_of(position.begin(), position.end(),
                       [](double place) { return std::abs(place) <= kFurthest; });
}

PlanePoint in_plane(const Position& position, const Plane& plane) noexcept {
    return {position[plane.first], position[plane.second]};
}

}  // namespace

Interpreter::Fault Interpreter::move() {
    const int before = modes_.motion;
    if (words_.has(CodeGroup::motion)) {
        modes_.motion = words_.code(CodeGroup::motion);
        doubts_.motion = false;
    }
    if (doubts_.motion) return std::nullopt;
    if (outcome_.motion == kNoCode) return std::nullopt;
    const bool is_arc = outcome_.motion == 20 || outcome_.motion == 30;
    if (!is_arc && !is_cycle(outcome_.motion) && words_.axes() == 0) return std::nullopt;
    if (drawing_.is_mode_doubtful) {
        pass_doubtful_move();
        return std::nullopt;
    }
    if (!is_drawing(DrawnMode::none)) return draw();
    if (is_cycle(outcome_.motion)) {
        if (words_.axes() == 0)
            return fault(words_.column(CodeGroup::motion), ProblemCode::axes_missing,
                         phrase("%1 has no axis word", code_name('G', outcome_.motion)));
        // The words of one cycle do not hold for another.
        if (!is_cycle(before)) cycle_.initial_mm = place_.program[modes_.plane->across];
        modes_.motion = before;
        const Fault wrong = drill();
        modes_.motion = outcome_.motion;
        return wrong;
    }
    return is_arc ? move_on_arc(outcome_.motion == 20) : move_straight(outcome_.motion == 0);
}

double Interpreter::axis_mm(std::size_t axis) const noexcept {
    return is_rotary(axis) ? words_.axis_value(axis) : words_.axis_value(axis) * modes_.mm_per_unit;
}

Position Interpreter::target() const noexcept {
    const AxisMask axes = words_.axes();
    const bool is_machine = words_.code(CodeGroup::once) == 530;
    Position end = is_machine ? place_.machine : place_.program;
    for (std::size_t axis = 0; axis < kLetterCount; ++axis) {
        if ((axes & mask_of(axis)) == 0) continue;
        end[axis] = modes_.is_incremental ? end[axis] + axis_mm(axis) : axis_mm(axis);
    }
    return is_machine ? offsets_.to_program(end) : end;
}

AxisMask Interpreter::both_if_turned(AxisMask axes) const noexcept {
    return static_cast<AxisMask>(offsets_.is_turned() && (axes & 3U) != 0 ? axes | 3U : axes);
}

AxisMask Interpreter::unknown_zeros() const noexcept {
    return static_cast<AxisMask>(
        both_if_turned(static_cast<AxisMask>(unknown_.shift | unknown_.origins[offsets_.active()])) |
        unknown_.tool);
}

void Interpreter::note_places(AxisMask axes, bool is_machine) noexcept {
    if (doubts_.are_of_places()) {
        place_.placed = static_cast<AxisMask>(place_.placed & ~both_if_turned(axes));
        doubts_.axes |= axes;
        return;
    }
    if (modes_.is_incremental && !is_machine) return;
    const AxisMask unknown = static_cast<AxisMask>(axes & unknown_zeros());
    doubts_.axes = static_cast<AxisMask>((doubts_.axes & ~axes) | (is_machine ? unknown : 0));
    const AxisMask both = 3;
    if (is_machine || !offsets_.is_turned() || (axes & both) == 0 || (axes & both) == both) {
        place_.placed |= axes;
    } else {
        // One word moves both axes of the machine, from where it stands.
        if ((place_.placed & both) != both) place_.placed = static_cast<AxisMask>(place_.placed & ~both);
        place_.placed |= static_cast<AxisMask>(axes & ~both);
    }
    if (!is_machine) place_.placed = static_cast<AxisMask>(place_.placed & ~both_if_turned(unknown));
}

Interpreter::Fault Interpreter::check_feed() {
    if (doubts_.feed) return std::nullopt;
    const std::uint32_t column = words_.axis_column();
    if (modes_.feed_mode == FeedMode::inverse_time) {
        if (words_.has('F') && modes_.feed_number > 0.0) return std::nullopt;
        return fault(column, ProblemCode::inverse_feed_missing, phrase("a move under G93 without F"));
    }
    if (modes_.feed_number <= 0.0)
        return fault(column, ProblemCode::feed_missing, phrase("a move that cuts, and the feed is 0"));
    if (modes_.feed_mode == FeedMode::per_revolution && modes_.spindle_rpm <= 0.0)
        return fault(column, ProblemCode::no_spindle_speed, phrase("a move under G95, and no spindle speed"));
    return std::nullopt;
}

double Interpreter::feed_of_length(double length) const noexcept {
    switch (modes_.feed_mode) {
        case FeedMode::inverse_time:
            return modes_.feed_number * length;
        case FeedMode::per_revolution:
            return modes_.feed_mm * modes_.spindle_rpm;
        case FeedMode::per_minute:
            break;
    }
    return modes_.feed_mm;
}

Interpreter::FeedAlong Interpreter::feed_of_line(const Position& from, const Position& to) const noexcept {
    if (options_.drawing.feeds_over_surface) {
        const double over_mm =
            line_over_surface_mm(options_.drawing, offsets_.to_machine(from), offsets_.to_machine(to));
        if (over_mm >= kLeastLength) return {feed_of_length(over_mm), over_mm};
    }
    double length = length_of(from, to, 0);
    if (length < kLeastLength) length = length_of(from, to, 6);
    if (length >= kLeastLength) return {feed_of_length(length), length};
    const double turned_deg = length_of(from, to, 3);
    if (turned_deg == 0.0 || modes_.feed_mode == FeedMode::inverse_time)
        return {feed_of_length(turned_deg), turned_deg};
    // Degrees, whatever the unit of length.
    return {modes_.feed_mode == FeedMode::per_minute ? modes_.feed_number
                                                     : modes_.feed_number * modes_.spindle_rpm,
            turned_deg};
}

void Interpreter::emit_move(CanonRecord& moved, const Position& program, const FeedAlong& along) {
    moved.start = place_.machine;
    moved.column = words_.axis_column();
    moved.feed_per_min = along.per_min;
    moved.length = along.length;
    moved.placed = place_.placed;
    moved.start_placed = place_.start_placed;
    const Position machine = offsets_.to_machine(program);
    if (!is_in_reach(machine) || !(std::abs(moved.centre_first_mm) <= kFurthest) ||
        !(std::abs(moved.centre_second_mm) <= kFurthest)) {
        outcome_.is_too_far = true;
        return;
    }
    place_.program = program;
    place_.machine = machine;
    place_.start_placed = place_.placed;
    moved.end = place_.machine;
    if (!moved.ends_within) ++course_.motions;
    if (moved.end != moved.start || moved.turns != 0) ++course_.actions;
    give(moved);
}

void Interpreter::rapid_to(const Position& program) {
    CanonRecord moved = record(CanonKind::rapid);
    emit_move(moved, program, {});
}

void Interpreter::feed_to(const Position& program) {
    CanonRecord moved = record(CanonKind::feed);
    emit_move(moved, program, feed_of_line(place_.program, program));
}

Interpreter::Fault Interpreter::move_straight(bool is_rapid) {
    if (!is_rapid)
        if (auto wrong = check_feed()) return wrong;
    const Position end = target();
    note_places(words_.axes(), words_.code(CodeGroup::once) == 530);
    is_rapid ? rapid_to(end) : feed_to(end);
    return std::nullopt;
}

Interpreter::Fault Interpreter::read_centre_words(const PlanePoint& start, PlanePoint& centre) const {
    const Plane& plane = *modes_.plane;
    const bool has_first = words_.has(plane.first_centre);
    const bool has_second = words_.has(plane.second_centre);
    if (modes_.has_absolute_centres && !(has_first && has_second))
        return fault(
            words_.first_column(), ProblemCode::word_missing,
            phrase("under G90.1 an arc has both %1 and %2", plane.first_centre, plane.second_centre));
    const double scale = modes_.mm_per_unit;
    const double first_mm = has_first ? words_.value(plane.first_centre) * scale : 0.0;
    const double second_mm = has_second ? words_.value(plane.second_centre) * scale : 0.0;
    centre = modes_.has_absolute_centres ? PlanePoint{first_mm, second_mm}
                                         : PlanePoint{start.first_mm + first_mm, start.second_mm + second_mm};
    return std::nullopt;
}

Interpreter::Fault Interpreter::find_centre(const PlanePoint& start, const PlanePoint& end, bool is_clockwise,
                                            PlanePoint& centre) {
    const Plane& plane = *modes_.plane;
    const bool has_centre = words_.has(plane.first_centre) || words_.has(plane.second_centre);
    const std::uint32_t column = words_.axis_column();
    if (words_.has(plane.other_centre))
        return fault(words_.column(plane.other_centre), ProblemCode::arc_words_mixed,
                     phrase("%1 is no word of an arc in %2", plane.other_centre, plane.name));
    if (words_.has('R') && has_centre)
        return fault(words_.column('R'), ProblemCode::arc_words_mixed,
                     phrase("the arc has a centre and a radius"));
    if (!words_.has('R') && !has_centre)
        return fault(column, ProblemCode::arc_centre_missing, phrase("the arc has no centre and no radius"));
    const AxisMask axes = static_cast<AxisMask>(mask_of(plane.first) | mask_of(plane.second));
    std::optional<ArcFault> wrong;
    if (words_.has('R')) {
        const double radius_mm = words_.value('R') * modes_.mm_per_unit;
        if (const auto found = centre_of_radius(start, end, radius_mm, is_clockwise, wrong)) centre = *found;
    } else {
        if (auto missing = read_centre_words(start, centre)) return missing;
        wrong = centre_fault(start, end, centre);
    }
    if (!wrong || (doubts_.axes & axes) != 0) return std::nullopt;
    return fault(column, wrong->code, std::move(wrong->what));
}

Interpreter::Fault Interpreter::read_turns(int& turns) const {
    turns = 1;
    if (!words_.has('P')) return std::nullopt;
    const double value = words_.value('P');
    if (value != std::floor(value))
        return fault(words_.column('P'), ProblemCode::not_whole, phrase("P of an arc counts its turns"));
    if (value < 1.0 || value > kMostTurns)
        return fault(words_.column('P'), ProblemCode::out_of_range, phrase("an arc has 1 to 1000000 turns"));
    turns = static_cast<int>(value);
    return std::nullopt;
}

Interpreter::Fault Interpreter::move_on_arc(bool is_clockwise) {
    const Plane& plane = *modes_.plane;
    if (auto wrong = check_feed()) return wrong;
    if (offsets_.is_turned() && plane.across != 2)
        return fault(words_.axis_column(), ProblemCode::arc_rotated,
                     phrase("an arc in %1 of a system that is rotated", plane.name));
    const Position end = target();
    const PlanePoint from = in_plane(place_.program, plane);
    const PlanePoint to = in_plane(end, plane);
    PlanePoint centre = from;
    int turns = 1;
    if (auto wrong = find_centre(from, to, is_clockwise, centre)) return wrong;
    if (auto wrong = read_turns(turns)) return wrong;
    CanonRecord moved = record(CanonKind::arc);
    note_places(words_.axes(), false);
    Position middle = end;
    middle[plane.first] = centre.first_mm;
    middle[plane.second] = centre.second_mm;
    middle = offsets_.to_machine(middle);
    moved.plane = &plane;
    moved.centre_first_mm = middle[plane.first];
    moved.centre_second_mm = middle[plane.second];
    moved.turns = is_clockwise ? -turns : turns;
    const double radius_mm = std::hypot(from.first_mm - centre.first_mm, from.second_mm - centre.second_mm);
    const double round_mm = radius_mm * sweep_rad(from, to, centre, moved.turns);
    double length_mm = std::hypot(round_mm, end[plane.across] - place_.program[plane.across]);
    if (options_.drawing.feeds_over_surface) {
        moved.start = place_.machine;
        moved.end = offsets_.to_machine(end);
        length_mm = arc_over_surface_mm(options_.drawing, moved, length_mm);
    }
    emit_move(moved, end, {feed_of_length(length_mm), length_mm});
    return std::nullopt;
}

}  // namespace psicarve::gcode
