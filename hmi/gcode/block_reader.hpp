// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "hmi/gcode/block.hpp"
#include "hmi/gcode/problem.hpp"

namespace psicarve::gcode {

/// Reads one line, without its line feed, into `block`: words in their order, capitals and small letters
/// alike, without blanks and comments. Nothing, or the first thing that cannot be read; the words before it
/// are in the block.
std::optional<Problem> read_block(std::string_view line, std::uint64_t line_number, Block& block);

/// Whether the line holds nothing but % and blanks.
bool is_percent_line(std::string_view line) noexcept;

}  // namespace psicarve::gcode
