// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "shared/machine/program_origin.hpp"
#include "shared/machine/program_status.hpp"

namespace psicarve::report {

// Which program runs, as its writer tells it. Nothing of it is believed: any bytes are a name that can be
// shown.

enum class OriginKind : std::uint8_t {
    file,
    stream,  ///< standard input
    typed,   ///< a block of the window's MDI line
};
OriginKind kind_of(const ProgramOrigin& origin) noexcept;
/// Without its folders, printable; "?" where it has none.
std::string file_name_of(const ProgramOrigin& origin);
/// "pocket.ngc", "standard input", "a typed block".
std::string origin_text(const ProgramOrigin& origin);
/// "single block", "optional stop", "block delete", "dry run", "ISO dialect", "from line 5": the first two as
/// they are switched now, the others as the program was read, where that is known.
std::vector<std::string> switch_names(const ProgramStatus& status, const ProgramOrigin* origin);

}  // namespace psicarve::report
