// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/model/file_bytes.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <new>
#include <span>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "shared/base/result.hpp"

namespace psicarve::model {
namespace {

std::string reason(int error_number) {
    return std::generic_category().message(error_number);
}

}  // namespace

Result<InputFile> InputFile::open(const std::string& path) {
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor < 0) {
        if (errno == ENOENT) return bad_input(path + ": no such file");
        return bad_input(path + ": cannot be opened: " + reason(errno));
    }
    InputFile file(descriptor, 0, path);
    struct stat status {};
    if (::fstat(descriptor, &status) != 0) return bad_input(path + ": cannot be read: " + reason(errno));
    if (S_ISDIR(status.st_mode)) return bad_input(path + ": is a directory, not a model file");
    if (!S_ISREG(status.st_mode)) return bad_input(path + ": is not a regular file");
    file.size_bytes_ = static_cast<std::uint64_t>(status.st_size);
    return file;
}

InputFile::InputFile(InputFile&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      size_bytes_(other.size_bytes_),
      path_(std::move(other.path_)) {}

InputFile::~InputFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

Result<void> InputFile::read(std::uint64_t offset_bytes, std::span<char> target) const {
    std::size_t done = 0;
    while (done < target.size()) {
        const ::ssize_t got = ::pread(descriptor_, target.data() + done, target.size() - done,
                                      static_cast<::off_t>(offset_bytes + done));
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return bad_input(path_ + ": cannot be read: " + reason(errno));
        if (got == 0) return bad_input(path_ + ": became shorter while it was read");
        done += static_cast<std::size_t>(got);
    }
    return {};
}

Result<std::vector<char>> InputFile::read_all() const {
    try {
        std::vector<char> bytes(size_bytes_);
        const Result<void> done = read(0, bytes);
        if (!done) return done.error();
        return bytes;
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::out_of_room, path_ + ": too large for this computer's memory"};
    }
}

}  // namespace psicarve::model
