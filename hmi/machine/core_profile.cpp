// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/machine/core_profile.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "shared/job/job.hpp"
#include "shared/profile/profile_place.hpp"
#include "shared/record/snapshot_file.hpp"

namespace psicarve::machine {
namespace {

namespace fs = std::filesystem;

std::string text_of_process(const fs::path& process, const char* file) {
    std::ifstream in{process / file, std::ios::binary};
    return {std::istreambuf_iterator<char>{in}, {}};
}

}  // namespace

Result<Profile> profile_in(const std::string& path) {
    if (!is_snapshot_file(path)) return load_profile(path);
    const auto snapshot = load_snapshot(path);
    if (!snapshot) return snapshot.error();
    const auto job = JobView::check(snapshot->job_blob);
    if (!job) return bad_input(path + ": holds no job, and so no profile");
    return job_profile(*job);
}

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
        auto read = profile_in(place);
        if (read && profile_hash(*read) == hash) return std::move(read).value();
    }
    // The built-in one, where a default place here has another than the core's user has there.
    if (Profile built_in; profile_hash(built_in) == hash) return built_in;
    return std::nullopt;
}

}  // namespace psicarve::machine
