// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/job_source.hpp"
#include "shared/profile/profile_place.hpp"

namespace psicarve::cli {
namespace {

constexpr CommandText kProfilePathText{
    "path", "Which machine profile applies",
    "The file of --profile; else the first that is there of $XDG_CONFIG_HOME/psicarve/machine.toml "
    "(~/.config)\n"
    "and /etc/psicarve/machine.toml; else 'built-in'. $PSICARVE_PROFILE names the one place instead.",
    "psicarve profile path"};

Result<int> show_path(const CommonOptions& common) {
    const std::string path = chosen_profile_path(common);
    if (const auto good = chosen_profile(common); !good) return good.error();
    if (!common.json) {
        std::printf("%s\n", path.empty() ? "built-in" : path.c_str());
        return kExitDone;
    }
    using PathJson = nlohmann::ordered_json;
    const PathJson object{{"profile", path.empty() ? PathJson(nullptr) : PathJson(path)},
                          {"places", profile_places()}};
    std::printf("%s\n", object.dump(-1, ' ', false, PathJson::error_handler_t::replace).c_str());
    return kExitDone;
}

}  // namespace

void add_profile_path(CommandSet& commands) {
    commands.add(kProfilePathText, show_path);
}

}  // namespace psicarve::cli
