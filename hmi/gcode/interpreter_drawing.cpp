// SPDX-License-Identifier: GPL-3.0-or-later
// The modes of drawing with the table: G7.1 on the unrolled cylinder, G12.1 and G13.1 in the cross-section.
// What is drawn becomes ways that are straight for the axes, close enough that they and their corners keep
// the tolerance.
#include <cmath>
#include <string>
#include <string_view>

#include "hmi/gcode/arc_chords.hpp"
#include "hmi/gcode/interpreter.hpp"
#include "shared/base/units.hpp"

namespace psicarve::gcode {
namespace {

/// X 0 is the axis within this.
constexpr double kSameZeroMm = 1e-6;
bool is_once_kept(int code) noexcept {
    return code == kNoCode || code == 40;
}

std::string_view mode_name(DrawnMode mode) noexcept {
    return mode == DrawnMode::cylinder ? "G7.1" : "G12.1";
}

}  // namespace

/// G7.1 with its C, G12.1 and G13.1 stand alone.
Interpreter::Fault Interpreter::judge_drawing() {
    const int code = words_.code(CodeGroup::drawing);
    const std::uint32_t column = words_.column(CodeGroup::drawing);
    const std::string name = code_name('G', code);
    outcome_.motion = kNoCode;
    for (std::size_t group = 0; group < kCodeGroupCount; ++group) {
        const auto which = static_cast<CodeGroup>(group);
        if (which != CodeGroup::drawing && words_.has(which))
            return fault(words_.column(which), ProblemCode::drawing_beside,
                         phrase("another code stands beside %1", name));
    }
    const AxisMask own = code == 71 ? mask_of(kTurnLetter) : AxisMask{0};
    if ((words_.axes() & ~own) != 0)
        return fault(words_.axis_column(), ProblemCode::drawing_beside,
                     phrase("an axis word stands beside %1", name));
    for (const char letter : {'F', 'S', 'T'})
        if (words_.has(letter))
            return fault(words_.column(letter), ProblemCode::drawing_beside,
                         phrase("%1 stands beside %2", letter, name));
    words_.take_axes();
    if (code != 71) return words_.left_over();
    if (!words_.has('C'))
        return fault(column, ProblemCode::word_missing, phrase("G7.1 has no C, the cylinder's radius"));
    if (words_.value('C') < 0.0 && !doubts_.values)
        return fault(words_.column('C'), ProblemCode::out_of_range,
                     phrase("a cylinder's radius of less than 0"));
    return words_.left_over();
}

/// What would move the drawing's zero or its plane, or leaves it.
Interpreter::Fault Interpreter::judge_drawing_mode() {
    const auto refused = [&](CodeGroup group) {
        return fault(
            words_.column(group), ProblemCode::drawing_code,
            phrase("%1 while %2 holds", code_name('G', words_.code(group)), mode_name(drawing_.mode)));
    };
    for (const CodeGroup group : {CodeGroup::plane, CodeGroup::length, CodeGroup::system})
        if (words_.has(group)) return refused(group);
    if (!is_once_kept(words_.code(CodeGroup::once))) return refused(CodeGroup::once);
    if (is_cycle(outcome_.motion) && words_.has(CodeGroup::motion)) return refused(CodeGroup::motion);
    return std::nullopt;
}

Interpreter::Fault Interpreter::set_drawing() {
    const int code = words_.code(CodeGroup::drawing);
    const bool ends = code == 131 || (code == 71 && words_.value('C') == 0.0);
    // Behind a wrong one, or with a value that is not known, it is not known what held.
    drawing_.is_mode_doubtful = code == 71 && doubts_.values;
    if (drawing_.is_mode_doubtful) {
        doubt_drawing();
        return std::nullopt;
    }
    const DrawnMode mode = code == 71 ? DrawnMode::cylinder : DrawnMode::polar;
    // To end what does not hold is right: programs begin so, for safety.
    const bool holds_other = !is_drawing(DrawnMode::none) && (!ends || !is_drawing(mode));
    if (holds_other)
        return fault(words_.column(CodeGroup::drawing), ProblemCode::drawing_code,
                     phrase("%1 while %2 holds", code_name('G', code), mode_name(drawing_.mode)));
    if (!ends) return begin_drawing(mode);
    if (!is_drawing(DrawnMode::none)) end_drawing();
    return std::nullopt;
}

Interpreter::Fault Interpreter::begin_drawing(DrawnMode mode) {
    const std::uint32_t column = words_.column(CodeGroup::drawing);
    const std::string_view name = mode_name(mode);
    // Also where something is wrong with it: what follows is written for it.
    drawing_.mode = mode;
    drawing_.plane_before = modes_.plane;
    drawing_.radius_mm = mode == DrawnMode::cylinder ? words_.value('C') * modes_.mm_per_unit : 0.0;
    drawing_.is_doubtful = (doubts_.axes & kDrawnLetters) != 0;
    modes_.plane = mode == DrawnMode::polar ? &kCrossSection
                                            : (options_.drawing.is_y_on_z ? &kCylinderZc : &kCylinderCy);
    if (is_cycle(modes_.motion) && !doubts_.motion)
        return fault(column, ProblemCode::drawing_begin, phrase("%1 while a cycle holds", name));
    if (offsets_.is_turned())
        return fault(column, ProblemCode::drawing_begin, phrase("%1 in a system that is rotated", name));
    return mode == DrawnMode::polar && !drawing_.is_doubtful ? begin_polar() : std::nullopt;
}

Interpreter::Fault Interpreter::begin_polar() {
    const std::uint32_t column = words_.column(CodeGroup::drawing);
    if ((place_.placed & kDrawnLetters) != kDrawnLetters || (unknown_zeros() & kDrawnLetters) != 0)
        return fault(column, ProblemCode::drawing_begin,
                     phrase("G12.1, and the program has not said yet where X and C are"));
    const double zero_mm = offsets_.origin(offsets_.active())[kDepthLetter] +
                           (offsets_.is_shifted() ? offsets_.kept_shift()[kDepthLetter] : 0.0);
    const DrawingMachine& machine = options_.drawing;
    const double radius_mm = place_.program[kDepthLetter] + machine.tip_mm[0];
    const double apart_mm = machine.tip_mm[1] - machine.tip_mm[0];
    if (machine.follows && std::abs(apart_mm) > machine.half_pulse_mm[1])
        return fault(
            column, ProblemCode::drawing_begin,
            phrase(apart_mm < 0.0 ? "G12.1, and the tip of r2, which follows, stands %1 mm further in"
                                  : "G12.1, and the tip of r2, which follows, stands %1 mm further out",
                   mm_text(std::abs(apart_mm))));
    if (std::abs(zero_mm) > kSameZeroMm)
        return fault(column, ProblemCode::drawing_begin,
                     phrase("G12.1, and X 0 lies %1 mm off the axis", mm_text(zero_mm)));
    if (!(radius_mm >= kLeastPolarMm))
        return fault(
            column, ProblemCode::drawing_begin,
            phrase("G12.1 with the tip %1 mm from the axis, and there is no direction", mm_text(radius_mm)));
    const double angle_rad = rad_from_deg(place_.program[kTurnLetter]);
    drawing_.place = {radius_mm * std::cos(angle_rad), radius_mm * std::sin(angle_rad)};
    return std::nullopt;
}

/// It may have been drawn, or gone to straight.
void Interpreter::pass_doubtful_move() noexcept {
    const AxisMask axes = static_cast<AxisMask>(words_.axes() | kDrawnLetters);
    doubts_.axes |= axes;
    place_.placed = static_cast<AxisMask>(place_.placed & ~axes);
    place_.start_placed = static_cast<AxisMask>(place_.start_placed & ~axes);
}

/// C goes on from the direction that it has come to, with all its turns.
void Interpreter::end_drawing() noexcept {
    drawing_.mode = DrawnMode::none;
    modes_.plane = drawing_.plane_before;
}

/// What chords may be off: the rest of the tolerance is for their corners.
double Interpreter::chord_mm() const noexcept {
    return kChordShare *
           (drawing_.tolerance_mm > 0.0 ? drawing_.tolerance_mm : options_.drawing.tolerance_mm);
}

/// Along these letters alone, from where the machine stands.
double Interpreter::moved_mm(const Position& to, AxisMask letters) const noexcept {
    double squares = 0.0;
    for (std::size_t letter = 0; letter < kLetterCount; ++letter) {
        const double moved_mm = to[letter] - place_.program[letter];
        if ((letters & mask_of(letter)) != 0) squares += moved_mm * moved_mm;
    }
    return std::sqrt(squares);
}

Interpreter::Fault Interpreter::draw() {
    if (is_cycle(outcome_.motion))
        return fault(words_.axis_column(), ProblemCode::drawing_code,
                     phrase("a cycle while %1 holds", mode_name(drawing_.mode)));
    if (outcome_.motion != 0)
        if (auto wrong = check_feed()) return wrong;
    return is_drawing(DrawnMode::polar) ? draw_in_polar() : draw_on_cylinder();
}

Interpreter::Fault Interpreter::arc_in_plane(const PlanePoint& from, const PlanePoint& to, PlanePoint& centre,
                                             int& turns) {
    const bool is_clockwise = outcome_.motion == 20;
    if (auto wrong = find_centre(from, to, is_clockwise, centre)) return wrong;
    if (auto wrong = read_turns(turns)) return wrong;
    if (is_clockwise) turns = -turns;
    return std::nullopt;
}

/// One of the ways that something drawn becomes: its last `share`.
void Interpreter::emit_drawn(const Position& program, double share, const FeedAlong& along, bool is_first,
                             bool is_last) {
    CanonRecord moved = record(outcome_.motion == 0 ? CanonKind::rapid : CanonKind::feed);
    moved.is_drawn = true;
    ++course_.drawn_chords;
    moved.begins_within = !is_first;
    moved.ends_within = !is_last;
    emit_move(moved, program,
              outcome_.motion == 0 ? FeedAlong{} : FeedAlong{along.per_min, along.length * share});
}

}  // namespace psicarve::gcode
