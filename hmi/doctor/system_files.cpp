// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/doctor/system_files.hpp"

#include <sys/stat.h>
#include <sys/statvfs.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>

namespace psicarve::doctor {
namespace {

std::string trimmed(std::string text) {
    constexpr const char* kSpace = " \t\n";
    text.erase(0, std::min(text.find_first_not_of(kSpace), text.size()));
    text.erase(text.find_last_not_of(kSpace) + 1);
    return text;
}

std::optional<std::uint64_t> number_from(std::string_view text, int base = 10) {
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, base);
    if (error != std::errc{} || end == text.data()) return std::nullopt;
    return number;
}

}  // namespace

std::optional<std::string> SystemFiles::text(const std::string& path) const {
    std::ifstream file{root_ + path};
    if (!file) return std::nullopt;
    // Some files of /proc and /sys open and then fail: here that is a state of the stream, where iterators
    // would throw.
    std::ostringstream text;
    if (file.peek() != std::ifstream::traits_type::eof()) text << file.rdbuf();
    if (file.bad()) return std::nullopt;
    return trimmed(text.str());
}

bool SystemFiles::exists(const std::string& path) const {
    std::error_code error;
    return std::filesystem::exists(root_ + path, error);
}

std::vector<std::string> SystemFiles::names_in(const std::string& folder) const {
    std::vector<std::string> names;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator{root_ + folder, error}) {
        names.push_back(entry.path().filename().string());
    }
    std::ranges::sort(names);
    return names;
}

std::optional<std::string> SystemFiles::field(const std::string& path, std::string_view name) const {
    std::istringstream lines{text(path).value_or("")};
    for (std::string line; std::getline(lines, line);) {
        const std::size_t colon = line.find(':');
        if (colon != std::string::npos && trimmed(line.substr(0, colon)) == name)
            return trimmed(line.substr(colon + 1));
    }
    return std::nullopt;
}

std::optional<std::uint64_t> SystemFiles::limit(std::string_view name) const {
    std::istringstream lines{text("/proc/self/limits").value_or("")};
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with(name)) continue;
        const std::string value = trimmed(line.substr(name.size()));
        if (value.starts_with("unlimited")) return std::numeric_limits<std::uint64_t>::max();
        return number_from(value);
    }
    return std::nullopt;
}

bool SystemFiles::has_capability(unsigned number) const {
    const auto mask = number_from(field("/proc/self/status", "CapEff").value_or(""), 16);
    return mask && (*mask >> number & 1U) != 0;
}

bool SystemFiles::may_write(const std::string& path) const {
    struct stat facts {};
    if (stat((root_ + path).c_str(), &facts) != 0) return false;
    if (has_capability(kCapDacOverride)) return true;
    // Real, effective, saved and file system ids: the last one counts for files.
    const auto ids_in = [&](std::string_view name) {
        std::istringstream words{field("/proc/self/status", name).value_or("")};
        return std::vector<std::uint64_t>{std::istream_iterator<std::uint64_t>{words}, {}};
    };
    const auto users = ids_in("Uid");
    auto groups = ids_in("Groups");
    if (const auto own = ids_in("Gid"); !own.empty()) groups.push_back(own.back());
    if (!users.empty() && users.back() == facts.st_uid) return (facts.st_mode & S_IWUSR) != 0;
    if (std::ranges::find(groups, facts.st_gid) != groups.end()) return (facts.st_mode & S_IWGRP) != 0;
    return (facts.st_mode & S_IWOTH) != 0;
}

std::optional<std::uint64_t> SystemFiles::free_bytes(const std::string& folder) const {
    struct statvfs facts {};
    if (statvfs((root_ + folder).c_str(), &facts) != 0) return std::nullopt;
    return std::uint64_t{facts.f_bavail} * facts.f_frsize;
}

}  // namespace psicarve::doctor
