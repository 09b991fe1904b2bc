// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "hmi/gcode/position.hpp"

namespace psicarve::gcode {

/// Of a work coordinate system: where its zero is, in machine coordinates, and its turn in X and Y.
struct SystemOffset {
    Position origin{};
    double rotation_deg = 0.0;
    bool operator==(const SystemOffset&) const = default;
};

inline constexpr std::size_t kSystemCount = 9;
inline constexpr std::array<std::string_view, kSystemCount> kSystemNames{
    "G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"};

/// No offset, place or turn that is kept is larger [mm, degrees].
inline constexpr double kMostOffset = 1e9;

/// What outlives the program that sets it. Source: RS274/NGC as LinuxCNC 2.9 has it, persistent parameters
/// #5161 to #5390. All but #5220: a program begins with G54.
struct KeptOffsets {
    std::array<SystemOffset, kSystemCount> systems{};
    Position shift{};         ///< of G92, also while it is suspended
    bool is_shifted = false;  ///< it is in force
    /// Of G28 and G30, machine coordinates; nothing: where the machine has them.
    std::array<std::optional<Position>, 2> references{};
    /// None is larger than kMostOffset.
    bool is_within_limits() const noexcept;
    bool operator==(const KeptOffsets&) const = default;
};

}  // namespace psicarve::gcode
