// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace psicarve::doctor {

/// The kernel's files about the computer in /proc, /sys and /dev, all below a root: "" is this computer, a
/// folder is one that a test made up.
class SystemFiles {
public:
    explicit SystemFiles(std::string root = {}) : root_(std::move(root)) {}

    std::string path_of(const std::string& path) const { return root_ + path; }
    /// The file's text without white space at its ends; nothing when it cannot be read.
    std::optional<std::string> text(const std::string& path) const;
    bool exists(const std::string& path) const;
    /// Names in a folder, sorted; empty when there is none.
    std::vector<std::string> names_in(const std::string& folder) const;
    /// The rest of the line that begins with "name:" in a file like /proc/self/status.
    std::optional<std::string> field(const std::string& path, std::string_view name) const;
    /// The soft limit in /proc/self/limits; its greatest value when unlimited.
    std::optional<std::uint64_t> limit(std::string_view name) const;
    /// Whether this process has a Linux capability, by its number in capabilities(7).
    bool has_capability(unsigned number) const;
    /// Whether this process may write to the file, by mode, owner, groups and capabilities.
    bool may_write(const std::string& path) const;
    /// Free bytes on the file system of a folder.
    std::optional<std::uint64_t> free_bytes(const std::string& folder) const;

private:
    std::string root_;
};

inline constexpr unsigned kCapDacOverride = 1;
inline constexpr unsigned kCapIpcLock = 14;
inline constexpr unsigned kCapSysRawio = 17;
inline constexpr unsigned kCapSysNice = 23;

}  // namespace psicarve::doctor
