// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "rtcore/port/open_port.hpp"
#include "shared/base/result.hpp"

namespace psicarve::port {

/// Opens and claims /dev/parportN for this process alone, with its data lines driven and its safe state
/// written: claiming switches outputs on (docs/hardware.md). A port that is refused after the claim is left
/// in its safe state, too, if the hardware takes it.
Result<OpenPort> open_ppdev(const std::string& device, const PinMap& pin_map);

/// "SPP, PS/2, EPP": what a port can do, by the kernel's PARPORT_MODE bits.
std::string port_modes_text(unsigned modes);

}  // namespace psicarve::port
