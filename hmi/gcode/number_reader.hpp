// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace psicarve::gcode {

/// The number behind a letter.
struct NumberReading {
    std::size_t end = 0;  ///< index of the first byte behind the number
    bool has_digits = false;
    std::optional<double> value;  ///< nothing: it is too large, or has no digits
};

/// Reads a number as RS274/NGC writes it: a sign, digits and a point, blanks anywhere between them; no
/// exponent. The value is the nearest double.
NumberReading read_number(std::string_view line, std::size_t begin) noexcept;

}  // namespace psicarve::gcode
