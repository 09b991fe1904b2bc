// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/motion_command.hpp"

namespace psicarve::cli {
namespace {

constexpr CommandText kText{
    "start", "Drives and spindle on, heads to the job's first point, wait there",
    "Waits until the machine is there. With --carve it goes on to carve and returns when "
    "carving has begun.",
    "psicarve start --carve"};

struct Options {
    bool carve = false;
};

Result<int> start(const CommonOptions& common, const Options& options) {
    auto link = link_to_core(common);
    if (!link) return link.error();
    auto status = run_motion(*link, {CommandKind::start, {}, {MachineState::waiting}});
    if (status && options.carve) status = run_motion(*link, {CommandKind::start_interpolation, {}, {}});
    if (!status) return status.error();
    report_motion(common, kText.name, *status);
    return kExitDone;
}

}  // namespace

void add_start(CommandSet& commands) {
    const auto options = std::make_shared<Options>();
    commands.add(kText, [options](const CommonOptions& common) { return start(common, *options); })
        .flag("--carve", options->carve, "Begin to carve at once");
}

}  // namespace psicarve::cli
