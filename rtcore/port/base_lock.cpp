// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/port/base_lock.hpp"

#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "shared/computer/abstract_name.hpp"
#include "shared/computer/kernel_ports.hpp"

namespace psicarve::port {
namespace {

Error busy(const std::string& holder) {
    return Error{ErrorCode::machine_refused,
                 "busy: " + (holder.empty() ? "another program" : holder) + " has it; end that first"};
}

Error failed(const std::string& what) {
    return Error{ErrorCode::machine_refused, what + ": " + std::generic_category().message(errno)};
}

struct flock signature(short type) noexcept {
    constexpr off_t kFarBehind = off_t{1} << 32;
    struct flock lock {};
    lock.l_type = type;
    lock.l_whence = SEEK_SET;
    lock.l_start = kFarBehind;
    lock.l_len = 1;
    return lock;
}

}  // namespace

void sign_device(int descriptor) noexcept {
    struct flock lock = signature(F_WRLCK);
    static_cast<void>(::fcntl(descriptor, F_SETLK, &lock));
}

std::string signer_of(int descriptor) {
    struct flock lock = signature(F_WRLCK);
    if (::fcntl(descriptor, F_GETLK, &lock) != 0 || lock.l_type == F_UNLCK || lock.l_pid <= 0) return {};
    return process_text(lock.l_pid);
}

Result<std::optional<int>> lock_range(const std::string& device, std::uint16_t first, std::uint16_t count) {
    const int descriptor = ::open(device.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (descriptor < 0) return std::optional<int>{};
    struct flock request {};
    request.l_type = F_WRLCK;
    request.l_whence = SEEK_SET;
    request.l_start = first;
    request.l_len = count;
    if (::fcntl(descriptor, F_OFD_SETLK, &request) == 0) return std::optional{descriptor};
    const bool is_busy = errno == EAGAIN || errno == EACCES;
    ::close(descriptor);
    if (!is_busy) return std::optional<int>{};
    return busy(processes_with(device));
}

Result<int> lock_name(const std::string& name) {
    const auto wanted = AbstractName::from(name);
    if (!wanted) return Error{ErrorCode::machine_refused, "cannot be locked: too long a name: " + name};
    const int listener = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (listener < 0) return failed("cannot be locked");
    if (::bind(listener, wanted->address(), wanted->bytes()) == 0 && ::listen(listener, SOMAXCONN) == 0)
        return listener;
    const bool is_taken = errno == EADDRINUSE;
    const Error error =
        is_taken ? busy(holder_of(*wanted).value_or(NameHolder{}).text) : failed("cannot be locked");
    ::close(listener);
    return error;
}

}  // namespace psicarve::port
