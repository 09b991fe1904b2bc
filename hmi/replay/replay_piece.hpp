// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>

#include "hmi/piece/piece_front.hpp"
#include "hmi/replay/tool_timeline.hpp"
#include "hmi/session/background_queue.hpp"

namespace psicarve::replay {

/// Calculates what the tool has left at the time that a recording shows, on a thread of its own: the newest
/// request counts. The owner waits only in the destructor, and then for one place to be cut, or one piece to
/// be copied.
class ReplayPiece {
public:
    explicit ReplayPiece(std::shared_ptr<const ToolTimeline> timeline);
    ~ReplayPiece();
    ReplayPiece(const ReplayPiece&) = delete;
    ReplayPiece& operator=(const ReplayPiece&) = delete;

    void want(std::int64_t time);
    /// Whether the front is the piece at this time.
    bool shows(std::int64_t time) const { return has_wanted_ && wanted_.load() == time && queue_.is_idle(); }
    piece::PieceFront& front() noexcept { return front_; }

private:
    void follow();

    piece::PieceFront front_;
    PieceInTime piece_;  ///< used by the queue's thread
    bool has_wanted_ = false;
    std::atomic<std::int64_t> wanted_{0};
    std::atomic<bool> is_dropped_{false};
    session::BackgroundQueue queue_;  // last: it uses the others
};

}  // namespace psicarve::replay
