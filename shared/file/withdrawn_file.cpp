// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/file/withdrawn_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "shared/file/partial_file.hpp"

namespace psicarve {
namespace {

int sync_folder_of(const std::string& path) noexcept {
    const OpenFile folder{::open(folder_of(path).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)};
    if (folder.get() < 0) return errno;
    return ::fsync(folder.get()) == 0 ? 0 : errno;
}

}  // namespace

Result<void> withdraw_file(const std::string& path) {
    // Opens it while it has its name: the next calls may remove the name and leave the file on the disk.
    const OpenFile file{::open(path.c_str(), O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC)};
    int failed = ::unlink(path.c_str()) == 0 || errno == ENOENT ? 0 : errno;
    if (failed == 0) failed = sync_folder_of(path);
    // Where the folder is missing, or a folder has the name, there is no file.
    if (failed == 0 || failed == ENOENT || failed == ENOTDIR || failed == EISDIR) return {};
    if (file.get() >= 0 && ::ftruncate(file.get(), 0) == 0 && ::fsync(file.get()) == 0) return {};
    return bad_input(path + ": cannot be taken away: " + std::generic_category().message(failed));
}

}  // namespace psicarve
