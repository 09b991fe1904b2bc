// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "shared/base/result.hpp"

namespace psicarve::profile {

// Edits of a profile's text. toml++ reads it and says where each value stands, so every way to write TOML is
// known: dotted keys, `[ axis . r1 ]`, inline tables, arrays and strings over several lines.

/// The text with one value changed or added. Every other byte stays: comments, blanks, the ends of lines.
/// `path`: "axis.r1.speed_mm_s", bare keys; `toml`: the value as TOML writes it. A value that is missing is
/// added to its table as the table is written: on a line of its own behind the last of the table's lines,
/// within the braces of an inline table, or below a new `[table]` at the end. The result is read again, and
/// differs from `text` in this value alone. Errors: bad_input "line N: ..." where `text` is no TOML, or has
/// something else in the value's place; bad_input where `toml` is no value.
Result<std::string> with_value(std::string_view text, std::string_view path, std::string_view toml);

/// What with_value() would replace: the value's bytes, or nothing where it would add them or fail.
std::optional<std::string> value_in(std::string_view text, std::string_view path);

}  // namespace psicarve::profile
