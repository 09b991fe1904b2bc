// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/motion_command.hpp"

namespace psicarve::cli {
namespace {

constexpr CommandText kEstopText{
    "estop", "Emergency stop: no more pulses, spindle off, drives off, alarm",
    "Seen at the next tick, never refused. The switch on the machine is faster and needs no computer.",
    "psicarve estop"};
constexpr std::chrono::milliseconds kLimit{5000};

Result<int> emergency_stop(const CommonOptions& common) {
    auto link = link_to_stop(common);
    if (!link) return link.error();
    link->emergency_stop();
    const auto rest = link->wait_after_stop({MachineState::alarm}, kLimit);
    if (!rest) return rest.error();
    if (rest->is_port_silent != 0)
        return Error{ErrorCode::machine_refused, "estop: " + std::string{kSilentPortRemedy}};
    report_motion(common, kEstopText.name, *rest);
    return kExitDone;
}

}  // namespace

void add_estop(CommandSet& commands) {
    commands.add(kEstopText, emergency_stop);
}

}  // namespace psicarve::cli
