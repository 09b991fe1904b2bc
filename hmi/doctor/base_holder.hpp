// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace psicarve::doctor {

/// The process that drives a port by its addresses: "psicarve-rtcore (pid 4711)", or "another program" where
/// the system hides it. Nothing: no core that we can see. A core with --port io:BASE takes a name in the
/// kernel, and, where it may, locks the three bytes of DEV/port; this asks the kernel who has either, and
/// takes none, so that a core that starts at the same moment is not refused.
std::optional<std::string> base_holder(const std::string& dev, std::uint16_t base);

}  // namespace psicarve::doctor
