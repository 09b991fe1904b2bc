// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "shared/profile/pin_map.hpp"

namespace psicarve::port {

/// Registers relative to the base address, which is the data register.
inline constexpr std::uint16_t kStatusOffset = 1;
inline constexpr std::uint16_t kControlOffset = 2;
/// What is read at an address where no device answers.
inline constexpr std::uint8_t kNothingThere = 0xff;

/// The registers of an open parallel port, by a descriptor or by an address. It owns nothing: a plain value
/// that any thread may use, a signal handler too, and any process that has the descriptor or the right to the
/// addresses. RT: yes; one system call or one bus access each.
class PortAccess {
public:
    /// A descriptor of /dev/parportN with the port claimed.
    static PortAccess ppdev(int descriptor) noexcept { return PortAccess{descriptor, 0}; }
    /// Addresses that ioperm() has opened to this thread.
    static PortAccess raw(std::uint16_t base) noexcept { return PortAccess{-1, base}; }

    /// The data or the control register. False: the hardware or its driver answered with an error.
    bool write(PortRegister reg, std::uint8_t byte) const noexcept;
    bool read_status(std::uint8_t& byte) const noexcept;

private:
    PortAccess(int descriptor, std::uint16_t base) noexcept : descriptor_(descriptor), base_(base) {}

    int descriptor_;  ///< negative: by address
    std::uint16_t base_;
};

/// The safe state of a port, for any process to write: spindle off, drives off, steps low.
class SafeState {
public:
    SafeState(const PortAccess& access, const PinMap& pin_map) noexcept
        : access_(access), registers_(pin_map.encode(0)) {}

    /// Writes both registers, whatever they held; the second one even when the first one failed. May be
    /// called from a signal handler, and by another process than the one that opened the port.
    bool write() const noexcept {
        const bool is_data_safe = access_.write(PortRegister::data, registers_.data);
        const bool is_control_safe = access_.write(PortRegister::control, registers_.control);
        return is_data_safe && is_control_safe;
    }
    OutputRegisters registers() const noexcept { return registers_; }

private:
    PortAccess access_;
    OutputRegisters registers_;
};

}  // namespace psicarve::port
