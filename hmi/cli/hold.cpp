// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/motion_command.hpp"

namespace psicarve::cli {
namespace {

Result<int> hold(const CommonOptions& common) {
    auto link = link_to_stop(common);
    if (!link) return link.error();
    const MotionCommand command{
        CommandKind::hold, {}, {MachineState::held, MachineState::ready, MachineState::off}};
    const auto status = run_motion(*link, command);
    if (!status) return status.error();
    report_motion(common, name_of(command.kind), *status);
    return kExitDone;
}

}  // namespace

void add_hold(CommandSet& commands) {
    constexpr CommandText kHoldText{
        "hold", "Slow down on the path and rest there",
        "The spindle stays on. Waits until the machine is at rest; psicarve resume goes on.",
        "psicarve hold"};
    commands.add(kHoldText, hold);
}

}  // namespace psicarve::cli
