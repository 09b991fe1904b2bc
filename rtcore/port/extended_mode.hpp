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

/// Where the port at `base` has its extended control register, if it has one: where the kernel says, and
/// where the kernel lists no such port, at the offset that ports on ISA and LPC have. Nothing: what stands
/// there may be another device's.
std::optional<std::uint16_t> extended_address(std::uint16_t base, const std::vector<KernelPort>& ports);

/// Of the extended control register's byte: "SPP" ... ; empty when the byte is not one of such a register.
/// `control` is what the control register reads: old boards show it there once more.
std::string extended_mode_text(std::uint8_t extended, std::uint8_t control);

/// The mode that the port was found in, if it is known; a mode with a buffer between us and the lines is left
/// for plain access. Only reads until what is there looks like such a register; what does not keep what is
/// written to it gets back what stood there.
std::string take_plain_mode(Bus& bus, std::uint16_t base, std::uint16_t extended_address);

}  // namespace psicarve::port
