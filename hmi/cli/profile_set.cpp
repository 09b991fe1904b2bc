// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/job_source.hpp"
#include "hmi/cli/saved_draft.hpp"
#include "hmi/profile/profile_draft.hpp"
#include "shared/base/nearest.hpp"
#include "shared/profile/profile.hpp"
#include "shared/profile/profile_text.hpp"

namespace psicarve::cli {
namespace {

constexpr CommandText kProfileSetText{
    "set", "Change values of a machine profile's file",
    "Into FILE, or the profile that applies (psicarve profile path). All of it is checked before anything is "
    "written;\n"
    "comments and every other byte stay, the old file is FILE.bak. A range is written 0...60.",
    "psicarve profile set axis.r1.speed_mm_s=8 tool.shape=ball machine.toml"};

struct SetOptions {
    std::vector<std::string> words;
};

/// The key, or an error with the likely one of the same table.
Result<std::size_t> key_of(const std::string& path) {
    const auto& keys = profile_keys();
    const auto found = std::ranges::find(keys, path, &ProfileKey::path);
    if (found != keys.end()) return static_cast<std::size_t>(found - keys.begin());
    std::vector<std::string> names;
    for (const ProfileKey& key : keys)
        if (table_of_key(key.path) == table_of_key(path)) names.emplace_back(leaf_of_key(key.path));
    const auto meant = nearest(leaf_of_key(path), names);
    const std::string_view table = table_of_key(path);
    const std::string prefix = table.empty() ? std::string{} : std::string{table} + ".";
    return Error{ErrorCode::bad_usage,
                 path + ": unknown key; " +
                     (meant ? "did you mean " + prefix + *meant + "?" : "see profile show for all keys")};
}

/// Quotes and brackets as in a file are allowed, and not required.
std::string as_typed(const ProfileKey& key, std::string value) {
    if (key.value == ProfileValue::range) {
        std::erase_if(value, [](char c) { return c == '[' || c == ']'; });
        if (value.find("...") == std::string::npos)
            if (const std::size_t comma = value.find(','); comma != std::string::npos)
                value.replace(comma, 1, " ... ");
    }
    const bool is_quoted = value.size() >= 2 && value.front() == '"' && value.back() == '"';
    return is_quoted ? value.substr(1, value.size() - 2) : value;
}

Result<void> type_into(profile::ProfileDraft& draft, const std::vector<std::string>& changes) {
    for (const std::string& change : changes) {
        const std::size_t equals = change.find('=');
        const auto key = key_of(change.substr(0, equals));
        if (!key) return key.error();
        draft.type(*key, as_typed(profile_keys()[*key], change.substr(equals + 1)));
    }
    for (std::size_t i = 0; i < profile_keys().size(); ++i)
        if (!draft.problem(i).empty())
            return bad_input(profile_keys()[i].path + " = " + draft.typed(i) + ": " + draft.problem(i));
    return {};
}

Result<int> set_values(const CommonOptions& common, const SetOptions& options) {
    std::vector<std::string> changes = options.words;
    std::string path = chosen_profile_path(common);
    if (changes.back().find('=') == std::string::npos) {
        path = changes.back();
        changes.pop_back();
    }
    const auto is_change = [](const std::string& word) { return word.find('=') != std::string::npos; };
    if (changes.empty() || !std::ranges::all_of(changes, is_change))
        return Error{ErrorCode::bad_usage, "profile set: KEY=VALUE for each key, and the file last"};
    if (path.empty())
        return Error{
            ErrorCode::bad_usage,
            "profile set: no profile is there to be changed; psicarve profile show > machine.toml makes one"};
    auto draft = profile::ProfileDraft::open(path);
    if (!draft) return draft.error();
    if (const auto typed = type_into(*draft, changes); !typed) return typed.error();
    return save_draft(*draft, common);
}

}  // namespace

void add_profile_set(CommandSet& commands) {
    const auto options = std::make_shared<SetOptions>();
    commands
        .add(kProfileSetText, [options](const CommonOptions& common) { return set_values(common, *options); })
        .arguments("KEY=VALUE", options->words,
                   "Values to set, and the file last, if it is not the one that applies");
}

}  // namespace psicarve::cli
