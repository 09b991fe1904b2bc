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
/// millisecond to a tenth of a second. False when the patience is over, or `gives_up` says so, which is asked
/// before each pause. Sleeps: not for the tick.
bool write_until_taken(const SafeState& safe_state, std::chrono::milliseconds patience,
                       const std::function<bool()>& gives_up = {});

/// The safe state of a port (`name`) that was just opened, and perhaps claimed from the kernel's driver,
/// which switches things on. Where it is not taken at once: five seconds, and a word on standard error of
/// what may be on. Refused with the same.
Result<void> make_safe_at_opening(const PortAccess& access, const PinMap& pin_map, const std::string& name);

}  // namespace psicarve::port
