// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "hmi/session/message_log.hpp"

namespace psicarve::session {

/// The one message that there is room for at the window's edge: the newest, but what tells of trouble is not
/// swept away by the next good news.
class StatusLine {
public:
    using Clock = std::chrono::steady_clock;
    /// So long a warning or an alarm stands against everything but a newer one.
    static constexpr std::chrono::seconds kTroubleStays{8};

    /// At screen rate. True when another message is to be shown than before.
    bool look(const MessageLog& log, Clock::time_point now);
    /// Nothing: there was none yet.
    const std::optional<Message>& shown() const noexcept { return shown_; }

private:
    std::uint64_t seen_ = 0;
    std::optional<Message> shown_;
    std::optional<Message> waiting_;  ///< the newest of those that trouble has kept back
    Clock::time_point since_{};
};

}  // namespace psicarve::session
