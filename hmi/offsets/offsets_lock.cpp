// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/offsets/offsets_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string>
#include <system_error>
#include <thread>

namespace psicarve::offsets {
namespace {

constexpr std::chrono::milliseconds kLook{10};

Error not_kept(const std::string& path, int error_number) {
    return Error{error_number == ENOSPC ? ErrorCode::out_of_room : ErrorCode::bad_input,
                 path + ": work offsets cannot be kept: " + std::generic_category().message(error_number)};
}

}  // namespace

Result<OffsetsLock> OffsetsLock::take(const OffsetsPlace& place, std::chrono::milliseconds limit) {
    // The file itself is replaced by every write: a lock on it would be one on the old one.
    const std::string path = place.path + ".lock";
    std::error_code error;
    std::filesystem::create_directories(folder_of(path), error);
    if (error) return not_kept(folder_of(path), error.value());
    OpenFile file{::open(path.c_str(), O_RDONLY | O_CREAT | O_CLOEXEC | O_NOFOLLOW, place.mode)};
    if (file.get() < 0) return not_kept(path, errno);
    for (auto left = limit;; left -= kLook) {
        if (::flock(file.get(), LOCK_EX | LOCK_NB) == 0) return OffsetsLock{std::move(file)};
        if (errno != EWOULDBLOCK && errno != EINTR) return not_kept(path, errno);
        if (left <= std::chrono::milliseconds{0}) break;
        std::this_thread::sleep_for(kLook);
    }
    return Error{
        ErrorCode::machine_refused,
        "another process has the work offsets, as the one that runs a program has; wait for its end, "
        "or psicarve stop"};
}

}  // namespace psicarve::offsets
