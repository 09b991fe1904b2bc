// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/process/state_folder.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

#include "shared/file/partial_file.hpp"

namespace psicarve::supervisor {
namespace {

constexpr mode_t kStateFolderMode = 0755;

std::string without_last_slash(std::string folder) {
    while (folder.size() > 1 && folder.ends_with('/')) folder.pop_back();
    return folder;
}

/// Whether only root and we can remove what we put in.
bool is_only_ours(int folder) noexcept {
    struct stat facts {};
    if (::fstat(folder, &facts) != 0) return false;
    const bool is_ours = facts.st_uid == 0 || facts.st_uid == ::geteuid();
    return is_ours && (facts.st_mode & (S_IWGRP | S_IWOTH)) == 0;
}

/// Opens the folder that was just made; refuses a link in its place, or another user's folder.
OpenFile open_made(int parent, const char* name) noexcept {
    OpenFile made{::openat(parent, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC)};
    struct stat facts {};
    const bool is_ours = made.get() >= 0 && ::fstat(made.get(), &facts) == 0 && facts.st_uid == ::geteuid();
    return is_ours ? std::move(made) : OpenFile{-1};
}

}  // namespace

Result<void> make_state_folder(const std::string& folder) {
    const std::string path = without_last_slash(folder);
    std::error_code ignored;  // the last one tells
    std::filesystem::create_directories(std::filesystem::path{path}.parent_path(), ignored);
    const OpenFile parent{::open(folder_of(path).c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC)};
    const std::string name = path.substr(path.rfind('/') + 1);
    const int made = parent.get() < 0 ? -1 : ::mkdirat(parent.get(), name.c_str(), kStateFolderMode);
    if (made != 0 && errno == EEXIST) return {};
    if (made != 0) return bad_input(folder + ": cannot be made: " + std::generic_category().message(errno));
    if (!is_only_ours(parent.get())) return {};
    const OpenFile it = open_made(parent.get(), name.c_str());
    if (it.get() >= 0) static_cast<void>(::fchmod(it.get(), kStateFolderMode));
    return {};
}

void make_state_folder_for(const std::string& folder, uid_t user, gid_t group) {
    if (folder.empty()) return;
    const std::string path = without_last_slash(folder);
    const std::string name = path.substr(path.rfind('/') + 1);
    const OpenFile parent{::open(folder_of(path).c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC)};
    if (parent.get() < 0 || !is_only_ours(parent.get())) return;
    if (::mkdirat(parent.get(), name.c_str(), kStateFolderMode) != 0) return;
    const OpenFile it = open_made(parent.get(), name.c_str());
    if (it.get() < 0) return;
    // Where this is refused, writing to the folder is refused as well, and that is reported.
    static_cast<void>(::fchmod(it.get(), kStateFolderMode));
    [[maybe_unused]] const int given = ::fchown(it.get(), user, group);
}

}  // namespace psicarve::supervisor
