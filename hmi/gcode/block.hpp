// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace psicarve::gcode {

inline constexpr std::size_t kMostLineBytes = 1024;

/// A letter in capitals with its number.
struct Word {
    char letter = 0;
    std::uint32_t column = 0;  ///< of the letter, from 1, in bytes
    double value = 0.0;
};

/// One line of a program, as read: does not judge what its words mean together.
class Block {
public:
    void begin(std::uint64_t line) noexcept {
        line_ = line;
        count_ = 0;
        is_deleted_ = false;
        has_values_ = false;
        o_word_.reset();
    }
    /// A word takes at least two bytes, so there is room for all words of a line.
    void add(const Word& word) noexcept { words_[count_++] = word; }
    void mark_deleted() noexcept { is_deleted_ = true; }
    void mark_values() noexcept { has_values_ = true; }
    void mark_o_word(std::size_t index) noexcept { o_word_ = index; }

    std::uint64_t line() const noexcept { return line_; }
    bool is_deleted() const noexcept { return is_deleted_; }  ///< the block begins with /
    bool has_values() const noexcept { return has_values_; }  ///< of parameters and expressions
    /// Index of the O in the line, where it holds an O word; what stands from there on is not in words().
    std::optional<std::size_t> o_word() const noexcept { return o_word_; }
    std::span<const Word> words() const noexcept { return {words_.data(), count_}; }

private:
    std::uint64_t line_ = 0;
    std::size_t count_ = 0;
    bool is_deleted_ = false;
    bool has_values_ = false;
    std::optional<std::size_t> o_word_;
    std::array<Word, kMostLineBytes / 2> words_;
};

}  // namespace psicarve::gcode
