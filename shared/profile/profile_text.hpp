// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace psicarve {

// How a profile's keys and texts are written down.

/// "axis.r1" of "axis.r1.speed_mm_s"; empty for keys of the top.
std::string_view table_of_key(std::string_view path) noexcept;
/// "speed_mm_s" of "axis.r1.speed_mm_s".
std::string_view leaf_of_key(std::string_view path) noexcept;

/// A text as a TOML string. Requires that it holds no control characters.
std::string toml_quoted(std::string_view text);

}  // namespace psicarve
