// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "shared/base/result.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::cli {

// Read the command line's options for tool and blank into the profile; an empty text leaves the profile's
// value. ErrorCode::bad_usage names the option.

/// --tool: "point", "ball:3", "flat:2", "vee:6:60".
Result<void> read_tool(const std::string& text, ToolProfile& tool);
/// --flute: how deep the tool cuts; 0: deeper than any cut. After the tool.
Result<void> read_flute(const std::optional<double>& flute_mm, ToolProfile& tool);
/// --blank: "30x60".
Result<void> read_blank(const std::string& text, BlankProfile& blank);
/// --blank-at: "1.5,-2". After the blank.
Result<void> read_blank_at(const std::string& text, BlankProfile& blank);
/// --depth-limit. After the blank.
Result<void> read_depth_limit(const std::optional<double>& limit_mm, BlankProfile& blank);

/// The whole text as a finite number.
bool parse_number(std::string_view text, double& value);

}  // namespace psicarve::cli
