// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdio>
#include <string>

namespace psicarve {

/// A number for people, with `digits` digits behind the point. Requires |value| < 1e40, digits < 20.
inline std::string decimals(double value, int digits) {
    std::array<char, 64> text{};
    (void)std::snprintf(text.data(), text.size(), "%.*f", digits, value);
    return text.data();
}
inline std::string mm_text(double value_mm, int digits = 2) {
    return decimals(value_mm, digits) + " mm";
}

}  // namespace psicarve
