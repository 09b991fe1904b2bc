// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/model/text_scan.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace psicarve::model {
namespace {

bool is_blank(char c) noexcept {
    return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v';
}
bool is_space(char c) noexcept {
    return c == '\n' || is_blank(c);
}

}  // namespace

std::string_view without_byte_order_mark(std::string_view text) noexcept {
    constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";
    return text.substr(0, kUtf8Mark.size()) == kUtf8Mark ? text.substr(kUtf8Mark.size()) : text;
}

Words::Words(std::string_view text)
    : text_(text), position_(text.size() - without_byte_order_mark(text).size()) {}

std::string_view Words::next() noexcept {
    while (position_ < text_.size() && is_space(text_[position_])) ++position_;
    start_ = position_;
    while (position_ < text_.size() && !is_space(text_[position_])) ++position_;
    return text_.substr(start_, position_ - start_);
}

std::string_view Words::next_in_line() noexcept {
    while (position_ < text_.size() && is_blank(text_[position_])) ++position_;
    start_ = position_;
    while (position_ < text_.size() && !is_space(text_[position_])) ++position_;
    return text_.substr(start_, position_ - start_);
}

void Words::skip_line() noexcept {
    const std::size_t end = text_.find('\n', position_);
    position_ = end == std::string_view::npos ? text_.size() : end + 1;
}

std::size_t Words::line() const noexcept {
    const auto end = text_.begin() + static_cast<std::ptrdiff_t>(std::min(start_, text_.size()));
    return 1 + static_cast<std::size_t>(std::count(text_.begin(), end, '\n'));
}

bool is_word(std::string_view word, std::string_view lower_case) noexcept {
    return std::equal(word.begin(), word.end(), lower_case.begin(), lower_case.end(), [](char a, char b) {
        return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b;
    });
}

std::optional<double> number(std::string_view word) noexcept {
    if (!word.empty() && word.front() == '+') word.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (end != word.data() + word.size()) return std::nullopt;
    if (error == std::errc::result_out_of_range) return HUGE_VAL;
    if (error != std::errc{}) return std::nullopt;
    return value;
}

std::optional<long long> whole_number(std::string_view word) noexcept {
    if (!word.empty() && word.front() == '+') word.remove_prefix(1);
    long long value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (end != word.data() + word.size() || error != std::errc{}) return std::nullopt;
    return value;
}

std::string quoted(std::string_view text, std::size_t most_characters) {
    std::string out = "'";
    for (const char c : text.substr(0, most_characters)) out += c >= ' ' && c <= '~' ? c : '?';
    return out + "'";
}

}  // namespace psicarve::model
