// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "hmi/gcode/block.hpp"
#include "hmi/gcode/parameters.hpp"
#include "hmi/gcode/problem.hpp"

namespace psicarve::gcode {

/// How a line is to be read.
struct ReadingMode {
    bool is_judging = false;     ///< only how it is written is judged: values are 1
    bool skips_deleted = false;  ///< nothing of a block that begins with /
};

/// Reads one line, without its line feed, into `block`: words in their order, capitals and small letters
/// alike, without blanks and comments. Assignments are planned with the parameters, and an O word is only
/// found. Nothing, or the first thing that cannot be read; the words before it are in the block.
std::optional<Problem> read_block(std::string_view line, std::uint64_t line_number, Parameters& parameters,
                                  ReadingMode mode, Block& block);

/// Whether the line holds nothing but % and blanks.
bool is_percent_line(std::string_view line) noexcept;

}  // namespace psicarve::gcode
