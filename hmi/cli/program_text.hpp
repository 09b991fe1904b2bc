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
/// The same with its name or, where that is not told, its number first: "pocket.ngc, line 8".
std::string named_place_text(const ProgramReport& report);
/// Whether the last program ended in a stop or an alarm, with a line at hand.
bool was_broken_off(const ProgramStatus& program);
/// Of such a one: "in line 8 of its program; gcode run FILE --from-line 8 begins where that line is reached
/// first": in a loop that is its first pass.
std::string broken_off_text(const ProgramStatus& program);
/// Lines for a person, for status: of the one that runs, or where the last one was broken off; else empty.
/// `profile`: null where the machine's is not known: how far it is to go is not told then.
std::string program_text(const ProgramReport& report, const CoreStatus& machine, const Profile* profile);
/// Of the last program of a flight recorder, for `snapshot info`: "line 8: held, tool change", or how it
/// ended. `may_run`: false where the machine's state says that none runs. Empty: there was none.
std::string recorded_program_text(const ProgramStatus& program, bool may_run);
nlohmann::ordered_json recorded_program_json(const ProgramStatus& program);
/// What `status --json` says (docs/commands.md); null while none runs.
nlohmann::ordered_json program_json(const ProgramReport& report, const CoreStatus& machine,
                                    const Profile* profile);
/// Of the last program, where none runs; null: there was none.
nlohmann::ordered_json last_program_json(const ProgramReport& report);

}  // namespace psicarve::cli
