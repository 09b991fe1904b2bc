// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <utility>

#include "hmi/session/message_log.hpp"

namespace psicarve::session {

/// Calls an operator who does not look at the screen, once for all new alarms. Alarms from before the window
/// was open, and those in a recording, do not count.
class AlarmBell {
public:
    explicit AlarmBell(std::function<void()> ring) : ring_(std::move(ring)) {}

    void set_ring(std::function<void()> ring) { ring_ = std::move(ring); }
    /// While it is off it skips alarms for good.
    void set_on(bool is_on) noexcept { is_on_ = is_on; }
    /// Call it at every look at the machine.
    void poll(const MessageLog& log);

private:
    std::function<void()> ring_;
    bool is_on_ = true;
    std::uint64_t seen_ = 0;
};

}  // namespace psicarve::session
