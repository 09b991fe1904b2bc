// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "hmi/gcode/block.hpp"
#include "hmi/gcode/code_groups.hpp"
#include "hmi/gcode/position.hpp"
#include "hmi/gcode/problem.hpp"

namespace psicarve::gcode {

/// Codes whose meaning differs between controls.
enum class Dialect : std::uint8_t {
    ngc,  ///< G20 and G21 are the units
    iso,  ///< G70 and G71, too
};

/// A block's words by their function: codes by group, values by letter. The interpreter marks each word that
/// it uses; a word left over has no use.
class BlockMeaning {
public:
    /// Nothing, or the fault that makes the block wrong in every mode.
    std::optional<Problem> read(const Block& block, Dialect dialect);

    std::uint64_t line() const noexcept { return line_; }
    std::uint32_t first_column() const noexcept { return first_column_; }
    bool is_empty() const noexcept { return is_empty_; }

    /// kNoCode: none.
    int code(CodeGroup group) const noexcept { return codes_[index_of(group)]; }
    bool has(CodeGroup group) const noexcept { return code(group) != kNoCode; }
    std::uint32_t column(CodeGroup group) const noexcept { return code_columns_[index_of(group)]; }

    bool has(char letter) const noexcept { return (given_ & bit_of(letter)) != 0; }
    /// Requires has(letter).
    double value(char letter) const noexcept { return values_[slot_of(letter)]; }
    std::uint32_t column(char letter) const noexcept { return columns_[slot_of(letter)]; }
    AxisMask axes() const noexcept { return axes_; }
    double axis_value(std::size_t axis) const noexcept { return value(kAxisLetters[axis]); }
    /// Column of the first axis word; the block's first column where there is none.
    std::uint32_t axis_column() const noexcept;

    void take(char letter) noexcept { taken_ |= bit_of(letter); }
    void take_axes() noexcept { are_axes_taken_ = true; }
    /// The first word that was not used.
    std::optional<Problem> left_over() const;

    Problem problem(std::uint32_t column, ProblemCode code, Phrase what) const;

private:
    static std::size_t index_of(CodeGroup group) noexcept { return static_cast<std::size_t>(group); }
    static std::size_t slot_of(char letter) noexcept { return static_cast<std::size_t>(letter - 'A'); }
    static std::uint32_t bit_of(char letter) noexcept { return std::uint32_t{1} << slot_of(letter); }

    std::optional<Problem> read_code(const Word& word, Dialect dialect);
    std::optional<Problem> read_value(const Word& word);
    std::optional<Problem> enter(const Word& word, CodeGroup group, int code);

    std::uint64_t line_ = 0;
    std::uint32_t first_column_ = 1;
    bool is_empty_ = true;
    std::array<int, kCodeGroupCount> codes_{};
    std::array<std::uint32_t, kCodeGroupCount> code_columns_{};
    std::array<double, 26> values_{};
    std::array<std::uint32_t, 26> columns_{};
    std::uint32_t given_ = 0;
    std::uint32_t taken_ = 0;
    AxisMask axes_ = 0;
    bool are_axes_taken_ = false;
};

/// "G92.1", "M30"
std::string code_name(char letter, int code);

}  // namespace psicarve::gcode
