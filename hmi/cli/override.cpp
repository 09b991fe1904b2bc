// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/motion_command.hpp"
#include "hmi/cli/status_text.hpp"
#include "shared/machine/recorded_program.hpp"

namespace psicarve::cli {
namespace {

constexpr CommandText kOverrideText{
    "override", "Carve at so many per cent of the planned feed",
    "At any time, from the next tick on, within every axis' limits. Stays until the "
    "next job is published, which\n"
    "begins with 100. --rapids: of the speed of a program's rapid ways, 10 to 100; the feed's is not for "
    "them.",
    "psicarve override 80"};

constexpr std::uint32_t kMostNumber = ~std::uint32_t{0};

struct OverrideOptions {
    std::uint32_t percent = kFullFeed_percent;
    bool is_of_rapids = false;
};

/// What the numbers may be depends on the flag.
Result<void> check_percent(const OverrideOptions& options) {
    const std::uint32_t most = options.is_of_rapids ? kFullFeed_percent : kMostOverride_percent;
    if (options.percent >= kLeastOverride_percent && options.percent <= most) return {};
    return Error{ErrorCode::bad_usage, "PERCENT: Value " + std::to_string(options.percent) +
                                           " not in range " + std::to_string(kLeastOverride_percent) +
                                           " to " + std::to_string(most) +
                                           " (see: psicarve override --help)"};
}

Result<int> override_speed(const CommonOptions& common, const OverrideOptions& options) {
    if (const auto fits = check_percent(options); !fits) return fits.error();
    auto link = link_to_core(common);
    if (!link) return link.error();
    Command details{};
    details.value = options.percent;
    const CommandKind kind = options.is_of_rapids ? CommandKind::rapid_override : CommandKind::override;
    const auto status = run_motion(*link, {kind, {}, {}, details});
    if (!status) return status.error();
    if (common.json) {
        report_motion(common, kOverrideText.name, *status);
    } else if (options.is_of_rapids) {
        std::printf("override: rapid ways at %u %% of their speed; the machine is %s\n",
                    rapid_override_percent(*status), state_text(*status).c_str());
    } else {
        std::printf("override: %u %% of the planned feed; the machine is %s\n",
                    unsigned{status->override_percent}, state_text(*status).c_str());
    }
    return kExitDone;
}

}  // namespace

void add_override(CommandSet& commands) {
    const auto options = std::make_shared<OverrideOptions>();
    commands
        .add(kOverrideText,
             [options](const CommonOptions& common) { return override_speed(common, *options); })
        .argument("PERCENT", options->percent, 0, kMostNumber, "10 to 200; 100 is the feed as planned")
        .flag("--rapids", options->is_of_rapids, "of a program's rapid ways, 10 to 100");
}

}  // namespace psicarve::cli
