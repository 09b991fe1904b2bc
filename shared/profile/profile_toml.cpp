// SPDX-License-Identifier: GPL-3.0-or-later
#include <xxhash.h>

#include <charconv>
#include <cmath>
#include <type_traits>

#include "shared/profile/profile_table.hpp"

namespace psicarve::profile_detail {
namespace {

std::string shortest(double value) {
    // Exponents only where plain digits would be unreadable.
    const double size = std::fabs(value);
    const bool plain = size == 0.0 || (size >= 1e-7 && size < 1e15);
    std::array<char, 400> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                   plain ? std::chars_format::fixed : std::chars_format::scientific)
                         .ptr;
    return {buffer.data(), end};
}

std::string word_as_toml(const KeySpec& key, std::uint8_t value) {
    for (const Word& word : key.words) {
        if (word.value == value) return toml_quoted(word.text);
    }
    return toml_quoted("?");
}

}  // namespace

std::string number_text(double value) {
    if (!std::isfinite(value)) return std::isnan(value) ? "nan" : (value < 0 ? "-inf" : "inf");
    return shortest(value);
}

std::string number_as_toml(double value) {
    std::string text = number_text(value);
    // Without a point TOML would read an integer; that is accepted, but it is not the same type.
    if (text.find_first_of(".en") == std::string::npos) text += ".0";
    return text;
}

std::string value_as_toml(const KeySpec& key, const Profile& profile) {
    return std::visit(
        [&](const auto* field) -> std::string {
            using T = std::remove_cvref_t<decltype(*field)>;
            if constexpr (std::is_same_v<T, double>) {
                return number_as_toml(*field);
            } else if constexpr (std::is_same_v<T, std::string>) {
                return toml_quoted(*field);
            } else if constexpr (std::is_same_v<T, std::array<double, 2>>) {
                return "[" + number_as_toml((*field)[0]) + ", " + number_as_toml((*field)[1]) + "]";
            } else if constexpr (std::is_enum_v<T> || std::is_same_v<T, bool>) {
                return word_as_toml(key, static_cast<std::uint8_t>(*field));
            } else {
                return std::to_string(*field);
            }
        },
        field_of(key, profile));
}

std::string bounds_text(const KeySpec& key) {
    if (!key.words.empty()) {
        std::string text;
        for (std::size_t i = 0; i < key.words.size(); ++i) {
            if (i > 0) text += i + 1 == key.words.size() ? " or " : ", ";
            text += key.words[i].text;
        }
        return text;
    }
    const std::string least = number_text(key.bounds.least);
    const std::string greatest = number_text(key.bounds.greatest);
    static const Profile kAny;
    const Field field = field_of(key, kAny);
    if (std::holds_alternative<std::string*>(field)) return least + " to " + greatest + " bytes";
    if (std::holds_alternative<std::array<double, 2>*>(field)) {
        return least + " <= first < second <= " + greatest;
    }
    return least + " <= value <= " + greatest;
}

}  // namespace psicarve::profile_detail

namespace psicarve {

std::string_view table_of_key(std::string_view path) noexcept {
    const std::size_t dot = path.rfind('.');
    return dot == std::string_view::npos ? std::string_view{} : path.substr(0, dot);
}

std::string_view leaf_of_key(std::string_view path) noexcept {
    const std::size_t dot = path.rfind('.');
    return dot == std::string_view::npos ? path : path.substr(dot + 1);
}

std::string toml_quoted(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') result += '\\';
        result += c;
    }
    return result + '"';
}

std::string profile_to_toml(const Profile& profile) {
    namespace detail = profile_detail;
    std::string text;
    std::string_view table;
    for (const detail::KeySpec& key : detail::key_table()) {
        if (table_of_key(key.path) != table) {
            table = table_of_key(key.path);
            text += "\n[" + std::string(table) + "]\n";
        }
        std::string line = std::string(leaf_of_key(key.path)) + " = " + detail::value_as_toml(key, profile);
        constexpr std::size_t kCommentColumn = 34;
        line.resize(std::max(line.size() + 1, kCommentColumn), ' ');
        text += line + "# ";
        if (!key.unit.empty() && key.unit != "pin") text += "[" + key.unit + "] ";
        text += key.explanation + "\n";
    }
    return text;
}

std::uint64_t profile_hash(const Profile& profile) {
    const std::string text = profile_to_toml(profile);
    return XXH3_64bits(text.data(), text.size());
}

}  // namespace psicarve
