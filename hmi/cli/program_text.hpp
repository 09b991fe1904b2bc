// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "shared/machine/status.hpp"
#include "shared/profile/profile.hpp"
#include "shared/segment/segment_program.hpp"

namespace psicarve::cli {

/// "line 8: held, tool change; psicarve resume goes on"; just the line while it moves. Of a program that is
/// held for good also why.
std::string program_place_text(const ProgramReport& report);
/// Lines for a person, for status; empty while none runs. `profile`: null where the machine's is not known:
/// how far it is to go is not told then.
std::string program_text(const ProgramReport& report, const CoreStatus& machine, const Profile* profile);
/// What `status --json` says (docs/commands.md); null while none runs.
nlohmann::ordered_json program_json(const ProgramReport& report, const CoreStatus& machine,
                                    const Profile* profile);

}  // namespace psicarve::cli
