// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "rtcore/port/port_access.hpp"
#include "rtcore/port/port_address.hpp"
#include "shared/base/result.hpp"
#include "shared/profile/pin_map.hpp"

namespace psicarve::port {

/// A real port that this process, and no other core, has for itself; in its safe state since it was opened.
/// Its owner may hand SafeState(access(), pin map) to a process that inherits from this one. The destructor
/// gives the port back as it stands.
class OpenPort {
public:
    /// Takes the descriptors, which keep other processes out of the port.
    OpenPort(std::vector<int> descriptors, const PortAccess& access, std::string name) noexcept
        : descriptors_(std::move(descriptors)), access_(access), name_(std::move(name)) {}
    OpenPort(OpenPort&& other) noexcept
        : descriptors_(std::exchange(other.descriptors_, {})),
          access_(other.access_),
          name_(std::move(other.name_)),
          modes_(std::move(other.modes_)) {}
    OpenPort& operator=(OpenPort&&) = delete;
    ~OpenPort();

    const PortAccess& access() const noexcept { return access_; }
    /// For people: "/dev/parport0: can do SPP, PS/2; plain register access".
    std::string description() const;
    /// "can do SPP, PS/2"; empty until it is known.
    const std::string& modes() const noexcept { return modes_; }
    void note_modes(std::string modes) { modes_ = std::move(modes); }

    /// Keeps this port's access to the registers, and also holds the locks of the other.
    void keep(OpenPort&& other);

private:
    std::vector<int> descriptors_;
    PortAccess access_;
    std::string name_;  ///< of the port, for people
    std::string modes_;
};

/// Opens a real port for this process alone and writes its safe state, retrying for some seconds, or says why
/// not. Signals that would end the process are held back meanwhile.
Result<OpenPort> open_port(const PortAddress& address, const PinMap& pin_map);

}  // namespace psicarve::port
