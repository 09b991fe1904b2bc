// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <optional>
#include <string_view>
#include <vector>

#include "hmi/cli/command_set.hpp"
#include "hmi/machine/machine_link.hpp"

namespace psicarve::cli {

/// The segment and its core; no_core when there is none of either.
Result<machine::MachineLink> link_to_core(const CommonOptions& common);
/// The same for orders to stop, which need no --group: any segment that the kernel lets us write.
Result<machine::MachineLink> link_to_stop(const CommonOptions& common);

/// One command to the core, answered; then a wait for one of `wanted` (none: no wait).
struct MotionCommand {
    CommandKind kind;
    std::optional<Axis> axis;
    std::vector<MachineState> wanted;
    Command details{};  ///< the command without kind and axis
};
/// Ctrl-C while waiting stops the machine. Returns the status at the end.
Result<CoreStatus> run_motion(machine::MachineLink& link, const MotionCommand& command);

/// run_motion on the common options' segment, then the report: "home: the machine is ready".
Result<int> motion_body(const CommonOptions& common, const MotionCommand& command);

/// The value of --lease for a jog or a test [s], `usual` without one; bad_usage beyond what the core allows.
Result<std::chrono::milliseconds> lease_argument(std::optional<double> asked_s,
                                                 std::chrono::milliseconds usual);

/// "home: the machine is ready", or {"command": ..., "state": ...}.
void report_motion(const CommonOptions& common, std::string_view name, const CoreStatus& status);

}  // namespace psicarve::cli
