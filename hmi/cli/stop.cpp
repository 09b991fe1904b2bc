// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/motion_command.hpp"

namespace psicarve::cli {
namespace {

constexpr CommandText kStopText{
    "stop", "Slow down on the path, retract, spindle off: the job ends",
    "Never waits behind anything and is never refused. Drives stay on. Waits until the machine is at rest.",
    "psicarve stop"};
constexpr std::chrono::milliseconds kRestLimit{5000};

Result<int> stop(const CommonOptions& common) {
    auto link = link_to_stop(common);
    if (!link) return link.error();
    link->stop();
    using S = MachineState;
    const auto rest = link->wait_after_stop({S::ready, S::off, S::alarm}, kRestLimit);
    if (!rest) return rest.error();
    report_motion(common, kStopText.name, *rest);
    return kExitDone;
}

}  // namespace

void add_stop(CommandSet& commands) {
    commands.add(kStopText, stop);
}

}  // namespace psicarve::cli
