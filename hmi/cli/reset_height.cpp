// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/commands.hpp"
#include "hmi/cli/motion_command.hpp"

namespace psicarve::cli {

void add_reset_height(CommandSet& commands) {
    constexpr CommandText kResetHeightText{"reset-height",
                                           "Move Y to its limit sensor, which defines its position",
                                           "Waits until that is done.", "psicarve reset-height"};
    commands.add(kResetHeightText, [](const CommonOptions& common) {
        return motion_body(common, {CommandKind::reset_height, {}, {MachineState::ready, MachineState::off}});
    });
}

}  // namespace psicarve::cli
