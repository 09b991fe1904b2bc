// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <memory>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/job_source.hpp"

namespace psicarve::cli {
namespace {

constexpr CommandText kProfileShowText{
    "show", "Every key of a profile with its value, as TOML, and nothing else",
    "Without FILE the built-in profile. What it prints can be edited and read back.",
    "psicarve profile show > machine.toml"};

Result<int> show(CommonOptions common, const std::string& path) {
    if (!path.empty()) common.profile = path;
    const auto profile = chosen_profile(common);
    if (!profile) return profile.error();
    std::printf("%s", profile_to_toml(*profile).c_str());
    return kExitDone;
}

}  // namespace

void add_profile_show(CommandSet& commands) {
    const auto path = std::make_shared<std::string>();
    commands.add_plain(kProfileShowText, [path](const CommonOptions& common) { return show(common, *path); })
        .optional_argument("FILE", *path, "A profile (TOML), or a job file whose profile is meant");
}

}  // namespace psicarve::cli
