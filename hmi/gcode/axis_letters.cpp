// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/axis_letters.hpp"

namespace psicarve::gcode {

AxisLetters::AxisLetters(const GcodeProfile& how) noexcept : letters_{} {
    const bool is_turning = how.letters == AxisNames::turning;
    const auto set = [&](Axis axis, char letter) { letters_[index_of(axis)] = kAxisLetters.find(letter); };
    set(Axis::r1, 'X');
    set(Axis::r2, how.second_head == SecondHead::follow ? 'X' : (is_turning ? 'U' : 'Z'));
    set(Axis::y, is_turning ? 'Z' : 'Y');
    set(Axis::psi, 'C');
}

AxisMask AxisLetters::all() const noexcept {
    return static_cast<AxisMask>(of_heads() | mask_of_axis(Axis::psi) | mask_of_axis(Axis::y));
}

AxisMask AxisLetters::of_heads() const noexcept {
    return static_cast<AxisMask>(mask_of_axis(Axis::r1) | mask_of_axis(Axis::r2));
}

bool AxisLetters::has_arcs_in(const Plane& plane) const noexcept {
    const std::size_t y = letter_of(Axis::y);
    if (plane.first != y && plane.second != y) return false;
    return (of_heads() & mask_of(plane.first == y ? plane.second : plane.first)) != 0;
}

}  // namespace psicarve::gcode
