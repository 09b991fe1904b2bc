// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include <sys/socket.h>
#include <sys/un.h>

namespace psicarve {

/// A name of the kernel's own, of no file, at which one process at a time can listen: with its end, however
/// it ends, the name is free again. Names are of a network namespace, and every user may take one.
class AbstractName {
public:
    /// Nothing: the name is longer than the kernel keeps them (107 bytes).
    static std::optional<AbstractName> from(const std::string& name);

    const sockaddr* address() const noexcept { return reinterpret_cast<const sockaddr*>(&address_); }
    socklen_t bytes() const noexcept { return bytes_; }

private:
    AbstractName() = default;
    sockaddr_un address_{};
    socklen_t bytes_ = 0;
};

/// Who listens at a name.
struct NameHolder {
    std::string text;  ///< "psicarve-rtcore (pid 4711)"; empty: somebody, nobody may know who
};

/// Nothing: nobody listens there. The name is not taken meanwhile.
std::optional<NameHolder> holder_of(const AbstractName& name);

}  // namespace psicarve
