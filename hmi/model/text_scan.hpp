// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace psicarve::model {

/// The text behind the mark that some editors put before UTF-8.
std::string_view without_byte_order_mark(std::string_view text) noexcept;

/// The words of a text, and their lines.
class Words {
public:
    /// Skips a byte order mark before the first word.
    explicit Words(std::string_view text);

    /// The next word, also of a later line; empty at the end.
    std::string_view next() noexcept;
    /// The next word of this line; empty at its end.
    std::string_view next_in_line() noexcept;
    /// To the start of the next line.
    void skip_line() noexcept;
    bool at_end() const noexcept { return position_ >= text_.size(); }
    std::size_t position() const noexcept { return position_; }
    /// Line of the last word, from 1.
    std::size_t line() const noexcept;

private:
    std::string_view text_;
    std::size_t position_ = 0;
    std::size_t start_ = 0;
};

/// Whether the word is this one, in upper or lower case.
bool is_word(std::string_view word, std::string_view lower_case) noexcept;

/// The whole word as a number; NaN and infinity are numbers too, and one too large for a double is infinite.
std::optional<double> number(std::string_view word) noexcept;
std::optional<long long> whole_number(std::string_view word) noexcept;

/// The beginning of foreign text for a message, in quotes; unusual characters are shown as '?'.
std::string quoted(std::string_view text, std::size_t most_characters = 20);

}  // namespace psicarve::model
