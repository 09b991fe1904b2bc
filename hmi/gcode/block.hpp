// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
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
    }
    /// A word takes at least two bytes, so there is room for all words of a line.
    void add(const Word& word) noexcept { words_[count_++] = word; }
    void mark_deleted() noexcept { is_deleted_ = true; }

    std::uint64_t line() const noexcept { return line_; }
    bool is_deleted() const noexcept { return is_deleted_; }  ///< the block begins with /
    std::span<const Word> words() const noexcept { return {words_.data(), count_}; }

private:
    std::uint64_t line_ = 0;
    std::size_t count_ = 0;
    bool is_deleted_ = false;
    std::array<Word, kMostLineBytes / 2> words_;
};

}  // namespace psicarve::gcode
