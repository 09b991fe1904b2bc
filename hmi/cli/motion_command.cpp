// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/motion_command.hpp"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/operator_break.hpp"
#include "hmi/cli/progress_bar.hpp"
#include "hmi/cli/status_text.hpp"
#include "hmi/report/status_json.hpp"
#include "shared/machine/jog_lease.hpp"

namespace psicarve::cli {

Result<machine::MachineLink> link_to_core(const CommonOptions& common) {
    auto link = machine::MachineLink::attach(common.segment, common.group);
    if (!link) return link;
    if (const auto core = link->require_core(); !core) return core.error();
    return link;
}

Result<machine::MachineLink> link_to_stop(const CommonOptions& common) {
    auto link = machine::MachineLink::attach_to_stop(common.segment);
    if (!link) return link;
    if (const auto core = link->require_core(); !core) return core.error();
    return link;
}

Result<CoreStatus> run_motion(machine::MachineLink& link, const MotionCommand& command) {
    OperatorBreak operator_break;
    Command message = command.details;
    message.kind = command.kind;
    if (command.axis) message.axis = static_cast<std::uint32_t>(index_of(*command.axis));
    if (const auto sent = link.send(message); !sent) return sent.error();
    if (command.wanted.empty()) return link.status_after_answer();
    ProgressBar bar{std::string{name_of(command.kind)}};
    const auto watch = [&](const CoreStatus& status) -> Result<void> {
        bar.update(0.0, std::string{name_of(status.state)});
        return operator_break.pass_on(link);
    };
    auto reached = link.wait_for_state(command.wanted, watch);
    if (!operator_break.was_asked()) return reached;
    return operator_break.error(link.last_status().value_or(CoreStatus{}));
}

Result<std::chrono::milliseconds> lease_argument(std::optional<double> asked_s,
                                                 std::chrono::milliseconds usual) {
    if (!asked_s) return usual;
    const double lease_ms = *asked_s * 1000.0;
    const bool is_possible = lease_ms >= static_cast<double>(2 * kJogRenewal.count()) &&
                             lease_ms <= static_cast<double>(kLongestJogLease.count());
    if (!is_possible) return Error{ErrorCode::bad_usage, "--lease: from 0.1 to 2 seconds"};
    return std::chrono::milliseconds{std::lround(lease_ms)};
}

void report_motion(const CommonOptions& common, std::string_view name, const CoreStatus& status) {
    if (!common.json) {
        std::printf("%s: the machine is %s\n", std::string{name}.c_str(), state_text(status).c_str());
        return;
    }
    nlohmann::ordered_json report{{"command", name}};
    report.update(report::status_json(status));
    std::printf("%s\n", report.dump().c_str());
}

Result<int> motion_body(const CommonOptions& common, const MotionCommand& command) {
    auto link = link_to_core(common);
    if (!link) return link.error();
    const auto status = run_motion(*link, command);
    if (!status) return status.error();
    report_motion(common, name_of(command.kind), *status);
    return kExitDone;
}

}  // namespace psicarve::cli
