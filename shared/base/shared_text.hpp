// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <string>

namespace psicarve {

/// Text that another process wrote into a fixed field: ends at its first zero or at the field's end. It goes
/// to terminals, so control characters (escape sequences) become '?'.
template <std::size_t kBytes>
std::string text_from_field(const char (&field)[kBytes]) {
    const char* const begin = static_cast<const char*>(field);
    std::string text{begin, ::strnlen(begin, kBytes)};
    std::replace_if(
        text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; },
        '?');
    return text;
}

/// Copies as much of the text as fits, cut between characters of UTF-8, zero-terminated.
template <std::size_t kBytes>
void text_into_field(char (&field)[kBytes], const std::string& text) {
    std::size_t length = std::min(text.size(), kBytes - 1);
    const auto continues = [&](std::size_t at) {
        return (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80;
    };
    while (length > 0 && length < text.size() && continues(length)) --length;
    std::memset(static_cast<char*>(field), 0, kBytes);
    text.copy(static_cast<char*>(field), length);
}

}  // namespace psicarve
