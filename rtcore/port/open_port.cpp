// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/port/open_port.hpp"

#include <unistd.h>

#include "rtcore/port/ppdev_port.hpp"
#include "rtcore/port/raw_port.hpp"

namespace psicarve::port {

OpenPort::~OpenPort() {
    for (const int descriptor : descriptors_) ::close(descriptor);
}

void OpenPort::keep(OpenPort&& other) {
    const std::vector<int> descriptors = std::exchange(other.descriptors_, {});
    descriptors_.insert(descriptors_.end(), descriptors.begin(), descriptors.end());
}

Result<OpenPort> open_port(const PortAddress& address, const PinMap& pin_map) {
    auto open = address.kind == PortKind::raw ? open_raw(address.base) : open_ppdev(address.device);
    if (!open) return open.error();
    if (!SafeState{open->access(), pin_map}.write()) {
        return Error{ErrorCode::machine_refused,
                     open->description() + ": does not take what is written to it; is it still there?"};
    }
    return open;
}

}  // namespace psicarve::port
