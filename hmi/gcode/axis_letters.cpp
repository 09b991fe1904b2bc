// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/axis_letters.hpp"

namespace psicarve::gcode {

AxisMask AxisLetters::all() const noexcept {
    return static_cast<AxisMask>(of_heads() | mask_of(letter_of(Axis::psi)) | mask_of(letter_of(Axis::y)));
}

AxisMask AxisLetters::of_heads() const noexcept {
    return static_cast<AxisMask>(mask_of(letter_of(Axis::r1)) | mask_of(letter_of(Axis::r2)));
}

bool AxisLetters::has_arcs_in(const Plane& plane) const noexcept {
    const std::size_t y = letter_of(Axis::y);
    if (plane.first != y && plane.second != y) return false;
    const std::size_t other = plane.first == y ? plane.second : plane.first;
    return (of_heads() & mask_of(other)) != 0;
}

}  // namespace psicarve::gcode
