// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/commands.hpp"
#include "hmi/cli/motion_command.hpp"

namespace psicarve::cli {

void add_hold(CommandSet& commands) {
    constexpr CommandText kText{
        "hold", "Slow down on the path and rest there",
        "The spindle stays on. Waits until the machine is at rest; psicarve resume goes on.",
        "psicarve hold"};
    commands.add(kText, [](const CommonOptions& common) {
        return motion_body(
            common, {CommandKind::hold, {}, {MachineState::held, MachineState::ready, MachineState::off}});
    });
}

}  // namespace psicarve::cli
