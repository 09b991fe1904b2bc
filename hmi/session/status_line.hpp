// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "hmi/session/message_log.hpp"

namespace psicarve::session {

/// The one message for which the window's edge has room: the newest, except that a later good message does
/// not replace a warning or an alarm.
class StatusLine {
public:
    using Clock = std::chrono::steady_clock;
    /// For this time a warning or an alarm stays, unless a newer one comes.
    static constexpr std::chrono::seconds kTroubleStays{8};

    /// Call it at screen rate. True when it shows another message than before.
    bool look(const MessageLog& log, Clock::time_point now);
    /// Nothing: there was none yet.
    const std::optional<Message>& shown() const noexcept { return shown_; }

private:
    std::uint64_t seen_ = 0;
    std::optional<Message> shown_;
    std::optional<Message> waiting_;  ///< the newest of those held back by a warning or alarm
    Clock::time_point since_{};
};

}  // namespace psicarve::session
