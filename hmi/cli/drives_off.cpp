// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/commands.hpp"
#include "hmi/cli/motion_command.hpp"

namespace psicarve::cli {

void add_drives_off(CommandSet& commands) {
    constexpr CommandText kDrivesOffText{
        "drives-off", "Switch all drives off, the machine at rest",
        "The axes can be turned by hand then, so their positions are lost: home again.",
        "psicarve drives-off"};
    commands.add(kDrivesOffText, [](const CommonOptions& common) {
        return motion_body(common, {CommandKind::drives_off, {}, {MachineState::off}});
    });
}

}  // namespace psicarve::cli
