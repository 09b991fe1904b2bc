// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace psicarve::doctor {

/// "0x378"
std::string hex_of(std::uint16_t base);

/// Who drives a port by its addresses: "psicarve-rtcore (pid 4711)", or "another core" where nobody may know.
/// Nothing: no core that we can see. A core with --port io:BASE locks the three bytes of DEV/port, or where
/// it is not let at that a name of the kernel's own; the kernel is asked for the lock of either, and none is
/// taken, so that a core that starts in the same moment is not refused.
std::optional<std::string> base_holder(const std::string& dev, std::uint16_t base);

}  // namespace psicarve::doctor
