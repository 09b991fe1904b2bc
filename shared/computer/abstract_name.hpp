// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include <sys/socket.h>
#include <sys/un.h>

namespace psicarve {

/// A name in the kernel (abstract Unix socket, no file), at which one process at a time can listen: however
/// that process ends, the name is free again. Names belong to a network namespace, and every user may take
/// one.
class AbstractName {
public:
    /// Nothing: the name is longer than the kernel allows (107 bytes).
    static std::optional<AbstractName> from(const std::string& name);

    const sockaddr* address() const noexcept { return reinterpret_cast<const sockaddr*>(&address_); }
    socklen_t bytes() const noexcept { return bytes_; }

private:
    AbstractName() = default;
    sockaddr_un address_{};
    socklen_t bytes_ = 0;
};

/// The process that listens at a name.
struct NameHolder {
    std::string text;  ///< "psicarve-rtcore (pid 4711)"; empty: the name is taken, and the system hides by
                       ///< whom
};

/// Nothing: no process listens there. The look-up does not take the name.
std::optional<NameHolder> holder_of(const AbstractName& name);

}  // namespace psicarve
