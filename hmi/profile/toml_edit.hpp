// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace psicarve::profile {

/// A profile's text with one value changed or added; everything else, comments included, stays as it is.
/// `path`: "axis.r1.speed_mm_s"; `toml`: the value. Knows `key = value` on one line below a `[table]` header
/// and keys dotted out in full at the top; of other ways to write TOML the result may not say what it should:
/// read it back before it is used.
std::string with_value(std::string_view text, std::string_view path, std::string_view toml);

/// What with_value() would replace: the value's text, or nothing where it would add a line.
std::optional<std::string> value_in(std::string_view text, std::string_view path);

}  // namespace psicarve::profile
