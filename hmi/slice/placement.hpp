// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace psicarve::slice {

/// Which of the model's axes stands upright on the table.
enum class Up : std::uint8_t { x, y, z };

/// Placed coordinate k is the file's coordinate source_coordinate(up)[k]: a rotation, never a mirror.
/// `up x` takes (x, y, z) to (y, z, x), `up y` to (z, x, y).
constexpr std::array<std::size_t, 3> source_coordinate(Up up) noexcept {
    switch (up) {
        case Up::x:
            return {1, 2, 0};
        case Up::y:
            return {2, 0, 1};
        case Up::z:
            break;
    }
    return {0, 1, 2};
}

/// A point of the file turned upright.
constexpr std::array<double, 3> placed(Up up, const std::array<double, 3>& point) noexcept {
    const auto from = source_coordinate(up);
    return {point[from[0]], point[from[1]], point[from[2]]};
}

/// How the rotation axis stands in the model: after turning it upright, at (axis_x, axis_y). File units.
struct Placement {
    Up up = Up::z;
    double axis_x = 0.0;
    double axis_y = 0.0;
};

}  // namespace psicarve::slice
