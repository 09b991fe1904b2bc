// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "shared/base/result.hpp"

namespace psicarve::port {

// What keeps two cores from one port that no driver has. A lock is a descriptor: it is this process's and
// that of those that inherit it, and goes with the last of them, however they end.

/// Locks so many bytes of a device at which nobody is let who may not use the port anyway (/dev/port: its
/// bytes are the addresses). Nothing: it is not there, or we are not let at it. Refused with who has it.
Result<std::optional<int>> lock_range(const std::string& device, std::uint16_t first, std::uint16_t count);

/// A name that the kernel gives to one process at a time (shared/computer/abstract_name.hpp), whatever it may
/// open. Refused with who has it.
Result<int> lock_name(const std::string& name);

// The kernel's claim of a port says that somebody has it, not who; and what other users' processes have open
// nobody may look up. So whoever has claimed a device signs it: a lock of one byte far behind whatever it
// holds, which keeps nobody out, and of which the kernel tells every user whose it is. It is of the process
// that signs alone, and goes with it.

/// Whether it worked or not, the port is ours.
void sign_device(int descriptor) noexcept;

/// "psicarve-rtcore (pid 4711)"; empty: nobody has signed, or it is none of those that we may know of.
std::string signer_of(int descriptor);

}  // namespace psicarve::port
