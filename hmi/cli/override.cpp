// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/motion_command.hpp"
#include "hmi/cli/status_text.hpp"

namespace psicarve::cli {
namespace {

constexpr CommandText kOverrideText{
    "override", "Carve at so many per cent of the planned feed",
    "At any time, from the next tick on, within every axis' limits. Stays until the "
    "next job is published, which\n"
    "begins with 100.",
    "psicarve override 80"};

Result<int> override_feed(const CommonOptions& common, std::uint32_t percent) {
    auto link = link_to_core(common);
    if (!link) return link.error();
    Command details{};
    details.value = percent;
    const auto status = run_motion(*link, {CommandKind::override, {}, {}, details});
    if (!status) return status.error();
    if (common.json) {
        report_motion(common, kOverrideText.name, *status);
    } else {
        std::printf("override: %u %% of the planned feed; the machine is %s\n", status->override_percent,
                    state_text(*status).c_str());
    }
    return kExitDone;
}

}  // namespace

void add_override(CommandSet& commands) {
    const auto percent = std::make_shared<std::uint32_t>(100U);
    commands
        .add(kOverrideText,
             [percent](const CommonOptions& common) { return override_feed(common, *percent); })
        .argument("PERCENT", *percent, kLeastOverride_percent, kMostOverride_percent,
                  "10 to 200; 100 is the feed as planned");
}

}  // namespace psicarve::cli
