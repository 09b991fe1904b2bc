// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/port/ppdev_port.hpp"

#include <fcntl.h>
#include <linux/parport.h>
#include <linux/ppdev.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "rtcore/port/base_lock.hpp"
#include "rtcore/port/persistence.hpp"
#include "shared/computer/kernel_ports.hpp"

namespace psicarve::port {
namespace {

Error refused(const std::string& device, const std::string& text) {
    return Error{ErrorCode::machine_refused, device + ": " + text};
}

std::string text_of(int error) {
    return std::generic_category().message(error);
}

Error why_not_opened(const std::string& device, int error) {
    switch (error) {
        case ENOENT:
        case ENOTDIR:
            return refused(
                device, "no such device; load its drivers (modprobe -a parport_pc ppdev), or name another");
        case EACCES:
        case EPERM:
            return refused(device, "no right to open it; join its group (usermod -aG " + group_of(device) +
                                       " USER, then log in again)");
        case ENXIO:
        case ENODEV:
            return refused(device, "no parallel port is behind it; see ls /proc/sys/dev/parport");
        default:
            return refused(device, "cannot be opened: " + text_of(error));
    }
}

Error why_not_claimed(const std::string& device, int descriptor, int error) {
    if (error == ENOTTY || error == EINVAL || error == EOPNOTSUPP)
        return refused(device, "is not a parallel port");
    if (error != ENXIO && error != EBUSY && error != EAGAIN) {
        return refused(device, "cannot be claimed: " + text_of(error));
    }
    const std::string signer = signer_of(descriptor);
    const std::string holders = signer.empty() ? processes_with(device) : signer;
    if (!holders.empty()) return refused(device, "busy: " + holders + " has it; end that first");
    if (is_lp_loaded()) return refused(device, "busy: the printer driver has it; modprobe -r lp");
    return refused(device,
                   "busy: another driver has it, or another user's program that did not say its pid; see "
                   "/proc/sys/dev/parport/*/devices");
}

}  // namespace

std::string port_modes_text(unsigned modes) {
    struct Mode {
        unsigned bit;
        const char* name;
    };
    constexpr Mode kModes[] = {{PARPORT_MODE_PCSPP, "SPP"},
                               {PARPORT_MODE_TRISTATE, "PS/2"},
                               {PARPORT_MODE_EPP, "EPP"},
                               {PARPORT_MODE_ECP, "ECP"}};
    std::string text;
    for (const Mode& mode : kModes) {
        if ((modes & mode.bit) != 0) text += (text.empty() ? "" : ", ") + std::string{mode.name};
    }
    return text.empty() ? "mode unknown" : text;
}

Result<OpenPort> open_ppdev(const std::string& device, const PinMap& pin_map) {
    const int descriptor = ::open(device.c_str(), O_RDWR | O_CLOEXEC | O_NOCTTY | O_NONBLOCK);
    if (descriptor < 0) return why_not_opened(device, errno);
    OpenPort open{{descriptor}, PortAccess::ppdev(descriptor), device};
    unsigned modes = 0;
    if (ioctl(descriptor, PPGETMODES, &modes) != 0) return refused(device, "is not a parallel port");
    if ((modes & PARPORT_MODE_PCSPP) == 0) {
        return refused(device, "has no registers to write (a USB printer cable?); use a port on the bus");
    }
    // Exclusive first: claiming alone would share the port with others in turns.
    if (ioctl(descriptor, PPEXCL) != 0 || ioctl(descriptor, PPCLAIM) != 0) {
        return why_not_claimed(device, descriptor, errno);
    }
    sign_device(descriptor);
    int outwards = 0;
    const int direction_error = ioctl(descriptor, PPDATADIR, &outwards) == 0 ? 0 : errno;
    if (const auto safe = make_safe_at_opening(open.access(), pin_map, device); !safe) return safe.error();
    if (direction_error != 0) return why_not_claimed(device, descriptor, direction_error);
    open.note_modes("can do " + port_modes_text(modes));
    return open;
}

}  // namespace psicarve::port
