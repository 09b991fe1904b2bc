// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/file/atomic_file.hpp"

#include <fcntl.h>
#include <linux/magic.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <cstdint>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "shared/file/partial_file.hpp"

namespace psicarve {
namespace {

constexpr mode_t kNewFileMode = 0666;  ///< before the umask
/// Larger than any job can be; a wrong path (/dev/zero, a disk image) is not read into memory.
constexpr std::uint64_t kLargestFileBytes = std::uint64_t{64} << 30;

Error file_error(const std::string& path, const std::string& what, int error_number) {
    const bool is_full = error_number == ENOSPC || error_number == EDQUOT || error_number == EFBIG;
    return Error{is_full ? ErrorCode::out_of_room : ErrorCode::bad_input,
                 path + ": " + what + ": " + std::generic_category().message(error_number)};
}

bool is_on_proc(const std::string& folder) noexcept {
    struct statfs facts {};
    return ::statfs(folder.c_str(), &facts) == 0 && facts.f_type == PROC_SUPER_MAGIC;
}

/// Whether it leads, link by link, through /proc's files of a process, as /dev/stdout does to
/// /proc/self/fd/1: such a name does not belong to the file that is open there.
bool leads_by_proc(std::string path) {
    constexpr int kMostLinks = 40;  // the kernel's own limit
    for (int i = 0; i < kMostLinks; ++i) {
        std::array<char, PATH_MAX> target{};
        const ssize_t size = ::readlink(path.c_str(), target.data(), target.size());
        const std::string folder = folder_of(path);
        if ((size > 0 || i > 0) && is_on_proc(folder)) return true;
        if (size <= 0) return false;
        const std::string_view to{target.data(), static_cast<std::size_t>(size)};
        path = to.starts_with('/') ? std::string{to} : folder + std::string{to};
    }
    return false;
}

/// The mode of the file to be replaced, if there is one. Refuses a file that a rename would destroy.
Result<std::optional<mode_t>> mode_to_keep(const std::string& path) {
    if (leads_by_proc(path))
        return bad_input(path + ": is an open descriptor, not a file's name: use - for standard output");
    struct stat facts {};
    if (::stat(path.c_str(), &facts) != 0) {
        if (errno == ENOENT) return std::optional<mode_t>{};
        return file_error(path, "cannot be written", errno);
    }
    if (S_ISDIR(facts.st_mode)) return bad_input(path + ": is a folder, not a file");
    if (!S_ISREG(facts.st_mode)) return bad_input(path + ": is no regular file: choose a file name");
    struct stat link {};
    if (::lstat(path.c_str(), &link) == 0 && S_ISLNK(link.st_mode)) return std::optional<mode_t>{};
    return std::optional{static_cast<mode_t>(facts.st_mode & 0777)};
}

int write_all(int file, std::span<const std::byte> bytes) noexcept {
    while (!bytes.empty()) {
        const ssize_t put = ::write(file, bytes.data(), bytes.size());
        if (put < 0 && errno == EINTR) continue;
        if (put <= 0) return put < 0 ? errno : ENOSPC;
        bytes = bytes.subspan(static_cast<std::size_t>(put));
    }
    return 0;
}

/// Puts the content into a file; returns the error number, or 0.
using Filling = std::function<int(int file)>;

int put_stream(int file, const std::function<void(std::FILE*)>& put) {
    const int copy = ::fcntl(file, F_DUPFD_CLOEXEC, 0);
    if (copy < 0) return errno;
    std::FILE* const out = ::fdopen(copy, "wb");
    if (out == nullptr) {
        const int failed = errno;
        ::close(copy);
        return failed;
    }
    errno = 0;
    put(out);
    int failed = 0;
    if (std::ferror(out) != 0) failed = errno != 0 ? errno : EIO;
    if (std::fflush(out) != 0 && failed == 0) failed = errno;
    if (std::fclose(out) != 0 && failed == 0) failed = errno;
    return failed;
}

int fill(const OpenFile& file, std::optional<FileRights> rights, const Filling& put) {
    constexpr auto kSameUser = static_cast<uid_t>(-1);
    // First the group, then its rights: at no instant may a wrong group read it.
    if (rights && rights->group && ::fchown(file.get(), kSameUser, *rights->group) != 0) return errno;
    if (rights && ::fchmod(file.get(), rights->mode) != 0) return errno;
    if (const int failed = put(file.get()); failed != 0) return failed;
    return ::fsync(file.get()) == 0 ? 0 : errno;
}

/// Makes the new name survive a power failure. Some file systems cannot, and the file is whole anyway;
/// returns the error number of a disk that could and did not, or 0.
int sync_folder(const std::string& path) noexcept {
    const OpenFile folder{::open(folder_of(path).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)};
    if (folder.get() < 0 || ::fsync(folder.get()) == 0) return 0;
    return errno == EIO || errno == ENOSPC || errno == EDQUOT ? errno : 0;
}

struct RegularFile {
    OpenFile file;
    std::uint64_t size_bytes;
};

Result<RegularFile> open_regular(const std::string& path) {
    // Not blocking: a pipe without a writer is refused, not waited for.
    OpenFile file{::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)};
    if (file.get() < 0) return file_error(path, "cannot be read", errno);
    struct stat facts {};
    if (::fstat(file.get(), &facts) != 0) return file_error(path, "cannot be read", errno);
    if (S_ISDIR(facts.st_mode)) return bad_input(path + ": is a folder, not a file");
    if (!S_ISREG(facts.st_mode)) return bad_input(path + ": is no regular file");
    return RegularFile{std::move(file), static_cast<std::uint64_t>(facts.st_size)};
}

/// Reads this many bytes; fewer when the file has become shorter.
Result<std::vector<std::byte>> read_start(const RegularFile& file, const std::string& path,
                                          std::uint64_t byte_count) {
    std::vector<std::byte> bytes(byte_count);
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t got = ::read(file.file.get(), bytes.data() + done, bytes.size() - done);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return file_error(path, "cannot be read", errno);
        if (got == 0) break;
        done += static_cast<std::size_t>(got);
    }
    bytes.resize(done);
    return bytes;
}

Result<void> replace_file(const std::string& path, const std::optional<FileRights>& rights,
                          const Filling& put) {
    const auto mode = mode_to_keep(path);
    if (!mode) return mode.error();
    std::optional<FileRights> wanted = rights;
    if (!rights && *mode) wanted = FileRights{**mode, {}};
    constexpr mode_t kOwnerAlone = 0600;
    auto part = PartialFile::create(folder_of(path), rights ? kOwnerAlone : kNewFileMode);
    if (!part) return file_error(path, "cannot be written in this folder", part.error());
    if (const int failed = fill(part->file(), wanted, put); failed != 0) {
        return file_error(path, "cannot be written, what was there before is unchanged", failed);
    }
    if (const int failed = part->take_name(path); failed != 0) {
        return file_error(path, "cannot be replaced, what was there before is unchanged", failed);
    }
    if (const int failed = sync_folder(path); failed != 0)
        return file_error(path, "is written, but a power cut may bring back what was there before", failed);
    return {};
}

}  // namespace

Result<void> write_parts_atomically(const std::string& path,
                                    std::span<const std::span<const std::byte>> parts,
                                    const std::optional<FileRights>& rights) {
    return replace_file(path, rights, [parts](int file) {
        for (const auto part : parts) {
            if (const int failed = write_all(file, part); failed != 0) return failed;
        }
        return 0;
    });
}

Result<void> write_stream_atomically(const std::string& path, const std::function<void(std::FILE*)>& put) {
    return replace_file(path, std::nullopt, [&put](int file) { return put_stream(file, put); });
}

Result<void> check_writable(const std::string& path) {
    if (const auto mode = mode_to_keep(path); !mode) return mode.error();
    const auto part = PartialFile::create(folder_of(path), kNewFileMode);
    if (!part) return file_error(path, "cannot be written in this folder", part.error());
    return {};
}

Result<void> write_file_atomically(const std::string& path, std::span<const std::byte> bytes) {
    return write_parts_atomically(path, std::array{bytes});
}

Result<std::vector<std::byte>> read_whole_file(const std::string& path) {
    const Result<RegularFile> file = open_regular(path);
    if (!file) return file.error();
    if (file->size_bytes > kLargestFileBytes) return file_error(path, "cannot be read", EFBIG);
    return read_start(*file, path, file->size_bytes);
}

Result<std::vector<std::byte>> read_file_start(const std::string& path, std::uint64_t most_bytes) {
    const Result<RegularFile> file = open_regular(path);
    if (!file) return file.error();
    return read_start(*file, path, std::min(most_bytes, file->size_bytes));
}

}  // namespace psicarve
