// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/port/port_access.hpp"

#include <linux/ppdev.h>
#include <sys/io.h>
#include <sys/ioctl.h>

namespace psicarve::port {
bool PortAccess::write(PortRegister reg, std::uint8_t byte) const noexcept {
    if (descriptor_ >= 0) {
        return ioctl(descriptor_, reg == PortRegister::data ? PPWDATA : PPWCONTROL, &byte) == 0;
    }
    outb(byte, reg == PortRegister::data ? base_ : static_cast<std::uint16_t>(base_ + kControlOffset));
    return true;
}

bool PortAccess::read_status(std::uint8_t& byte) const noexcept {
    if (descriptor_ >= 0) return ioctl(descriptor_, PPRSTATUS, &byte) == 0;
    byte = inb(static_cast<std::uint16_t>(base_ + kStatusOffset));
    return true;
}

}  // namespace psicarve::port
