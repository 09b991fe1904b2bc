// SPDX-License-Identifier: GPL-3.0-or-later
// The settings that blocks make, in the order of their execution.
#include <cmath>

#include "hmi/gcode/interpreter.hpp"

namespace psicarve::gcode {
namespace {

constexpr double kMostOutputs = 64.0;
/// Source: LinuxCNC 2.9, M66 L: at once, a rise, a fall, high, low.
constexpr double kMostWaits = 4.0;

FeedMode feed_mode_of(int code) noexcept {
    return code == 930 ? FeedMode::inverse_time
                       : (code == 940 ? FeedMode::per_minute : FeedMode::per_revolution);
}

bool is_whole(double value) noexcept {
    return value == std::floor(value);
}

}  // namespace

void Interpreter::set_units() {
    const int code = words_.code(CodeGroup::units);
    if (code == kNoCode) return;
    const double mm_per_unit = code == 200 ? kMmPerInch : 1.0;
    if (words_.has('F') && mm_per_unit != modes_.mm_per_unit)
        problems_.add(fault(words_.column('F'), ProblemCode::feed_beside_units,
                            phrase("F stands beside new units, and counts in these")));
    modes_.mm_per_unit = mm_per_unit;
    doubts_.units = false;
}

Interpreter::Fault Interpreter::set_feed() {
    if (words_.has(CodeGroup::feed_mode)) {
        const FeedMode mode = feed_mode_of(words_.code(CodeGroup::feed_mode));
        // A feed per minute means nothing per turn.
        if (mode != modes_.feed_mode) modes_.feed_number = modes_.feed_mm = 0.0;
        modes_.feed_mode = mode;
    }
    if (!words_.has('F')) return std::nullopt;
    modes_.feed_number = words_.value('F');
    modes_.feed_mm = modes_.feed_number * modes_.mm_per_unit;
    doubts_.feed = false;
    return std::nullopt;
}

Interpreter::Fault Interpreter::set_outputs() {
    const int code = words_.code(CodeGroup::outputs);
    if (code == kNoCode) return std::nullopt;
    if (!words_.has('P'))
        return fault(words_.column(CodeGroup::outputs), ProblemCode::word_missing,
                     phrase("%1 has no P, the number", code_name('M', code)));
    const double number = words_.value('P');
    if (!is_whole(number))
        return fault(words_.column('P'), ProblemCode::not_whole, phrase("P is a number of an output"));
    if (number < 0.0 || number >= kMostOutputs)
        return fault(words_.column('P'), ProblemCode::out_of_range,
                     phrase("outputs and inputs have numbers 0 to 63"));
    if (code == 66) {
        if (words_.has('L') && !is_whole(words_.value('L')))
            return fault(words_.column('L'), ProblemCode::not_whole, phrase("L of M66 is a way to wait"));
        if (words_.has('L') && (words_.value('L') < 0.0 || words_.value('L') > kMostWaits))
            return fault(words_.column('L'), ProblemCode::out_of_range, phrase("L of M66 is 0 to 4"));
        if (words_.has('Q') && words_.value('Q') < 0.0)
            return fault(words_.column('Q'), ProblemCode::out_of_range, phrase("a wait of less than 0 s"));
    }
    emit(code == 66 ? CanonKind::input : CanonKind::output, code, number);
    return std::nullopt;
}

void Interpreter::set_tool() {
    if (words_.has('T')) {
        modes_.tool = words_.value('T');
        emit(CanonKind::tool_select, 0, modes_.tool);
    }
    if (!words_.has(CodeGroup::tool)) return;
    if (modes_.is_spindle_on) emit(CanonKind::spindle, 5, 0.0);
    modes_.is_spindle_on = false;
    modes_.tool_in_spindle = modes_.tool;
    emit(CanonKind::tool_change, 6, modes_.tool);
}

void Interpreter::set_spindle() {
    const int code = words_.code(CodeGroup::spindle);
    if (code == kNoCode) return;
    modes_.is_spindle_on = code != 5;
    modes_.is_spindle_reverse = code == 4;
    emit(CanonKind::spindle, code, modes_.spindle_rpm);
}

Interpreter::Fault Interpreter::set_switches() {
    if (words_.has(CodeGroup::coolant)) {
        const int coolant = words_.code(CodeGroup::coolant);
        modes_.is_mist_on = coolant == 7 || (coolant == 8 && modes_.is_mist_on);
        modes_.is_flood_on = coolant == 8 || (coolant == 7 && modes_.is_flood_on);
        emit(CanonKind::coolant, coolant, 0.0);
    }
    if (!words_.has(CodeGroup::overrides)) return std::nullopt;
    const int code = words_.code(CodeGroup::overrides);
    const double value = code >= 50 && words_.has('P') ? words_.value('P') : 1.0;
    if (value != 0.0 && value != 1.0)
        return fault(words_.column('P'), ProblemCode::out_of_range,
                     phrase("P of %1 is 0, off, or 1, on", code_name('M', code)));
    if (code <= 49) modes_.are_overrides_off = code == 49;
    emit(CanonKind::override_set, code, value);
    return std::nullopt;
}

Interpreter::Fault Interpreter::dwell() {
    if (words_.code(CodeGroup::once) != 40) return std::nullopt;
    if (!words_.has('P'))
        return fault(words_.column(CodeGroup::once), ProblemCode::word_missing,
                     phrase("G4 has no P, the seconds"));
    if (words_.value('P') < 0.0)
        return fault(words_.column('P'), ProblemCode::out_of_range, phrase("a dwell of less than 0 s"));
    emit(CanonKind::dwell, 40, words_.value('P'));
    return std::nullopt;
}

void Interpreter::set_plane() noexcept {
    const int code = words_.code(CodeGroup::plane);
    if (code == kNoCode) return;
    modes_.plane = code == 170 ? &kPlaneXy : (code == 180 ? &kPlaneZx : &kPlaneYz);
}

void Interpreter::set_distances() noexcept {
    if (words_.has(CodeGroup::distance)) {
        modes_.is_incremental = words_.code(CodeGroup::distance) == 910;
        doubts_.distance = false;
    }
    if (words_.has(CodeGroup::arc_distance))
        modes_.has_absolute_centres = words_.code(CodeGroup::arc_distance) == 901;
    if (words_.has(CodeGroup::retract)) modes_.retracts_to_start = words_.code(CodeGroup::retract) == 980;
}

Interpreter::Fault Interpreter::set_path() {
    const int code = words_.code(CodeGroup::path);
    if (code == kNoCode) return std::nullopt;
    const bool has_tolerance = code == 640 && words_.has('P');
    for (const char letter : {'P', 'Q'})
        if (code == 640 && words_.has(letter) && words_.value(letter) < 0.0)
            return fault(words_.column(letter), ProblemCode::out_of_range,
                         phrase("a tolerance of less than 0"));
    if (code == 640 && words_.has('Q') && !course_.is_path_q_told) {
        course_.is_path_q_told = true;
        problems_.add(fault(words_.column('Q'), ProblemCode::tolerance_unused,
                            phrase("Q of G64 is not used: the tolerance of P holds for all")));
    }
    modes_.path = code;
    emit(CanonKind::path, code, has_tolerance ? words_.value('P') * modes_.mm_per_unit : 0.0);
    return std::nullopt;
}

Interpreter::Fault Interpreter::set_length() {
    const int code = words_.code(CodeGroup::length);
    if (code == kNoCode) return std::nullopt;
    modes_.length = code;
    if (code == 490) {
        offsets_.clear_tool();
        unknown_.tool = 0;
    } else {
        Position length{};
        for (std::size_t axis = 0; axis < kLetterCount; ++axis)
            if ((words_.axes() & mask_of(axis)) != 0) length[axis] = axis_mm(axis);
        offsets_.set_tool(words_.axes(), length);
        note_unknown(unknown_.tool, words_.axes(), 0);
    }
    refresh_program();
    return std::nullopt;
}

void Interpreter::set_system() {
    const int code = words_.code(CodeGroup::system);
    if (code == kNoCode) return;
    const int system = code <= 590 ? (code - 540) / 10 : 5 + (code - 590);
    offsets_.select(static_cast<std::size_t>(system));
    refresh_program();
}

Interpreter::Fault Interpreter::do_once() {
    switch (words_.code(CodeGroup::once)) {
        case 100:
            return set_coordinates();
        case 280:
            go_to_reference(0);
            refresh_program();
            return std::nullopt;
        case 300:
            go_to_reference(1);
            refresh_program();
            return std::nullopt;
        case 281:
            references_[0].at = place_.machine;
            references_[0].is_set = true;
            unknown_.references[0] = static_cast<AxisMask>(kAllLetters & ~place_.placed);
            break;
        case 301:
            references_[1].at = place_.machine;
            references_[1].is_set = true;
            unknown_.references[1] = static_cast<AxisMask>(kAllLetters & ~place_.placed);
            break;
        case 920:
            set_shift();
            break;
        case 921:
            offsets_.clear_shift();
            unknown_.shift = 0;
            break;
        case 922:
            offsets_.suspend_shift();
            break;
        case 923:
            offsets_.restore_shift();
            break;
        default:
            return std::nullopt;
    }
    refresh_program();
    return note_offsets();
}

/// They are told once the whole block is accepted.
Interpreter::Fault Interpreter::note_offsets() {
    KeptOffsets kept;
    offsets_.keep(kept);
    for (std::size_t which = 0; which < references_.size(); ++which)
        if (references_[which].is_set) kept.references[which] = references_[which].at;
    if (!kept.is_within_limits())
        return fault(words_.column(CodeGroup::once), ProblemCode::out_of_range,
                     phrase("an offset beyond 1 000 000 000 mm or degrees"));
    outcome_.offsets = kept;
    return std::nullopt;
}

Interpreter::Fault Interpreter::set_coordinates() {
    const std::uint32_t column = words_.column(CodeGroup::once);
    if (!words_.has('L')) return fault(column, ProblemCode::word_missing, phrase("G10 has no L"));
    const double kind = words_.value('L');
    if (kind != 2.0 && kind != 20.0)
        return fault(words_.column('L'), ProblemCode::out_of_range, phrase("G10 is read with L2 and L20"));
    if (!words_.has('P')) return fault(column, ProblemCode::word_missing, phrase("G10 has no P, the system"));
    const double number = words_.value('P');
    if (!is_whole(number))
        return fault(words_.column('P'), ProblemCode::not_whole, phrase("P is a system's number"));
    if (number < 0.0 || number > 9.0)
        return fault(words_.column('P'), ProblemCode::out_of_range, phrase("systems have numbers 0 to 9"));
    const std::size_t system = number == 0.0 ? offsets_.active() : static_cast<std::size_t>(number) - 1;
    if (words_.has('R') && kind == 20.0)
        return fault(words_.column('R'), ProblemCode::word_unused, phrase("G10 L20 sets no rotation"));
    if (words_.has('R')) offsets_.set_rotation(system, words_.value('R'));
    Position given{};
    for (std::size_t axis = 0; axis < kLetterCount; ++axis) {
        if ((words_.axes() & mask_of(axis)) == 0) continue;
        given[axis] = axis_mm(axis);
        if (kind == 2.0) offsets_.set_origin(system, axis, given[axis]);
    }
    if (kind == 20.0) offsets_.set_current(system, place_.machine, words_.axes(), given);
    // Where the place is not known, its new name does not locate the machine.
    const AxisMask axes = kind == 20.0 ? both_if_turned(words_.axes()) : words_.axes();
    const AxisMask unplaced =
        both_if_turned(static_cast<AxisMask>((kAllLetters & ~place_.placed) | unknown_.shift));
    note_unknown(unknown_.origins[system], axes, kind == 20.0 ? unplaced : AxisMask{0});
    // Of a rotation both axes.
    if (words_.has('R') && doubts_.values)
        unknown_.origins[system] |= static_cast<AxisMask>(mask_of(0) | mask_of(1));
    refresh_program();
    return note_offsets();
}

void Interpreter::set_shift() {
    Position given{};
    for (std::size_t axis = 0; axis < kLetterCount; ++axis)
        if ((words_.axes() & mask_of(axis)) != 0) given[axis] = axis_mm(axis);
    offsets_.set_shift(place_.machine, words_.axes(), given);
    const AxisMask unplaced = both_if_turned(
        static_cast<AxisMask>((kAllLetters & ~place_.placed) | unknown_.origins[offsets_.active()]));
    note_unknown(unknown_.shift, words_.axes(), unplaced);
}

/// Zeros that the block sets: those of unplaced axes, and all where the words are doubtful, are not known.
void Interpreter::note_unknown(AxisMask& zeros, AxisMask axes, AxisMask unplaced) const noexcept {
    zeros = static_cast<AxisMask>((zeros & ~axes) | (axes & (doubts_.are_of_words() ? axes : unplaced)));
}

void Interpreter::go_to_reference(std::size_t which) {
    const AxisMask axes = words_.axes() != 0 ? words_.axes() : kAllLetters;
    const Position between = target();
    note_places(words_.axes(), false);
    rapid_to(between);
    Position home = place_.machine;
    for (std::size_t axis = 0; axis < kLetterCount; ++axis)
        if ((axes & mask_of(axis)) != 0) home[axis] = references_[which].at[axis];
    note_places(axes, true);
    const AxisMask unknown = static_cast<AxisMask>(axes & unknown_.references[which]);
    place_.placed = static_cast<AxisMask>(place_.placed & ~unknown);
    doubts_.axes |= unknown;
    rapid_to(offsets_.to_program(home));
}

Interpreter::Fault Interpreter::stop() {
    const int code = words_.code(CodeGroup::stop);
    if (code == kNoCode) return std::nullopt;
    if (code == 98 || code == 99) return want_jump(code);
    emit(code == 2 || code == 30 ? CanonKind::end : CanonKind::stop, code, 0.0);
    course_.has_ended = code == 2 || code == 30;
    return std::nullopt;
}

Interpreter::Fault Interpreter::want_jump(int code) {
    const std::uint32_t column = words_.column(CodeGroup::stop);
    outcome_.jump = {code, 0, 1, column};
    if (code == 99) return std::nullopt;
    outcome_.jump.code = 0;
    if (!words_.has('P'))
        return fault(column, ProblemCode::word_missing, phrase("M98 has no P, the number of the subroutine"));
    if (!is_whole(words_.value('P')))
        return fault(words_.column('P'), ProblemCode::not_whole, phrase("P is the number of a subroutine"));
    if (words_.value('P') < 0.0)
        return fault(words_.column('P'), ProblemCode::out_of_range,
                     phrase("P is the number of a subroutine"));
    outcome_.jump = {code, static_cast<std::uint64_t>(words_.value('P')), 1, column};
    if (words_.has('L')) outcome_.jump.times = static_cast<std::uint64_t>(words_.value('L'));
    return std::nullopt;
}

}  // namespace psicarve::gcode
