// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "shared/machine/program_status.hpp"

namespace psicarve::cli {

/// "line 8: held, tool change; psicarve resume goes on"; just the line while it moves.
std::string program_place_text(const ProgramStatus& program);
/// A line for a person, for status; empty while none runs.
std::string program_text(const ProgramStatus& program);
/// {"number", "line", "hold": null or its name, "single", "starvations"}; null while none runs.
nlohmann::ordered_json program_json(const ProgramStatus& program);

}  // namespace psicarve::cli
