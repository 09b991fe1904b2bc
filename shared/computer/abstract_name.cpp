// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/computer/abstract_name.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>

#include "shared/computer/kernel_ports.hpp"

namespace psicarve {

std::optional<AbstractName> AbstractName::from(const std::string& name) {
    AbstractName abstract;
    // Its first byte is 0: it is not the name of a file.
    if (name.size() > sizeof abstract.address_.sun_path - 1) return std::nullopt;
    abstract.address_.sun_family = AF_UNIX;
    std::copy(name.begin(), name.end(), abstract.address_.sun_path + 1);
    abstract.bytes_ = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
    return abstract;
}

std::optional<NameHolder> holder_of(const AbstractName& name) {
    const int caller = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (caller < 0) return std::nullopt;
    std::optional<NameHolder> holder;
    if (::connect(caller, name.address(), name.bytes()) == 0) {
        ucred listener{};
        socklen_t bytes = sizeof listener;
        const bool is_known =
            ::getsockopt(caller, SOL_SOCKET, SO_PEERCRED, &listener, &bytes) == 0 && listener.pid > 0;
        holder = NameHolder{is_known ? process_text(listener.pid) : ""};
    } else if (errno == EAGAIN) {
        // The listener answers no caller: one that asked before still waits there.
        holder = NameHolder{};
    }
    ::close(caller);
    return holder;
}

}  // namespace psicarve
