// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "shared/base/result.hpp"

namespace psicarve::port {

enum class PortKind : std::uint8_t { simulated, ppdev, raw };

/// The port that --port names.
struct PortAddress {
    PortKind kind = PortKind::simulated;
    std::string device;      ///< ppdev: the path
    std::uint16_t base = 0;  ///< raw: address of the data register

    bool is_simulated() const noexcept { return kind == PortKind::simulated; }
};

/// Reads "sim", "ppdev:/dev/parport0" or "io:0x378". Does not check whether there is such a port.
Result<PortAddress> parse_port_address(const std::string& text);
/// The text that parse_port_address() reads back.
std::string port_text(const PortAddress& address);

}  // namespace psicarve::port
