// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/base/printable.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>

namespace psicarve {
namespace {

std::uint8_t byte_of(char c) noexcept {
    return static_cast<std::uint8_t>(c);
}

bool continues(char c) noexcept {
    return (byte_of(c) & 0xC0U) == 0x80U;
}

/// The number of bytes of a letter that begins with this one; 0: none does.
std::size_t letter_size(char first) noexcept {
    const std::uint8_t lead = byte_of(first);
    if (lead < 0x80U) return 1;
    if (lead >= 0xC2U && lead < 0xE0U) return 2;
    if (lead >= 0xE0U && lead < 0xF0U) return 3;
    if (lead >= 0xF0U && lead < 0xF5U) return 4;
    return 0;
}

struct Letter {
    std::uint32_t code = 0;
    std::size_t size = 0;  ///< in bytes; 0: no UTF-8
};

/// Of the first letter.
Letter letter_of(std::string_view text) noexcept {
    constexpr std::array<std::uint32_t, 5> kLeast{0, 0, 0x80, 0x800, 0x10000};
    constexpr std::array<std::uint32_t, 5> kLeadBits{0, 0x7F, 0x1F, 0x0F, 0x07};
    const std::size_t size = letter_size(text.front());
    if (size == 0 || size > text.size()) return {};
    std::uint32_t code = byte_of(text.front()) & kLeadBits[size];
    for (std::size_t i = 1; i < size; ++i) {
        if (!continues(text[i])) return {};
        code = code << 6U | (byte_of(text[i]) & 0x3FU);
    }
    const bool is_surrogate = code >= 0xD800U && code < 0xE000U;
    return code < kLeast[size] || is_surrogate || code > 0x10FFFFU ? Letter{} : Letter{code, size};
}

bool steers(std::uint32_t code) noexcept {
    if (code == '\n' || code == '\t') return false;
    const bool is_control = code < 0x20U || (code >= 0x7FU && code < 0xA0U);
    const bool turns_writing = code == 0x061CU || code == 0x200EU || code == 0x200FU ||
                               (code >= 0x202AU && code <= 0x202EU) || (code >= 0x2066U && code <= 0x2069U);
    return is_control || turns_writing;
}

void add_escaped(std::string& out, const char* format, std::uint32_t value) {
    std::array<char, 16> escaped{};
    std::snprintf(escaped.data(), escaped.size(), format, value);
    out += escaped.data();
}

}  // namespace

std::string printable(std::string_view text) {
    std::string out;
    out.reserve(text.size());
    while (!text.empty()) {
        const Letter letter = letter_of(text);
        const std::size_t size = std::max<std::size_t>(letter.size, 1);
        if (letter.size == 0) {
            add_escaped(out, "\\x%02x", byte_of(text.front()));
        } else if (steers(letter.code)) {
            add_escaped(out, "\\u%04x", letter.code);
        } else {
            out += text.substr(0, size);
        }
        text.remove_prefix(size);
    }
    return out;
}

std::size_t unfinished_letter_bytes(std::string_view text) noexcept {
    for (std::size_t back = 1; back <= std::min<std::size_t>(text.size(), 3); ++back) {
        const char c = text[text.size() - back];
        if (!continues(c)) return letter_size(c) > back ? back : 0;
    }
    return 0;
}

}  // namespace psicarve
