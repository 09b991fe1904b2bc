// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/machine/unique_fd.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

namespace psicarve::machine {
namespace {

constexpr int kFirstFreeFd = 3;
constexpr int kPipeBytes = 1 << 20;

Error system_error(const std::string& what) {
    return Error{ErrorCode::out_of_room, what + ": " + std::strerror(errno)};
}

UniqueFd above_standard_streams(UniqueFd fd) {
    if (!fd.is_open() || fd.get() >= kFirstFreeFd) return fd;
    return UniqueFd{fcntl(fd.get(), F_DUPFD_CLOEXEC, kFirstFreeFd)};
}

}  // namespace

UniqueFd& UniqueFd::operator=(UniqueFd&& other) noexcept {
    if (this != &other) {
        reset();
        fd_ = other.release();
    }
    return *this;
}

int UniqueFd::release() noexcept {
    return std::exchange(fd_, -1);
}

void UniqueFd::reset() noexcept {
    if (fd_ >= 0) close(fd_);
    fd_ = -1;
}

Result<UniqueFd> open_memory_file(const char* name) {
    UniqueFd fd = above_standard_streams(UniqueFd{memfd_create(name, MFD_CLOEXEC)});
    if (!fd.is_open()) return system_error("memfd_create");
    return fd;
}

Result<UniqueFd> open_memory_file(const char* name, std::span<const std::byte> bytes) {
    auto fd = open_memory_file(name);
    if (!fd) return fd;
    while (!bytes.empty()) {
        const ssize_t written = write(fd->get(), bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return system_error("memory file");
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    lseek(fd->get(), 0, SEEK_SET);
    return fd;
}

Result<Pipe> open_pipe() {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) return system_error("pipe");
    Pipe made{above_standard_streams(UniqueFd{ends[0]}), above_standard_streams(UniqueFd{ends[1]})};
    if (!made.read_end.is_open() || !made.write_end.is_open()) return system_error("pipe");
    // Fewer wake-ups while a trace streams through; a kernel that refuses keeps its default size.
    (void)fcntl(made.write_end.get(), F_SETPIPE_SZ, kPipeBytes);
    return made;
}

std::string tail_of(int fd, std::size_t most_bytes) {
    struct stat about {};
    if (fstat(fd, &about) != 0) return {};
    const auto size = static_cast<std::size_t>(about.st_size);
    std::string text(std::min(size, most_bytes), '\0');
    const ssize_t got = pread(fd, text.data(), text.size(), static_cast<off_t>(size - text.size()));
    text.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
    return text;
}

}  // namespace psicarve::machine
