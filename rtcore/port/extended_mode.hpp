// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "shared/computer/kernel_ports.hpp"

namespace psicarve::port {

/// Single bytes of the computer's address space.
class Bus {
public:
    virtual ~Bus() = default;
    virtual std::uint8_t read(std::uint16_t address) = 0;
    virtual void write(std::uint16_t address, std::uint8_t byte) = 0;
};

/// The address of the extended control register of the port at `base`, if it has one: the address that the
/// kernel lists, or, where it lists no such port, the usual offset of ports on ISA and LPC. Nothing: what
/// stands there may be another device's.
std::optional<std::uint16_t> extended_address(std::uint16_t base, const std::vector<KernelPort>& ports);

/// Names the mode in the extended control register's byte: "SPP" ... ; empty when the byte cannot be one of
/// such a register. `control` is what the control register reads: old boards show it at that address once
/// more.
std::string extended_mode_text(std::uint8_t extended, std::uint8_t control);

/// Switches from a mode with a buffer between us and the lines to plain access; returns the mode that the
/// port was in, if it is known. Only reads until the place looks like such a register; a register that does
/// not keep what is written to it gets its old value back.
std::string take_plain_mode(Bus& bus, std::uint16_t base, std::uint16_t extended_address);

}  // namespace psicarve::port
