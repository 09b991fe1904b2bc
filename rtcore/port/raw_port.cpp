// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/port/raw_port.hpp"

#include <fcntl.h>
#include <sys/io.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "rtcore/port/kernel_ports.hpp"
#include "rtcore/port/ppdev_port.hpp"

namespace psicarve::port {
namespace {

constexpr std::uint16_t kRegisters = 3;
constexpr std::uint16_t kControlOffset = 2;
constexpr std::uint16_t kExtendedOffset = 0x402;
constexpr std::uint8_t kNothingThere = 0xff;
/// Mode 000, SPP; no error interrupt, no DMA, no service interrupt. Source: IEEE 1284 ECP register set.
constexpr std::uint8_t kPlainMode = 0x14;

std::string hex(std::uint16_t base) {
    char text[8];
    (void)std::snprintf(text, sizeof text, "0x%x", base);
    return text;
}

Error refused(std::uint16_t base, const std::string& text) {
    return Error{ErrorCode::machine_refused, "port at " + hex(base) + ": " + text};
}

Error why_not_allowed(std::uint16_t base, int error) {
    if (error == EPERM || error == EACCES) {
        return refused(
            base, "no right to its addresses; run with CAP_SYS_RAWIO, or use --port ppdev:/dev/parport0");
    }
    if (error == ENOSYS)
        return refused(base, "this kernel lets nobody at addresses; use --port ppdev:/dev/parport0");
    return refused(base, "ioperm: " + std::generic_category().message(error));
}

/// Takes the lock of this base, for ports without a driver: the descriptor that holds it.
Result<int> lock_base(std::uint16_t base) {
    char path[40];
    (void)std::snprintf(path, sizeof path, "/dev/shm/psicarve-port-%x", base);
    int descriptor = ::open(path, O_RDWR | O_CLOEXEC | O_NOFOLLOW);
    if (descriptor < 0) descriptor = ::open(path, O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600);
    if (descriptor < 0)
        return refused(base, std::string{path} + ": " + std::generic_category().message(errno));
    struct flock request {};
    request.l_type = F_WRLCK;
    request.l_whence = SEEK_SET;
    if (::fcntl(descriptor, F_OFD_SETLK, &request) == 0) return descriptor;
    ::close(descriptor);
    const std::string holders = processes_with(path);
    return refused(base, "busy: " + (holders.empty() ? "another core" : holders) + " has it; end that first");
}

/// Where the kernel drives the same port: claims it there. Nothing: the kernel does not know it, or offers no
/// device for it.
Result<std::optional<OpenPort>> claim_from_kernel(std::uint16_t base, const std::vector<KernelPort>& ports) {
    const auto found =
        std::find_if(ports.begin(), ports.end(), [&](const KernelPort& port) { return port.base == base; });
    if (found == ports.end()) return std::optional<OpenPort>{};
    const std::string device = "/dev/" + found->name;
    if (::access(device.c_str(), R_OK | W_OK) != 0) {
        if (found->holder.empty()) return std::optional<OpenPort>{};
        return refused(base, "busy: " + found->holder + " has " + found->name + "; end that first");
    }
    auto open = open_ppdev(device);
    if (!open) return open.error();
    return std::optional<OpenPort>{std::move(*open)};
}

/// The mode that the port was found in; a mode with a buffer between us and the lines is left for plain
/// access.
std::string take_plain_mode(std::uint16_t base) {
    const auto address = static_cast<std::uint16_t>(base + kExtendedOffset);
    if (ioperm(address, 1, 1) != 0) return "mode not asked";
    const std::uint8_t extended = inb(address);
    const std::string mode =
        extended_mode_text(extended, inb(static_cast<std::uint16_t>(base + kControlOffset)));
    if (mode.empty()) return "SPP";
    outb(kPlainMode, address);
    return "found in mode " + mode;
}

}  // namespace

std::string extended_mode_text(std::uint8_t extended, std::uint8_t control) {
    constexpr std::array kModes{"SPP", "PS/2",     "parallel FIFO", "ECP",
                                "EPP", "reserved", "test",          "configuration"};
    constexpr unsigned kFifoBits = 3;  // full, empty: at rest the FIFO is empty
    constexpr unsigned kEmpty = 1;
    constexpr unsigned kModeShift = 5;
    const bool is_mirror = extended == control;
    if (extended == kNothingThere || is_mirror || (extended & kFifoBits) != kEmpty) return {};
    return kModes[extended >> kModeShift];
}

Result<OpenPort> open_raw(std::uint16_t base) {
    const auto ports = kernel_ports();
    const bool is_listed =
        std::any_of(ports.begin(), ports.end(), [&](const KernelPort& port) { return port.base == base; });
    if (base == 0 || (!is_listed && !is_classic_base(base))) {
        return Error{ErrorCode::bad_usage,
                     "--port io:" + hex(base) +
                         ": the kernel lists no parallel port there; 0x378, 0x278, 0x3bc, "
                         "or one of /proc/sys/dev/parport/*/base-addr"};
    }
    if (ioperm(base, kRegisters, 1) != 0) return why_not_allowed(base, errno);
    auto claimed = claim_from_kernel(base, ports);
    if (!claimed) return claimed.error();
    const auto lock = lock_base(base);
    if (!lock) return lock.error();
    OpenPort open{{*lock}, PortAccess::raw(base), "port at " + hex(base)};
    if (*claimed) open.keep(std::move(**claimed));
    const bool is_empty = inb(base) == kNothingThere &&
                          inb(static_cast<std::uint16_t>(base + 1)) == kNothingThere &&
                          inb(static_cast<std::uint16_t>(base + kControlOffset)) == kNothingThere;
    if (is_empty) return refused(base, "nothing answers there; see the BIOS, or name another address");
    open.describe("port at " + hex(base) + ": " + take_plain_mode(base) + "; plain register access");
    return open;
}

}  // namespace psicarve::port
