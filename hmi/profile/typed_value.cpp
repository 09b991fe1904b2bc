// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/profile/typed_value.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>

#include "shared/base/trimmed.hpp"
#include "shared/profile/profile_text.hpp"

namespace psicarve::profile {
namespace {

constexpr std::string_view kBetween = " ... ";

/// "12", "12.5", "1e3", also "12,5" as many keyboards have it; as TOML that is no integer.
std::optional<std::string> real_from(std::string_view typed) {
    std::string text(trimmed(typed));
    std::replace(text.begin(), text.end(), ',', '.');
    if (text.starts_with('+')) text.erase(0, 1);
    double value = 0.0;
    const auto end = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || end.ec != std::errc{} || end.ptr != text.data() + text.size()) return std::nullopt;
    // TOML wants digits on both sides of a point, and none of C's other spellings.
    const bool is_plain = text.find_first_not_of("0123456789+-.eE") == std::string::npos;
    if (!is_plain) return std::nullopt;
    // Nor does it know zeros before a number.
    const std::size_t begin = text.starts_with('-') ? 1 : 0;
    while (text.size() > begin + 1 && text[begin] == '0' && text[begin + 1] >= '0' && text[begin + 1] <= '9')
        text.erase(begin, 1);
    const std::size_t point = text.find('.');
    if (point != std::string::npos) {
        if (point + 1 == text.size() || text.find_first_of("eE") == point + 1) text.insert(point + 1, "0");
        if (point == 0 || text[point - 1] == '-') text.insert(point, "0");
    }
    if (text.find_first_of(".eE") == std::string::npos) text += ".0";
    return text;
}

std::optional<std::string> integer_from(std::string_view typed) {
    std::string_view text = trimmed(typed);
    if (text.starts_with('+')) text.remove_prefix(1);
    std::int64_t value = 0;
    const auto end = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || end.ec != std::errc{} || end.ptr != text.data() + text.size()) return std::nullopt;
    return std::to_string(value);
}

/// "0 ... 60", "0..60", "0; 60".
std::optional<std::string> range_from(std::string_view typed) {
    for (const std::string_view between : {"...", "..", "\xE2\x80\xA6", ";"}) {
        const std::size_t at = typed.find(between);
        if (at == std::string_view::npos) continue;
        const auto first = real_from(typed.substr(0, at));
        const auto second = real_from(typed.substr(at + between.size()));
        if (!first || !second) return std::nullopt;
        return "[" + *first + ", " + *second + "]";
    }
    return std::nullopt;
}

std::string unquoted(std::string_view toml) {
    if (toml.size() < 2) return std::string(toml);
    std::string result;
    for (std::size_t i = 1; i + 1 < toml.size(); ++i) {
        if (toml[i] == '\\' && i + 2 < toml.size()) ++i;
        result += toml[i];
    }
    return result;
}

bool has_control(std::string_view text) {
    return std::any_of(text.begin(), text.end(), [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte < 0x20 || byte == 0x7F;
    });
}

}  // namespace

std::string typed_from_toml(const ProfileKey& key, std::string_view toml) {
    switch (key.value) {
        case ProfileValue::text:
        case ProfileValue::word:
            return unquoted(toml);
        case ProfileValue::range: {
            const std::size_t comma = toml.find(',');
            if (comma == std::string_view::npos || toml.size() < 2) return std::string(toml);
            return std::string(trimmed(toml.substr(1, comma - 1))) + std::string(kBetween) +
                   std::string(trimmed(toml.substr(comma + 1, toml.size() - comma - 2)));
        }
        case ProfileValue::number:
        case ProfileValue::integer:
            break;
    }
    return std::string(toml);
}

std::optional<std::string> toml_from_typed(const ProfileKey& key, std::string_view typed) {
    switch (key.value) {
        case ProfileValue::number:
            return real_from(typed);
        case ProfileValue::integer:
            return integer_from(typed);
        case ProfileValue::range:
            return range_from(typed);
        case ProfileValue::text:
        case ProfileValue::word:
            break;
    }
    const std::string_view text = trimmed(typed);
    if (has_control(text)) return std::nullopt;
    return toml_quoted(text);
}

}  // namespace psicarve::profile
