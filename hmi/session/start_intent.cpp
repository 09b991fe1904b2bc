// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/start_intent.hpp"

namespace psicarve::session {
namespace {

// One status may have been sampled before the core saw the command and be written after it; the next one is
// new.
constexpr std::uint64_t kFreshAfter = 2;

}  // namespace

bool StartIntent::take(const CoreStatus& status) noexcept {
    if (!is_armed_) return false;
    if (status.state == MachineState::waiting) {
        is_armed_ = false;
        return true;
    }
    if (status.state == MachineState::positioning) return false;
    if (status.heartbeat >= heartbeat_ + kFreshAfter || status.heartbeat < heartbeat_) is_armed_ = false;
    return false;
}

}  // namespace psicarve::session
