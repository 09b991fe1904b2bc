// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/port/open_port.hpp"

#include <signal.h>
#include <unistd.h>

#include "rtcore/port/ppdev_port.hpp"
#include "rtcore/port/raw_port.hpp"

namespace psicarve::port {
namespace {

/// While it lives, signals that would end or stop the process are held back: between the claim, which
/// switches outputs on, and the safe state no other process would write it.
class SignalsHeldBack {
public:
    SignalsHeldBack() noexcept {
        sigset_t held;
        sigfillset(&held);
        for (const int fault : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP, SIGSYS})
            sigdelset(&held, fault);
        pthread_sigmask(SIG_BLOCK, &held, &before_);
    }
    ~SignalsHeldBack() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    SignalsHeldBack(const SignalsHeldBack&) = delete;
    SignalsHeldBack& operator=(const SignalsHeldBack&) = delete;

private:
    sigset_t before_{};
};

}  // namespace

OpenPort::~OpenPort() {
    for (const int descriptor : descriptors_) ::close(descriptor);
}

std::string OpenPort::description() const {
    return modes_.empty() ? name_ : name_ + ": " + modes_ + "; plain register access";
}

void OpenPort::keep(OpenPort&& other) {
    const std::vector<int> descriptors = std::exchange(other.descriptors_, {});
    descriptors_.insert(descriptors_.end(), descriptors.begin(), descriptors.end());
}

Result<OpenPort> open_port(const PortAddress& address, const PinMap& pin_map) {
    const SignalsHeldBack held;
    return address.kind == PortKind::raw ? open_raw(address.base, pin_map)
                                         : open_ppdev(address.device, pin_map);
}

}  // namespace psicarve::port
