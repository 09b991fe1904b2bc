// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/doctor/base_holder.hpp"

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdio>

#include "shared/kernel_ports.hpp"

namespace psicarve::doctor {
namespace {

constexpr off_t kLockedBytes = 3;
constexpr const char* kUnknownHolder = "another core";

/// Whether anybody has a lock on the base's bytes of the device; nothing: this user is not let at it.
std::optional<bool> is_range_locked(const std::string& device, std::uint16_t base) {
    const int descriptor = ::open(device.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (descriptor < 0) return std::nullopt;
    struct flock question {};
    question.l_type = F_WRLCK;
    question.l_whence = SEEK_SET;
    question.l_start = base;
    question.l_len = kLockedBytes;
    const bool is_answered = ::fcntl(descriptor, F_OFD_GETLK, &question) == 0;
    ::close(descriptor);
    if (!is_answered) return std::nullopt;
    return question.l_type != F_UNLCK;
}

/// Who listens at a name that the kernel gives to one process at a time.
std::optional<std::string> listener_at(const std::string& name) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    // Its first byte is 0: it is no file's.
    const std::size_t length = std::min(name.size(), sizeof address.sun_path - 1);
    std::copy_n(name.begin(), length, address.sun_path + 1);
    const auto bytes = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + length);
    const int caller = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (caller < 0) return std::nullopt;
    std::optional<std::string> holder;
    if (::connect(caller, reinterpret_cast<const sockaddr*>(&address), bytes) == 0) {
        ucred listener{};
        socklen_t size = sizeof listener;
        const bool is_known =
            ::getsockopt(caller, SOL_SOCKET, SO_PEERCRED, &listener, &size) == 0 && listener.pid > 0;
        holder = is_known ? process_text(listener.pid) : kUnknownHolder;
    } else if (errno == EAGAIN) {
        // A core answers nobody: whoever has asked before still waits there.
        holder = kUnknownHolder;
    }
    ::close(caller);
    return holder;
}

}  // namespace

std::string hex_of(std::uint16_t base) {
    char text[8];
    (void)std::snprintf(text, sizeof text, "0x%x", base);
    return text;
}

std::optional<std::string> base_holder(const std::string& dev, std::uint16_t base) {
    // A core that is not let at the device has a name instead, also where we are let at it.
    if (auto listener = listener_at("psicarve-port-" + hex_of(base))) return listener;
    const std::string device = dev + "/port";
    if (!is_range_locked(device, base).value_or(false)) return std::nullopt;
    const std::string holders = processes_with(device);
    return holders.empty() ? kUnknownHolder : holders;
}

}  // namespace psicarve::doctor
