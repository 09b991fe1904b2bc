// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "hmi/gcode/position.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::gcode {

/// Which letter of a program moves which axis of the machine, by the profile's [gcode]. Where r2 follows r1,
/// one letter moves both.
class AxisLetters {
public:
    explicit AxisLetters(const GcodeProfile& how) noexcept;

    std::size_t letter_of(Axis axis) const noexcept { return letters_[index_of(axis)]; }
    AxisMask mask_of_axis(Axis axis) const noexcept { return mask_of(letter_of(axis)); }
    /// All letters that move an axis.
    AxisMask all() const noexcept;
    /// Those that move r1 or r2.
    AxisMask of_heads() const noexcept;
    /// An arc moves y and the letter of a head.
    bool has_arcs_in(const Plane& plane) const noexcept;

private:
    std::array<std::size_t, kAxisCount> letters_;
};

}  // namespace psicarve::gcode
