// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace psicarve {

inline constexpr std::string_view kGaps = " \t\r\n\f";

/// The text without the gaps at its ends, as a view of the same characters.
constexpr std::string_view trimmed(std::string_view text) noexcept {
    const std::size_t begin = text.find_first_not_of(kGaps);
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(kGaps) - begin + 1);
}

}  // namespace psicarve
