// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/core_profile.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>

#include "shared/profile/profile_place.hpp"

namespace psicarve::session {
namespace {

namespace fs = std::filesystem;

std::string text_of_process(const fs::path& process, const char* file) {
    std::ifstream in{process / file, std::ios::binary};
    return {std::istreambuf_iterator<char>{in}, {}};
}

}  // namespace

std::string profile_named_in(const std::string& command_line, const std::string& folder) {
    constexpr std::string_view kOption = "--profile";
    std::string named;
    bool is_next = false;
    for (std::size_t at = 0; at < command_line.size();) {
        const std::string word{command_line.c_str() + at};
        at += word.size() + 1;
        if (is_next) named = word;
        is_next = word == kOption;
        if (word.starts_with(std::string{kOption} + "=")) named = word.substr(kOption.size() + 1);
    }
    if (named.empty()) return {};
    return (fs::path{folder} / named).string();  // an absolute path stays as it is
}

std::optional<Profile> find_core_profile(std::uint32_t core_pid, std::uint64_t hash) {
    const fs::path process = fs::path{"/proc"} / std::to_string(core_pid);
    std::error_code unknown;
    const fs::path folder = fs::read_symlink(process / "cwd", unknown);
    std::vector<std::string> places{profile_named_in(text_of_process(process, "cmdline"), folder.string())};
    for (const std::string& place : profile_places()) places.push_back(place);
    for (const std::string& place : places) {
        if (place.empty()) continue;
        auto read = load_profile(place);
        if (read && profile_hash(*read) == hash) return std::move(read).value();
    }
    return std::nullopt;
}

std::vector<Phrase> profile_differences(const Profile& core, const Profile& here, std::size_t most) {
    const auto of_core = profile_values(core);
    const auto of_here = profile_values(here);
    std::vector<Phrase> told;
    std::size_t count = 0;
    for (std::size_t key = 0; key < of_core.size(); ++key) {
        if (of_core[key] == of_here[key] || ++count > most) continue;
        told.push_back(phrase("%1: core %2, here %3", profile_keys()[key].path, of_core[key], of_here[key]));
    }
    if (count > most) told.push_back(phrase("%1 more", std::to_string(count - most)));
    return told;
}

}  // namespace psicarve::session
