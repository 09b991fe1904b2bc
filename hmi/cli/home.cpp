// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/commands.hpp"
#include "hmi/cli/motion_command.hpp"

namespace psicarve::cli {

void add_home(CommandSet& commands) {
    constexpr CommandText kText{"home", "Find the home positions",
                                "R1 and R2 go out to their sensors first, then Y to its own, then Psi to its "
                                "index. Waits until that is done.",
                                "psicarve home"};
    commands.add(kText, [](const CommonOptions& common) {
        return motion_body(common, {CommandKind::home, {}, {MachineState::ready}});
    });
}

}  // namespace psicarve::cli
