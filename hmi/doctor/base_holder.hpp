// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace psicarve::doctor {

/// Who drives a port by its addresses: "psicarve-rtcore (pid 4711)", or "another program" where nobody may
/// know. Nothing: no core that we can see. A core with --port io:BASE takes a name of the kernel's own, and
/// besides the three bytes of DEV/port where it is let at them; the kernel is asked who has either, and none
/// is taken, so that a core that starts in the same moment is not refused.
std::optional<std::string> base_holder(const std::string& dev, std::uint16_t base);

}  // namespace psicarve::doctor
