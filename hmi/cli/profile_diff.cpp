// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/job_source.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::cli {
namespace {

using DiffJson = nlohmann::ordered_json;

constexpr CommandText kProfileDiffText{
    "diff", "In which keys two profiles differ",
    "Without B: from the built-in profile. Exit code 6 when they differ. Either may be a job file, whose "
    "profile is\n"
    "meant. With * are keys that matter to motion: a core refuses a job that was made for another value.",
    "psicarve profile diff machine.toml\n  psicarve profile diff machine.toml figurine.job"};

struct DiffOptions {
    std::string a;
    std::string b;
};

struct KeyDifference {
    const ProfileKey* key;
    std::string a;
    std::string b;
};

std::vector<KeyDifference> differences(const Profile& a, const Profile& b) {
    const auto of_a = profile_values(a);
    const auto of_b = profile_values(b);
    std::vector<KeyDifference> found;
    for (std::size_t i = 0; i < of_a.size(); ++i)
        if (of_a[i] != of_b[i]) found.push_back({&profile_keys()[i], of_a[i], of_b[i]});
    return found;
}

Result<Profile> profile_of(CommonOptions common, const std::string& path) {
    if (path.empty()) return Profile{};
    common.profile = path;
    return chosen_profile(common);
}

std::string diff_json(const DiffOptions& options, const std::vector<KeyDifference>& found) {
    auto keys = DiffJson::object();
    for (const KeyDifference& one : found)
        keys[one.key->path] = {{"a", one.a},
                               {"b", one.b},
                               {"unit", one.key->unit.empty() ? DiffJson(nullptr) : DiffJson(one.key->unit)},
                               {"matters_to_motion", one.key->matters_to_motion}};
    const DiffJson object{{"a", options.a},
                          {"b", options.b.empty() ? DiffJson(nullptr) : DiffJson(options.b)},
                          {"differences", keys}};
    return object.dump(-1, ' ', false, DiffJson::error_handler_t::replace) + "\n";
}

std::string diff_text(const DiffOptions& options, const std::vector<KeyDifference>& found) {
    if (found.empty()) return "no differences\n";
    std::string text = "  " + options.a + " -> " + (options.b.empty() ? "built-in" : options.b) + "\n";
    for (const KeyDifference& one : found)
        text += std::string{one.key->matters_to_motion ? "* " : "  "} + one.key->path + ": " + one.a +
                " -> " + one.b + (one.key->unit.empty() ? "" : " " + one.key->unit) + "\n";
    return text;
}

Result<int> diff_profiles(const CommonOptions& common, const DiffOptions& options) {
    const auto a = profile_of(common, options.a);
    if (!a) return a.error();
    const auto b = profile_of(common, options.b);
    if (!b) return b.error();
    const auto found = differences(*a, *b);
    std::printf("%s", (common.json ? diff_json(options, found) : diff_text(options, found)).c_str());
    return found.empty() ? kExitDone : kExitDifference;
}

}  // namespace

void add_profile_diff(CommandSet& commands) {
    const auto options = std::make_shared<DiffOptions>();
    commands
        .add(kProfileDiffText,
             [options](const CommonOptions& common) { return diff_profiles(common, *options); })
        .input("A", options->a, "A profile (TOML), or a job file whose profile is meant")
        .optional_argument("B", options->b, "Another; without it the built-in one");
}

}  // namespace psicarve::cli
