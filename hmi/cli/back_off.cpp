// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/motion_command.hpp"

namespace psicarve::cli {
namespace {

constexpr CommandText kBackOffText{
    "back-off", "In alarm: move one axis away from its tripped sensor until that clears",
    "The one motion allowed while a limit is tripped; at home speed. Then: psicarve reset-alarm.",
    "psicarve back-off r1"};

Result<int> back_off(const CommonOptions& common, const std::string& axis_name) {
    auto link = link_to_core(common);
    if (!link) return link.error();
    const auto before = link->status();
    if (!before) return before.error();
    const auto after =
        run_motion(*link, {CommandKind::back_off, axis_from_name(axis_name), {MachineState::alarm}});
    if (!after) return after.error();
    // It begins and ends in alarm; a new alarm on the way means that it failed.
    if (after->alarm_count > before->alarm_count) return machine::alarm_error(*after);
    report_motion(common, kBackOffText.name, *after);
    return kExitDone;
}

}  // namespace

void add_back_off(CommandSet& commands) {
    const auto axis = std::make_shared<std::string>();
    commands.add(kBackOffText, [axis](const CommonOptions& common) { return back_off(common, *axis); })
        .choice_argument("AXIS", *axis, {"r1", "r2", "psi", "y"}, "The axis whose sensor is tripped");
}

}  // namespace psicarve::cli
