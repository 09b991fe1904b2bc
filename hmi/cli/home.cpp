// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/motion_command.hpp"

namespace psicarve::cli {
namespace {

constexpr CommandText kHomeText{
    "home", "Find the home positions, of all axes or of some",
    "R1 and R2 go out to their sensors first, then Y to its own, then Psi to its index. Waits until that is\n"
    "done. Y and Psi alone only once R1 and R2 are homed.",
    "psicarve home\n  psicarve home r2"};

Result<int> home(const CommonOptions& common, const std::vector<std::string>& names) {
    MotionCommand command{CommandKind::home, {}, {MachineState::ready}};
    for (const std::string& name : names) {
        const auto axis = axis_from_name(name);
        if (!axis) return Error{ErrorCode::bad_usage, "home: '" + name + "' is no axis; r1, r2, psi or y"};
        command.details.axis |= 1U << index_of(*axis);
    }
    // Homing some alone may leave others that are not homed.
    if (!names.empty()) command.wanted.push_back(MachineState::off);
    auto link = link_to_core(common);
    if (!link) return link.error();
    const auto status = run_motion(*link, command);
    if (!status) return status.error();
    report_motion(common, kHomeText.name, *status);
    return kExitDone;
}

}  // namespace

void add_home(CommandSet& commands) {
    const auto names = std::make_shared<std::vector<std::string>>();
    commands.add(kHomeText, [names](const CommonOptions& common) { return home(common, *names); })
        .optional_arguments("AXIS", *names, "r1, r2, psi, y: these alone");
}

}  // namespace psicarve::cli
