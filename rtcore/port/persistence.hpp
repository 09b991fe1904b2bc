// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "rtcore/port/port_access.hpp"
#include "shared/base/result.hpp"
#include "shared/profile/pin_map.hpp"

namespace psicarve::port {

/// Writes the safe state until the hardware takes it, at once and then with pauses that grow from a
/// millisecond to a tenth of a second. False when the patience is over, or when `gives_up`, asked before each
/// pause, returns true. Sleeps: not for the tick.
bool write_until_taken(const SafeState& safe_state, std::chrono::milliseconds patience,
                       const std::function<bool()>& gives_up = {});

/// Writes the safe state of a port (`name`) that was just opened, and perhaps claimed from the kernel's
/// driver, which switches outputs on. Where the hardware does not take it at once, it retries for five
/// seconds and says on standard error what may be on. A refusal says the same.
Result<void> make_safe_at_opening(const PortAccess& access, const PinMap& pin_map, const std::string& name);

}  // namespace psicarve::port
