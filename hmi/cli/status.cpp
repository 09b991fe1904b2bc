// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/job_source.hpp"
#include "hmi/cli/motion_command.hpp"
#include "hmi/cli/status_text.hpp"
#include "hmi/cli/watch_loop.hpp"
#include "hmi/machine/machine_link.hpp"

namespace psicarve::cli {
namespace {

constexpr CommandText kText{
    "status", "What the machine is doing",
    "--watch shows it again and again until Ctrl-C: in place on a terminal, else a line for each change.",
    "psicarve status --watch"};

struct Options {
    bool watch = false;
};

/// The core's profile, when the one that we have is the same: only then are its mm and degrees ours.
std::optional<Profile> known_profile(machine::MachineLink& link, const Profile& chosen) {
    if (link.segment().header().core_profile_hash.load() != profile_hash(chosen)) return std::nullopt;
    return chosen;
}

std::string head_line(const machine::MachineLink& link) {
    return "segment    " + link.segment_name() + ", core pid " + std::to_string(link.core_pid().value_or(0)) +
           "\n";
}

std::string json_line(const machine::MachineLink& link, const CoreStatus& status) {
    nlohmann::ordered_json object{{"segment", link.segment_name()},
                                  {"core_pid", link.core_pid().value_or(0)}};
    object.update(status_json(status));
    return object.dump() + "\n";
}

/// What the dead core left behind is worth a line: where the machine was.
Error with_last_state(machine::MachineLink& link, Error error) {
    const auto last = link.last_status();
    if (!last || link.core_pid()) return error;
    error.message += "; the last one left it " + state_text(*last);
    if (last->points_total > 0) {
        error.message +=
            " at layer " + std::to_string(last->layer) + ", point " + std::to_string(last->point);
    }
    return error;
}

Result<int> show_status(const CommonOptions& common, const Options& options) {
    const auto chosen = chosen_profile(common);
    if (!chosen) return chosen.error();
    auto link = machine::MachineLink::attach(common.segment, common.group);
    if (!link) return link.error();
    const auto show = [&](bool as_line) -> Result<std::string> {
        const auto status = link->status();
        if (!status) return with_last_state(*link, status.error());
        if (common.json) return json_line(*link, *status);
        if (as_line) return status_line(*status);
        const auto profile = known_profile(*link, *chosen);
        return head_line(*link) + status_text(*status, profile ? &*profile : nullptr);
    };
    return show_or_watch(show, options.watch, common.json);
}

}  // namespace

void add_status(CommandSet& commands) {
    const auto options = std::make_shared<Options>();
    commands.add(kText, [options](const CommonOptions& common) { return show_status(common, *options); })
        .flag("--watch", options->watch, "Go on showing it until Ctrl-C");
}

}  // namespace psicarve::cli
