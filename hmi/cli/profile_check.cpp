// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/job_source.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr CommandText kProfileCheckText{
    "check", "Whether a machine profile is right",
    "Unknown keys, wrong types and impossible values are refused with their line.",
    "psicarve profile check machine.toml"};

Result<int> check(const CommonOptions& common, const std::string& named) {
    const std::string path = named.empty() ? chosen_profile_path(common) : named;
    if (path.empty())
        return Error{
            ErrorCode::bad_usage,
            "profile check: no FILE is given, and none is where a profile is looked for (psicarve profile "
            "path)"};
    const auto profile = load_profile(path);
    if (!profile) return profile.error();
    if (common.json) {
        const Json object{{"file", path}, {"ok", true}, {"name", profile->name}};
        std::printf("%s\n", object.dump(-1, ' ', false, Json::error_handler_t::replace).c_str());
    } else {
        std::printf("%s: OK, profile '%s'\n", path.c_str(), profile->name.c_str());
    }
    return kExitDone;
}

}  // namespace

void add_profile_check(CommandSet& commands) {
    const auto path = std::make_shared<std::string>();
    commands.add(kProfileCheckText, [path](const CommonOptions& common) { return check(common, *path); })
        .optional_argument("FILE", *path, "A machine profile (TOML); without it the one that applies");
}

}  // namespace psicarve::cli
