// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "shared/segment/segment_program.hpp"

namespace psicarve::cli {

/// "line 8: held, tool change; psicarve resume goes on"; just the line while it moves. Of a program that is
/// held for good also why.
std::string program_place_text(const ProgramReport& report);
/// A line for a person, for status; empty while none runs.
std::string program_text(const ProgramReport& report);
/// {"number", "line", "hold": null or its name, "refusal": null or why it is held for good, "single",
/// "starvations"}; null while none runs.
nlohmann::ordered_json program_json(const ProgramReport& report);

}  // namespace psicarve::cli
