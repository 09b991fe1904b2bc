// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "rtcore/port/open_port.hpp"
#include "shared/base/result.hpp"

namespace psicarve::port {

/// Where the kernel lists its ports; tests have other places.
struct KernelPlaces {
    std::string proc = "/proc";
    std::string dev = "/dev";
};

/// Opens the addresses of a parallel port to this thread and those that it starts: only where the kernel
/// lists one, or at one of the three classic bases. Where the kernel has a driver for it, the port is claimed
/// there as well, so that no other program gets it. The port is not touched before the locks of its base are
/// ours; its safe state is written.
Result<OpenPort> open_raw(std::uint16_t base, const PinMap& pin_map, const KernelPlaces& places = {});

}  // namespace psicarve::port
