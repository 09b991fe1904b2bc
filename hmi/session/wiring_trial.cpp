// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/wiring_trial.hpp"

#include <algorithm>

#include "hmi/session/action_lock.hpp"

namespace psicarve::session {

std::optional<Phrase> wiring_lock(const MachineView& machine) {
    if (machine.is_heard() && machine.state() == MachineState::testing) return std::nullopt;
    if (auto lock = lock_of(Action::home, machine, OpenJobView{})) return lock;
    if (machine.state() == MachineState::ready) return phrase("Wiring test: switch the drives off first");
    if (machine.is_active(Signal::estop)) return phrase("The emergency stop switch is still pressed");
    return std::nullopt;
}

std::chrono::seconds WiringTrial::left(Clock::time_point now) const noexcept {
    if (!is_armed_) return std::chrono::seconds{0};
    const auto left = std::chrono::ceil<std::chrono::seconds>(used_ + kIdleLimit - now);
    return std::clamp(left, std::chrono::seconds{0}, kIdleLimit);
}

}  // namespace psicarve::session
