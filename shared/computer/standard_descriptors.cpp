// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/computer/standard_descriptors.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>

namespace psicarve {
namespace {

bool leads_into(int descriptor, const struct stat& pipe) noexcept {
    struct stat facts {};
    if (fstat(descriptor, &facts) != 0) return false;
    if (facts.st_dev != pipe.st_dev || facts.st_ino != pipe.st_ino) return false;
    const int flags = fcntl(descriptor, F_GETFL);
    return flags >= 0 && (flags & O_ACCMODE) != O_RDONLY;
}

}  // namespace

void keep_standard_descriptors_taken() noexcept {
    for (int descriptor = STDIN_FILENO; descriptor <= STDERR_FILENO; ++descriptor) {
        if (fcntl(descriptor, F_GETFD) >= 0 || errno != EBADF) continue;
        // The least number that is free: this one, as those below it are taken. Children have it, too.
        (void)!open("/dev/null", O_RDWR);  // NOLINT(android-cloexec-open)
    }
}

void close_writing_ends_of_standard_input() noexcept {
    struct stat input {};
    if (fstat(STDIN_FILENO, &input) != 0 || !S_ISFIFO(input.st_mode)) return;
    DIR* const folder = opendir("/proc/self/fd");
    if (folder == nullptr) return;
    // Found first, closed then: the folder changes with each.
    std::array<int, 64> found{};
    std::size_t count = 0;
    for (const dirent* entry = readdir(folder); entry != nullptr; entry = readdir(folder)) {
        const int descriptor = static_cast<int>(std::strtol(entry->d_name, nullptr, 10));
        if (descriptor <= STDERR_FILENO || count == found.size() || !leads_into(descriptor, input)) continue;
        found[count++] = descriptor;
    }
    closedir(folder);
    for (std::size_t i = 0; i < count; ++i) close(found[i]);
}

}  // namespace psicarve
