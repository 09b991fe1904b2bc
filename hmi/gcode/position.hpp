// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace psicarve::gcode {

/// X Y Z A B C U V W; mm, A B C in degrees.
using Position = std::array<double, 9>;
using AxisMask = std::uint16_t;  ///< bit n: axis n

inline constexpr std::size_t kLetterCount = 9;
inline constexpr std::string_view kAxisLetters = "XYZABCUVW";
inline constexpr AxisMask kAllLetters = 0x1FF;

constexpr bool is_rotary(std::size_t axis) noexcept {
    return axis >= 3 && axis <= 5;
}
constexpr AxisMask mask_of(std::size_t axis) noexcept {
    return static_cast<AxisMask>(1U << axis);
}

/// Where an arc is drawn: its two axes in the order of the plane, the one across, and the centre's words.
struct Plane {
    std::string_view name;
    std::size_t first;
    std::size_t second;
    std::size_t across;
    char first_centre;
    char second_centre;
    char other_centre;
};
inline constexpr Plane kPlaneXy{"XY", 0, 1, 2, 'I', 'J', 'K'};
inline constexpr Plane kPlaneZx{"ZX", 2, 0, 1, 'K', 'I', 'J'};
inline constexpr Plane kPlaneYz{"YZ", 1, 2, 0, 'J', 'K', 'I'};

}  // namespace psicarve::gcode
