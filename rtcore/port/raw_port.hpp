// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "rtcore/port/open_port.hpp"
#include "shared/result.hpp"

namespace psicarve::port {

/// Opens the addresses of a parallel port to this thread and those that it starts: only where the kernel
/// lists one, or at one of the three classic bases. Where the kernel has a driver for it, it is claimed there
/// as well, so that nobody else gets it.
Result<OpenPort> open_raw(std::uint16_t base);

/// Of the extended control register's byte: "SPP" ... ; empty when the byte is not one of such a register.
/// `control` is what the control register reads: old boards show it there once more.
std::string extended_mode_text(std::uint8_t extended, std::uint8_t control);

}  // namespace psicarve::port
