// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <memory>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/job_source.hpp"

namespace psicarve::cli {
namespace {

constexpr CommandText kProfileShowText{"show",
                                       "Every key of a profile with its value, as TOML, and nothing else",
                                       "Without FILE the profile that applies (psicarve profile path), with "
                                       "--built-in the one that psicarve knows by "
                                       "itself.\nWhat it prints can be edited and read back.",
                                       "psicarve profile show > machine.toml"};

struct ShowOptions {
    std::string path;
    bool is_built_in = false;
};

Result<int> show(CommonOptions common, const ShowOptions& options) {
    if (options.is_built_in && (!options.path.empty() || !common.profile.empty()))
        return Error{ErrorCode::bad_usage, "profile show: --built-in is the profile of no file"};
    if (!options.path.empty()) common.profile = options.path;
    const auto profile = options.is_built_in ? Result<Profile>{Profile{}} : chosen_profile(common);
    if (!profile) return profile.error();
    std::printf("%s", profile_to_toml(*profile).c_str());
    return kExitDone;
}

}  // namespace

void add_profile_show(CommandSet& commands) {
    const auto options = std::make_shared<ShowOptions>();
    commands
        .add_plain(kProfileShowText,
                   [options](const CommonOptions& common) { return show(common, *options); })
        .flag("--built-in", options->is_built_in, "The built-in profile, whichever applies")
        .optional_argument("FILE", options->path, "A profile (TOML), or a job file whose profile is meant");
}

}  // namespace psicarve::cli
