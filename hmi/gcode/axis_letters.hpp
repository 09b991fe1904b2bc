// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "hmi/gcode/position.hpp"
#include "shared/machine/signal.hpp"

namespace psicarve::gcode {

/// Which letter of a program is which axis of the machine: X is r1, Z is r2, Y is y, C is psi.
class AxisLetters {
public:
    std::size_t letter_of(Axis axis) const noexcept { return letters_[index_of(axis)]; }
    /// All letters that move an axis.
    AxisMask all() const noexcept;
    /// Those that move r1 or r2.
    AxisMask of_heads() const noexcept;

    /// An arc moves y and one head.
    bool has_arcs_in(const Plane& plane) const noexcept;

private:
    std::array<std::size_t, kAxisCount> letters_{0, 2, 5, 1};
};

}  // namespace psicarve::gcode
