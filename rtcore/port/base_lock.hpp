// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "shared/base/result.hpp"

namespace psicarve::port {

// Locks that keep two cores from one port that no driver has claimed. A lock is a descriptor: it belongs to
// this process and to those that inherit it, and ends with the last of them, however they end.

/// Locks `count` bytes of a device that only processes with the right to the port can open (/dev/port: its
/// bytes are the addresses). Nothing: the device is not there, or we may not open it. A refusal names the
/// holder.
Result<std::optional<int>> lock_range(const std::string& device, std::uint16_t first, std::uint16_t count);

/// Takes a name that the kernel gives to one process at a time (shared/computer/abstract_name.hpp), whatever
/// files that process may open. A refusal names the holder.
Result<int> lock_name(const std::string& name);

// The kernel's claim of a port shows that a process has it, but not which; and no user may look up what other
// users' processes have open. So a core that has claimed a device signs it: it locks one byte far behind its
// other locks, which keeps no process out, and whose holder the kernel tells every user. The lock belongs to
// the signing process alone, and ends with it.

/// The port is ours whether signing worked or not.
void sign_device(int descriptor) noexcept;

/// "psicarve-rtcore (pid 4711)"; empty: unsigned, or by a process that we may not see.
std::string signer_of(int descriptor);

}  // namespace psicarve::port
