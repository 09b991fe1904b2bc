// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/port/raw_port.hpp"

#include <fcntl.h>
#include <sys/io.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "rtcore/port/base_lock.hpp"
#include "rtcore/port/extended_mode.hpp"
#include "rtcore/port/persistence.hpp"
#include "rtcore/port/port_access.hpp"
#include "rtcore/port/ppdev_port.hpp"
#include "shared/computer/kernel_ports.hpp"
#include "shared/computer/raw_access.hpp"

namespace psicarve::port {
namespace {

Error refused(std::uint16_t base, const std::string& text) {
    return Error{ErrorCode::machine_refused, "port at " + hex_of(base) + ": " + text};
}

/// Takes the locks of this base, for ports without a driver: returns the descriptors that hold them. Every
/// core takes the name; the bytes, where they can be had, are for other programs that check them.
Result<std::vector<int>> lock_base(std::uint16_t base, const KernelPlaces& places) {
    const auto name = lock_name(base_lock_name(places.dev, base));
    if (!name) return refused(base, name.error().message);
    std::vector<int> locks{*name};
    const auto range = lock_range(places.dev + "/port", base, kPortRegisters);
    if (!range) {
        ::close(*name);
        return refused(base, range.error().message);
    }
    if (*range) locks.push_back(**range);
    return locks;
}

/// Where the kernel drives the same port: claims it there. Nothing: the kernel does not know it, or offers no
/// device for it.
Result<std::optional<OpenPort>> claim_from_kernel(std::uint16_t base, const std::vector<KernelPort>& ports,
                                                  const PinMap& pin_map, const KernelPlaces& places) {
    const auto found =
        std::find_if(ports.begin(), ports.end(), [&](const KernelPort& port) { return port.base == base; });
    if (found == ports.end()) return std::optional<OpenPort>{};
    const std::string device = places.dev + "/" + found->name;
    // Tries by opening it: access() checks the rights of the user who started us, without our capabilities.
    const int trial = ::open(device.c_str(), O_RDWR | O_CLOEXEC);
    if (trial >= 0) ::close(trial);
    if (trial < 0 && (errno == EACCES || errno == EPERM || errno == ENOENT)) {
        if (found->holder.empty()) return std::optional<OpenPort>{};
        return refused(base, "busy: " + found->holder + " has " + found->name + "; end that first");
    }
    auto open = open_ppdev(device, pin_map);
    if (!open) return open.error();
    return std::optional<OpenPort>{std::move(*open)};
}

class RealBus final : public Bus {
public:
    std::uint8_t read(std::uint16_t address) override { return inb(address); }
    void write(std::uint16_t address, std::uint8_t byte) override { outb(byte, address); }
};

/// For a port that the kernel's driver has not put into a plain mode for us.
std::string mode_of(std::uint16_t base, const std::vector<KernelPort>& ports) {
    const auto address = extended_address(base, ports);
    if (!address || ioperm(*address, 1, 1) != 0) return "mode not asked";
    RealBus bus;
    return take_plain_mode(bus, base, *address);
}

}  // namespace

Result<OpenPort> open_raw(std::uint16_t base, const PinMap& pin_map, const KernelPlaces& places) {
    const auto ports = kernel_ports(places.proc);
    const bool is_listed =
        std::any_of(ports.begin(), ports.end(), [&](const KernelPort& port) { return port.base == base; });
    if (base == 0 || (!is_listed && !is_classic_base(base))) {
        return Error{ErrorCode::bad_usage,
                     "--port io:" + hex_of(base) +
                         ": the kernel lists no parallel port there; 0x378, 0x278, 0x3bc, "
                         "or one of /proc/sys/dev/parport/*/base-addr"};
    }
    if (const auto refusal = take_addresses(base, kPortRegisters))
        return refused(base, refusal->reason + "; " + refusal->remedy);
    auto locks = lock_base(base, places);
    if (!locks) return locks.error();
    OpenPort open{std::move(*locks), PortAccess::raw(base), "port at " + hex_of(base)};
    auto claimed = claim_from_kernel(base, ports, pin_map, places);
    if (!claimed) return claimed.error();
    const bool is_claimed = claimed->has_value();
    std::string modes;
    if (is_claimed) {
        modes = "claimed from the kernel's driver, " + (*claimed)->modes();
        open.keep(std::move(**claimed));
    }
    const bool is_empty = inb(base) == kNothingThere &&
                          inb(static_cast<std::uint16_t>(base + 1)) == kNothingThere &&
                          inb(static_cast<std::uint16_t>(base + kControlOffset)) == kNothingThere;
    if (is_empty) return refused(base, "nothing answers there; see the BIOS, or name another address");
    // A claimed port is safe already.
    if (!is_claimed) {
        modes = mode_of(base, ports);
        if (const auto safe = make_safe_at_opening(open.access(), pin_map, open.description()); !safe)
            return safe.error();
    }
    open.note_modes(std::move(modes));
    return open;
}

}  // namespace psicarve::port
